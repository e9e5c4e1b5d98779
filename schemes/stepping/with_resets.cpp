// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/with_resets.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace fde {
namespace {

// The jumps of y so far.
class Jumps {
 public:
  explicit Jumps(Eigen::Index size) : sums_{Vec::Zero(size)} {}

  // The sum of the jumps up to t, and of those before t.
  [[nodiscard]] const Vec& until(double t) const {
    return sums_[static_cast<std::size_t>(std::ranges::upper_bound(times_, t) - times_.begin())];
  }
  [[nodiscard]] const Vec& before(double t) const {
    return sums_[static_cast<std::size_t>(std::ranges::lower_bound(times_, t) - times_.begin())];
  }
  [[nodiscard]] double last_time() const { return times_.empty() ? -1.0 : times_.back(); }

  void add(double t, const Vec& jump) {
    times_.push_back(t);
    sums_.emplace_back(sums_.back() + jump);
  }

  // A jump, or the start, may leave y next to a zero of an event function, where rounding decides the sign.
  // For a short time after it the event functions therefore have their values at the end of that time.
  [[nodiscard]] static double short_time(double t) { return 1e-10 * t; }
  void hold(double from, double to, std::vector<double> ahead) {
    held_from_ = from;
    held_to_ = to;
    ahead_ = std::move(ahead);
  }
  [[nodiscard]] std::optional<double> held(std::size_t reset, double t) const {
    if (t < held_from_ || t > held_to_) return std::nullopt;
    return ahead_[reset];
  }

 private:
  std::vector<double> times_{};  // increasing
  std::vector<Vec> sums_;        // one more
  double held_from_ = 0.0, held_to_ = -1.0;
  std::vector<double> ahead_{};
};

// df/dy of y as one of u.
template <class Dependent>
Derivatives of_u(const Dependent& derivatives, const std::shared_ptr<Jumps>& jumps) {
  if constexpr (std::is_same_v<Dependent, DenseJacobian> || std::is_same_v<Dependent, SparseJacobian>) {
    return Dependent{[at = derivatives.at, jumps](double t, In u, auto&& jacobian) {
      at(t, u + jumps->until(t), std::forward<decltype(jacobian)>(jacobian));
    }};
  } else {
    return derivatives;
  }
}

// The function of y as one of u; empty if it is.
template <class Value>
std::function<Value(double, In)> of_u(const std::function<Value(double, In)>& function,
                                      const std::shared_ptr<Jumps>& jumps) {
  if (!function) return {};
  return [function, jumps](double t, In u) { return function(t, u + jumps->until(t)); };
}

// The problem for u, whose f jumps at the zeros of the event functions.
Problem problem_of_u(const Problem& problem, const std::shared_ptr<Jumps>& jumps) {
  Problem of{
      .components = problem.components,
      .rhs = [rhs = problem.rhs, jumps](double t, In u, Out f) { rhs(t, u + jumps->until(t), f); },
      .derivatives = std::visit([&](const auto& given) { return of_u(given, jumps); }, problem.derivatives),
      .end = problem.end,
      .outputs = of_u(problem.outputs, jumps),
      .domain = {.edge = problem.domain.edge, .margin = of_u(problem.domain.margin, jumps)},
      .jump_times = problem.jump_times,
      .kink_times = problem.kink_times,
      .step_limits = problem.step_limits};
  for (const auto& function : problem.switching_functions)
    of.switching_functions.push_back(of_u(function, jumps));
  for (std::size_t k = 0; k < problem.resets.size(); ++k) {
    of.switching_functions.emplace_back(
        [k, jumps, value = of_u(problem.resets[k].value, jumps)](double t, In u) {
          const auto held = jumps->held(k, t);
          return held ? *held : value(t, u);
        });
  }
  return of;
}

// Follows a run step by step and adds the jumps.
class ResetsOfRun {
 public:
  ResetsOfRun(const Problem& problem, std::shared_ptr<Jumps> jumps)
      : problem_(problem),
        resets_(problem.resets),
        jumps_(std::move(jumps)),
        last_(values_after_start()),
        last_y_(taylor_part(problem, 0.0)) {
    jumps_->hold(0.0, Jumps::short_time(problem.end), last_);
  }

  // u at the end of the step to t; a switch is at the end of a step.
  void accept_step(double t, In u) {
    if (t == 0.0) return;
    const Vec y = u + jumps_->until(t);
    const auto values = values_at(t, y);
    Vec after = y;
    for (std::size_t k = 0; k < resets_.size(); ++k)
      if (is_crossed(k, values[k])) resets_[k].state(t, y, after);
    last_ = values;
    if (after != y) {
      last_ = values_ahead(t, y, after);
      jumps_->add(t, after - y);
      jumps_->hold(t, t + Jumps::short_time(t), last_);
    }
    last_time_ = t;
    last_y_ = after;
  }

 private:
  [[nodiscard]] bool is_crossed(std::size_t k, double value) const {
    const bool rises = last_[k] < 0.0 && value > 0.0, falls = last_[k] > 0.0 && value < 0.0;
    const auto crossing = resets_[k].crossing;
    return (rises && crossing != Crossing::falling) || (falls && crossing != Crossing::rising);
  }

  // At a zero the sign before it is kept.
  [[nodiscard]] std::vector<double> values_at(double t, const Vec& y) const {
    std::vector<double> values;
    for (std::size_t k = 0; k < resets_.size(); ++k) {
      const double value = resets_[k].value(t, y);
      values.push_back(value == 0.0 ? last_[k] : value);
    }
    return values;
  }

  // The values at the start; where one is 0, that a short time h later: y_i moves by h^g/Gamma(g+1) f_i.
  [[nodiscard]] std::vector<double> values_after_start() const {
    const double h = Jumps::short_time(problem_.end);
    const Vec start = taylor_part(problem_, 0.0), f = rhs_at(problem_, 0.0, start);
    Vec ahead = taylor_part(problem_, h);
    for (Eigen::Index i = 0; i < ahead.size(); ++i) {
      const double order = problem_.component(i).order;
      if (order > 0.0 && std::isfinite(f[i]))
        ahead[i] += std::pow(h, order) / std::tgamma(order + 1.0) * f[i];
    }
    std::vector<double> values;
    for (const auto& reset : resets_) {
      const double value = reset.value(0.0, start);
      values.push_back(value == 0.0 ? reset.value(h, ahead) : value);
    }
    return values;
  }

  // The values a short time h after y has become `after`. To leading order y_i moves by h f_i for g = 1. For
  // other g its history goes on with the slope of the last step, and a jump of f_i adds h^g/Gamma(g+1) times
  // it.
  [[nodiscard]] std::vector<double> values_ahead(double t, const Vec& y, const Vec& after) const {
    const double h = Jumps::short_time(t);
    const Vec f = rhs_at(problem_, t, after), jump = f - rhs_at(problem_, t, y);
    Vec ahead = after;
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      const double order = problem_.component(i).order;
      if (order == 1.0) {
        ahead[i] += h * f[i];
      } else if (order > 0.0) {
        const double slope = (y[i] - last_y_[i]) / (t - last_time_);
        ahead[i] += h * slope + std::pow(h, order) / std::tgamma(order + 1.0) * jump[i];
      }
    }
    return values_at(t + h, ahead);
  }

  const Problem& problem_;
  const std::vector<Reset>& resets_;
  std::shared_ptr<Jumps> jumps_;
  std::vector<double> last_{};  // the values of the event functions at the end of the last step
  double last_time_ = 0.0;      // of the last step
  Vec last_y_{};
};

Options options_of_u(const Options& options, const std::shared_ptr<Jumps>& jumps, ResetsOfRun& resets) {
  Options of = options;
  of.observer = [&options, &resets, jumps](double t, In u) {
    resets.accept_step(t, u);
    if (options.observer) options.observer(t, u + jumps->until(t));
  };
  for (auto& event : of.events) {
    event.value = of_u(event.value, jumps);
    event.last_jump = [jumps] { return jumps->last_time(); };
  }
  if (options.wants_past) {
    of.wants_past = [&options, jumps](const Past& solution) {
      options.wants_past([&solution, jumps](double t, Out y) {
        solution(t, y);
        y += jumps->until(t);
      });
    };
  }
  return of;
}

}  // namespace

std::optional<std::string> unsupported_resets_reason(const Scheme& scheme, const Problem& problem) {
  if (problem.resets.empty()) return std::nullopt;
  if (!scheme.capabilities.is_adaptive()) return "locates no events, at which unknowns are set";
  if (is_two_sided(problem) || !problem.delays.lags.empty())
    return "takes events that set unknowns only without delays and conditions at both ends";
  return std::nullopt;
}

Solve with_resets(Solve solve) {
  return [solve = std::move(solve)](const Problem& problem, const Resolution& resolution,
                                    const Options& options) {
    if (problem.resets.empty()) return solve(problem, resolution, options);
    const auto jumps = std::make_shared<Jumps>(problem.size());
    ResetsOfRun resets(problem, jumps);
    Trajectory path = solve(problem_of_u(problem, jumps), resolution, options_of_u(options, jumps, resets));
    for (Eigen::Index c = 0; c < path.y.cols(); ++c) path.y.col(c) += jumps->until(path.time(c));
    for (auto& event : path.events) event.y += jumps->before(event.t);
    if (path.dense_output) {
      path.dense_output = [jumps, of_u = std::move(path.dense_output)](double t) -> Vec {
        return of_u(t) + jumps->until(t);
      };
    }
    return path;
  };
}

}  // namespace fde
