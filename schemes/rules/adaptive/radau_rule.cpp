// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/radau_rule.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "fdebench/schemes/rules/implicit/algebraic_slopes.hpp"
#include "fdebench/schemes/rules/implicit/difference_jacobian.hpp"

namespace fde {
namespace {

using Square = Eigen::Matrix<double, stages, stages>;

constexpr int most_iterations = 10;
constexpr double longest_continued = 2.0;  // of the previous step size
constexpr double converged = 1e-3;         // of the tolerance
// A defect that is 1 at the start of a step and 0 at the points counts as this constant defect on the whole
// step. At order 1/2 its true effect at the end of the step is half of that, at order 1 nothing; the largest
// is 0.036, near order 1/4.
constexpr double part_of_defect = 0.06;
// An algebraic unknown with such a defect has an error up to it between the stages. Where the unknown is
// found from its integral of order g, its error at the end is 0.29 of the defect for g = 1/2, 0.75 for g = 1.
constexpr double part_of_algebraic_defect = 0.3;

const std::array<double, stages>& points() {
  static const std::array<double, stages> c{(4.0 - std::sqrt(6.0)) / 10.0, (4.0 + std::sqrt(6.0)) / 10.0,
                                            1.0};
  return c;
}

// The values at places of 1, w, w^2, one row a place.
Square powers_at(const std::array<double, stages>& places) {
  Square result;
  for (Eigen::Index i = 0; i < stages; ++i) {
    for (Eigen::Index m = 0; m < stages; ++m)
      result(i, m) = std::pow(places[static_cast<std::size_t>(i)], static_cast<double>(m));
  }
  return result;
}

// From values at the points to coefficients of 1, w, w^2, one row a coefficient.
const Square& to_powers() {
  static const Square matrix = powers_at(points()).inverse();
  return matrix;
}

// From values at the beginning and at the points to coefficients of 1, w, w^2, w^3.
const Eigen::Matrix4d& to_cubic() {
  static const Eigen::Matrix4d matrix = [] {
    Eigen::Matrix4d powers = Eigen::Matrix4d::Zero();
    powers(0, 0) = 1.0;
    for (Eigen::Index i = 0; i < stages; ++i) {
      for (Eigen::Index m = 0; m <= stages; ++m)
        powers(i + 1, m) = std::pow(points()[static_cast<std::size_t>(i)], static_cast<double>(m));
    }
    return Eigen::Matrix4d(powers.inverse());
  }();
  return matrix;
}

// I^order of w^m at the points is Gamma(m+1)/Gamma(order+m+1) w^(order+m).
Square integral_weights(double order) {
  Square of_powers;
  for (Eigen::Index i = 0; i < stages; ++i) {
    const double place = points()[static_cast<std::size_t>(i)];
    for (Eigen::Index m = 0; m < stages; ++m) {
      const auto power = static_cast<double>(m);
      of_powers(i, m) =
          std::tgamma(power + 1.0) / std::tgamma(order + power + 1.0) * std::pow(place, order + power);
    }
  }
  return of_powers * to_powers();
}

}  // namespace

RadauRule::RadauRule(const Problem& problem, const Tolerance& accuracy, const Options& options, Run& run,
                     double shortest)
    : problem_(problem),
      taylor_(problem),
      allowed_(accuracy),
      matrix_(make_stage_matrix(problem)),
      weights_(static_cast<std::size_t>(problem.size())),
      known_(problem.size(), stages),
      y_(known_),
      f_(known_),
      derivatives_(known_),
      previous_parabolas_(Values::Zero(problem.size(), stages)),
      rhs_error_(problem.size()),
      derivatives_at_start_(run.rhs(0.0, run.start())),
      previous_(run.start()),
      result_(previous_) {
  for (const auto& component : problem.components) {
    auto& row = rows_.emplace_back();
    if (is_algebraic(component)) continue;
    const double order = component.order;
    auto found = std::ranges::find(kernels_, order, &Kernel::order);
    if (found == kernels_.end()) {
      const Square weights = integral_weights(order);
      // The memory term is evaluated no nearer to the earlier steps than the first point of a step.
      kernels_.push_back({order,
                          KernelIntegrals(ExponentialKernel(order, points().front() * shortest, problem.end,
                                                            options.newton_tolerance)),
                          weights, weights.inverse()});
      found = std::prev(kernels_.end());
    }
    row = Row{static_cast<std::size_t>(found - kernels_.begin()), found->integrals.add_function()};
  }
  for (auto& kernel : kernels_) kernel.integrals.begin();
  has_algebraic_rows_ = has_algebraic_rows(problem);
}

double RadauRule::rate() const {
  double least = 1.0;
  for (const auto& kernel : kernels_) least = std::min(least, kernel.order);
  return 3.0 + least;
}

void RadauRule::prepare(double t) {
  next_ = t;
  length_ = t - time_;
  for (auto& kernel : kernels_) {
    kernel.unit = std::pow(length_, kernel.order);
    for (std::size_t i = 0; i < kernel.to_stage.size(); ++i)
      kernel.integrals.prepare(points()[i] * length_, kernel.to_stage[i]);
  }
  for (Eigen::Index i = 0; i < stages; ++i)
    taylor_.at(time_ + points()[static_cast<std::size_t>(i)] * length_, known_.col(i));
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    weights_[r].setZero();
    if (!rows_[r]) continue;
    const auto& kernel = kernels_[rows_[r]->kernel];
    weights_[r] = kernel.unit * kernel.weights;
    for (Eigen::Index i = 0; i < stages; ++i) {
      known_(static_cast<Eigen::Index>(r), i) += kernel.integrals.integral(
          kernel.to_stage[static_cast<std::size_t>(i)], rows_[r]->function, Polynomial::Zero());
    }
  }
}

// Initial guess of Newton's method: the parabola of the previous step is extrapolated where the new step is
// not much longer; otherwise f is constant.
void RadauRule::guess() {
  const Vec start = derivatives_at_start_.unaryExpr([](double v) { return std::isfinite(v) ? v : 0.0; });
  derivatives_.colwise() = start;
  if (previous_length_ && length_ <= longest_continued * *previous_length_) {
    std::array<double, stages> ahead{};
    for (std::size_t i = 0; i < ahead.size(); ++i) ahead[i] = 1.0 + points()[i] * length_ / *previous_length_;
    derivatives_ = previous_parabolas_ * powers_at(ahead).transpose();
  }
  for (Eigen::Index r = 0; r < y_.rows(); ++r) {
    y_.row(r) = known_.row(r) + derivatives_.row(r) * weights_[static_cast<std::size_t>(r)].transpose();
    if (!rows_[static_cast<std::size_t>(r)]) y_.row(r).setConstant(previous_[r]);
  }
}

bool RadauRule::evaluate(Run& run) {
  for (Eigen::Index i = 0; i < stages; ++i)
    f_.col(i) = run.rhs(time_ + points()[static_cast<std::size_t>(i)] * length_, y_.col(i));
  return f_.allFinite();
}

// The residual of the equations of the step, stage after stage.
Vec RadauRule::residual() const {
  Values rest(y_.rows(), stages);
  for (Eigen::Index r = 0; r < y_.rows(); ++r) {
    const auto row = static_cast<std::size_t>(r);
    rest.row(r) = rows_[row] ? (known_.row(r) + f_.row(r) * weights_[row].transpose() - y_.row(r)).eval()
                             : f_.row(r).eval();
  }
  return rest.reshaped();
}

// The effects at the stages of constant defects of the rows.
RadauRule::Values RadauRule::effect_of(const Vec& defects) const {
  Values effect = Values::Zero(y_.rows(), stages);
  for (Eigen::Index r = 0; r < y_.rows(); ++r) {
    const auto row = static_cast<std::size_t>(r);
    if (rows_[row]) effect.row(r) = defects[r] * weights_[row].rowwise().sum().transpose();
  }
  return effect;
}

// What the equations of the step leave of these effects at its end.
Vec RadauRule::answer_to(const Values& effect) const {
  Vec answered = effect.reshaped();
  matrix_->solve(answered);
  return answered.tail(y_.rows());
}

// An algebraic unknown may have the error that changes no other row on the step by more than a part of its
// tolerance. From the third step on this part falls with the step's part of the time: next to the start an
// unknown may be unbounded, and only its effect is small. It falls more slowly than the effect, so that a
// step after one with too large an error can be made short enough.
Vec RadauRule::limits() const {
  constexpr double on_first_step = 0.01;
  Vec limit = limits_of_rows();
  if (!has_algebraic_rows_) return limit;
  const double of_time = length_ / (next_ - last_jump_time_);
  const double part = steps_since_jump_ == 0   ? on_first_step
                      : steps_since_jump_ == 1 ? 1.0
                                               : std::pow(of_time, 0.75);
  const Vec tolerance =
      allowed_.from_tolerance(y_.cwiseAbs().rowwise().maxCoeff(), known_.cwiseAbs().rowwise().maxCoeff());
  Values changes = Values::Zero(y_.rows(), stages);
  for (Eigen::Index r = 0; r < limit.size(); ++r)
    if (rows_[static_cast<std::size_t>(r)]) changes.row(r).setConstant(part * tolerance[r]);
  const Vec unfelt = answer_to(changes).cwiseAbs();
  for (Eigen::Index r = 0; r < limit.size(); ++r)
    if (!rows_[static_cast<std::size_t>(r)]) limit[r] = std::max(tolerance[r], unfelt[r]);
  return limit;
}

Vec RadauRule::limits_of_rows() const {
  const Vec largest = y_.cwiseAbs().rowwise().maxCoeff().cwiseMax(previous_.cwiseAbs());
  const Vec terms = known_.cwiseAbs().rowwise().maxCoeff();
  if (!rhs_error_.is_measured()) return allowed_.on_step(largest, terms);
  return allowed_.on_step(largest, largest, terms, answer_to(effect_of(rhs_error_.all())).cwiseAbs())
      .cwiseMax(answer_to(effect_of(rhs_error_.rounding())).cwiseAbs());
}

void RadauRule::measure_rhs_error(Run& run) {
  const Vec limit = limits();
  rhs_error_.measure([&](In y) -> const Vec& { return run.rhs(next_, y); }, y_.col(stages - 1), limit);
}

// Whether each component of the newest increment is small enough or due to rounding in f.
bool RadauRule::is_rounding(Run& run, const Vec& increment) {
  measure_rhs_error(run);
  const Vec limit = limits();
  const Values rounding = effect_of(rhs_error_.rounding()).cwiseAbs();
  for (Eigen::Index k = 0; k < increment.size(); ++k) {
    const auto r = k % y_.rows();
    if (rows_[static_cast<std::size_t>(r)] &&
        !(std::abs(increment[k]) <= std::max(converged * limit[r], rounding.row(r).maxCoeff())))
      return false;
  }
  return true;
}

bool RadauRule::solve(Run& run) {
  double last = no_solution;
  bool renewed = true;  // whether the matrix is factorised again in each iteration
  for (int iteration = 1; iteration <= most_iterations; ++iteration) {
    if (!evaluate(run)) return false;
    if (renewed) matrix_->factorise(run, time_ + length_, y_.col(stages - 1), f_.col(stages - 1), weights_);
    const Vec rest = residual();
    Vec increment = rest;
    matrix_->solve(increment);
    if (!increment.allFinite()) {
      if (!renewed) return false;
      y_ += rest.reshaped(y_.rows(), stages);
      continue;
    }
    if (iteration == 1) renewed = false;
    y_ += increment.reshaped(y_.rows(), stages);
    ++*run.cost().newton_iterations;
    const Vec limit = limits();
    double size = 0.0;
    for (Eigen::Index k = 0; k < increment.size(); ++k) {
      if (increment[k] != 0.0) size = std::max(size, std::abs(increment[k]) / limit[k % y_.rows()]);
    }
    if (size <= converged) return true;
    if (size > 0.5 * last) return is_rounding(run, increment);
    last = size;
  }
  return false;
}

// Computes D^g y from the equations: where they are stiff, the error of f(t, y) is far larger than that of y.
void RadauRule::compute_derivatives() {
  for (Eigen::Index r = 0; r < y_.rows(); ++r) {
    const auto& row = rows_[static_cast<std::size_t>(r)];
    if (!row) continue;
    const auto& kernel = kernels_[row->kernel];
    derivatives_.row(r) = (y_.row(r) - known_.row(r)) * kernel.inverse.transpose() / kernel.unit;
  }
}

// On a first step the unknowns of algebraic rows begin like a power of the time.
void RadauRule::compute_slopes(Run& run) {
  slopes_.resize(0, 0);
  if (!has_algebraic_rows_ || steps_since_jump_ > 0) return;
  const double t = time_ + points().front() * length_;
  const Vec y = y_.col(0);
  Matrix jacobian(y.size(), y.size());
  if (!evaluate_jacobian(problem_, t, y, jacobian))
    difference_jacobian_of_rhs(run, problem_, t, y, run.rhs(t, y), Vec::Zero(y.size()), jacobian);
  slopes_ = algebraic_slopes(problem_, jacobian);
}

double RadauRule::attempt(Run& run, double t) {
  prepare(t);
  guess();
  const bool solved = solve(run);
  result_ = y_.col(stages - 1);
  if (!solved) return no_solution;
  compute_derivatives();
  compute_slopes(run);
  return error(run);
}

double RadauRule::error(Run& run) {
  const Vec from_parabola = derivatives_ * to_powers().row(0).transpose();
  Vec defects = derivatives_at_start_ - from_parabola;
  for (Eigen::Index r = 0; r < y_.rows(); ++r)
    if (!std::isfinite(defects[r])) defects[r] = derivatives_(r, 0) - derivatives_(r, stages - 1);
  const Values effect = effect_of(part_of_defect * defects);
  const Vec signed_errors = answer_to(effect);
  Vec answered = signed_errors.cwiseAbs();
  for (Eigen::Index r = 0; r < y_.rows(); ++r) {
    if (rows_[static_cast<std::size_t>(r)]) continue;
    const double defect = previous_[r] - y_.row(r).dot(to_powers().row(0));
    // Nothing has tested the value at the end of the first step.
    answered[r] =
        steps_since_jump_ > 1 ? std::max(answered[r], part_of_algebraic_defect * std::abs(defect)) : 0.0;
  }
  const double of_outputs = allowed_.error_of_outputs(problem_, next_, result_, signed_errors,
                                                      known_.cwiseAbs().rowwise().maxCoeff());
  const auto largest = [&](const Vec& limit) {
    double error = of_outputs;
    for (Eigen::Index r = 0; r < y_.rows(); ++r)
      if (answered[r] != 0.0) error = std::max(error, answered[r] / limit[r]);
    return error;
  };
  Vec limit = limits();
  double result = largest(limit);
  if (result > 1.0) {
    measure_rhs_error(run);
    limit = limits();
    result = largest(limit);
  }
  interpolated_.clear();
  for (Eigen::Index r = 0; r < y_.rows(); ++r)
    if (needs_interpolation(effect(r, stages - 1), answered[r], limit[r])) interpolate(r);
  return result;
}

void RadauRule::interpolate(Eigen::Index row) {
  const Eigen::Vector4d values(previous_[row], y_(row, 0), y_(row, 1), y_(row, 2));
  interpolated_.push_back({row, to_cubic() * values});
}

// y at t where D^g y is this polynomial of (t' - time_) / (t - time_), one row a component; in algebraic rows
// the polynomial leaves out these slopes.
Vec RadauRule::integrated(double t, const Values& polynomials, const Matrix& slopes) {
  Vec y = previous_;
  taylor_.at(t, y);
  for (auto& kernel : kernels_) kernel.integrals.prepare(t - time_, kernel.to_stage.front());
  for (Eigen::Index r = 0; r < y.size(); ++r) {
    const auto& row = rows_[static_cast<std::size_t>(r)];
    if (!row) {
      y[r] = polynomials.row(r).sum();
      continue;
    }
    const auto& kernel = kernels_[row->kernel];
    const Polynomial newest(polynomials(r, 0), polynomials(r, 1), 2.0 * polynomials(r, 2));
    y[r] += kernel.integrals.integral(kernel.to_stage.front(), row->function, newest);
  }
  if (slopes.size() > 0) y += slopes * y;
  return y;
}

// The polynomials of the attempt (see DerivativePolynomials).
RadauRule::Values RadauRule::parabolas() const {
  Values values = derivatives_;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const auto row = static_cast<Eigen::Index>(r);
    if (!rows_[r]) values.row(row) = y_.row(row);
  }
  if (slopes_.size() > 0) values -= slopes_ * y_;
  return values * to_powers().transpose();
}

Vec RadauRule::dense_output(double t) {
  const double share = (t - time_) / length_;
  Values polynomials = parabolas();
  polynomials.col(1) *= share;
  polynomials.col(2) *= share * share;
  Vec y = integrated(t, polynomials, slopes_);
  for (const auto& row : interpolated_) y[row.row] = row.at(share);
  return y;
}

Vec RadauRule::extrapolate(double t) {
  Values polynomials = Values::Zero(y_.rows(), stages);
  const double ratio = previous_length_ ? (t - time_) / *previous_length_ : longest_continued + 1.0;
  if (ratio <= longest_continued) {
    polynomials.col(0) = previous_parabolas_.rowwise().sum();
    polynomials.col(1) = ratio * (previous_parabolas_.col(1) + 2.0 * previous_parabolas_.col(2));
    polynomials.col(2) = ratio * ratio * previous_parabolas_.col(2);
    return integrated(t, polynomials, previous_slopes_);
  }
  polynomials.col(0) = derivatives_at_start_;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const auto row = static_cast<Eigen::Index>(r);
    if (!rows_[r]) polynomials(row, 0) = previous_[row];
  }
  return integrated(t, polynomials, {});
}

void RadauRule::extrapolate_over_jump(double t) {
  result_ = extrapolate(t);
  prepare(t);
  derivatives_.colwise() = derivatives_at_start_;
  y_.colwise() = result_;
  interpolated_.clear();
  slopes_.resize(0, 0);
}

void RadauRule::restart(Run& run) {
  derivatives_at_start_ = run.rhs(time_, previous_);
  previous_length_.reset();
  last_jump_time_ = time_;
  steps_since_jump_ = 0;
  allowed_.restart();
}

void RadauRule::accept() {
  previous_parabolas_ = parabolas();
  previous_slopes_ = slopes_;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (!rows_[r]) continue;
    const auto powers = previous_parabolas_.row(static_cast<Eigen::Index>(r));
    kernels_[rows_[r]->kernel].integrals.polynomial(rows_[r]->function) =
        length_ * Polynomial(powers[0], powers[1], 2.0 * powers[2]);
  }
  for (auto& kernel : kernels_) kernel.integrals.advance(kernel.to_stage.back());
  allowed_.accept_step(y_.cwiseAbs().rowwise().maxCoeff().cwiseMax(previous_.cwiseAbs()));
  time_ = next_;
  ++steps_since_jump_;
  previous_length_ = length_;
  derivatives_at_start_ = derivatives_.col(stages - 1);
  previous_ = result_;
}

std::size_t RadauRule::bytes() const {
  std::size_t bytes = 0;
  for (const auto& kernel : kernels_) bytes += kernel.integrals.bytes();
  return bytes;
}

void RadauRule::state(Archive& archive) {
  for (auto& kernel : kernels_) archive(kernel.integrals);
  archive(allowed_, rhs_error_, last_jump_time_, steps_since_jump_, time_, previous_length_,
          previous_parabolas_, derivatives_at_start_, previous_, result_);
  archive.resizable(previous_slopes_);
}

}  // namespace fde
