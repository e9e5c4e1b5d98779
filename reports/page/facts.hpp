// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <initializer_list>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/reports/page/page_data.hpp"

// What the page says, as JSON without words: the page's templates make sentences and cells of it.
namespace fde::bench {

// A number of the page: a whole one as it is, any other to eight digits. null without a finite value.
nlohmann::json fact(const std::optional<double>& value);

// A number of a chart, with as many digits as it can show: a page has thousands of these. null without a
// value.
inline constexpr int chart_digits = 5, few_digits = 3;
nlohmann::json chart_number(const std::optional<double>& value, int digits = chart_digits);

// Texts by their places, so that facts name them by numbers.
class Places {
 public:
  std::size_t operator()(const std::string& text) {
    const auto [found, is_new] = places_.try_emplace(text, texts_.size());
    if (is_new) texts_.push_back(text);
    return found->second;
  }
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::map<std::string, std::size_t> places_{};
  std::vector<std::string> texts_{};
};

// The value without the members of its objects that are null, false or empty: a template leaves out what it
// does not find. Elements of lists are kept.
nlohmann::json compact(nlohmann::json value);

// A run: `line`, `grid` if the line's name omits it, `steps`, `wall_clock`, and the named quantities.
nlohmann::json run_facts(const PageInput& page, const Record& run,
                         std::initializer_list<std::string_view> quantities);

// The same of a recommended run, with `error`, `requested` (tolerance, with adaptive step size), the time
// `seconds` and its interval `low`, `high`, `first_seconds` of the first run of a process if that takes
// longer (or `later_seconds` if `seconds` is of the first), and `session` from 1 on if there are several.
nlohmann::json run_facts(const PageInput& page, const RecommendedRun& option);

// How a run ended: `ending`, the id of its outcome, and `detail`.
nlohmann::json ending_facts(const RunOutcome& outcome);

// The number of a session, from 1 on; null if there is only one.
nlohmann::json session_number(const PageInput& page, std::size_t index);

}  // namespace fde::bench
