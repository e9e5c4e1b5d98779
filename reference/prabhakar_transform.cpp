#include "prabhakar_transform.hpp"

#include "roots_on_sheet.hpp"

namespace fde {
namespace {

using Long = long double;
using Point = EnclosingContour::Point;
using Node = EnclosingContour::Node;
using Disc = EnclosingContour::Disc;
using Arguments = PrabhakarArguments<BigReal>;

constexpr Long infinity = std::numeric_limits<Long>::infinity();
constexpr Long half_turn = std::numbers::pi_v<Long>;
constexpr Long hair = 1e-9L;  // more than all rounding in the majorants

// The arguments for the geometry; z may be beyond all exponents of long double.
struct Shape {
  Long alpha, beta, gamma;
  Point log_z;
  std::vector<Point> log_roots, roots;  // s*, on the sheet

  [[nodiscard]] bool whole_alpha() const { return is_whole(alpha); }
  [[nodiscard]] Long power() const { return alpha * gamma - beta; }  // of s beside (s^alpha - z)^-gamma
  bool whole_power = false;                                          // it is, and not negative

  [[nodiscard]] bool cut_free() const { return whole_alpha() && whole_power; }
  // Far from all s* a whole power leaves little of F but s^power, which has nothing to contribute.
  [[nodiscard]] bool peeled() const {
    constexpr Long far = -1e6L;
    const auto is_far = [](const Point& s) { return s.real() < far; };
    return whole_power && !whole_alpha() && std::log(-far) * alpha < log_z.real() &&
           std::ranges::all_of(roots, is_far);
  }
};

Shape shape_of(const Arguments& x) {
  const BigComplex log_z = log(x.z);
  const BigReal power = x.alpha * x.gamma - x.beta;
  Shape shape{
      .alpha = x.alpha.convert_to<Long>(),
      .beta = x.beta.convert_to<Long>(),
      .gamma = x.gamma.convert_to<Long>(),
      .log_z = {real_part<BigReal>(log_z).convert_to<Long>(), imag_part<BigReal>(log_z).convert_to<Long>()},
      .log_roots = {},
      .roots = {},
      .whole_power = is_whole(power) && power >= 0};
  for (const auto& root : roots_on_sheet(shape.alpha, shape.log_z)) {
    shape.log_roots.push_back(root.logarithm);
    shape.roots.push_back(root.value);
  }
  return shape;
}

Point long_point(const BigComplex& s) {
  return {real_part<BigReal>(s).convert_to<Long>(), imag_part<BigReal>(s).convert_to<Long>()};
}

// A bound of |s|^power on a disc, its logarithm.
Long log_power(const Disc& disc, Long power) {
  const Long size = std::abs(disc.centre);
  if (power >= 0.0L) return power == 0.0L ? 0.0L : power * std::log(size + disc.radius);
  return size > disc.radius ? power * std::log(size - disc.radius) : infinity;
}

// Whole alpha: F = s^(alpha gamma - beta) product of (s - s*)^-gamma.
Long majorant_by_roots(const Shape& x, const Disc& disc) {
  Long sum = log_power(disc, x.power());
  for (const auto& root : x.roots) sum += log_power({disc.centre - root, disc.radius}, -x.gamma);
  return sum + hair;
}

// With u = alpha log s - log z, 1 - z s^-alpha = 1 - e^-u; of 1 - e^-u and e^u - 1 the one that is not large.
Long majorant_by_logarithm(const Shape& x, const Disc& disc) {
  const Long size = std::abs(disc.centre);
  if (disc.radius >= 0.5L * size) return infinity;
  const Long spread = -x.alpha * std::log1p(-disc.radius / size);  // of u on the disc
  const Point u = x.alpha * std::log(disc.centre) - x.log_z;
  const bool far = u.real() >= 0.0L;
  const Point exponential = std::exp(far ? -u : u);
  const Long centre = std::abs(1.0L - exponential), off = std::abs(exponential) * std::expm1(spread);
  const Long least = centre * (1.0L - hair) - off;
  if (x.gamma > 0.0L && least <= hair * centre + hair * hair) return infinity;
  const Long other = far ? 0.0L : x.gamma * (u.real() + (x.gamma > 0.0L ? spread : -spread));
  const Long log_factor = -x.gamma * std::log(x.gamma > 0.0L ? least : centre + off);
  return log_power(disc, -x.beta) + log_factor + other + hair * (1.0L + std::abs(x.gamma));
}

// Without the head (-z)^-gamma s^power: |(1 - x)^-gamma - 1| <= e^(|gamma| |x| / (1 - |x|)) - 1, x = s^alpha
// / z.
Long majorant_without_head(const Shape& x, const Disc& disc) {
  const Long log_ratio = log_power(disc, x.alpha) - x.log_z.real();
  if (log_ratio > std::log(0.5L)) return infinity;
  const Long ratio = std::exp(log_ratio), exponent = std::abs(x.gamma) * ratio / (1.0L - ratio);
  const Long log_factor =
      exponent > 1.0L
          ? exponent
          : log_ratio + std::log(std::abs(x.gamma) * std::expm1(exponent) / exponent / (1.0L - ratio));
  return log_power(disc, x.power()) - x.gamma * x.log_z.real() + log_factor +
         hair * (1.0L + std::abs(x.gamma * x.log_z.real()));
}

// The logarithm of 1 - z s^-alpha with cuts from the s* to the left. The principal one is cut along the lines
// from 0 to the s* instead: between these and the negative axis it is a turn off. (Points of the contour
// are there only for s* that were left out.)
BigComplex log_with_cuts_to_the_left(const Shape& x, const Point& s, const BigComplex& argument) {
  BigComplex value = log(argument);
  const Long height = std::abs(s.imag()), angle = std::arg(s);
  for (std::size_t k = 0; k < x.roots.size(); ++k) {
    const Long root_angle = x.log_roots[k].imag(), sign = root_angle > 0.0L ? 1.0L : -1.0L;
    if (sign * s.imag() <= 0.0L || height >= std::abs(x.roots[k].imag())) continue;
    const Long beyond = sign * x.alpha * (angle - root_angle);
    constexpr Long unsure = 0.1L;  // there the logarithm itself says on which side of its cut it is
    const bool crossed = std::abs(beyond) < unsure ? sign * imag_part<BigReal>(value) > 0 : beyond > 0.0L;
    if (crossed) value -= BigComplex(BigReal(0), BigReal(2 * sign * pi<BigReal>()));
  }
  return value;
}

// F at the nodes, at one precision.
class Evaluation {
 public:
  Evaluation(const Arguments& x, const Shape& shape)
      : x_(x), shape_(shape), power_(x.alpha * x.gamma - x.beta), log_z_(log(x.z)) {
    for (const auto& root : shape.log_roots) {
      const auto turns = std::round((shape.alpha * root.imag() - shape.log_z.imag()) / (2.0L * half_turn));
      const BigComplex turned = log_z_ + BigComplex(BigReal(0), BigReal(2 * turns * pi<BigReal>()));
      roots_.push_back(x.alpha == 1 ? x.z : exp(BigComplex(turned / x.alpha)));
    }
  }

  void add(const Node& node, std::vector<Sum<BigReal>>& sums) const {
    sums.resize(1);
    BigReal ulps = 8 + 4 * size_of(node.s);
    const BigComplex value = shape_.whole_alpha() ? by_roots(node, ulps)
                             : shape_.peeled()    ? without_head(node, ulps)
                                                  : by_logarithm(node, ulps);
    sums.front().add(BigComplex(node.weight * value), BigReal(ulps * epsilon<BigReal>()));
  }

 private:
  // Whole alpha: F = s^(alpha gamma - beta) product of (s - s*)^-gamma.
  BigComplex by_roots(const Node& node, BigReal& ulps) const {
    BigComplex exponent = power_ * node.log_s;
    const BigReal root_ulps = 2 + 2 * size_of(log_z_);
    for (const auto& root : roots_) {
      const BigComplex difference = node.s - root, logarithm = log(difference);
      exponent -= x_.gamma * logarithm;
      const BigReal loss = (size_of(node.s) + root_ulps * size_of(root)) / size_of(difference);
      ulps += abs(x_.gamma) * (4 + 2 * size_of(logarithm) + 2 * loss);
    }
    ulps += 4 * abs(power_) * (1 + size_of(node.log_s));
    return exp(exponent);
  }

  // F = s^-beta (1 - z s^-alpha)^-gamma.
  BigComplex by_logarithm(const Node& node, BigReal& ulps) const {
    const BigComplex ratio = exp(BigComplex(log_z_ - x_.alpha * node.log_s)), factor = 1 - ratio;
    const BigComplex logarithm = log_with_cuts_to_the_left(shape_, long_point(node.s), factor);
    const BigReal ratio_ulps = 4 + 4 * (size_of(log_z_) + x_.alpha * size_of(node.log_s));
    ulps += abs(x_.gamma) * (4 + 2 * size_of(logarithm) + 2 * ratio_ulps * size_of(ratio) / size_of(factor));
    ulps += 4 * abs(x_.beta) * (1 + size_of(node.log_s));
    return exp(BigComplex(-x_.beta * node.log_s - x_.gamma * logarithm));
  }

  // F - (-z)^-gamma s^power = (-z)^-gamma s^power ((1 - s^alpha / z)^-gamma - 1): power is whole and not
  // negative, so that what is taken away contributes nothing.
  BigComplex without_head(const Node& node, BigReal& ulps) const {
    const BigComplex ratio = exp(BigComplex(x_.alpha * node.log_s - log_z_));
    BigComplex power = -x_.gamma * log_of_one_minus(ratio);
    ulps += 16 + 8 * (size_of(log_z_) + x_.alpha * size_of(node.log_s)) + 4 * abs(x_.gamma);
    ulps += 4 * (power_ + abs(x_.gamma)) * (1 + size_of(node.log_s) + size_of(log_z_));
    const BigComplex head = power_ * node.log_s - x_.gamma * log(BigComplex(-x_.z));
    return exp(head) * exponential_less_one(power);
  }

  // log(1 - x) = -2 artanh(x / (2 - x)) = -2 sum y^(2k+1) / (2k+1), and e^x - 1 by its series: |x| is small.
  static BigComplex log_of_one_minus(const BigComplex& x) {
    const BigComplex y = x / (2 - x), square = y * y;
    BigComplex sum(0), power = y;
    for (int k = 1; size_of(power) > epsilon<BigReal>() * size_of(sum); k += 2, power *= square)
      sum += power / BigReal(k);
    return -2 * sum;
  }
  static BigComplex exponential_less_one(const BigComplex& x) {
    if (size_of(x) > 0.5) return exp(x) - BigReal(1);
    BigComplex sum(0), term = x;
    for (int k = 2; size_of(term) > epsilon<BigReal>() * size_of(sum); ++k) {
      sum += term;
      term *= x / BigReal(k);
    }
    return sum;
  }

  Arguments x_;
  Shape shape_;
  BigReal power_;
  BigComplex log_z_;
  std::vector<BigComplex> roots_;
};

}  // namespace

EnclosedTransform prabhakar_transform(const ReadPrabhakar& read) {
  constexpr int enough_digits = 40;
  const Precision precision(enough_digits);
  const Arguments x = read();
  const Shape shape = shape_of(x);
  EnclosedTransform transform{
      .singularities = shape.roots,
      .hints = {.order = std::abs(shape.gamma),
                .growth = std::abs(shape.beta) + std::abs(shape.gamma) * (1.0L + shape.alpha)},
      .real = x.real()};
  if (!shape.cut_free()) transform.singularities.emplace_back(0.0L);
  transform.prepare = [read, shape] {
    return [evaluation = Evaluation(read(), shape)](const Node& node, std::vector<Sum<BigReal>>& sums) {
      evaluation.add(node, sums);
    };
  };
  transform.majorants = {[shape](const Disc& disc) {
    return shape.whole_alpha() ? majorant_by_roots(shape, disc)
           : shape.peeled()    ? majorant_without_head(shape, disc)
                               : majorant_by_logarithm(shape, disc);
  }};
  return transform;
}

Sum<BigReal> prabhakar_series(const PrabhakarArguments<BigReal>& x) {
  Sum<BigReal> sum;
  BigComplex factor(1);  // (gamma)_k z^k / k!
  const BigReal size = abs(x.z);
  for (int k = 0;; ++k) {
    const BigReal argument = x.alpha * k + x.beta;
    const BigComplex term = factor * reciprocal_gamma(argument);
    const BigReal ulps = 8 + 8 * BigReal(k) + abs(argument) * (2 + 2 * log1p(abs(argument)));
    sum.add(term, BigReal(ulps * epsilon<BigReal>()));
    factor *= x.z * (x.gamma + k) / BigReal(k + 1);
    if (factor == 0) return sum;
    // From here on |(gamma)_k / k!| grows by less than ratio / |z|, and 1/Gamma falls.
    const BigReal next = x.gamma + k + 1;
    const BigReal ratio = size * std::max(BigReal(1), BigReal(abs(next) / (k + 2)));
    if (argument < 2 || next <= 0 || ratio > 0.9) continue;
    const BigReal tail = size_of(factor) * reciprocal_gamma(argument) / (1 - ratio);
    if (tail > epsilon<BigReal>() * size_of(sum.value)) continue;
    sum.error += tail;
    return sum;
  }
}

}  // namespace fde
