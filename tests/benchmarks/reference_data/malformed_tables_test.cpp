// SPDX-License-Identifier: MIT
// Tables of other programs that are not well-formed: the message names file, line and column.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "fdebench/benchmarks/reference_data/reference_check.hpp"
#include "support/matchers.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

void require_well_formed(const TemporaryFolder& folder) {
  check_folder(folder.path(), 1, [](std::size_t, std::size_t, const std::string&) {});
}

struct MalformedTable {
  const char *file, *text, *message;
};

class MalformedTables : public testing::TestWithParam<MalformedTable> {};

TEST_P(MalformedTables, AreNamedWithLineAndColumn) {
  const TemporaryFolder folder;
  folder.write(GetParam().file, GetParam().text);
  EXPECT_THAT([&] { require_well_formed(folder); },
              ThrowsMessage<std::invalid_argument>(HasSubstr(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(
    ReferenceTables, MalformedTables,
    testing::ValuesIn<MalformedTable>(
        {{"a.csv", "alpha,beta,re_z,re\n1,1,1,e\n", "a.csv: line 2, column re: 'e' must be a decimal"},
         {"a.csv", "alpha,beta,re_z,re\n1,1,x,1\n", "a.csv: line 2: mittag_leffler: re z: 'x'"},
         {"a.csv", "alpha,beta,re_z,re\n7,1,1,1\n", "a.csv: line 2: mittag_leffler: alpha = 7 has to be in"},
         {"a.csv", "alpha,beta,re_z,re,bound\n1,1,1,1,-1\n", "column bound: -1 must not be negative"},
         {"a.csv", "alpha,re_z,re\n", "a.csv: line 1: column beta is missing"},
         {"a.csv", "x,y\n1,2\n", "must have a column re_z or t or scheme"},
         {"pendulums.csv", "t,phi\n", "scene pendulums: no such scene, did you mean 'pendulum'?"},
         {"pendulum.csv", "t,psi\n1,2\n", "has none of the columns phi"},
         {"pendulum.csv", "t,phi\n1e9,2\n", "line 2, column t: 1e9 must be a time in [0, 1000]"},
         {"power.csv", "scheme,steps,error_end\nl2,8,1\n", "line 2, column scheme: no such scheme 'l2'"},
         {"power.csv", "scheme,steps,error_end\nl1,8.5,1\n", "column steps: '8.5' must be a whole number"}}));

TEST(ReferenceTables, AMalformedDescriptionIsNamed) {
  const auto complains = [](const char* description, const char* message) {
    const TemporaryFolder folder;
    folder.write("power.csv", "t,y\n3,9\n");
    folder.write("power.json", description);
    EXPECT_THAT([&] { require_well_formed(folder); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
  };
  complains("{", "power.json: is not JSON, at byte 2");
  complains(R"({"parameters": {"p": {"of": 2}}})", "power.json: is not as docs/reference_data.md says");
  complains(R"({"parameters": {"p": [2]}})", "p = [2]: must be a number in (0, 50]");
  complains(R"({"parameters": {"p": ["two"]}})", "power.json: is not as docs/reference_data.md says");
  complains(R"({"parameters": {"p": "two"}})", "power.json: p = two: must be a number");
  complains(R"({"parameters": {"q": 2}})", "power.json: q: scene power has no such parameter");
  complains(R"({"schema": {"id": "fdebench.convergence"}})", "schema id = fdebench.convergence: must be");
  complains(R"({"schema": {"version": 2}})", "schema version = 2: must be 1");
  complains(R"({"schema": {"columns": [{"name": "z"}]}})", "column z of the description is missing");
  complains(R"({"rows": 2})", "has 1 rows, 2 in its description");
}

TEST(ReferenceTables, AFolderWithoutTablesIsNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT([&] { require_well_formed(folder); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("holds no table")));
}

}  // namespace
}  // namespace fde::bench
