// SPDX-License-Identifier: MIT
#pragma once

// All functions of the library fdebench::special_functions: the Mittag-Leffler function E_{alpha,beta} of
// complex numbers and of matrices, its derivatives, and the three-parameter function of Prabhakar, each with
// a bound of the error. docs/special_functions.md is the page.
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/mittag_leffler_matrix.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar.hpp"
