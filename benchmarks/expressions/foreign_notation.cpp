// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/foreign_notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "fdebench/benchmarks/expressions/formula_tokens.hpp"

namespace fde::bench {
namespace {

// Names in lower case, or symbols, each between blanks.
struct ForeignNotation {
  std::string_view notations, here;
};

constexpr std::string_view conditions_here =
    "there are no conditions; step(a - b) is 1 for a > b and 0 for a < b, so that y + (z - y)*step(a - b) is "
    "z "
    "for a > b and y for a < b";
constexpr std::string_view complex_numbers_here =
    "numbers are real; write the real and the imaginary part as two unknowns, as in fdebench scenes "
    "relaxation_pair --toml";
constexpr std::string_view remainder_here =
    "the remainder with the sign of a is mod(x, a), a sawtooth mod(t, 1)";
constexpr std::string_view unknown_of_integral_here =
    "there are no integrals; one from 0 to t is an unknown with order = 1, the integrand as rhs and initial "
    "= [0]";
constexpr std::string_view derivative_here = "the derivative of order q of an unknown x is D(x, q)";
constexpr std::string_view prefix_here = "names have no prefix: sin(t), pi";

constexpr std::array foreign_functions{
    ForeignNotation{" sgn signum ", "here it is sign(x)"},
    ForeignNotation{" heaviside heavisidetheta unitstep hstep stepfun ustep theta ", "here it is step(x)"},
    ForeignNotation{" ln loge ", "here it is log(x)"},
    ForeignNotation{" log10 lg ", "here it is log(x)/log(10)"},
    ForeignNotation{" log2 ld lb ", "here it is log(x)/log(2)"},
    ForeignNotation{" log1p ", "here it is log(1 + x)"},
    ForeignNotation{" expm1 ", "here it is exp(x) - 1"},
    ForeignNotation{" exp2 ", "here it is 2^x"},
    ForeignNotation{" pow power mpower ", "here it is x^y"},
    ForeignNotation{" sqr ", "here it is x^2"},
    ForeignNotation{" square ", "x squared is x^2, a square wave sign(sin(x))"},
    ForeignNotation{" cbrt nthroot surd ", "the cube root is sign(x)*abs(x)^(1/3)"},
    ForeignNotation{" fabs absolute norm ", "here it is abs(x)"},
    ForeignNotation{" arcsin ", "here it is asin(x)"},
    ForeignNotation{" arccos ", "here it is acos(x)"},
    ForeignNotation{" arctan ", "here it is atan(x)"},
    ForeignNotation{" arctan2 ", "here it is atan2(y, x)"},
    ForeignNotation{" asinh arcsinh arsinh ", "here it is log(x + sqrt(x^2 + 1))"},
    ForeignNotation{" acosh arccosh arcosh ", "here it is log(x + sqrt(x^2 - 1))"},
    ForeignNotation{" atanh arctanh artanh ", "here it is log((1 + x)/(1 - x))/2"},
    ForeignNotation{" cot cotan ", "here it is 1/tan(x)"},
    ForeignNotation{" sec ", "here it is 1/cos(x)"},
    ForeignNotation{" csc cosec ", "here it is 1/sin(x)"},
    ForeignNotation{" coth ", "here it is 1/tanh(x)"},
    ForeignNotation{" sech ", "here it is 1/cosh(x)"},
    ForeignNotation{" csch ", "here it is 1/sinh(x)"},
    ForeignNotation{" sind ", "here it is sin(pi*x/180)"},
    ForeignNotation{" cosd ", "here it is cos(pi*x/180)"},
    ForeignNotation{" sinc ", "here it is sin(x)/x, in MATLAB and NumPy sin(pi*x)/(pi*x)"},
    ForeignNotation{" hypot ", "here it is sqrt(x^2 + y^2)"},
    ForeignNotation{" clip clamp saturate saturation sat ", "here it is min(max(x, a), b)"},
    ForeignNotation{" fix trunc ", "here it is sign(x)*floor(abs(x))"},
    ForeignNotation{" ceiling ", "here it is ceil(x)"},
    ForeignNotation{" round rint nint ", "here it is floor(x + 0.5)"},
    ForeignNotation{" fmod rem ", "here it is sign(x)*mod(abs(x), y) for y > 0"},
    ForeignNotation{" modulo remainder sawtooth ", remainder_here},
    ForeignNotation{" rect rectpuls boxcar unitbox rectangularpulse pulse ",
                    "from a to b it is step(t - a) - step(t - b)"},
    ForeignNotation{" tri tripuls trianglewave ",
                    "a triangle is max(0, 1 - abs(x)), a triangle wave asin(sin(x))"},
    ForeignNotation{" dirac diracdelta delta impulse ",
                    "there is no impulse; a pulse of area 1 is (step(t - a) - step(t - b))/(b - a)"},
    ForeignNotation{" erfcx ", "here it is mittag_leffler(0.5, 1, -x)"},
    ForeignNotation{" tgamma ", "here it is gamma(x)"},
    ForeignNotation{" lgamma gammaln loggamma ", "here it is log(gamma(x)) for x > 0"},
    ForeignNotation{" factorial ", "n! is gamma(n + 1)"},
    ForeignNotation{" nchoosek binomial binom comb ",
                    "here it is gamma(n + 1)/(gamma(k + 1)*gamma(n - k + 1))"},
    ForeignNotation{" beta ", "here it is gamma(a)*gamma(b)/gamma(a + b)"},
    ForeignNotation{" ml mlf mittag mittagleffler mittaglefflere mittag_leffler_e ",
                    "here it is mittag_leffler(alpha, beta, z)"},
    ForeignNotation{" if iff iif ifelse where piecewise select switch cond which boole ", conditions_here},
    ForeignNotation{" diff dt ddt deriv derivative dot gradient caputo fderiv ", derivative_here},
    ForeignNotation{" int integral integrate quad quadgk trapz cumtrapz cumsum ", unknown_of_integral_here},
    ForeignNotation{" delay lag history ", "x at the time t - tau is x(t - tau)"},
    ForeignNotation{
        " rand randn random normal uniform ",
        "there are no random numbers; a value v that holds from a to b is v*(step(t - a) - step(t - b))"},
    ForeignNotation{
        " interp interp1 interp1d interpolate interpolation lookup table griddedinterpolant spline ",
        "a function of samples is a [table.u] with file = \"u.csv\", called as u(t)"},
    ForeignNotation{" summation ", "here it is sum(j, 1, 3, j*x)"},
    ForeignNotation{" prod product ", "write the factors one by one"},
    ForeignNotation{" real imag re im conj complex ", complex_numbers_here},
};

constexpr std::array foreign_names{
    ForeignNotation{" e m_e exponentiale ", "e^x is exp(x)"},
    ForeignNotation{" pi m_pi ", "here it is pi"},
    ForeignNotation{" i j imaginaryi ", complex_numbers_here},
    ForeignNotation{" inf infinity nan ", "numbers are finite"},
    ForeignNotation{" np numpy math cmath scipy sympy std ", prefix_here},
    ForeignNotation{" if then else elif and or not xor otherwise ", conditions_here},
    ForeignNotation{" true ", "here it is 1"},
    ForeignNotation{" false ", "here it is 0"},
};

// Symbols and words that begin a text.
constexpr std::array foreign_symbols{
    ForeignNotation{" < > == != ! & | ? : ~ \u2264 \u2265 \u2260 if else and or not ", conditions_here},
    ForeignNotation{" = ", "a formula has no =; an equation a = b is the formula a - b, which is 0"},
    ForeignNotation{" % ", remainder_here},
    ForeignNotation{" .^ .* ./ ", "operations are written without a point: ^ * /"},
    ForeignNotation{" [ ] { } ", "brackets are round: sin(t)"},
    ForeignNotation{" ' \u2202 \u2032 ", derivative_here},
    ForeignNotation{" ; ", "a formula has no ';' at its end"},
    ForeignNotation{" # // /* ", "comments must be outside of the quotes"},
    ForeignNotation{" @ ", "a formula is only what the function returns"},
    ForeignNotation{" \\ ", "a formula is not in LaTeX: sin(t), a/b"},
    ForeignNotation{" \u2212 \u2010 \u2013 ", "here it is -"},
    ForeignNotation{" \u00b7 \u00d7 \u22c5 \u2217 ", "here it is *"},
    ForeignNotation{" \u00f7 ", "here it is /"},
    ForeignNotation{" \u00b2 ", "here it is ^2"},
    ForeignNotation{" \u00b3 ", "here it is ^3"},
    ForeignNotation{" \u221a ", "here it is sqrt(x)"},
    ForeignNotation{" \u222b ", unknown_of_integral_here},
    ForeignNotation{" \u03c0 ", "here it is pi"},
    ForeignNotation{" \u221e ", "numbers are finite"},
};

std::string hint_text(std::string_view here) { return here.empty() ? "" : fmt::format("; {}", here); }

std::string hint_of(std::span<const ForeignNotation> table, std::string_view notation) {
  std::string word = fmt::format(" {} ", notation);
  std::ranges::transform(word, word.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found = std::ranges::find_if(
      table, [&](const ForeignNotation& one) { return one.notations.find(word) != std::string_view::npos; });
  return hint_text(found == table.end() ? "" : found->here);
}

// Keys of equation files.
constexpr std::array foreign_keys{
    ForeignNotation{" history past delay delays lag tau ",
                    "a delay is x(t - tau) in rhs, and the key before of x has x(t) for t < 0"},
    ForeignNotation{
        " boundary bc at_end terminal ",
        "the value at the end is final = [1.0], or a table of derivatives, in place of an initial value"},
    ForeignNotation{" reset action jump_to assign then ",
                    "what unknowns become at an event is set = { x = \"x + 1\" }"},
    ForeignNotation{" tf transfer_function num den numerator denominator plant laplace ",
                    "a transfer function is transfer = \"1/(s^1.2 + 1)\", with its input"},
    ForeignNotation{" lookup interp signal samples_of data ",
                    "a function of samples is a [table.u] with file = \"u.csv\", called as u(t)"},
    ForeignNotation{" hamiltonian kinetic potential ", "write T - V as the lagrangian"},
    ForeignNotation{" dissipation rayleigh friction damping ",
                    "write it as a force, as forces = { x = \"-0.1*D(x,1)\" }"},
    ForeignNotation{" begin t0 from tstart t_start ", "here it is start"},
    ForeignNotation{" until tspan t_end tend stop duration tmax t_final ", "here it is end"},
    ForeignNotation{" scheme steps grid accuracy tolerance method solver ",
                    "it is an option of the commands"},
    ForeignNotation{" type definition kind operator ", "derivatives are those of Caputo"},
    ForeignNotation{" alpha gamma q derivative ", "here it is order"},
    ForeignNotation{" ic y0 x0 init start_value ", "here it is initial, a list"},
    ForeignNotation{" f equation lhs right ", "here it is rhs, of terms = rhs"},
};

}  // namespace

std::string function_hint(std::string_view name) { return hint_of(foreign_functions, name); }

std::string name_hint(std::string_view name) { return hint_of(foreign_names, name); }

std::string key_hint(std::string_view name) { return hint_of(foreign_keys, name); }

std::string symbol_hint(std::string_view from, bool follows_number, bool follows_value) {
  const auto first = next_token(from, 0).text;
  if (first.empty()) return "";
  if (!follows_value && first == "|") return hint_text("|x| is abs(x)");
  if (!follows_value && first == "%") return "";  // %pi of Maxima
  if (follows_value && first == "!" && !from.starts_with("!=")) return hint_text("n! is gamma(n + 1)");
  for (const std::size_t length : {std::size_t{2}, first.size()})
    if (auto known = hint_of(foreign_symbols, from.substr(0, length)); !known.empty()) return known;
  const bool has_digit = first == "," && from.size() > 1 && is_digit(from[1]);
  if (follows_number && has_digit) return hint_text("a decimal has a point, as 1.5");
  if (follows_number && (first == "i" || first == "j")) return hint_text(complex_numbers_here);
  if (follows_number && first.find_first_not_of("dD0123456789") == std::string_view::npos)
    return hint_text("the exponent of a decimal follows e, as in 1e-3");
  const bool is_factor = is_letter(first.front()) || is_digit(first.front()) || first == "(";
  return follows_value && is_factor ? hint_text("a product needs its '*'") : "";
}

}  // namespace fde::bench
