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

// The sum with its rounding error is Knuth's.
void advance_kernel(Eigen::Index rows, Eigen::Index columns, const double* decay_minus_one, ConstBlock input,
                    Block state, Block carry) {
  constexpr Eigen::Index width = hn::MaxLanes(tag);
  for (Eigen::Index j = 0; j < columns; ++j) {
    for (Eigen::Index row = 0; row < rows; row += width) {
      double *const at = state.data + j * state.stride + row, *const rest =
                                                                  carry.data + j * carry.stride + row;
      const Vector old = hn::Load(tag, at), before = hn::Load(tag, rest);
      const Vector change = hn::Add(hn::MulAdd(hn::Load(tag, decay_minus_one + row), old,
                                               hn::Load(tag, input.data + j * input.stride + row)),
                                    before);
      const Vector sum = hn::Add(old, change), added = hn::Sub(sum, old);
      hn::Store(sum, tag, at);
      hn::Store(hn::Add(hn::Sub(old, hn::Sub(sum, added)), hn::Sub(change, added)), tag, rest);
    }
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
HWY_EXPORT(dot_product_kernel);

namespace {

// The functions of the chosen target, looked up once.
struct Kernels {
  decltype(&multiply_add) multiplying;
  decltype(&scatter) scattering;
  decltype(&advance) advancing;
  decltype(&dot_product) multiplying_arrays;
};
Kernels kernels_of(std::int64_t targets) {
  hwy::GetChosenTarget().Update(targets);
  return {HWY_DYNAMIC_DISPATCH(multiply_add_kernel), HWY_DYNAMIC_DISPATCH(scatter_kernel),
          HWY_DYNAMIC_DISPATCH(advance_kernel), HWY_DYNAMIC_DISPATCH(dot_product_kernel)};
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

double dot_product(const double* a, const double* b, Eigen::Index length) {
  return kernels.multiplying_arrays(a, b, length);
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
