#include "linear/linear_solution.hpp"

#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "laplace/refine.hpp"
#include "numbers/bounded.hpp"
#include "transfer_functions/linear_response.hpp"

namespace fde {
namespace {

class LinearSolution {
 public:
  explicit LinearSolution(LinearTransform transform)
      : exact_(std::move(transform)), quick_(exact_), zeros_(find_zeros(quick_.characteristic)) {}

  [[nodiscard]] std::vector<DoubleBounded> at(double t) const;
  [[nodiscard]] std::vector<Bounded<BigReal>> at(double t, int digits) const;

 private:
  [[nodiscard]] std::size_t size() const { return exact_.groups.front().numerators.size(); }
  [[nodiscard]] LinearValues<long double> in_long_double(double t) const;
  [[nodiscard]] std::vector<Sum<BigReal>> in_digits(double t, int digits) const;
  [[nodiscard]] int phase_digits(double t) const;

  LinearTransform exact_;
  RoundedTransform<long double> quick_;
  std::vector<Zero<long double>> zeros_;
};

template <class Real>
LinearValues<Real> nothing(std::size_t outputs) {
  return {std::vector<Sum<Real>>(outputs), std::vector<Complex<Real>>(outputs, Complex<Real>(0))};
}

// What there is besides the real part is what a conjugate node cancels.
template <class Real>
void drop_imaginary_parts(std::vector<Sum<Real>>& sums) {
  for (auto& sum : sums) sum.value = Complex<Real>(real_part<Real>(sum.value));
}

LinearValues<long double> LinearSolution::in_long_double(double t) const {
  auto values = nothing<long double>(size());
  const auto t_exact = decimal<long double>(t);
  for (const auto& group : quick_.groups) {
    const long double time = t_exact - group.from;
    if (time == 0.0L) quick_.add_start_values(group, values.sums);
    if (time <= 0.0L) continue;
    auto part = nothing<long double>(size());
    std::vector<Complex<long double>> log_poles;
    for (const auto& zero : zeros_) log_poles.push_back(zero.log + std::log(time));
    const auto& contour = contour_away_from(log_poles);
    LinearResponse<long double> response(quick_, group, time);
    response.add_to(part, zeros_, contour);
    response.add_discretisation(part, contour);
    // A difference of decimals near each other is known less well: that is an error of the time.
    const long double time_ulps = t_exact / time;
    for (std::size_t j = 0; j < size(); ++j) {
      const long double rate = std::abs(part.rates[j].real());
      part.sums[j].error += epsilon<long double>() * time_ulps * rate;
      values.rates[j] += part.rates[j] * time_ulps;
    }
    for (std::size_t j = 0; j < size(); ++j) values.sums[j].add(part.sums[j]);
  }
  drop_imaginary_parts(values.sums);
  return values;
}

std::vector<Sum<BigReal>> LinearSolution::in_digits(double t, int digits) const {
  const RoundedTransform<BigReal> transform(exact_);
  const auto zeros = polished(transform.characteristic, zeros_);
  const Contour<BigReal>& contour = contour_for(digits);
  auto values = nothing<BigReal>(size());
  for (const auto& group : transform.groups) {
    const BigReal time = decimal<BigReal>(t) - group.from;
    if (time == 0) transform.add_start_values(group, values.sums);
    if (time > 0) LinearResponse<BigReal>(transform, group, time).add_to(values, zeros, contour);
  }
  drop_imaginary_parts(values.sums);
  return values.sums;
}

// Digits by which the phase of e^(s* t) exceeds one turn.
int LinearSolution::phase_digits(double t) const {
  constexpr double most = 400.0;
  double digits = 0.0;
  for (const auto& zero : zeros_)
    digits = std::max(digits, static_cast<double>(zero.log.real()) / std::numbers::ln10 + std::log10(t));
  return static_cast<int>(std::min(digits, most)) + 1;
}

std::vector<Bounded<BigReal>> LinearSolution::at(double t, int digits) const {
  return refine(digits, phase_digits(t), [&](int working) { return in_digits(t, working); });
}

std::vector<DoubleBounded> LinearSolution::at(double t) const {
  const auto [sums, rates] = in_long_double(t);
  std::vector<DoubleBounded> values;
  for (std::size_t j = 0; j < sums.size(); ++j) {
    const auto& sum = sums[j];
    const long double scale = std::max(std::abs(sum.value.real()), std::abs(rates[j].real()));
    const bool settled = std::isfinite(sum.error) && sum.error <= double_tolerance * scale;
    if (!sum.infinite && !settled) break;
    values.push_back(to_double(sum.value, sum.error));
  }
  if (values.size() == sums.size()) return values;
  values.clear();
  const Precision precision(contour_precision(double_digits));
  for (const auto& value : at(t, double_digits)) values.push_back(to_double(value));
  return values;
}

// Made when first asked for: a scene that is only solved needs no zeros of its characteristic function.
class LazySolution {
 public:
  LazySolution(const char* name, std::function<LinearTransform()> transform)
      : name_(name), transform_(std::move(transform)) {}
  const LinearSolution& get() {
    std::call_once(once_, [this] { solution_.emplace(transform_()); });
    return *solution_;
  }
  void require(bool holds, const char* message) const {
    if (!holds) throw std::invalid_argument(fmt::format("{}: {}", name_, message));
  }
  void require_time(double t) const {
    require(t >= 0.0 && std::isfinite(t), "times have to be finite and not negative");
  }

 private:
  const char* name_;
  std::function<LinearTransform()> transform_;
  std::once_flag once_;
  std::optional<LinearSolution> solution_;
};

}  // namespace

Reference exact_reference(const char* name, std::function<LinearTransform()> transform) {
  const auto solution = std::make_shared<LazySolution>(name, std::move(transform));
  const auto at = [solution](double t) {
    solution->require_time(t);
    const auto values = solution->get().at(t);
    const auto size = static_cast<Eigen::Index>(values.size());
    ReferenceValue known{Vec(size), Vec(size)};
    for (Eigen::Index j = 0; j < size; ++j) {
      known.value[j] = values[static_cast<std::size_t>(j)].value.real();
      known.bound[j] = values[static_cast<std::size_t>(j)].bound;
      if (std::isfinite(known.value[j]) && !std::isfinite(known.bound[j]))
        throw std::runtime_error(fmt::format("the exact solution turns too often to be known at t = {}", t));
    }
    return known;
  };
  const auto digits = [solution](double t, int wanted) {
    solution->require_time(t);
    solution->require(wanted >= 1, "the number of digits has to be positive");
    const Precision precision(contour_precision(wanted));
    std::vector<Decimal> texts;
    for (const auto& [value, bound] : solution->get().at(t, wanted)) {
      const DecimalText text = write_decimal(real_part<BigReal>(value), bound, wanted);
      texts.push_back({text.value, write_bound(text.bound)});
    }
    return texts;
  };
  return {at, digits};
}

}  // namespace fde
