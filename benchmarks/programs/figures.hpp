// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

// What prints the tables and figures of the pages in docs, each in a file of its name: fde_figures NAME
// [WORD]...
namespace fde::bench::figures {

using Words = std::vector<std::string>;

// docs/history.md: the sum of exponentials of the memory term, and the weights that it replaces.
void exponentials(const Words& words);
void weight_floor(const Words& words);

// docs/large.md.
void large(const Words& words);

// docs/references.md.
void function_times(const Words& words);
void two_methods(const Words& words);

// What `choose` recommends: held against all runs, and what docs/which_scheme.md shows.
void choices(const Words& given);
void winners(const Words& scenes);

// docs/stability.md.
void stability_boundaries(const Words& words);
void stability_chain_steps(const Words& words);
void stability_tables(const Words& words);

}  // namespace fde::bench::figures
