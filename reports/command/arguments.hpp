#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "command/command_line.hpp"
#include "records/setup.hpp"
#include "scenes/variant.hpp"
#include "stepping/scheme.hpp"

namespace fde {

// Texts of the command line into values. Each throws std::invalid_argument naming the argument, the text and
// what is allowed.

// "1", "-2.5i", "1e-3+i" into the texts of real and imaginary part; the parts are not checked.
struct ComplexText {
  std::string re, im;
};
ComplexText split_complex(std::string_view text);

const Scheme& scheme_named(std::string_view id);

// What `solve` and `run` say of how a scheme runs.
struct MeansArguments {
  std::string grid = "uniform", history = "auto", budget;
  std::optional<std::string> tolerance{};
};
void add_options(Subcommand& command, MeansArguments& arguments);
Setup parse_means(const MeansArguments& arguments);

Accuracy parse_accuracy(std::string_view text);  // one number, relative and absolute

inline constexpr int most_digits = 100'000;
inline constexpr int most_steps = 1'000'000'000;  // weights are checked up to this lag

}  // namespace fde
