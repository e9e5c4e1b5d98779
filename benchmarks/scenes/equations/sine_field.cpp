#include "scenes/equations/sine_field.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "history/running_sum.hpp"
#include "mittag_leffler/mittag_leffler.hpp"

namespace fde {
namespace {

constexpr int longest_shown = 2000, shown_of_a_line = 9, shown_of_a_side = 3;
constexpr double rounding = std::numeric_limits<double>::epsilon();

struct Bounded {
  double value, bound;
};

// The solution of D^g u = -rate u from 1: E_g(-z), z = rate t^g. Rounding moves z by some units, and E_g(-z)
// by as many of z E_g'(-z) = z E_{g,g}(-z) / g; what is of second order in that is below the factor 2.
Bounded part_left(double order, double rate, double t) {
  const double z = rate * std::pow(t, order), of_time = t > 0.0 ? std::abs(std::log(t)) : 0.0;
  const auto left = mittag_leffler(order, 1.0, std::complex<double>(-z));
  const double slope = z * mittag_leffler(order, order, -z) / order;
  return {left.value.real(), left.bound + 2.0 * (8.0 + of_time) * rounding * std::abs(slope)};
}

}  // namespace

// The terms of the solution at one time, added up at the points that are shown.
class SineField::Sum {
 public:
  explicit Sum(Eigen::Index shown) : at_points_(shown) {}

  // An amplitude times the part that is left of it, of so many modes whose values at the points add up to
  // these.
  template <class Values>
  void add(double amplitude, const Bounded& part, double count, const Values& values) {
    const double term = amplitude * part.value;
    for (Eigen::Index i = 0; i < values.size(); ++i) at_points_.add(i, term * values[i]);
    squares_.add(0, count * term * term);
    // Amplitude and sines are good to a few units.
    bound_ += count * std::abs(amplitude) * (part.bound + 32.0 * rounding * std::abs(part.value));
  }

  // The norm of a mode is below its largest value: one bound serves all columns. square_of_mode is that of
  // its norm.
  [[nodiscard]] ReferenceValue result(bool with_norm, double square_of_mode) const {
    const Eigen::Index points = at_points_.size(), columns = points + (with_norm ? 1 : 0);
    ReferenceValue result{Vec(columns), Vec::Constant(columns, bound_)};
    for (Eigen::Index i = 0; i < points; ++i) result.value[i] = at_points_[i];
    if (with_norm) result.value[points] = std::sqrt(square_of_mode * squares_[0]);
    return result;
  }

 private:
  RunningSums at_points_, squares_{1};
  double bound_ = 0.0;
};

SineField::SineField(SinePoints points, SineStart start, int dimensions, double order, double diffusivity)
    : points_(points),
      start_(std::move(start)),
      dimensions_(dimensions),
      order_(order),
      diffusivity_(diffusivity),
      with_norm_(dimensions > 1 || points.points > longest_shown),
      shown_(points.spread(!with_norm_       ? points.points
                           : dimensions == 1 ? shown_of_a_line
                                             : shown_of_a_side)),
      sines_(std::ssize(shown_), start_.amplitudes.size()) {
  for (Eigen::Index k = 0; k < sines_.cols(); ++k) {
    for (Eigen::Index i = 0; i < sines_.rows(); ++i)
      sines_(i, k) = points.sine(static_cast<int>(k) + 1, shown_[static_cast<std::size_t>(i)]);
  }
}

Eigen::Index SineField::size() const {
  const Eigen::Index n = points_.points;
  return dimensions_ == 1 ? n : n * n;
}

double SineField::coupling() const { return diffusivity_ * points_.intervals() * points_.intervals(); }

std::vector<Component> SineField::components() const {
  std::vector<Component> all;
  all.reserve(static_cast<std::size_t>(size()));
  const auto add = [&](double value) {
    all.push_back({order_, order_ > 1.0 ? std::vector{value, 0.0} : std::vector{value}});
  };
  for (const double y : dimensions_ == 1 ? Vec::Ones(1) : start_.values) {
    for (const double x : start_.values) add(x * y);
  }
  return all;
}

SparseMatrix SineField::matrix() const {
  const Eigen::Index n = points_.points;
  SparseMatrix result(size(), size());
  result.reserve(Eigen::VectorXi::Constant(static_cast<int>(size()), 2 * dimensions_ + 1));
  const double c = coupling();
  for (Eigen::Index i = 0; i < size(); ++i) {
    const bool first = i % n == 0, last = i % n == n - 1;
    if (i >= n) result.insert(i - n, i) = c;
    if (!first) result.insert(i - 1, i) = c;
    result.insert(i, i) = -2.0 * dimensions_ * c;
    if (!last) result.insert(i + 1, i) = c;
    if (i + n < size()) result.insert(i + n, i) = c;
  }
  result.makeCompressed();
  return result;
}

void SineField::differences(In u, Out f) const {
  const Eigen::Index n = points_.points, lines = size() / n;
  const double c = coupling(), middle = -2.0 * dimensions_;
  for (Eigen::Index j = 0; j < lines; ++j) {
    const auto own = u.segment(j * n, n);
    auto line = f.segment(j * n, n);
    line[0] = c * (middle * own[0] + own[1]);
    line.segment(1, n - 2) = c * (own.head(n - 2) + middle * own.segment(1, n - 2) + own.tail(n - 2));
    line[n - 1] = c * (own[n - 2] + middle * own[n - 1]);
    if (j > 0) line += c * u.segment((j - 1) * n, n);
    if (j + 1 < lines) line += c * u.segment((j + 1) * n, n);
  }
}

Outputs SineField::outputs() const {
  Outputs outputs;
  std::vector<Eigen::Index> places;
  const auto show = [&](std::string name, Eigen::Index place) {
    outputs.names.push_back(std::move(name));
    places.push_back(place);
  };
  for (const int i : shown_) {
    if (dimensions_ == 1) {
      show(fmt::format("u{}", i), i - 1);
      continue;
    }
    for (const int j : shown_) {
      show(fmt::format("u{}_{}", i, j), i - 1 + static_cast<Eigen::Index>(points_.points) * (j - 1));
    }
  }
  if (!with_norm_) return outputs;
  outputs.names.emplace_back("l2");
  const double cell = std::pow(points_.intervals(), -dimensions_);
  outputs.of = [places = std::move(places), cell](double, In u, Out columns) {
    for (std::size_t i = 0; i < places.size(); ++i) columns[static_cast<Eigen::Index>(i)] = u[places[i]];
    columns[columns.size() - 1] = std::sqrt(cell) * u.stableNorm();  // where its square would overflow, too
  };
  return outputs;
}

ReferenceValue SineField::at(double t) const {
  const Eigen::Index modes = start_.amplitudes.size(), shown = sines_.rows();
  const auto rate = [&](Eigen::Index k) { return diffusivity_ * points_.rate(static_cast<int>(k) + 1); };
  Sum sum(dimensions_ == 1 ? shown : shown * shown);
  for (Eigen::Index k = 0; k < modes; ++k) {
    const double of_x = start_.amplitudes[k];
    if (of_x == 0.0) continue;
    if (dimensions_ == 1) {
      sum.add(of_x, part_left(order_, rate(k), t), 1.0, sines_.col(k));
      continue;
    }
    // Modes k, l and l, k decay alike.
    for (Eigen::Index l = 0; l <= k; ++l) {
      const double amplitude = of_x * start_.amplitudes[l];
      if (amplitude == 0.0) continue;
      Matrix both = sines_.col(l) * sines_.col(k).transpose();
      if (l < k) both += Matrix(both.transpose());
      sum.add(amplitude, part_left(order_, rate(k) + rate(l), t), l < k ? 2.0 : 1.0, both.reshaped());
    }
  }
  return sum.result(with_norm_, dimensions_ == 1 ? 0.5 : 0.25);
}

Scene scene_of_field(const SineField& field, double order) {
  const auto kept = std::make_shared<const SineField>(field);
  Scene scene;
  scene.problem.components = field.components();
  scene.problem.rhs = [kept](double, In u, Out f) { kept->differences(u, f); };
  scene.problem.derivatives = SparseLinearPart{field.matrix()};
  scene.smoothness.powers.assign(scene.problem.components.size(),
                                 power_lattice({order}, {order}, order + 2.0));
  scene.outputs = field.outputs();
  scene.reference.at = [kept](double t) { return kept->at(t); };
  return scene;
}

}  // namespace fde
