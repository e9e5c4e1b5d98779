// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/fit/least_squares.hpp"

#include <cmath>
#include <stdexcept>
#include <unsupported/Eigen/LevenbergMarquardt>
#include <utility>

namespace fde::bench {
namespace {

// A size that no sum of squares of accepted residuals has, and whose square is a double.
constexpr double rejected = 1e140;

// What Eigen's minimiser calls, with w = z - start + 1: it bounds its first step by the size of w, which at z
// = 0 would be none.
class Functor : public Eigen::DenseFunctor<double> {
 public:
  Functor(const Residuals& residuals, const Vec& start, const Vec& first, const LeastSquaresOptions& options)
      : DenseFunctor(static_cast<int>(start.size()), static_cast<int>(first.size())),
        residuals_(residuals),
        options_(options),
        origin_(start.array() - 1.0),
        accepted_(start) {}

  [[nodiscard]] Vec z(const Vec& w) const { return w + origin_; }

  int operator()(const Vec& w, Vec& r) const {
    const Vec z = this->z(w);
    auto found = is_within_reach(z) ? residuals_(z) : std::nullopt;
    r = found ? *std::move(found) : Vec::Constant(values(), rejected);
    return 0;
  }

  int df(const Vec& w, Matrix& jacobian) {
    const Vec z = this->z(w);
    accepted_ = z;
    jacobian.resize(values(), inputs());
    for (Eigen::Index j = 0; j < z.size(); ++j) jacobian.col(j) = derivative(z, j);
    return 0;
  }

 private:
  [[nodiscard]] bool is_within_reach(const Vec& z) const {
    if (!options_.reach) return true;
    for (Eigen::Index j = 0; j < z.size(); ++j)
      if (std::abs(z[j] - accepted_[j]) > options_.reach(j, accepted_[j])) return false;
    return true;
  }

  [[nodiscard]] Vec derivative(const Vec& z, Eigen::Index j) const {
    Vec after = z, before = z;
    after[j] += options_.difference;
    before[j] -= options_.difference;
    auto high = residuals_(after), low = residuals_(before);
    if (!high) {
      high = residuals_(z);
      after = z;
    } else if (!low) {
      low = residuals_(z);
      before = z;
    }
    if (!high || !low) throw std::runtime_error("the model has no values on either side of parameters");
    return (*high - *low) / (after[j] - before[j]);
  }

  const Residuals& residuals_;
  const LeastSquaresOptions& options_;
  Vec origin_;
  Vec accepted_;  // where the derivatives were taken last
};

}  // namespace

LeastSquares least_squares(const Residuals& residuals, Vec start, const LeastSquaresOptions& options) {
  const auto first = residuals(start);
  if (!first) throw std::runtime_error("the model has no values at the start");
  Functor functor(residuals, start, *first, options);
  LeastSquares found{.z = std::move(start), .residuals = *first, .has_converged = first->isZero(0.0)};
  if (!found.has_converged) {
    Eigen::LevenbergMarquardt<Functor> minimiser(functor);
    minimiser.setFactor(1.0);  // of the first step, by the size of w
    minimiser.setFtol(options.tolerance * options.tolerance);
    minimiser.setXtol(options.tolerance);
    Vec w = Vec::Ones(found.z.size());
    minimiser.minimize(w);
    found.z = functor.z(w);
    found.residuals = minimiser.fvec();
    found.iterations = static_cast<int>(minimiser.iterations());
    found.has_converged = minimiser.info() == Eigen::Success;
  }
  functor.df(found.z - functor.z(Vec::Zero(found.z.size())), found.jacobian);
  return found;
}

}  // namespace fde::bench
