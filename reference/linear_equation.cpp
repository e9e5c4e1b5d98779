#include "linear_equation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "linear_response.hpp"
#include "refine.hpp"

namespace fde {
namespace {

void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(fmt::format("linear equation: {}", message));
}

// The equation without its zero terms, which would otherwise count as unknown orders.
LinearEquation checked(LinearEquation equation, const std::vector<double>& orders) {
  double top = -1.0;
  for (const auto& [coefficient, order, time_scale] : equation.terms) {
    require(std::isfinite(coefficient.real()) && std::isfinite(coefficient.imag()),
            "coefficients have to be finite");
    require(order >= 0.0 && order <= 2.0, "orders have to be in [0, 2]");
    require(time_scale > 0.0 && std::isfinite(time_scale), "time scales have to be positive");
    if (coefficient != 0.0) top = std::max(top, order);
  }
  require(top > 0.0, "a derivative with a coefficient other than zero is needed");
  const auto needed = static_cast<std::size_t>(std::ceil(top));
  require(equation.initial.size() >= needed, "an initial value is missing");
  equation.initial.resize(needed);
  for (const auto& [coefficient, power, from] : equation.loads) {
    require(std::isfinite(coefficient), "loads have to be finite");
    require(power > -1.0 && std::isfinite(power), "powers of loads have to be above -1");
    require(from >= 0.0 && std::isfinite(from), "loads have to start at a time from 0 on");
  }
  for (const double order : orders)
    require(order >= 0.0 && std::ceil(order) <= std::ceil(top), "this derivative is not known at 0");
  return equation;
}

// Of a checked equation.
class LinearSolution {
 public:
  LinearSolution(LinearEquation equation, std::vector<double> orders)
      : equation_(std::move(equation)),
        orders_(std::move(orders)),
        quick_(equation_, orders_),
        zeros_(find_zeros(quick_.characteristic)) {}

  [[nodiscard]] bool real() const { return quick_.real; }
  [[nodiscard]] std::vector<DoubleBounded> at(double t) const;
  [[nodiscard]] std::vector<Bounded<BigReal>> at(double t, int digits) const;

 private:
  [[nodiscard]] std::vector<Sum<long double>> in_long_double(double t) const;
  [[nodiscard]] std::vector<Sum<BigReal>> in_digits(double t, int digits) const;
  [[nodiscard]] int phase_digits(double t) const;

  LinearEquation equation_;
  std::vector<double> orders_;
  LinearTransform<long double> quick_;
  std::vector<Zero<long double>> zeros_;
};

// What there is of a real solution besides its real part is rounding, or what a conjugate node cancels.
template <class Real>
void drop_imaginary_parts(std::vector<Sum<Real>>& sums) {
  for (auto& sum : sums) sum.value = Complex<Real>(real_part<Real>(sum.value));
}

std::vector<Sum<long double>> LinearSolution::in_long_double(double t) const {
  std::vector<Sum<long double>> sums(orders_.size());
  for (const auto& group : quick_.groups) {
    const long double time = decimal<long double>(t) - group.from;
    if (time == 0.0L) quick_.add_start_values(group, sums);
    if (time <= 0.0L) continue;
    std::vector<Complex<long double>> log_poles;
    for (const auto& zero : zeros_) log_poles.push_back(zero.log + std::log(time));
    const auto& contour = contour_away_from(log_poles);
    LinearResponse<long double> response(quick_, group, time);
    response.add_to(sums, zeros_, contour);
    response.add_discretisation(sums, contour);
  }
  if (real()) drop_imaginary_parts(sums);
  return sums;
}

std::vector<Sum<BigReal>> LinearSolution::in_digits(double t, int digits) const {
  const LinearTransform<BigReal> transform(equation_, orders_);
  const auto zeros = polished(transform.characteristic, zeros_);
  const Contour<BigReal> contour = contour_for(digits);
  std::vector<Sum<BigReal>> sums(orders_.size());
  for (const auto& group : transform.groups) {
    const BigReal time = decimal<BigReal>(t) - group.from;
    if (time == 0) transform.add_start_values(group, sums);
    if (time > 0) LinearResponse<BigReal>(transform, group, time).add_to(sums, zeros, contour);
  }
  if (real()) drop_imaginary_parts(sums);
  return sums;
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
  require(t >= 0.0 && std::isfinite(t), "times have to be finite and not negative");
  const auto sums = in_long_double(t);
  const auto settled = [&](const Sum<long double>& sum) {
    return sum.infinite || (std::isfinite(sum.error) && sum.error <= double_tolerance * std::abs(sum.value));
  };
  std::vector<DoubleBounded> values;
  if (std::ranges::all_of(sums, settled)) {
    for (const auto& sum : sums) values.push_back(to_double(sum.value, sum.error));
    return values;
  }
  const Precision precision(contour_precision(double_digits));
  for (const auto& value : at(t, double_digits)) values.push_back(to_double(value));
  return values;
}

std::vector<Decimal> in_decimal(const std::vector<Bounded<BigReal>>& values, int digits, bool pair) {
  std::vector<Decimal> texts;
  const auto write = [&](const BigReal& part, const BigReal& bound) {
    const DecimalText text = write_decimal(part, bound, digits);
    texts.push_back({text.value, write_bound(text.bound)});
  };
  for (const auto& [value, bound] : values) {
    write(real_part<BigReal>(value), bound);
    if (pair) write(imag_part<BigReal>(value), bound);
  }
  return texts;
}

Truth in_double(const std::vector<DoubleBounded>& values, bool pair) {
  const auto size = static_cast<Eigen::Index>(values.size() * (pair ? 2 : 1));
  Truth truth{Vec(size), Vec(size)};
  Eigen::Index i = 0;
  const auto put = [&](double value, double bound) {
    truth.value[i] = value;
    truth.bound[i++] = bound;
  };
  for (const auto& [value, bound] : values) {
    put(value.real(), bound);
    if (pair) put(value.imag(), bound);
  }
  return truth;
}

// Made when first asked for: a scene that is only solved needs no zeros of its characteristic function.
class LazySolution {
 public:
  LazySolution(LinearEquation equation, std::vector<double> orders)
      : equation_(checked(std::move(equation), orders)), orders_(std::move(orders)) {}
  const LinearSolution& get() {
    std::call_once(once_, [this] { solution_.emplace(equation_, orders_); });
    return *solution_;
  }

 private:
  LinearEquation equation_;
  std::vector<double> orders_;
  std::once_flag once_;
  std::optional<LinearSolution> solution_;
};

bool is_real(const LinearEquation& equation) {
  return std::ranges::all_of(equation.terms,
                             [](const auto& term) { return term.coefficient.imag() == 0.0; }) &&
         std::ranges::all_of(equation.initial, [](const auto& value) { return value.imag() == 0.0; });
}

Exact exact(const LinearEquation& equation, const std::vector<double>& orders, bool pair) {
  require(pair || is_real(equation), "a complex solution has to be asked for as a pair");
  const auto solution = std::make_shared<LazySolution>(equation, orders);
  const auto digits = [solution, pair](double t, int wanted) {
    require(t >= 0.0 && std::isfinite(t), "times have to be finite and not negative");
    require(wanted >= 1, "the number of digits has to be positive");
    const Precision precision(contour_precision(wanted));
    return in_decimal(solution->get().at(t, wanted), wanted, pair);
  };
  return {[solution, pair](double t) { return in_double(solution->get().at(t), pair); }, digits};
}

}  // namespace

Exact exact_solution(const LinearEquation& equation, const std::vector<double>& orders) {
  return exact(equation, orders, false);
}

Exact exact_solution_complex_pair(const LinearEquation& equation) { return exact(equation, {0.0}, true); }

}  // namespace fde
