// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/fit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/fit/least_squares.hpp"
#include "fdebench/benchmarks/fit/linearised.hpp"
#include "fdebench/benchmarks/fit/measured_model.hpp"
#include "fdebench/benchmarks/fit/weighted.hpp"
#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"

namespace fde::bench {
namespace {

constexpr double first_accuracy = 1e-8, least_accuracy = 1e-12, accuracy_ratio = 0.01;

std::vector<std::string> names_of(const std::vector<FreeParameter>& parameters) {
  std::vector<std::string> names;
  for (const auto& one : parameters) names.push_back(one.name);
  return names;
}

class Fitter {
 public:
  Fitter(const FitRequest& request, const FitProgress& progress, const Scene& posed,
         std::vector<FreeParameter> parameters, ExternalTrajectory measured, const Scheme& scheme)
      : request_(request),
        progress_(progress),
        parameters_(std::move(parameters)),
        model_(request.variant, posed, names_of(parameters_), std::move(measured), scheme),
        has_deviations_(model_.measured().deviations.size() > 0) {
    fit_.scheme = scheme.id;
    fit_.names = model_.names();
    restart();
  }

  FittedScene run() && {
    std::optional<FittedScene> found;
    std::optional<Undetermined> undetermined;
    for (double accuracy = first_accuracy; accuracy > 0.9 * least_accuracy; accuracy *= accuracy_ratio) {
      fit_.accuracy = accuracy;
      model_.set_accuracy(accuracy);
      try {
        estimate();
        conclude();
      } catch (const Undetermined& vague) {  // perhaps only with these errors of the scheme
        undetermined = vague;
        if (!can_refine()) break;
        restart();
        continue;
      } catch (const NumericalFailure&) {
        if (!found && !undetermined) throw;
        break;  // the last accuracy is the smallest at which the scheme comes through
      }
      undetermined.reset();
      found = fit_;
      if (is_solver_negligible() || !can_refine()) break;
    }
    if (undetermined) {
      throw NumericalFailure(
          fmt::format("these measurements do not determine {}", fmt::join(undetermined->names, ", ")));
    }
    found->solves = model_.solves();
    return *std::move(found);
  }

 private:
  static constexpr int most_restarts = 20;

  // To the start of the fit.
  void restart() {
    const auto& measured = model_.measured();
    theta_.resize(std::ssize(parameters_));
    free_.clear();
    for (Eigen::Index j = 0; j < theta_.size(); ++j) {
      theta_[j] = parameter(j).start;
      free_.push_back(j);
    }
    fit_.deviations =
        has_deviations_ ? measured.deviations : Rows::Ones(measured.values.rows(), measured.values.cols());
  }

  [[nodiscard]] FreeParameter& parameter(Eigen::Index j) { return parameters_[static_cast<std::size_t>(j)]; }
  [[nodiscard]] const FreeParameter& parameter(Eigen::Index j) const {
    return parameters_[static_cast<std::size_t>(j)];
  }

  [[nodiscard]] double difference() const { return std::cbrt(fit_.accuracy); }

  // The free variables at theta, and theta with these in place of the present ones.
  [[nodiscard]] Vec free_variables() const {
    Vec z(std::ssize(free_));
    for (Eigen::Index k = 0; const Eigen::Index j : free_) z[k++] = parameter(j).variable().free(theta_[j]);
    return z;
  }
  [[nodiscard]] Vec theta_of(const Vec& z) const {
    Vec theta = theta_;
    for (Eigen::Index k = 0; const Eigen::Index j : free_) theta[j] = parameter(j).variable().bounded(z[k++]);
    return theta;
  }

  [[nodiscard]] std::vector<std::string> free_names() const {
    std::vector<std::string> names;
    for (const Eigen::Index j : free_) names.push_back(parameter(j).name);
    return names;
  }

  std::optional<Vec> residuals(const Weighted& weighted, const Vec& theta) {
    if (progress_) progress_(model_.solves());
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    if (elapsed.count() > request_.budget) {
      throw NumericalFailure(fmt::format("the fit is out of its budget of {} s, after {} solves",
                                         request_.budget, model_.solves()));
    }
    const auto columns = model_.columns(theta);
    return columns ? std::optional(weighted.residuals(*columns)) : std::nullopt;
  }

  // Minimises with the deviations that are given, or in turns with those that the last minimum leaves.
  void estimate() {
    constexpr int most_turns = 30;
    constexpr double settled = 1e-3;
    for (int turn = 0; turn < most_turns; ++turn) {
      minimise();
      if (has_deviations_) return;
      const Rows before = fit_.deviations;
      estimate_deviations();
      require_noise();
      const Rows change = fit_.deviations.cwiseQuotient(before);
      if (change.maxCoeff() < (1.0 + settled) * change.minCoeff()) return;
    }
    throw NumericalFailure("the deviations of the columns have not settled; sd_ columns would give them");
  }

  // A minimum over all free variables, from which no step leads on by much of a standard error. Variables
  // that go to an end of their range are fixed there.
  void minimise() {
    for (int attempt = 0; attempt < most_restarts; ++attempt) {
      if (minimise_once() && !adjust_units()) return;
    }
    const auto& why = model_.why_none();
    throw NumericalFailure(fmt::format("the fit has not converged in {} iterations{}", fit_.iterations,
                                       why.empty() ? "" : "; a trial failed: " + why));
  }

  bool minimise_once() {
    const Weighted weighted(model_.measured(), fit_.deviations);
    errors_.resize(0);
    if (free_.empty()) return true;
    const auto found = minimum(weighted);
    theta_ = theta_of(found.z);
    if (fix_at_limits() || adjust_units()) return false;
    jacobian_ = weighted.deviations().asDiagonal() * found.jacobian;
    const Linearised linear(found.jacobian, difference(), noise_of(weighted), free_names());
    const double variance = has_deviations_ ? 1.0
                                            : found.residuals.squaredNorm() /
                                                  static_cast<double>(weighted.size() - theta_.size());
    errors_ = linear.covariance().diagonal().cwiseSqrt() * std::sqrt(variance);
    return is_last(weighted, found, linear);
  }

  LeastSquares minimum(const Weighted& weighted) {
    constexpr double far = 3.0;
    const LeastSquaresOptions options{
        .tolerance = fit_.accuracy, .difference = difference(), .reach = [this](Eigen::Index k, double z) {
          const auto j = free_[static_cast<std::size_t>(k)];
          const bool is_linear = !parameter(j).variable().has_bound();
          return is_linear ? far * std::max(1.0, std::abs(z)) : far;
        }};
    try {
      auto found = least_squares([&](const Vec& z) { return residuals(weighted, theta_of(z)); },
                                 free_variables(), options);
      fit_.iterations += found.iterations;
      return found;
    } catch (const NumericalFailure&) {
      throw;
    } catch (const std::runtime_error& failure) {
      throw NumericalFailure(fmt::format("{}: {}", failure.what(), model_.why_none()));
    }
  }

  // What runs with this accuracy add to a difference of residuals.
  [[nodiscard]] double noise_of(const Weighted& weighted) const {
    return fit_.accuracy * weighted.norm_of(model_.sizes());
  }

  // Whether the step from a minimum is a small part of the standard errors. Then such steps are taken, with
  // the same derivatives, as long as they become shorter.
  bool is_last(const Weighted& weighted, const LeastSquares& found, const Linearised& linear) {
    constexpr double small = 0.1, negligible = 1e-8, shorter = 0.5;
    const auto size_of = [&](const Vec& step) { return step.cwiseQuotient(errors_).cwiseAbs().maxCoeff(); };
    Vec z = found.z, step = linear.step(found.residuals);
    double size = size_of(step);
    const bool is_small = size < small;
    while (is_small && size > negligible) {
      const auto after = residuals(weighted, theta_of(z + step));
      const double next = after ? size_of(linear.step(*after)) : size;
      if (next > shorter * size) break;
      z += step;
      step = linear.step(*after);
      size = next;
    }
    theta_ = theta_of(z);
    return is_small;
  }

  // Fixes free variables near an end of their range, where the sum of squares is no larger at the end.
  bool fix_at_limits() {
    constexpr double near = 0.01;
    const Weighted weighted(model_.measured(), fit_.deviations);
    bool is_fixed = false;
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const auto j = free_[k];
      const auto variable = parameter(j).variable();
      if (!variable.has_bound()) continue;
      Vec theta = theta_;
      theta[j] = variable.nearest_end(theta_[j]);
      if (std::abs(theta[j] - theta_[j]) > near * variable.width()) continue;
      const auto here = residuals(weighted, theta_), there = residuals(weighted, theta);
      if (!here || !there || there->norm() > here->norm()) continue;
      theta_ = theta;
      free_.erase(free_.begin() + static_cast<std::ptrdiff_t>(k--));
      is_fixed = true;
    }
    return is_fixed;
  }

  // Makes the unit of each variable without bounds the size of its estimate, or of its error where that is
  // known and larger. Returns whether one was far from that, so that its differences were too long or too
  // short.
  bool adjust_units() {
    constexpr double far = 3.0;
    bool is_changed = false;
    for (std::size_t k = 0; k < free_.size(); ++k) {
      FreeParameter& one = parameter(free_[k]);
      if (one.variable().has_bound()) continue;
      const bool is_known = errors_.size() > 0;
      const double size = std::abs(theta_[free_[k]]),
                   error = is_known ? errors_[static_cast<Eigen::Index>(k)] * one.unit : one.unit,
                   unit = std::max(size, error);
      if (!(unit > 0.0) || (unit < far * one.unit && one.unit < far * unit)) continue;
      one.unit = unit;
      is_changed = true;
    }
    return is_changed;
  }

  // Of each column what the model leaves, by its number of measurements less its share of the parameters.
  void estimate_deviations() {
    constexpr double least = 1e-15;  // of the size of the column, where nothing is left
    fit_.model = columns_at_estimates();
    const auto all = misfits(model_.measured(), fit_.model);
    double count = 0.0;
    for (const ColumnMisfit& one : all) count += one.count;
    const double free_part = 1.0 - static_cast<double>(free_.size()) / count;
    for (Eigen::Index c = 0; const ColumnMisfit& one : all) {
      const double size = model_.sizes()[c] > 0.0 ? model_.sizes()[c] : 1.0;
      fit_.deviations.row(c++).setConstant(
          std::max(std::sqrt(one.sum_of_squares / (one.count * free_part)), least * size));
    }
  }

  // Of several columns with unknown deviations some may be fitted ever better at the cost of the others.
  void require_noise() const {
    constexpr double vanishing = 100.0;  // by the error of the scheme
    std::vector<std::string> exact;
    for (std::size_t c = 0; c < fit_.names.size(); ++c) {
      const auto row = static_cast<Eigen::Index>(c);
      if (fit_.deviations(row, 0) <= vanishing * fit_.accuracy * model_.sizes()[row])
        exact.push_back(fit_.names[c]);
    }
    if (exact.empty() || exact.size() == fit_.names.size()) return;
    throw NumericalFailure(fmt::format(
        "column {0} is fitted exactly, at the cost of the others: its deviations are needed, as sd_{0}",
        exact.front()));
  }

  // Errors, intervals and correlations of the linearised model, with the model without the error of the
  // scheme.
  void conclude() {
    const auto& measured = model_.measured();
    const Weighted weighted(measured, fit_.deviations);
    fit_.model = columns_at_estimates();
    const Rows truth = true_columns();
    fit_.parameters.clear();
    for (Eigen::Index j = 0; j < theta_.size(); ++j)
      fit_.parameters.push_back({.name = parameter(j).name, .value = theta_[j], .is_at_limit = true});
    fit_.correlation = Matrix::Identity(theta_.size(), theta_.size());
    if (!free_.empty()) set_errors(weighted, weighted.differences(truth, fit_.model));
    fit_.model = truth;
    fit_.variant = model_.at(theta_);
    fit_.misfits = misfits(measured, fit_.model);
    fit_.measured = measured;
    if (has_deviations_)
      fit_.chi_squared = chi_squared(measured, fit_.model, static_cast<int>(parameters_.size()));
  }

  void set_errors(const Weighted& weighted, const Vec& error_of_scheme) {
    const Matrix jacobian = weighted.deviations().cwiseInverse().asDiagonal() * jacobian_;
    const Linearised linear(jacobian, difference(), noise_of(weighted), free_names());
    const Matrix covariance = linear.covariance();
    const Vec shift = linear.step(error_of_scheme), z = free_variables();
    const double factor = quantile(weighted.size() - theta_.size());
    for (Eigen::Index k = 0; k < z.size(); ++k) {
      const auto j = free_[static_cast<std::size_t>(k)];
      const double slope = parameter(j).variable().slope(z[k]), error = slope * std::sqrt(covariance(k, k));
      FittedParameter& one = fit_.parameters[static_cast<std::size_t>(j)];
      one = {.name = one.name,
             .value = one.value,
             .standard_error = error,
             .low = one.value - factor * error,
             .high = one.value + factor * error,
             .solver_error = std::abs(slope * shift[k])};
      for (Eigen::Index m = 0; m < k; ++m) {
        const auto i = free_[static_cast<std::size_t>(m)];
        fit_.correlation(i, j) = fit_.correlation(j, i) =
            covariance(m, k) / std::sqrt(covariance(m, m) * covariance(k, k));
      }
    }
  }

  [[nodiscard]] double quantile(Eigen::Index degrees) const {
    const double p = 0.5 * (1.0 + request_.confidence);
    return has_deviations_ ? boost::math::quantile(boost::math::normal(), p)
                           : boost::math::quantile(boost::math::students_t(static_cast<double>(degrees)), p);
  }

  Rows columns_at_estimates() {
    auto columns = model_.columns(theta_);
    if (!columns) throw NumericalFailure(fmt::format("at the estimates: {}", model_.why_none()));
    return *std::move(columns);
  }

  // The measured columns without the error of the scheme.
  Rows true_columns() {
    try {
      fit_.by_reference = true;
      return model_.exact_columns(theta_);
    } catch (const std::runtime_error&) {
      fit_.by_reference = false;
    }
    MeasuredModel finer = model_;
    finer.set_accuracy(accuracy_ratio * fit_.accuracy);
    auto columns = finer.columns(theta_);
    if (!columns) throw NumericalFailure(fmt::format("at the estimates: {}", finer.why_none()));
    return *std::move(columns);
  }

  // Whether a fit with a smaller tolerance takes a reasonable time.
  [[nodiscard]] bool can_refine() const {
    constexpr double most_seconds = 0.2;  // of a run with the present one
    return model_.seconds() < most_seconds;
  }

  [[nodiscard]] bool is_solver_negligible() const {
    constexpr double small = 0.01;
    return std::ranges::all_of(fit_.parameters, [](const FittedParameter& one) {
      return one.solver_error <= small * one.standard_error;
    });
  }

  const FitRequest& request_;
  const FitProgress& progress_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::vector<FreeParameter> parameters_;
  MeasuredModel model_;
  bool has_deviations_;
  Vec theta_{};                       // of all parameters
  std::vector<Eigen::Index> free_{};  // those that are not fixed at an end of their range
  Matrix jacobian_{};                 // of the measured values by the free variables
  Vec errors_{};                      // standard errors of the free variables
  FittedScene fit_{};
};

void require_enough(const ExternalTrajectory& measured, const std::vector<std::string>& names,
                    std::size_t parameters) {
  Eigen::Index count = 0;
  for (const auto& of : misfits(measured, Rows::Zero(measured.values.rows(), measured.values.cols()))) {
    if (of.count == 0) {
      throw Refusal({RequestField{"data"},
                     fmt::format(": has no measurements of {}", names[static_cast<std::size_t>(of.column)])});
    }
    count += of.count;
  }
  const bool estimated = measured.deviations.size() == 0;
  const auto least = static_cast<Eigen::Index>(parameters) + (estimated ? 1 : 0);
  if (count >= least) return;
  throw Refusal({RequestField{"data"},
                 fmt::format(": has {} of at least {} measurements: as many as parameters{}", count, least,
                             estimated ? ", and one more without standard deviations" : "")});
}

}  // namespace

FittedScene fit(const FitRequest& request, const FitProgress& progress) {
  require_in("confidence", request.confidence, order_below_one);
  require_in("budget", request.budget, positive);
  auto parameters = free_parameters(request.vary, request.variant);
  const Scene scene = make_scene(request.variant);
  require_start_at_zero(scene, "fit");
  const Scheme& scheme = adaptive_scheme_for(scene.problem, request.scheme);
  auto measured = request.data(scene);
  require_enough(measured, scene.outputs.names, parameters.size());
  return Fitter(request, progress, scene, std::move(parameters), std::move(measured), scheme).run();
}

}  // namespace fde::bench
