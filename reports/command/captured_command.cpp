// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/captured_command.hpp"

#include <sstream>
#include <stdexcept>
#include <string_view>

#include "fdebench/reports/command/command.hpp"

namespace fde::bench {

std::string output_of(const std::vector<std::string>& arguments, const SceneRegistry& known) {
  std::ostringstream out, err;
  const int code = run_fdebench(arguments, {.out = out, .err = err}, known);
  if (code == 0) return out.str();
  std::string line = err.str();
  if (line.ends_with('\n')) line.pop_back();
  line = line.substr(line.find_last_of('\n') + 1);
  constexpr std::string_view speaker = "fdebench: ";
  if (line.starts_with(speaker)) line = line.substr(speaker.size());
  constexpr int bad_input_code = 2;
  if (code == bad_input_code) throw std::invalid_argument(line);
  throw NumericalFailure(line);
}

std::string without_dashes(std::string text) {
  for (auto at = text.find("--"); at != std::string::npos; at = text.find("--", at)) {
    const bool begins_option = at == 0 || text[at - 1] == ' ';
    if (begins_option) text.erase(at, 2);
    at += 1;
  }
  return text;
}

}  // namespace fde::bench
