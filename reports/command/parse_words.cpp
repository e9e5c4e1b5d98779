// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "fdebench/benchmarks/text/entry_named.hpp"
#include "fdebench/reports/command/given.hpp"

namespace fde::bench {
namespace {

// What other programs call our options.
constexpr std::array<std::pair<std::string_view, std::string_view>, 20> foreign_options{
    {{"--h", "--steps"},        {"--dt", "--steps"},       {"--step", "--steps"},    {"--n", "--steps"},
     {"--N", "--steps"},        {"--rtol", "--accuracy"},  {"--atol", "--accuracy"}, {"--tol", "--accuracy"},
     {"--accuracy", "--error"}, {"--error", "--accuracy"}, {"--tspan", "--until"},   {"--t_end", "--until"},
     {"--end", "--until"},      {"--T", "--until"},        {"--method", "--scheme"}, {"--solver", "--scheme"},
     {"--output", "--out"},     {"--times", "--at"},       {"--parameter", "--set"}, {"--param", "--set"}}};

std::string suggestion(const SubcommandText& command, std::string_view name) {
  for (const auto& [foreign, own] : foreign_options)
    if (name == foreign && command.find(own) != nullptr) return fmt::format("; here it is {}", own);
  std::vector<std::string_view> options{"--quiet", "--help"};
  for (const auto& argument : command.arguments)
    if (!argument.is_positional()) options.emplace_back(argument.name);
  const auto meant = did_you_mean(name, options);
  const bool has_parameters = meant.empty() && command.find("--set") != nullptr;
  return has_parameters ? "; a parameter of the scene is set by --set NAME=VALUE" : meant;
}

// "-1" and "-.5" are numbers, "-" is standard input.
bool is_option(std::string_view word) {
  return word.size() > 1 && word.starts_with('-') && (word[1] < '0' || word[1] > '9') && word[1] != '.';
}

class Parser {
 public:
  Parser(const SubcommandText& command, bool& quiet) : command_(command), refusing_(command), quiet_(quiet) {
    for (const auto& argument : command.arguments)
      if (argument.is_positional()) positional_.push_back(&argument);
  }

  Given parse(std::span<const std::string> words) {
    bool has_options = true;
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (has_options && words[i] == "--") {
        has_options = false;
      } else if (has_options && is_option(words[i])) {
        i += take_option(words[i], words.subspan(i + 1));
      } else {
        take_word(words[i]);
      }
    }
    check_given();
    check_alternatives();
    if (!rest_.empty()) {
      const bool is_setting = rest_.find('=') != std::string::npos && command_.find("--set") != nullptr;
      refusing_.refuse(fmt::format("{}: {} takes no such argument{}", rest_, command_.name,
                                   is_setting ? fmt::format("; --set {} sets a parameter", rest_) : ""));
    }
    return Given(command_, std::move(texts_));
  }

 private:
  // How many of the next words belong to an option.
  std::size_t take_option(const std::string& word, std::span<const std::string> next) {
    list_ = nullptr;
    const auto equals = word.find('=');
    const auto name = word.substr(0, equals);
    const bool is_quiet = name == "-q" || name == "--quiet";
    const auto* const argument = command_.find(name);
    if (argument == nullptr && !is_quiet) {
      if (name.starts_with("--")) {
        refusing_.refuse(
            fmt::format("{}: {} has no such option{}", name, command_.name, suggestion(command_, name)));
      }
      return take_rest(word);
    }
    if (is_quiet || argument->value.empty()) {
      if (equals != std::string::npos) refusing_.refuse(fmt::format("{}: takes no value", name));
      is_quiet ? void(quiet_ = true) : void(texts_[name] = {"yes"});
      return 0;
    }
    auto& texts = texts_[name];
    if (!texts.empty() && !argument->repeated) refusing_.refuse(fmt::format("{}: must be given once", name));
    const bool is_inside = equals != std::string::npos && equals + 1 < word.size();
    if (!is_inside && (equals != std::string::npos || next.empty())) {
      refusing_.refuse(fmt::format("{}: its value is missing: {}, {}", name, argument->value,
                                   full_description(*argument)));
    }
    texts.push_back(is_inside ? word.substr(equals + 1) : next.front());
    if (argument->repeated) list_ = &texts;
    return is_inside ? 0 : 1;
  }

  // The next positional argument; where there is none another value of the option before.
  void take_word(const std::string& word) {
    if (next_ < positional_.size()) {
      texts_[positional_[next_]->name].push_back(word);
      if (!positional_[next_]->repeated) ++next_;
    } else if (list_ != nullptr) {
      list_->push_back(word);
    } else {
      take_rest(word);
    }
  }

  std::size_t take_rest(const std::string& word) {
    if (rest_.empty()) rest_ = word;
    return 0;
  }

  void check_given() const {
    for (const auto& argument : command_.arguments) {
      if (argument.required && argument.choice == 0 && !texts_.contains(argument.name)) {
        refusing_.refuse(
            fmt::format("{} is required: {}, {}", argument.name, argument.value, full_description(argument)));
      }
    }
  }

  // Where a positional argument is one of them, the command refuses the others in its own words.
  void check_alternatives() const {
    const ArgumentText* first = nullptr;
    for (const auto& argument : command_.arguments) {
      if (argument.choice == 0 || argument.is_positional() || !texts_.contains(argument.name)) continue;
      if (first != nullptr && first->choice == argument.choice)
        refusing_.refuse(fmt::format("{} excludes {}", first->name, argument.name));
      first = &argument;
    }
  }

  const SubcommandText& command_;
  Given refusing_;
  bool& quiet_;
  std::vector<const ArgumentText*> positional_{};
  std::size_t next_ = 0;
  Given::Texts texts_{};
  std::vector<std::string>* list_ = nullptr;  // of the repeated option whose value was read last
  std::string rest_{};                        // the first word that belongs to nothing
};

}  // namespace

std::optional<Given> parse_words(const SubcommandText& command, std::span<const std::string> words,
                                 bool& quiet) {
  const auto options = words.first(static_cast<std::size_t>(std::ranges::find(words, "--") - words.begin()));
  if (std::ranges::find(options, "--help") != options.end() ||
      std::ranges::find(options, "-h") != options.end())
    return std::nullopt;
  return Parser(command, quiet).parse(words);
}

}  // namespace fde::bench
