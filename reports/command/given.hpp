// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/requests/solve_request.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"
#include "fdebench/reports/command/program_text.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// What a command is given: texts by the names of its arguments, "scene" or "--steps". Its functions throw
// std::logic_error for a name that the command does not declare. Those that parse a text take what the
// declaration allows and throw std::invalid_argument naming the argument, the text and what is allowed.
class Given {
 public:
  using Texts = std::map<std::string, std::vector<std::string>, std::less<>>;
  explicit Given(SubcommandText command, Texts texts = {});

  [[nodiscard]] bool has(std::string_view name) const;
  [[nodiscard]] std::string text(std::string_view name) const;  // without one the default
  [[nodiscard]] std::optional<std::string> find(std::string_view name) const;
  [[nodiscard]] const std::vector<std::string>& all(std::string_view name) const;

  [[nodiscard]] double number(std::string_view name) const;
  [[nodiscard]] std::optional<double> find_number(std::string_view name) const;
  [[nodiscard]] std::vector<double> numbers(std::string_view name) const;
  [[nodiscard]] int count(std::string_view name) const;
  [[nodiscard]] std::optional<int> find_count(std::string_view name) const;
  [[nodiscard]] std::string word(std::string_view name) const;

  // Throws std::invalid_argument with a message, and where the help of the command is.
  [[noreturn]] void refuse(const std::string& message) const;
  [[noreturn]] void refuse(std::string_view name, std::string_view allowed) const;  // the text of an argument
  // Throws the refusal with another word for each field: that of `words`, or --field if the command declares
  // it.
  [[noreturn]] void refuse(const Refusal& refusal,
                           const std::map<std::string, std::string>& words = {}) const;

 private:
  [[nodiscard]] const ArgumentText& declared(std::string_view name) const;

  SubcommandText command_;
  Texts texts_;
};

// The words after the name of a command, parsed; nullopt where they ask for help. An option takes the next
// word or what follows its "="; behind "--" all words are positional. Sets `quiet` for --quiet. Throws
// std::invalid_argument where words are unknown, missing, repeated or exclude each other.
std::optional<Given> parse_words(const SubcommandText& command, std::span<const std::string> words,
                                 bool& quiet);

// Declarations that several commands have.
ArgumentText scene_argument(const std::string& what = "id of a scene");
std::vector<ArgumentText> run_settings_arguments(
    const std::string& budget);  // --grid, --history, --tolerance, --budget
ArgumentText set_argument();
ArgumentText digits_argument();
ArgumentText evaluation_budget_argument();
ArgumentText runs_argument();
ArgumentText plain_names_argument();
ArgumentText until_argument();
// Lists of declarations in one.
std::vector<ArgumentText> joined(std::initializer_list<std::vector<ArgumentText>> lists);

// The scene that the arguments `scene` and --set name.
SceneVariant read_variant(const Given& given, const SceneRegistry& known);

// For --grid graded:auto the grading is 1 here: it depends on scheme and scene (optimal_grading).
RunSettings parse_run_settings(const Given& given);
inline constexpr auto uniform_grid = "uniform";

Tolerance parse_accuracy(std::string_view text);  // one number, relative and absolute

// Throws std::invalid_argument if the file that the argument `out` names is one that the command reads: one
// of these arguments, or a scene of the command.
void refuse_overwriting(const Given& given, std::string_view out,
                        std::initializer_list<std::string_view> read);

// Whether times are those of the first run of a process: --runs 1, otherwise many.
bool requests_first_run(const Given& given);

}  // namespace fde::bench
