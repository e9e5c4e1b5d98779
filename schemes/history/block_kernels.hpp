// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// The inner loops of the histories, compiled for every vector width of the architecture and selected once at
// run time (Highway), so that no -march flag is needed. Each entry of a result adds its terms in the same
// order for every width: all widths with a fused multiply-add give the same bits; without one the results
// differ by rounding.
//
// Preconditions: matrices are stored by columns, the number of rows is a multiple of lanes, and columns are
// aligned to 64 bytes.

inline constexpr Eigen::Index lanes = 8;

// The smallest multiple of `of` that is not below count >= 0.
constexpr Eigen::Index rounded_up(Eigen::Index count, Eigen::Index of = lanes) {
  return (count + of - 1) / of * of;
}

// A view of a column-major matrix or of a part of one: the first entry and the distance between columns.
// Whole matrices and vectors convert.
struct Block {
  Block(double* first, Eigen::Index column_stride) : data(first), stride(column_stride) {}
  Block(Matrix& whole) : Block(whole.data(), whole.rows()) {}
  Block(Vec& whole) : Block(whole.data(), whole.size()) {}
  double* data;
  Eigen::Index stride;
};
struct ConstBlock {
  ConstBlock(const Block& block) : data(block.data), stride(block.stride) {}
  ConstBlock(const double* first, Eigen::Index column_stride) : data(first), stride(column_stride) {}
  ConstBlock(const Matrix& whole) : ConstBlock(whole.data(), whole.rows()) {}
  ConstBlock(const Vec& whole) : ConstBlock(whole.data(), whole.size()) {}
  const double* data;
  Eigen::Index stride;
};

// The values, padded with `fill` to a multiple of lanes.
Vec padded(const Vec& values, double fill);

// c += a b for a of size rows x inner and b of size inner x columns.
void multiply_add(Eigen::Index rows, Eigen::Index inner, Eigen::Index columns, ConstBlock a, ConstBlock b,
                  Block c);

// Adds a[8 i ... 8 i + 7] * b[j] to the eight rows of c from row i * below on, in every column j < columns,
// for i = 0 ... tables - 1.
void add_outer_product(Eigen::Index tables, const double* a, const double* b, Eigen::Index columns,
                       Eigen::Index below, Block c);

// result = factors * values + scale * others, entry by entry, `rows` entries each; every product is rounded.
void weighted_sum(Eigen::Index rows, const double* factors, const double* values, double scale,
                  const double* others, double* result);

// Compensated update state + carry += state * (decay - 1) + input: state is the rounded sum and carry its
// rounding error, so that slow decays lose no accuracy over many calls. decay_minus_one and the columns of
// the other arguments have `rows` entries.
void advance_states(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock input,
                    Block state, Block carry);

// The same with one decay per column.
void advance_columns(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock input,
                     Block state, Block carry);

// As advance_states, with the input sum_k phi_k p_k in each column; phi is rows x 3, polynomials 3 x columns.
void advance_integrals(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock phi,
                       ConstBlock polynomials, Block state, Block carry);

// decayed = values * decay, entry by entry.
void apply_decay(Eigen::Index rows, const double* values, const double* decay_minus_one, double* decayed);

// The dot product of two arrays of any length and alignment.
double dot_product(const double* a, const double* b, Eigen::Index length);

// phi_k(x) = sum_i (-x)^i / (i + k)!, k = 1, 2, 3, at x = length * node: the integrals of exp(-x (1 - w))
// w^(k-1) / (k-1)! over w in [0, 1], one column of phi per k; and exp(-x) - 1. Accurate to a few units in the
// last place. Precondition: nodes are nonnegative and do not decrease.
void phi_functions(Eigen::Index rows, double length, const double* nodes, Block phi, double* decay_minus_one);

// The instruction sets that this build has code for and this machine supports, the widest first. The first is
// the default.
std::vector<std::string_view> vector_targets();

// Selects one of vector_targets(), for tests and benchmarks. Not thread-safe. Throws std::invalid_argument
// naming the target where there is none of this name.
void select_vector_target(std::string_view name);

}  // namespace fde
