// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/text/range.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

namespace fde::bench {

inline constexpr Range mittag_leffler_orders{.low = 0.0, .high = 5.0, .open_low = true};
inline constexpr Range mittag_leffler_parameters{.low = -reference::largest_parameter,
                                                 .high = reference::largest_parameter};

// What is asked of mittag_leffler(). Numbers are decimal texts, taken exactly, also beyond double; bounds of
// arguments are not read. A matrix is square, row by row.
struct MittagLefflerRequest {
  std::string alpha{}, beta = "1";
  std::variant<reference::DecimalComplex, std::vector<reference::DecimalComplex>> argument{};
  std::optional<int> derivative{};     // in z, without gamma and matrix
  std::optional<std::string> gamma{};  // Prabhakar's third parameter, without matrix
  std::optional<int> digits{};         // nullopt: doubles
};

// The value, or the entries of that of a matrix, row by row, with bounds. Those that double does not hold are
// infinite.
using MittagLefflerValues =
    std::variant<std::vector<reference::MittagLefflerValue>, std::vector<reference::DecimalComplex>>;

// E_{alpha,beta} of a number or a matrix, its derivative, or Prabhakar's function. Throws Refusal naming the
// field, and NumericalFailure where a value in digits is beyond all exponents.
MittagLefflerValues mittag_leffler(const MittagLefflerRequest& request);

}  // namespace fde::bench
