// SPDX-License-Identifier: MIT
#pragma once

#include <toml++/toml.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/expressions/sampled_function.hpp"

namespace fde::bench {

// The tables [table.NAME] of a file with these parameters and unknowns, as functions; file and text as in
// TomlReader. Samples are in the file, or in a CSV file beside it: a header, then lines with an argument and
// a value. Throws std::invalid_argument naming the file, the line and the column, the value and what is
// allowed; the column of a CSV file is the number of the cell.
std::vector<std::shared_ptr<const SampledFunction>> read_tables(const std::string& file,
                                                                std::string_view text, const toml::node& node,
                                                                const EquationText& others);

// Replaces, in the TOML of a file, the name of a CSV file by its samples.
void write_samples(toml::table& all, const std::vector<std::shared_ptr<const SampledFunction>>& tables);

}  // namespace fde::bench
