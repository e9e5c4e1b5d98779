// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace fde::bench {

// How to write here what formulas of MATLAB, Python, Mathematica or C contain, as the end of a message: ";
// here it is sign(x)". Empty where nothing is known.

// The name of a function that does not exist here.
std::string function_hint(std::string_view name);
// A name that is no function.
std::string name_hint(std::string_view name);
// A key of an equation file.
std::string key_hint(std::string_view name);
// The text from a symbol on that is not allowed at its place. `follows_number`, `follows_value`: whether it
// stands behind a number, or behind a number, a name or a closing bracket.
std::string symbol_hint(std::string_view from, bool follows_number, bool follows_value);

}  // namespace fde::bench
