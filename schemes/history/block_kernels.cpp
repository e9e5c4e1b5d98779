#include "history/block_kernels.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

// The tiles are arrays of vectors, which vectors of unknown length cannot be.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "history/block_kernels.cpp"
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

// Rows of vectors held in registers at a time: with the columns they make the accumulators of one tile.
constexpr Eigen::Index tile_vectors = hn::MaxLanes(tag) == lanes ? 4 : 2;

// Rows [0, Vectors * width) of Columns columns of c += a b.
template <Eigen::Index Vectors, Eigen::Index Columns>
HWY_INLINE void tile(Eigen::Index inner, ConstBlock a, ConstBlock b, Block c) {
  constexpr Eigen::Index width = hn::MaxLanes(tag);
  std::array<std::array<Vector, Columns>, Vectors> sum;
  for (Eigen::Index j = 0; j < Columns; ++j) {
    for (Eigen::Index v = 0; v < Vectors; ++v) sum[v][j] = hn::Load(tag, c.data + j * c.stride + v * width);
  }
  for (Eigen::Index k = 0; k < inner; ++k) {
    std::array<Vector, Vectors> left;
    for (Eigen::Index v = 0; v < Vectors; ++v) left[v] = hn::Load(tag, a.data + k * a.stride + v * width);
    for (Eigen::Index j = 0; j < Columns; ++j) {
      const Vector right = hn::Set(tag, b.data[j * b.stride + k]);
      for (Eigen::Index v = 0; v < Vectors; ++v) sum[v][j] = hn::MulAdd(left[v], right, sum[v][j]);
    }
  }
  for (Eigen::Index j = 0; j < Columns; ++j) {
    for (Eigen::Index v = 0; v < Vectors; ++v) hn::Store(sum[v][j], tag, c.data + j * c.stride + v * width);
  }
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

void scatter_kernel(const double* a, const double* b, Eigen::Index columns, Block c) {
  constexpr Eigen::Index width = hn::MaxLanes(tag);
  for (Eigen::Index j = 0; j < columns; ++j) {
    const Vector factor = hn::Set(tag, b[j]);
    for (Eigen::Index row = 0; row < lanes; row += width) {
      double* entry = c.data + j * c.stride + row;
      hn::Store(hn::MulAdd(hn::Load(tag, a + row), factor, hn::Load(tag, entry)), tag, entry);
    }
  }
}

// state + carry += decay_minus_one * state + input. The sum with its rounding error is Knuth's.
HWY_INLINE void advance_vector(Vector decay_minus_one, const double* input, double* state, double* carry) {
  const Vector old = hn::Load(tag, state), before = hn::Load(tag, carry);
  const Vector change = hn::Add(hn::MulAdd(decay_minus_one, old, hn::Load(tag, input)), before);
  const Vector sum = hn::Add(old, change), added = hn::Sub(sum, old);
  hn::Store(sum, tag, state);
  hn::Store(hn::Add(hn::Sub(old, hn::Sub(sum, added)), hn::Sub(change, added)), tag, carry);
}

void advance_kernel(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock input,
                    Block state, Block carry) {
  constexpr Eigen::Index width = hn::MaxLanes(tag);
  for (Eigen::Index j = 0; j < columns; ++j) {
    for (Eigen::Index row = 0; row < rows; row += width) {
      advance_vector(hn::Load(tag, decay_minus_one + row), input.data + j * input.stride + row,
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
      advance_vector(decay, input.data + j * input.stride + row, state.data + j * state.stride + row,
                     carry.data + j * carry.stride + row);
    }
  }
}

// 1/i; the series below has 16 terms at most.
constexpr auto reciprocals = [] {
  std::array<double, 24> all{};
  for (std::size_t i = 1; i < all.size(); ++i) all[i] = 1.0 / static_cast<double>(i);
  return all;
}();

// phi_3 = sum_i (-x)^i / (i+3)! for 0 <= x <= 1, by so many terms after the first.
HWY_INLINE Vector third_phi(Vector x, int terms) {
  const Vector one = hn::Set(tag, 1.0);
  Vector sum = one;
  for (int i = terms + 3; i > 3; --i)
    sum = hn::NegMulAdd(hn::Mul(x, hn::Set(tag, reciprocals[static_cast<std::size_t>(i)])), sum, one);
  return hn::Mul(sum, hn::Set(tag, reciprocals[6]));
}

// So many that the next is below rounding up to this x.
HWY_INLINE int terms_up_to(double x) {
  int terms = 0;
  for (double next = x / 4.0; next > 0x1p-55; next *= x / (terms + 4)) ++terms;
  return terms;
}

// The functions follow from each other by phi_k = 1/k! - x phi_(k+1): upwards without loss for x below 1,
// downwards above. What is done is decided for `lanes` nodes, whatever the width.
void phi_functions_kernel(Eigen::Index rows, double length, const double* nodes, Block phi,
                          double* decay_minus_one) {
  constexpr Eigen::Index width = hn::MaxLanes(tag);
  const Vector one = hn::Set(tag, 1.0), half = hn::Set(tag, 0.5);
  int terms = 0;
  bool some_small = false, some_large = false;
  for (Eigen::Index row = 0; row < rows; row += width) {
    if (row % lanes == 0) {
      const double last = length * nodes[row + lanes - 1];
      some_small = length * nodes[row] < 1.0;
      some_large = last >= 1.0;
      if (some_small) terms = terms_up_to(std::min(last, 1.0));
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
      const Vector below = hn::Sub(hn::Exp(tag, hn::Neg(x)), one);
      const Vector one_below = hn::Div(hn::Neg(below), x), two_below = hn::Div(hn::Sub(one, one_below), x);
      third = hn::IfThenElse(large, hn::Div(hn::Sub(half, two_below), x), third);
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

// Thirty-two running sums, whatever the width.
double dot_product_kernel(const double* a, const double* b, Eigen::Index length) {
  constexpr Eigen::Index together = 4 * lanes, width = hn::MaxLanes(tag), vectors = together / width;
  std::array<Vector, vectors> sum;
  for (auto& part : sum) part = hn::Zero(tag);
  Eigen::Index k = 0;
  for (; k + together <= length; k += together) {
    for (Eigen::Index v = 0; v < vectors; ++v) {
      sum[v] = hn::MulAdd(hn::LoadU(tag, a + k + v * width), hn::LoadU(tag, b + k + v * width), sum[v]);
    }
  }
  HWY_ALIGN std::array<double, together> parts;
  for (Eigen::Index v = 0; v < vectors; ++v) hn::Store(sum[v], tag, parts.data() + v * width);
  double total = 0.0;
  for (const double part : parts) total += part;
  for (; k < length; ++k) total += a[k] * b[k];
  return total;
}

}  // namespace fde::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fde {

HWY_EXPORT(multiply_add_kernel);
HWY_EXPORT(scatter_kernel);
HWY_EXPORT(advance_kernel);
HWY_EXPORT(advance_columns_kernel);
HWY_EXPORT(dot_product_kernel);
HWY_EXPORT(phi_functions_kernel);

namespace {

// The functions of the chosen target, looked up once.
struct Kernels {
  decltype(&multiply_add) multiplying;
  decltype(&scatter) scattering;
  decltype(&advance) advancing;
  decltype(&advance_columns) advancing_columns;
  decltype(&dot_product) multiplying_arrays;
  decltype(&phi_functions) integrating;
};
Kernels kernels_of(std::int64_t targets) {
  hwy::GetChosenTarget().Update(targets);
  return {HWY_DYNAMIC_DISPATCH(multiply_add_kernel), HWY_DYNAMIC_DISPATCH(scatter_kernel),
          HWY_DYNAMIC_DISPATCH(advance_kernel),      HWY_DYNAMIC_DISPATCH(advance_columns_kernel),
          HWY_DYNAMIC_DISPATCH(dot_product_kernel),  HWY_DYNAMIC_DISPATCH(phi_functions_kernel)};
}
Kernels kernels = kernels_of(hwy::SupportedTargets());

}  // namespace

Vec padded(const Vec& values, double fill) {
  Vec result = Vec::Constant((values.size() + lanes - 1) / lanes * lanes, fill);
  result.head(values.size()) = values;
  return result;
}

void multiply_add(Eigen::Index rows, Eigen::Index inner, Eigen::Index columns, ConstBlock a, ConstBlock b,
                  Block c) {
  kernels.multiplying(rows, inner, columns, a, b, c);
}

void scatter(const double* a, const double* b, Eigen::Index columns, Block c) {
  kernels.scattering(a, b, columns, c);
}

void advance(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock input,
             Block state, Block carry) {
  kernels.advancing(rows, columns, decay_minus_one, input, state, carry);
}

void advance_columns(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock input,
                     Block state, Block carry) {
  kernels.advancing_columns(rows, columns, decay_minus_one, input, state, carry);
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

void use_vector_target(std::string_view name) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (hwy::TargetName(target) != name) continue;
    kernels = kernels_of(target);
    return;
  }
  throw std::invalid_argument("no vector target " + std::string(name));
}

}  // namespace fde
#endif
