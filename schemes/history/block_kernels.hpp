#pragma once

#include <string_view>
#include <vector>

#include "problem/problem.hpp"

namespace fde {

// The loops in which a history spends its time, compiled for every vector width of the architecture and
// chosen once at run time (Highway), so that no -march flag is needed. Each entry of a result adds its terms
// in the same order whatever the width: all widths with a fused multiply-add give the same bits; without one
// the results differ by rounding.
//
// Matrices are stored by columns; their rows are a multiple of lanes and start on a multiple of 64 bytes.

inline constexpr Eigen::Index lanes = 8;

// A matrix, or a part of one: where it starts, and how far its columns lie apart. Whole matrices and vectors
// convert.
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

// The values, with `fill` added to make a whole number of vectors.
Vec padded(const Vec& values, double fill);

// c += a b for a of rows x inner, b of inner x columns.
void multiply_add(Eigen::Index rows, Eigen::Index inner, Eigen::Index columns, ConstBlock a, ConstBlock b,
                  Block c);

// Eight entries of each column j of c += a * b[j], and the same of so many tables: the next eight of a belong
// to the rows of c that lie so far below.
void scatter(Eigen::Index tables, const double* a, const double* b, Eigen::Index columns, Eigen::Index below,
             Block c);

// result = factors * values + scale * others, `rows` entries of each, every product rounded.
void weigh(Eigen::Index rows, const double* factors, const double* values, double scale, const double* others,
           double* result);

// state + carry += state * (decay - 1) + input, where state stays the rounded sum: the carry keeps what
// rounding took, so that slow decays over many calls lose nothing. decay_minus_one and the columns of the
// others have `rows` entries.
void advance(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock input,
             Block state, Block carry);

// The same where a decay belongs to a column.
void advance_columns(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock input,
                     Block state, Block carry);

// The same with the input sum_k phi_k p_k of each column, phi of three columns and polynomials of three rows.
void advance_integrals(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock phi,
                       ConstBlock polynomials, Block state, Block carry);

// decayed = values * decay.
void apply_decay(Eigen::Index rows, const double* values, const double* decay_minus_one, double* decayed);

// The dot product of two arrays of any length and alignment.
double dot_product(const double* a, const double* b, Eigen::Index length);

// phi_k(x) = sum_i (-x)^i / (i + k)!, k = 1, 2, 3, at x = length * node: the integrals of exp(-x (1 - w))
// w^(k-1) / (k-1)! over w in [0, 1], one column of phi a k; and exp(-x) - 1. Good to a few units in the last
// place. Nodes are not negative and do not decrease.
void phi_functions(Eigen::Index rows, double length, const double* nodes, Block phi, double* decay_minus_one);

// The instruction sets that this build has code for and this machine runs, the widest first: that one is
// used.
std::vector<std::string_view> vector_targets();

// Uses another one of them from now on, for tests and benchmarks. Not while another thread computes. Throws
// std::invalid_argument naming it when there is none of this name.
void use_vector_target(std::string_view name);

}  // namespace fde
