#pragma once

#include <Eigen/Core>

namespace fde {

// The loops in which a history spends its time, compiled for every vector width of the architecture and
// chosen once at run time (Highway), so that no -march flag is needed. Each entry of a result adds its terms
// in the same order whatever the width: all widths with a fused multiply-add give the same bits; without one
// the results differ by rounding.
//
// Matrices are stored by columns, with `rows` contiguous; rows are a multiple of lanes and start on a
// multiple of 64 bytes. Columns lie `stride` apart.

inline constexpr Eigen::Index lanes = 8;

struct Block {
  double* data;
  Eigen::Index stride;
};
struct ConstBlock {
  const double* data;
  Eigen::Index stride;
};

// c += a b for a of rows x inner, b of inner x columns.
void multiply_add(Eigen::Index rows, Eigen::Index inner, Eigen::Index columns, ConstBlock a, ConstBlock b,
                  Block c);

// The first eight entries of each column j of c += a * b[j].
void scatter(const double* a, const double* b, Eigen::Index columns, Block c);

// state + carry += state * (decay - 1) + input, where state stays the rounded sum: the carry keeps what
// rounding took, so that slow decays over many calls lose nothing. decay_minus_one and the columns of the
// others have `rows` entries.
void advance(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock input,
             Block state, Block carry);

// The dot product of two arrays of any length and alignment.
double dot_product(const double* a, const double* b, Eigen::Index length);

}  // namespace fde
