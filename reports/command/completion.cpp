// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/scenes/equation_file_name.hpp"
#include "fdebench/reports/command/topics.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

// Lines of candidates that begin with a word.
class Candidates {
 public:
  explicit Candidates(std::string begin) : begin_(std::move(begin)) {}

  void add(std::string_view word, std::string_view what) {
    if (word.starts_with(begin_)) text_ += fmt::format("{}\t{}\n", word, what);
  }
  void add_files(std::string_view ending) { text_ += fmt::format("\t{}\n", ending); }
  [[nodiscard]] const std::string& begin() const { return begin_; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string begin_, text_;
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
  for (const auto& word : argument.offered) found.add(word, argument.name);
  switch (argument.completion) {
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
      [[fallthrough]];
    case Completion::command:
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

}  // namespace

std::string candidates(const ProgramText& program, const std::vector<std::string>& words,
                       const SceneRegistry& known) {
  Candidates found(words.empty() ? "" : words.back());
  const std::vector<std::string> before(words.begin(), words.empty() ? words.end() : words.end() - 1);
  const auto name = std::ranges::find_if(before, [](const auto& word) { return !word.starts_with('-'); });
  if (name == before.end()) {
    add_names(program, found);
    for (const auto& option : common_options()) add_option(option, found);
    found.add("--version", "print the version");
    return found.text();
  }
  const auto* const subcommand = program.find(*name);
  if (subcommand == nullptr) return {};
  // Which argument the last word is the value of.
  const ArgumentText* open = nullptr;
  std::vector<const ArgumentText*> positional;
  for (const auto& argument : subcommand->arguments)
    if (argument.is_positional()) positional.push_back(&argument);
  std::size_t next = 0;
  for (auto word = name + 1; word != before.end(); ++word) {
    if (open != nullptr) {
      open = nullptr;
    } else if (word->starts_with("--")) {
      const auto option = std::ranges::find(subcommand->arguments, *word, &ArgumentText::name);
      if (option != subcommand->arguments.end() && !option->value.empty()) open = &*option;
    } else if (next < positional.size() && !positional[next]->repeated) {
      ++next;
    }
  }
  if (open != nullptr) {
    add_values(program, *open, {name + 1, before.end()}, known, found);
    return found.text();
  }
  if (found.begin().starts_with('-')) {
    for (const auto& argument : subcommand->arguments)
      if (!argument.is_positional()) add_option(argument, found);
    for (const auto& option : common_options()) add_option(option, found);
    return found.text();
  }
  if (next < positional.size()) add_values(program, *positional[next], before, known, found);
  return found.text();
}

const std::vector<std::string>& completion_shells() {
  static const std::vector<std::string> shells{"bash", "zsh", "fish"};
  return shells;
}

std::string completion_script(const std::string& program, std::string_view shell) {
  // In bash ":" and "=" end a word; the words of the command line are put together again, and what a
  // candidate has before the last of them is cut off.
  constexpr auto bash = R"(# bash completion for NAME
_NAME() {
  local line="${COMP_LINE:0:COMP_POINT}" word what current cut
  local -a words
  read -r -a words <<< "$line"
  [[ $line == *[[:space:]] ]] && words+=("")
  current="${words[${#words[@]}-1]}"
  cut="${current%"${current##*[:=]}"}"
  COMPREPLY=()
  while IFS= read -r word; do
    what="${word#*$'\t'}" word="${word%%$'\t'*}"
    if [[ -n $word ]]; then
      COMPREPLY+=("${word#"$cut"}")
      [[ $word == *= ]] && compopt -o nospace
    elif [[ $what == / ]]; then
      compopt -o filenames
      while IFS= read -r word; do COMPREPLY+=("$word"); done < <(compgen -d -- "$current")
    else
      compopt -o filenames
      while IFS= read -r word; do
        [[ -d $word || $word == *"$what" ]] && COMPREPLY+=("$word")
      done < <(compgen -f -- "$current")
    fi
  done < <("${words[0]}" __complete "${words[@]:1}" 2>/dev/null)
}
complete -F _NAME NAME
)";
  constexpr auto zsh = R"(#compdef NAME
local line word what
local -a found
while IFS= read -r line; do
  word=${line%%$'\t'*} what=${line#*$'\t'}
  if [[ -n $word ]]; then
    found+=("${word//:/\\:}:$what")
  elif [[ $what == / ]]; then
    _files -/
  elif [[ -n $what ]]; then
    _files -g "*$what"
  else
    _files
  fi
done < <("${words[1]}" __complete "${(@)words[2,CURRENT]}" 2>/dev/null)
(( $#found )) && _describe NAME found
)";
  constexpr auto fish = R"(# fish completion for NAME
function __NAME_candidates
    set -l words (commandline -opc) (commandline -ct)
    for line in ($words[1] __complete $words[2..-1] 2>/dev/null)
        set -l parts (string split -m 1 \t -- $line)
        if test -n "$parts[1]"
            echo $line
        else if test "$parts[2]" = /
            __fish_complete_directories (commandline -ct)
        else
            __fish_complete_suffix (commandline -ct) $parts[2]
        end
    end
end
complete -c NAME -f -a '(__NAME_candidates)'
)";
  const auto& shells = completion_shells();
  std::string text = shell == shells[0] ? bash : shell == shells[1] ? zsh : fish;
  constexpr std::string_view place = "NAME";
  for (auto at = text.find(place); at != std::string::npos; at = text.find(place, at + program.size()))
    text.replace(at, place.size(), program);
  return text;
}

}  // namespace fde::bench
