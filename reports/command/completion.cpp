// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/reports/command/help_text.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

// The symbols of assets.S for each script: its first byte, and one past its last.
#define FDE_SHELL(id) extern "C" const char fde_asset_completion_##id[], fde_asset_completion_##id##_end[];
#include "fdebench/reports/command/shells.def"
#undef FDE_SHELL

namespace fde::bench {
namespace {

// Lines of candidates that begin with a word. What precedes that word in its argument, as "--scheme=",
// precedes the candidates too.
class Candidates {
 public:
  explicit Candidates(std::string begin, std::string prefix)
      : begin_(std::move(begin)), prefix_(std::move(prefix)) {}

  void add(std::string_view word, std::string_view what) {
    if (word.starts_with(begin_)) text_ += fmt::format("{}{}\t{}\n", prefix_, word, what);
  }
  void add_files(std::string_view ending) { text_ += fmt::format("\t{}\n", ending); }
  [[nodiscard]] const std::string& begin() const { return begin_; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string begin_, prefix_, text_;
};

void add_names(const ProgramText& program, Candidates& found) {
  for (const auto& subcommand : program.subcommands) found.add(subcommand.name, subcommand.what);
}

// PREFIX + NAME= for each parameter of the scene with this id, and for its end.
void add_settings(const std::string& id, const std::string& prefix, const SceneRegistry& known,
                  Candidates& found) {
  for (const auto& parameter : known.named(id).parameters)
    found.add(prefix + parameter.name + "=", parameter.description);
  found.add(prefix + "until=", "the end of the time interval");
}

// Built-in scenes and those of the user's folder; after ID: the parameters.
void add_scenes(const SceneRegistry& known, Candidates& found) {
  const auto& begin = found.begin();
  if (const auto colon = begin.find(':'); colon != std::string::npos) {
    const auto prefix = begin.substr(0, begin.find_last_of(":,") + 1);
    return add_settings(begin.substr(0, colon), prefix, known, found);
  }
  for (const auto& scene : known) found.add(scene.id, scene.title);
  for (const auto& name : names_in_scene_folder()) found.add(name, "an equation file");
  found.add_files(equation_file_extension);
}

// The settings of the first scene among the words.
void add_settings(const std::vector<std::string>& words, const SceneRegistry& known, Candidates& found) {
  const auto mine = names_in_scene_folder();
  for (const auto& word : words) {
    const auto id = word.substr(0, word.find(':'));
    if (find_scene(id, known) != nullptr || id.ends_with(equation_file_extension) ||
        std::ranges::find(mine, id) != mine.end())
      return add_settings(id, "", known, found);
  }
}

void add_values(const ProgramText& program, const ArgumentText& argument,
                const std::vector<std::string>& words, const SceneRegistry& known, Candidates& found) {
  if (const auto* choices = std::get_if<Words>(&argument.allowed))
    for (const auto& word : *choices) found.add(word, argument.name);
  const auto* offered = std::get_if<Completion>(&argument.allowed);
  switch (offered == nullptr ? Completion::nothing : *offered) {
    case Completion::nothing:
      break;
    case Completion::scene:
      add_scenes(known, found);
      break;
    case Completion::scheme:
      for (const auto& scheme : schemes()) found.add(scheme.id, scheme.title);
      break;
    case Completion::setting:
      add_settings(words, known, found);
      break;
    case Completion::grid:
      for (const auto* grid : {"uniform", "graded:", "graded:auto"}) found.add(grid, argument.name);
      break;
    case Completion::results:
      found.add_files(".jsonl");
      break;
    case Completion::file:
      found.add_files("");
      break;
    case Completion::folder:
      found.add_files("/");
      break;
    case Completion::topic:
      for (const auto& topic : topics()) found.add(topic.name, topic.what);
      add_names(program, found);
      break;
  }
}

// The names of an option: "-q,--quiet" has two.
void add_option(const ArgumentText& argument, Candidates& found) {
  const auto comma = argument.name.find(',');
  found.add(argument.name.substr(comma == std::string::npos ? 0 : comma + 1), argument.what);
  if (comma != std::string::npos) found.add(argument.name.substr(0, comma), argument.what);
}

// The argument whose value comes after these words of a subcommand: of an option without its value, or the
// next positional one. nullptr: none.
const ArgumentText* argument_at_end(const SubcommandText& subcommand, const std::vector<std::string>& words) {
  std::vector<const ArgumentText*> positional;
  for (const auto& argument : subcommand.arguments)
    if (argument.is_positional()) positional.push_back(&argument);
  const ArgumentText* open = nullptr;
  std::size_t next = 0;
  for (const auto& word : words) {
    if (open != nullptr) {
      open = nullptr;
    } else if (word.starts_with("--")) {
      const auto* option = subcommand.find(word);
      if (option != nullptr && !option->value.empty()) open = option;
    } else if (next < positional.size() && !positional[next]->repeated) {
      ++next;
    }
  }
  if (open != nullptr) return open;
  return next < positional.size() ? positional[next] : nullptr;
}

}  // namespace

std::string candidates(const ProgramText& program, std::vector<std::string> words,
                       const SceneRegistry& known) {
  std::string last, prefix;
  if (!words.empty()) {
    last = words.back();
    words.pop_back();
  }
  if (const auto equals = last.find('='); last.starts_with("--") && equals != std::string::npos) {
    words.push_back(last.substr(0, equals));
    prefix = last.substr(0, equals + 1);
    last = last.substr(equals + 1);
  }
  Candidates found(last, prefix);
  const auto name = std::ranges::find_if(words, [](const auto& word) { return !word.starts_with('-'); });
  if (name == words.end()) {
    add_names(program, found);
    for (const auto& option : common_options()) add_option(option, found);
    found.add("--version", "print the version");
    return found.text();
  }
  const auto* const subcommand = program.find(*name);
  if (subcommand == nullptr) return {};
  const std::vector<std::string> given(name + 1, words.end());
  const auto* const argument = argument_at_end(*subcommand, given);
  const bool is_value = argument != nullptr && !argument->is_positional();
  if (is_value || (argument != nullptr && !last.starts_with('-'))) {
    add_values(program, *argument, given, known, found);
  } else if (last.starts_with('-')) {
    for (const auto& option : subcommand->arguments)
      if (!option.is_positional()) add_option(option, found);
    for (const auto& option : common_options()) add_option(option, found);
  }
  return found.text();
}

const std::vector<std::string>& completion_shells() {
  static const std::vector<std::string> shells{
#define FDE_SHELL(id) #id,
#include "fdebench/reports/command/shells.def"
#undef FDE_SHELL
  };
  return shells;
}

std::string completion_script(const std::string& program, std::string_view shell) {
  std::string text;
#define FDE_SHELL(id) \
  if (shell == #id) text.assign(fde_asset_completion_##id, fde_asset_completion_##id##_end);
#include "fdebench/reports/command/shells.def"
#undef FDE_SHELL
  constexpr std::string_view place = "NAME";
  for (auto at = text.find(place); at != std::string::npos; at = text.find(place, at + program.size()))
    text.replace(at, place.size(), program);
  return text;
}

}  // namespace fde::bench
