// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>
#include <utility>

#include "fdebench/c/guard.hpp"
#include "fdebench/c/handles.hpp"

using namespace fde::bench::c;

namespace {

constexpr auto choice_handle = "a handle of fdebench_choose";

const nlohmann::json& facts_of(const fdebench_choice* choice) {
  return given("choice", choice, choice_handle).facts;
}

}  // namespace

int fdebench_choose(const fdebench_problem* problem, const fdebench_options* options,
                    fdebench_choice** choice) {
  return guarded([&] {
    auto& result = given("choice", choice);
    const auto& handle = given("problem", problem, problem_handle);
    std::vector<std::string> words{"--json"};
    for (const auto& [name, text] : given("options", options, options_handle).texts)
      words.push_back(fmt::format("--{}={}", name, text));
    const auto text = output_for(handle, "choose", words);
    auto facts = nlohmann::json::parse(text);
    if (handle.scene.empty()) facts["command"] = nullptr;  // no command knows the problem
    facts["json"] = facts.dump();
    result = std::make_unique<FdebenchChoice>(FdebenchChoice{std::move(facts)}).release();
  });
}

int fdebench_choice_number(const fdebench_choice* choice, const char* fact, double* number) {
  return guarded([&] {
    const auto& facts = facts_of(choice);
    given("number", number) = number_in(facts, text_of("fact", fact));
  });
}

int fdebench_choice_text(const fdebench_choice* choice, const char* fact, const char** text) {
  return guarded([&] {
    const auto& facts = facts_of(choice);
    given("text", text) = text_in(facts, text_of("fact", fact));
  });
}

int fdebench_choice_apply(const fdebench_choice* choice, fdebench_options* options) {
  return guarded([&] {
    const auto& facts = facts_of(choice);
    auto texts = given("options", options, options_handle).texts;
    for (const char* name :
         {"accuracy", "steps", "grid", "error", "norm", "scale", "columns", "runs", "max-time"})
      texts.erase(name);
    if (const double asked = number_in(facts, "asked"); !std::isnan(asked)) {
      texts["accuracy"] = fmt::format("{}", asked);
    } else {
      texts["steps"] = facts.at("steps").dump();
      texts["grid"] = text_in(facts, "grid");
    }
    options->texts = std::move(texts);
  });
}

void fdebench_choice_free(fdebench_choice* choice) { delete choice; }
