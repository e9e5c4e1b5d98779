// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/block_kernels.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fdebench/schemes/history/block_kernels.cpp"
#include <hwy/foreach_target.h>  // includes this file once for each target
#include <hwy/highway.h>
// clang-format off: after the target is chosen
#include <hwy/contrib/math/math-inl.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
static_assert(EIGEN_DEFAULT_ALIGN_BYTES >= 64, "the loads and stores below are aligned");

namespace fde::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, lanes>;
using Vector = hn::Vec<Tag>;
constexpr Tag tag;

// Vectors per column of a tile; the tile's accumulators are held in registers.
constexpr Eigen::Index tile_vectors = hn::MaxLanes(tag) == lanes ? 4 : 2;

// Rows [0, Vectors * width) of some columns of c += a b: entry e is vector e % Vectors of column e / Vectors.
// The expansion over the entries keeps all sums in registers.
template <Eigen::Index Vectors, Eigen::Index... Entries>
HWY_INLINE void tile(std::integer_sequence<Eigen::Index, Entries...> /*entries*/, Eigen::Index inner,
                     ConstBlock a, ConstBlock b, Block c) {
  constexpr Eigen::Index width = hn::MaxLanes(tag);
  const auto entry = [&](Eigen::Index e) { return c.data + e / Vectors * c.stride + e % Vectors * width; };
  std::array<Vector, sizeof...(Entries)> sum{hn::Load(tag, entry(Entries))...};
  for (Eigen::Index k = 0; k < inner; ++k) {
    const double *const left = a.data + k * a.stride, *const right = b.data + k;
    ((sum[Entries] = hn::MulAdd(hn::Load(tag, left + Entries % Vectors * width),
                                hn::Set(tag, right[Entries / Vectors * b.stride]), sum[Entries])),
     ...);
  }
  (hn::Store(sum[Entries], tag, entry(Entries)), ...);
}

template <Eigen::Index Vectors, Eigen::Index Columns>
HWY_INLINE void tile(Eigen::Index inner, ConstBlock a, ConstBlock b, Block c) {
  tile<Vectors>(std::make_integer_sequence<Eigen::Index, Vectors * Columns>(), inner, a, b, c);
}

template <Eigen::Index Columns>
HWY_INLINE void panel(Eigen::Index rows, Eigen::Index inner, ConstBlock a, ConstBlock b, Block c) {
  constexpr Eigen::Index width = hn::MaxLanes(tag), step = tile_vectors * width;
  const auto below = [](auto block, Eigen::Index row) {
    return decltype(block){block.data + row, block.stride};
  };
  Eigen::Index row = 0;
  for (; row + step <= rows; row += step) {
    tile<tile_vectors, Columns>(inner, below(a, row), b, below(c, row));
  }
  if constexpr (tile_vectors > 2) {
    for (; row + 2 * width <= rows; row += 2 * width)
      tile<2, Columns>(inner, below(a, row), b, below(c, row));
  }
  for (; row < rows; row += width) tile<1, Columns>(inner, below(a, row), b, below(c, row));
}

void multiply_add_kernel(Eigen::Index rows, Eigen::Index inner, Eigen::Index columns, ConstBlock a,
                         ConstBlock b, Block c) {
  constexpr Eigen::Index together = 4;
  while (columns > 0) {
    switch (std::min(columns, together)) {
      case 1:
        panel<1>(rows, inner, a, b, c);
        break;
      case 2:
        panel<2>(rows, inner, a, b, c);
        break;
      case 3:
        panel<3>(rows, inner, a, b, c);
        break;
      default:
        panel<together>(rows, inner, a, b, c);
    }
    columns -= together;
    b.data += together * b.stride;
    c.data += together * c.stride;
  }
}

void add_outer_product_kernel(Eigen::Index tables, const double* a, const double* b, Eigen::Index columns,
                              Eigen::Index below, Block c) {
  constexpr Eigen::Index width = hn::MaxLanes(tag);
  for (Eigen::Index table = 0; table < tables; ++table) {
    for (Eigen::Index row = 0; row < lanes; row += width) {
      const Vector left = hn::Load(tag, a + table * lanes + row);
      double* entry = c.data + table * below + row;
#if defined(__clang__)
#pragma clang loop unroll_count(4)
#else
#pragma GCC unroll 4
#endif
      for (Eigen::Index j = 0; j < columns; ++j, entry += c.stride)
        hn::Store(hn::MulAdd(left, hn::Set(tag, b[j]), hn::Load(tag, entry)), tag, entry);
    }
  }
}

void weighted_sum_kernel(Eigen::Index rows, const double* factors, const double* values, double scale,
                         const double* others, double* result) {
  constexpr Eigen::Index width = hn::MaxLanes(tag);
  const Vector scales = hn::Set(tag, scale);
  for (Eigen::Index row = 0; row < rows; row += width) {
    const Vector first = hn::Mul(hn::Load(tag, factors + row), hn::Load(tag, values + row));
    hn::Store(hn::Add(first, hn::Mul(scales, hn::Load(tag, others + row))), tag, result + row);
  }
}

// state + carry += decay_minus_one * state + input, with Knuth's TwoSum.
HWY_INLINE void advance_vector(Vector decay_minus_one, Vector input, double* state, double* carry) {
  const Vector old = hn::Load(tag, state), before = hn::Load(tag, carry);
  const Vector change = hn::Add(hn::MulAdd(decay_minus_one, old, input), before);
  const Vector sum = hn::Add(old, change), added = hn::Sub(sum, old);
  hn::Store(sum, tag, state);
  hn::Store(hn::Add(hn::Sub(old, hn::Sub(sum, added)), hn::Sub(change, added)), tag, carry);
}

void advance_states_kernel(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one,
                           ConstBlock input, Block state, Block carry) {
  constexpr Eigen::Index width = hn::MaxLanes(tag);
  for (Eigen::Index j = 0; j < columns; ++j) {
    for (Eigen::Index row = 0; row < rows; row += width) {
      advance_vector(hn::Load(tag, decay_minus_one + row), hn::Load(tag, input.data + j * input.stride + row),
                     state.data + j * state.stride + row, carry.data + j * carry.stride + row);
    }
  }
}

void advance_columns_kernel(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one,
                            ConstBlock input, Block state, Block carry) {
  constexpr Eigen::Index width = hn::MaxLanes(tag);
  for (Eigen::Index j = 0; j < columns; ++j) {
    const Vector decay = hn::Set(tag, decay_minus_one[j]);
    for (Eigen::Index row = 0; row < rows; row += width) {
      advance_vector(decay, hn::Load(tag, input.data + j * input.stride + row),
                     state.data + j * state.stride + row, carry.data + j * carry.stride + row);
    }
  }
}

// input = phi_1 p_0 + phi_2 p_1 + phi_3 p_2 in each column.
void advance_integrals_kernel(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one,
                              ConstBlock phi, ConstBlock polynomials, Block state, Block carry) {
  constexpr Eigen::Index width = hn::MaxLanes(tag);
  for (Eigen::Index j = 0; j < columns; ++j) {
    const double* const p = polynomials.data + j * polynomials.stride;
    const Vector constant = hn::Set(tag, p[0]), slope = hn::Set(tag, p[1]), bend = hn::Set(tag, p[2]);
    for (Eigen::Index row = 0; row < rows; row += width) {
      Vector input = hn::Mul(hn::Load(tag, phi.data + row), constant);
      input = hn::MulAdd(hn::Load(tag, phi.data + phi.stride + row), slope, input);
      input = hn::MulAdd(hn::Load(tag, phi.data + 2 * phi.stride + row), bend, input);
      advance_vector(hn::Load(tag, decay_minus_one + row), input, state.data + j * state.stride + row,
                     carry.data + j * carry.stride + row);
    }
  }
}

constexpr std::size_t most_terms = 16;

// 1/(i+3)!
constexpr auto inverse_factorials = [] {
  std::array<double, most_terms + 1> all{};
  double factorial = 6.0;
  for (std::size_t i = 0; i < all.size(); factorial *= static_cast<double>(++i + 3)) all[i] = 1.0 / factorial;
  return all;
}();

// The largest x in [0, 1] for which the series of phi_3 may be truncated after the first term and `terms`
// more: the next term is below rounding, x^(terms+1) 3! / (terms+4)! <= 2^-55.
constexpr auto reach_of_terms = [] {
  std::array<double, most_terms + 1> all{};
  for (std::size_t terms = 0; terms < all.size(); ++terms) {
    double low = 0.0, high = 1.0;
    for (int halving = 0; halving < 40; ++halving) {
      const double x = (low + high) / 2;
      double next = x / 4;
      for (std::size_t i = 0; i < terms; ++i) next *= x / static_cast<double>(i + 5);
      (next <= 0x1p-55 ? low : high) = x;
    }
    all[terms] = low;
  }
  all[most_terms] = 1.0;
  return all;
}();

// phi_3 = sum_i (-x)^i / (i+3)! for 0 <= x <= 1, with `terms` terms after the first.
HWY_INLINE Vector third_phi(Vector x, std::size_t terms) {
  Vector sum = hn::Set(tag, inverse_factorials[terms]);
  for (std::size_t i = terms; i > 0; --i)
    sum = hn::NegMulAdd(x, sum, hn::Set(tag, inverse_factorials[i - 1]));
  return sum;
}

// The recurrence phi_k = 1/k! - x phi_(k+1) is stable from phi_3 down to phi_1 for x < 1, and in the other
// direction for x >= 1. The choice is made for `lanes` nodes at a time, so that it does not depend on the
// vector width.
void phi_functions_kernel(Eigen::Index rows, double length, const double* nodes, Block phi,
                          double* decay_minus_one) {
  constexpr Eigen::Index width = hn::MaxLanes(tag);
  const Vector one = hn::Set(tag, 1.0), half = hn::Set(tag, 0.5);
  std::size_t terms = 0;
  bool some_small = false, some_large = false;
  for (Eigen::Index row = 0; row < rows; row += width) {
    if (row % lanes == 0) {
      const double last = length * nodes[row + lanes - 1];
      some_small = length * nodes[row] < 1.0;
      some_large = last >= 1.0;
      while (terms < most_terms && reach_of_terms[terms] < last) ++terms;
    }
    const Vector x = hn::Mul(hn::Set(tag, length), hn::Load(tag, nodes + row));
    Vector first = one, second = one, third = one, decay = one;
    if (some_small) {
      third = third_phi(hn::Min(x, one), terms);
      second = hn::NegMulAdd(x, third, half);
      first = hn::NegMulAdd(x, second, one);
      decay = hn::Neg(hn::Mul(x, first));
    }
    if (some_large) {
      const auto large = hn::Ge(x, one);
      const Vector below = hn::Sub(hn::Exp(tag, hn::Neg(x)), one), inverse = hn::Div(one, x);
      const Vector one_below = hn::Mul(hn::Neg(below), inverse);
      const Vector two_below = hn::Mul(hn::Sub(one, one_below), inverse);
      third = hn::IfThenElse(large, hn::Mul(hn::Sub(half, two_below), inverse), third);
      second = hn::IfThenElse(large, two_below, second);
      first = hn::IfThenElse(large, one_below, first);
      decay = hn::IfThenElse(large, below, decay);
    }
    hn::Store(first, tag, phi.data + row);
    hn::Store(second, tag, phi.data + phi.stride + row);
    hn::Store(third, tag, phi.data + 2 * phi.stride + row);
    hn::Store(decay, tag, decay_minus_one + row);
  }
}

void apply_decay_kernel(Eigen::Index rows, const double* values, const double* decay_minus_one,
                        double* decayed) {
  constexpr Eigen::Index width = hn::MaxLanes(tag);
  for (Eigen::Index row = 0; row < rows; row += width) {
    const Vector value = hn::Load(tag, values + row);
    hn::Store(hn::MulAdd(value, hn::Load(tag, decay_minus_one + row), value), tag, decayed + row);
  }
}

// Eight partial sums, for long arrays 32, for every vector width; they are added pairwise.
double dot_product_kernel(const double* a, const double* b, Eigen::Index length) {
  constexpr Eigen::Index together = 4 * lanes, width = hn::MaxLanes(tag), vectors = lanes / width;
  std::array<std::array<Vector, vectors>, 4> sum;
  for (auto& part : sum) part.fill(hn::Zero(tag));
  const auto add = [&](std::array<Vector, vectors>& to, Eigen::Index first) {
    for (Eigen::Index v = 0; v < vectors; ++v) {
      const Eigen::Index at = first + v * width;
      to[v] = hn::MulAdd(hn::LoadU(tag, a + at), hn::LoadU(tag, b + at), to[v]);
    }
  };
  Eigen::Index k = 0;
  for (; k + together <= length; k += together) {
    for (std::size_t part = 0; part < sum.size(); ++part)
      add(sum[part], k + static_cast<Eigen::Index>(part) * lanes);
  }
  for (std::size_t part = 0; k + lanes <= length; k += lanes) add(sum[part++], k);
  HWY_ALIGN std::array<double, lanes> parts;
  for (Eigen::Index v = 0; v < vectors; ++v) {
    const Vector total = hn::Add(hn::Add(sum[0][v], sum[1][v]), hn::Add(sum[2][v], sum[3][v]));
    hn::Store(total, tag, parts.data() + v * width);
  }
  double total =
      ((parts[0] + parts[1]) + (parts[2] + parts[3])) + ((parts[4] + parts[5]) + (parts[6] + parts[7]));
  for (; k < length; ++k) total += a[k] * b[k];
  return total;
}

}  // namespace fde::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fde {

HWY_EXPORT(multiply_add_kernel);
HWY_EXPORT(add_outer_product_kernel);
HWY_EXPORT(weighted_sum_kernel);
HWY_EXPORT(advance_states_kernel);
HWY_EXPORT(advance_columns_kernel);
HWY_EXPORT(advance_integrals_kernel);
HWY_EXPORT(apply_decay_kernel);
HWY_EXPORT(dot_product_kernel);
HWY_EXPORT(phi_functions_kernel);

namespace {

// The functions of the selected target.
struct Kernels {
  decltype(&multiply_add) multiplying;
  decltype(&add_outer_product) scattering;
  decltype(&weighted_sum) weighing;
  decltype(&advance_states) advancing;
  decltype(&advance_columns) advancing_columns;
  decltype(&advance_integrals) advancing_integrals;
  decltype(&apply_decay) decaying;
  decltype(&dot_product) multiplying_arrays;
  decltype(&phi_functions) integrating;
};
Kernels kernels_of(std::int64_t targets) {
  hwy::GetChosenTarget().Update(targets);
  return {HWY_DYNAMIC_DISPATCH(multiply_add_kernel),    HWY_DYNAMIC_DISPATCH(add_outer_product_kernel),
          HWY_DYNAMIC_DISPATCH(weighted_sum_kernel),    HWY_DYNAMIC_DISPATCH(advance_states_kernel),
          HWY_DYNAMIC_DISPATCH(advance_columns_kernel), HWY_DYNAMIC_DISPATCH(advance_integrals_kernel),
          HWY_DYNAMIC_DISPATCH(apply_decay_kernel),     HWY_DYNAMIC_DISPATCH(dot_product_kernel),
          HWY_DYNAMIC_DISPATCH(phi_functions_kernel)};
}
Kernels kernels = kernels_of(hwy::SupportedTargets());

}  // namespace

Vec padded(const Vec& values, double fill) {
  Vec result = Vec::Constant(rounded_up(values.size()), fill);
  result.head(values.size()) = values;
  return result;
}

void multiply_add(Eigen::Index rows, Eigen::Index inner, Eigen::Index columns, ConstBlock a, ConstBlock b,
                  Block c) {
  kernels.multiplying(rows, inner, columns, a, b, c);
}

void add_outer_product(Eigen::Index tables, const double* a, const double* b, Eigen::Index columns,
                       Eigen::Index below, Block c) {
  kernels.scattering(tables, a, b, columns, below, c);
}

void weighted_sum(Eigen::Index rows, const double* factors, const double* values, double scale,
                  const double* others, double* result) {
  kernels.weighing(rows, factors, values, scale, others, result);
}

void advance_states(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock input,
                    Block state, Block carry) {
  kernels.advancing(rows, columns, decay_minus_one, input, state, carry);
}

void advance_columns(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock input,
                     Block state, Block carry) {
  kernels.advancing_columns(rows, columns, decay_minus_one, input, state, carry);
}

void advance_integrals(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock phi,
                       ConstBlock polynomials, Block state, Block carry) {
  kernels.advancing_integrals(rows, columns, decay_minus_one, phi, polynomials, state, carry);
}

void apply_decay(Eigen::Index rows, const double* values, const double* decay_minus_one, double* decayed) {
  kernels.decaying(rows, values, decay_minus_one, decayed);
}

double dot_product(const double* a, const double* b, Eigen::Index length) {
  return kernels.multiplying_arrays(a, b, length);
}

void phi_functions(Eigen::Index rows, double length, const double* nodes, Block phi,
                   double* decay_minus_one) {
  kernels.integrating(rows, length, nodes, phi, decay_minus_one);
}

std::vector<std::string_view> vector_targets() {
  std::vector<std::string_view> names;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
    names.emplace_back(hwy::TargetName(target));
  return names;
}

void select_vector_target(std::string_view name) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (hwy::TargetName(target) != name) continue;
    kernels = kernels_of(target);
    return;
  }
  throw std::invalid_argument("no vector target " + std::string(name));
}

}  // namespace fde
#endif
