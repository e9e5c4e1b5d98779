#include "mittag_leffler/digits.hpp"

#include "laplace/contour.hpp"
#include "laplace/contour_bound.hpp"
#include "numbers/bounded.hpp"
#include "numbers/reciprocal_gamma.hpp"

namespace fde {
namespace {

using Arguments = MittagLefflerArguments;

bool is_pole_of_gamma(const BigReal& x) { return x <= 0 && is_whole(x); }

// All powers of s in the transform are whole: no branch cut, and the poles are everything.
bool cut_free(const Arguments& x) { return is_whole(x.alpha) && is_whole(x.beta) && x.beta <= x.alpha; }

// Adds Res(e^s F, s*) = (1/alpha) e^(s* + (1-beta) log s*) times a factor known to that many ulps.
void add_residue(Sum<BigReal>& sum, const Arguments& x, const BigComplex& log_pole, const BigComplex& factor,
                 const BigReal& factor_ulps) {
  const BigComplex pole = x.alpha == 1 ? x.z : BigComplex(exp(log_pole));
  if (real_part<BigReal>(pole) < -8 / epsilon<BigReal>())
    return;  // e^s* is nothing, and s* may have overflowed
  const BigReal power = 1 - x.beta;
  const BigReal pole_ulps = x.alpha == 1 ? BigReal(1) : BigReal(1 + size_of(log_pole));
  const BigComplex exponent = pole + power * log_pole;
  if (exp_overflows(pole, BigReal(pole_ulps * epsilon<BigReal>()))) {
    sum.add_infinite(exp(BigComplex(BigReal(0), imag_part<BigReal>(exponent))), real_part<BigReal>(pole));
    return;
  }
  const BigComplex residue = exp(exponent) / x.alpha;
  const BigReal ulps = (size_of(pole) + factor_ulps) * pole_ulps + abs(power) * size_of(log_pole) + 4;
  sum.add(residue * factor, ulps * epsilon<BigReal>());
}

// Cut free: E = sum over the alpha roots s* of s*^alpha = z of the residues.
Sum<BigReal> sum_of_residues(const Arguments& x) {
  const BigComplex log_z = log(x.z);
  Sum<BigReal> sum;
  for (int k = 0; k < x.alpha; ++k) {
    const BigComplex turned(real_part<BigReal>(log_z),
                            BigReal(imag_part<BigReal>(log_z) + 2 * k * pi<BigReal>()));
    add_residue(sum, x, BigComplex(turned / x.alpha), BigComplex(1), BigReal(0));
  }
  return sum;
}

// s^-beta at a node, from s where a product or a quotient does.
BigComplex power_minus_beta(const Arguments& x, const Contour<BigReal>::Node& node) {
  if (x.beta == 0) return {1};
  if (x.beta == 1) return 1 / node.s;
  if (x.beta == 2) return 1 / (node.s * node.s);
  return exp(BigComplex(-x.beta * node.log_s));
}

void add_nodes(Sum<BigReal>& sum, const Arguments& x, const Contour<BigReal>& contour) {
  const bool equal = x.beta == x.alpha;
  const BigReal powers = 2 * x.alpha + abs(x.beta);
  for (const auto& node : contour.nodes()) {
    const BigComplex s_alpha = exp(BigComplex(x.alpha * node.log_s));
    const BigComplex weight =
        equal ? node.weight : BigComplex(node.weight * s_alpha * power_minus_beta(x, node));
    const BigReal ulps = 3 + powers * size_of(node.log_s);
    const auto loss = [&](const BigComplex& difference) {  // in s^alpha - z
      return BigReal(ulps * (1 + size_of(s_alpha) / size_of(difference)) * epsilon<BigReal>());
    };
    const BigComplex denominator = s_alpha - x.z, term = weight / denominator;
    if (x.real()) {
      const BigComplex with_conjugate(BigReal(2 * real_part<BigReal>(term)));
      sum.add(with_conjugate, BigReal(2 * size_of(term)), loss(denominator), BigReal(1));
      continue;
    }
    const BigComplex mirrored = conj(s_alpha) - x.z;
    sum.add(term, loss(denominator), BigReal(1));
    sum.add(BigComplex(conj(weight) / mirrored), loss(mirrored), BigReal(1));
  }
}

// The poles s*^alpha = z on all sheets, as logarithms, and what ContourBound wants to know of them. Next to 0
// beyond the range of a double they are as good as on another sheet; far out a root as large as a double
// stands for them.
struct Poles {
  std::vector<BigComplex> logs;
  std::vector<std::complex<double>> roots;
  double nearest_sheet = std::numeric_limits<double>::infinity();

  Poles(const Arguments& x, const BigComplex& log_z, double mu) {
    constexpr double most_log = 600.0, most_log_of_contour = 20.0;
    const BigReal log_size = real_part<BigReal>(log_z) / x.alpha;
    const double clamped = std::clamp(log_size.convert_to<double>() - std::log(mu), -most_log, most_log);
    for (int sheet = -6; sheet <= 6; ++sheet) {
      const BigReal argument = imag_part<BigReal>(log_z) + 2 * sheet * pi<BigReal>();
      if (log_size < -most_log) {
        const BigReal apart = -log_size - most_log_of_contour;
        nearest_sheet = std::min(nearest_sheet, BigReal(apart * x.alpha).convert_to<double>());
      } else if (abs(argument) < 2 * pi<BigReal>() * x.alpha) {
        const BigReal turned = argument / x.alpha;
        logs.emplace_back(log_size, turned);
        roots.push_back(std::polar(std::exp(clamped / 2.0), turned.convert_to<double>() / 2.0));
      } else {
        nearest_sheet = std::min(nearest_sheet, abs(argument).convert_to<double>());
      }
    }
  }
};

// The residues that are beyond all exponents; then nothing else matters.
Sum<BigReal> overflowing_residues(const Arguments& x) {
  constexpr double least_log = 40.0;  // of |s*|: to overflow
  Sum<BigReal> sum;
  for (const BigComplex& log_pole : Poles(x, log(x.z), 1.0).logs) {
    if (real_part<BigReal>(log_pole) < least_log ||
        abs(BigReal(imag_part<BigReal>(log_pole))) > pi<BigReal>())
      continue;
    Sum<BigReal> residue;
    add_residue(residue, x, log_pole, BigComplex(1), BigReal(0));
    if (residue.infinite) sum.add_infinite(residue.value, residue.largest_exponent);
  }
  return sum;
}

Sum<BigReal> on_contour(const Arguments& x, int digits) {
  const BigComplex log_z = log(x.z);
  const auto exponent = BigReal(x.alpha - x.beta).convert_to<double>();
  const Contour<BigReal>& contour = contour_for(digits, exponent);
  const ContourShape shape = contour.shape();
  const Poles poles(x, log_z, shape.mu);
  const auto [log_bound, distance] =
      ContourBound(shape).at({.exponent = exponent,
                              .alpha = x.alpha.convert_to<double>(),
                              .log_size = real_part<BigReal>(log_z).convert_to<double>(),
                              .nearest_sheet = poles.nearest_sheet,
                              .roots = poles.roots});
  Sum<BigReal> sum;
  for (std::size_t i = 0; i < poles.logs.size(); ++i) {
    if (!ContourBound::counts(poles.roots[i], distance)) continue;
    const BigComplex factor = contour.pole_factor(poles.logs[i]);
    const BigReal off = size_of(BigComplex(factor - 1));
    // Beyond both lines the factor should be 1.
    const BigReal beyond =
        poles.roots[i].real() > shape.nearer_far_line() ? BigReal(off / epsilon<BigReal>()) : BigReal(0);
    add_residue(sum, x, poles.logs[i], factor, BigReal(contour.omega() * off + beyond));
  }
  add_nodes(sum, x, contour);
  sum.error += exp(BigReal(log_bound));
  return sum;
}

void scale(Sum<BigReal>& sum, const BigComplex& factor) {
  sum.value *= factor;
  sum.error = size_of(factor) * sum.error + 8 * epsilon<BigReal>() * size_of(sum.value);
}

// Far out the head of the asymptotic expansion is most of the value, and all of it where beta = alpha makes
// the first term vanish; exact with what is left:
//   E_{alpha,beta}(z) = -z^-1 / Gamma(beta - alpha) - z^-2 / Gamma(beta - 2 alpha) + z^-2 E_{alpha,beta-2
//   alpha}(z).
Sum<BigReal> peeled(const Arguments& x, int digits) {
  const BigComplex inverse = 1 / x.z, square = inverse * inverse;
  const BigReal first = x.beta - x.alpha, second = first - x.alpha;
  Sum<BigReal> sum = on_contour({x.alpha, second, x.z}, digits);
  scale(sum, square);
  add_reciprocal_gamma(sum, -inverse, first, BigReal(abs(x.beta) + x.alpha));
  add_reciprocal_gamma(sum, -square, second, BigReal(abs(x.beta) + 2 * x.alpha));
  return sum;
}

Sum<BigReal> evaluate(const Arguments& x, int digits) {
  if (x.z == 0) {
    Sum<BigReal> sum;
    add_reciprocal_gamma(sum, BigComplex(1), x.beta,
                         BigReal(is_whole(x.beta) ? BigReal(0) : BigReal(abs(x.beta))));
    return sum;
  }
  if (cut_free(x)) return sum_of_residues(x);
  Sum<BigReal> overflow = overflowing_residues(x);
  if (overflow.infinite) return overflow;
  constexpr double far = 65536.0;
  if (!is_pole_of_gamma(x.beta)) return size_of(x.z) < far ? on_contour(x, digits) : peeled(x, digits);
  // The first term of the series is 0: E_{alpha,beta}(z) = z E_{alpha,alpha+beta}(z), where less cancels.
  Sum<BigReal> sum = evaluate({x.alpha, BigReal(x.alpha + x.beta), x.z}, digits);
  scale(sum, x.z);
  return sum;
}

// Digits by which the phases of e^s* exceed one turn, of those that are not far on the left.
int phase_digits(const Arguments& x) {
  if (x.z == 0) return 0;
  constexpr double most = 1000.0, left = -1e-3;
  const Poles poles(x, log(x.z), 1.0);
  double digits = 0.0;
  for (const BigComplex& log_pole : poles.logs) {
    const auto turned = imag_part<BigReal>(log_pole).convert_to<double>();
    if (std::abs(turned) < 1.01 * std::numbers::pi && std::cos(turned) > left)
      digits = std::max(digits, real_part<BigReal>(log_pole).convert_to<double>() / std::numbers::ln10);
  }
  return static_cast<int>(std::min(digits, most)) + 1;
}

}  // namespace

Bounded<BigReal> mittag_leffler_to(int digits, int places,
                                   const std::function<MittagLefflerArguments()>& read) {
  const int extra = phase_digits(read()) + places;
  return raise_digits(digits, extra, [&](int working) { return evaluate(read(), working); });
}

}  // namespace fde
