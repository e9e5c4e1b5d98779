// SPDX-License-Identifier: MIT
#include "fdebench/reports/export/tables.hpp"

namespace fde::bench {
namespace {

constexpr std::array sessions{SqlColumn{"session_id", "INTEGER PRIMARY KEY"},
                              SqlColumn{"date", "TEXT NOT NULL"},
                              SqlColumn{"machine", "TEXT NOT NULL"},
                              SqlColumn{"cores", "INTEGER NOT NULL"},
                              SqlColumn{"system", "TEXT NOT NULL"},
                              SqlColumn{"compiler", "TEXT NOT NULL"},
                              SqlColumn{"flags", "TEXT NOT NULL"},
                              SqlColumn{"revision", "TEXT NOT NULL"},
                              SqlColumn{"version", "TEXT NOT NULL"},
                              SqlColumn{"node", "TEXT"},
                              SqlColumn{"build_id", "INTEGER NOT NULL"}};
constexpr std::array scenes{SqlColumn{"scene_id", "INTEGER PRIMARY KEY"},
                            SqlColumn{"scene", "TEXT NOT NULL"},
                            SqlColumn{"checksum", "TEXT"},
                            SqlColumn{"until", "REAL"},
                            SqlColumn{"title", "TEXT"},
                            SqlColumn{"source", "TEXT"},
                            SqlColumn{"evidence", "TEXT"},
                            SqlColumn{"reference_seconds", "REAL"},
                            SqlColumn{"description", "TEXT"}};
constexpr std::array parameters{SqlColumn{"scene_id", "INTEGER NOT NULL REFERENCES scenes"},
                                SqlColumn{"parameter", "TEXT NOT NULL"}, SqlColumn{"number", "REAL"},
                                SqlColumn{"word", "TEXT"}, SqlColumn{"given", "INTEGER NOT NULL"}};
constexpr std::array runs{SqlColumn{"run_id", "INTEGER PRIMARY KEY"},
                          SqlColumn{"session_id", "INTEGER NOT NULL REFERENCES sessions"},
                          SqlColumn{"scene_id", "INTEGER NOT NULL REFERENCES scenes"},
                          SqlColumn{"scheme", "TEXT NOT NULL"},
                          SqlColumn{"external", "INTEGER NOT NULL"},
                          SqlColumn{"code", "TEXT"},
                          SqlColumn{"code_version", "TEXT"},
                          SqlColumn{"language", "TEXT"},
                          SqlColumn{"steps", "INTEGER NOT NULL"},
                          SqlColumn{"h", "REAL NOT NULL"},
                          SqlColumn{"accuracy_relative", "REAL"},
                          SqlColumn{"accuracy_absolute", "REAL"},
                          SqlColumn{"grading", "REAL NOT NULL"},
                          SqlColumn{"history", "TEXT"},
                          SqlColumn{"tolerance", "REAL"},
                          SqlColumn{"budget", "REAL"},
                          SqlColumn{"ending", "TEXT"},
                          SqlColumn{"detail", "TEXT"},
                          SqlColumn{"ended_at", "REAL"},
                          SqlColumn{"latest", "INTEGER NOT NULL"}};
constexpr std::array results{SqlColumn{"result_id", "INTEGER PRIMARY KEY"},
                             SqlColumn{"run_id", "INTEGER NOT NULL REFERENCES runs"},
                             SqlColumn{"session_id", "INTEGER NOT NULL REFERENCES sessions"},
                             SqlColumn{"quantity", "TEXT NOT NULL"},
                             SqlColumn{"value", "REAL NOT NULL"},
                             SqlColumn{"unit", "TEXT NOT NULL"},
                             SqlColumn{"wall_clock", "INTEGER NOT NULL"}};
constexpr std::array courses{SqlColumn{"result_id", "INTEGER NOT NULL REFERENCES results"},
                             SqlColumn{"t", "REAL NOT NULL"}, SqlColumn{"value", "REAL NOT NULL"}};

}  // namespace

const std::array<SqlTable, table_count>& tables() {
  static constexpr std::array<SqlTable, table_count> all{{{"sessions", sessions},
                                                          {"scenes", scenes},
                                                          {"parameters", parameters},
                                                          {"runs", runs},
                                                          {"results", results},
                                                          {"courses", courses}}};
  return all;
}

}  // namespace fde::bench
