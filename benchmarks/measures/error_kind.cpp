// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/error_kind.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/text/number_text.hpp"

namespace fde::bench {
namespace {

constexpr std::array norms{std::pair{Norm::end, std::string_view("end")},
                           std::pair{Norm::maximum, std::string_view("maximum")}};
constexpr std::array scales{std::pair{Scale::absolute, std::string_view("absolute")},
                            std::pair{Scale::relative, std::string_view("relative")},
                            std::pair{Scale::mixed, std::string_view("mixed")},
                            std::pair{Scale::peak, std::string_view("peak")}};

template <class Names, class Value>
std::string_view name_in(const Names& names, Value one) {
  return std::ranges::find(names, one, &Names::value_type::first)->second;
}

// max |r| of one column over [0.9 t, t], for each t. The sliding window stores candidates for the maximum
// only.
Vec sizes_nearby(const std::vector<double>& times, const Eigen::Ref<const Eigen::RowVectorXd>& reference) {
  constexpr double window = 0.9;
  Vec sizes(reference.size());
  std::deque<Eigen::Index> largest;
  const auto time = [&](Eigen::Index c) { return times[static_cast<std::size_t>(c)]; };
  for (Eigen::Index c = 0; c < reference.size(); ++c) {
    const double size = std::abs(reference[c]);
    while (!largest.empty() && std::abs(reference[largest.back()]) <= size) largest.pop_back();
    largest.push_back(c);
    while (time(largest.front()) < window * time(c)) largest.pop_front();
    sizes[c] = std::abs(reference[largest.front()]);
  }
  return sizes;
}

Rows relative_divisors(const std::vector<double>& times, const Rows& reference) {
  constexpr double passing = 1e-3;
  Rows of = reference.cwiseAbs();
  for (Eigen::Index i = 0; i < of.rows(); ++i) {
    const Vec nearby = passing * sizes_nearby(times, reference.row(i));
    of.row(i) = of.row(i).cwiseMax(nearby.transpose());
  }
  return (of.array() > 0.0).select(of, std::numeric_limits<double>::infinity());
}

Rows peak_divisors(const Rows& reference) {
  const Vec peaks = reference.cwiseAbs().rowwise().maxCoeff();
  const Vec of = (peaks.array() > 0.0).select(peaks, std::numeric_limits<double>::infinity());
  return of.replicate(1, reference.cols());
}

// The errors of each column for t > 0 of y = 0 and, if the times begin at 0, of y = y(0); otherwise both are
// those of y = 0.
struct ConstantErrors {
  Vec zero, start;
};
ConstantErrors constant_errors(Norm norm, const std::vector<double>& times, const Rows& reference,
                               const Rows& divisors) {
  const bool from_start = times.front() == 0.0 && times.size() > 1;
  const Eigen::Index later = reference.cols() - (from_start ? 1 : 0);
  const auto errors_with = [&](const Vec& constant) -> Vec {
    const auto parts =
        (reference.rightCols(later).colwise() - constant).cwiseAbs().cwiseQuotient(divisors.rightCols(later));
    if (norm == Norm::end) return parts.rightCols(1);
    return parts.rowwise().maxCoeff();
  };
  Vec zero = errors_with(Vec::Zero(reference.rows())), start = zero;
  if (from_start) start = errors_with(reference.col(0));
  return {std::move(zero), std::move(start)};
}

}  // namespace

std::string_view name(Norm norm) { return name_in(norms, norm); }
std::string_view name(Scale scale) { return name_in(scales, scale); }

Norm parse_norm(std::string_view text) {
  const auto* found = std::ranges::find(norms, text, &decltype(norms)::value_type::second);
  if (found == norms.end()) reject_text("norm", text, "end or maximum");
  return found->first;
}

Scale parse_scale(std::string_view text) {
  const auto* found = std::ranges::find(scales, text, &decltype(scales)::value_type::second);
  if (found == scales.end()) reject_text("scale", text, "absolute, relative, mixed or peak");
  return found->first;
}

std::vector<std::string> scale_names() {
  std::vector<std::string> names;
  for (const auto& [scale, name] : scales) names.emplace_back(name);
  return names;
}

Rows divisors(Scale scale, const std::vector<double>& times, const Rows& reference) {
  switch (scale) {
    case Scale::absolute:
      return Rows::Ones(reference.rows(), reference.cols());
    case Scale::relative:
      return relative_divisors(times, reference);
    case Scale::mixed:
      return (1.0 + reference.array().abs()).matrix();
    case Scale::peak:
      return peak_divisors(reference);
  }
  throw std::logic_error("a scale without divisors");
}

Vec errors_of(Norm norm, const Rows& values, const Rows& reference, const Rows& divisors) {
  const auto parts = (values - reference).cwiseAbs().cwiseQuotient(divisors);
  if (norm == Norm::end) return parts.rightCols(1);
  return parts.rowwise().maxCoeff();
}

bool is_constant(const Rows& reference, const Rows& bounds) {
  constexpr double rounding = 1e-15;
  const auto first = reference.col(0).array();
  const Vec least = bounds.col(0).array() + rounding * first.abs();
  for (Eigen::Index c = 0; c < reference.cols(); ++c) {
    const auto away = (reference.col(c).array() - first).abs();
    if (!(away <= least.array() + bounds.col(c).array()).all()) return false;
  }
  return true;
}

double constant_solution_error(Norm norm, const std::vector<double>& times, const Rows& reference,
                               const Rows& divisors) {
  const auto [zero, start] = constant_errors(norm, times, reference, divisors);
  return std::min(zero.maxCoeff(), start.maxCoeff());
}

ErrorTable error_table(const std::vector<double>& times, const Rows& values, const Rows& reference) {
  if (reference.cols() == 0) return {};
  constexpr auto kinds = static_cast<Eigen::Index>(error_kinds.size());
  ErrorTable table{Matrix(values.rows(), kinds), Matrix(values.rows(), kinds), Matrix(values.rows(), kinds)};
  for (const Scale scale : error_scales) {
    const Rows by = divisors(scale, times, reference);
    for (const Norm norm : {Norm::end, Norm::maximum}) {
      const auto kind = std::ranges::find(error_kinds, ErrorKind{norm, scale}) - error_kinds.begin();
      const auto [zero, start] = constant_errors(norm, times, reference, by);
      table.run.col(kind) = errors_of(norm, values, reference, by);
      table.zero.col(kind) = zero;
      table.start.col(kind) = start;
    }
  }
  return table;
}

}  // namespace fde::bench
