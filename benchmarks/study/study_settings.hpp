// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/requests/sweep_request.hpp"
#include "fdebench/benchmarks/study/study_points.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"

namespace fde::bench {

// The settings of the runs of a family, and where the file has them.
struct StudySettings {
  SweepRequest request{};                        // without scenes
  std::map<std::string, TextPosition> places{};  // by key
};

// The lines of a study file with these settings.
std::string text_of(const StudySettings& settings);

// A text in double quotes.
std::string toml_text(const std::string& text);
// A key of a table, in quotes where it needs them.
std::string toml_key(const std::string& name);

// Throws std::invalid_argument: the refusal of a request with these settings, with the keys of the file for
// the fields, at the place of the first of them, or else at that of the family.
[[noreturn]] void reject_settings(const Refusal& refusal, const StudySettings& settings,
                                  const std::string& file, const TextPosition& family);

// Reads the settings of a study file. Each function throws std::invalid_argument naming file, line and
// column, the key, its value and what is allowed.
class StudySettingsReader : protected StudyPoints {
 public:
  using StudyPoints::StudyPoints;

 protected:
  // The keys of settings, and these.
  [[nodiscard]] static std::vector<std::string_view> with_settings(std::vector<std::string_view> keys);

  // The settings of a family: its own, and those of the file that it does not have.
  [[nodiscard]] StudySettings settings_of(const toml::table& study, const toml::table& family) const;

 private:
  friend std::string text_of(const StudySettings& settings);
  struct Setting;
  static const std::vector<Setting>& all();

  // The values of a list, or the one value.
  [[nodiscard]] std::vector<const toml::node*> values_of(const toml::node& node, std::string_view key) const;
  void read_steps(const toml::node& node, SweepRequest& request) const;
  void read_accuracies(const toml::node& node, SweepRequest& request) const;
};

}  // namespace fde::bench
