#include "decimal_arguments.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace fde {
namespace {

template <class Number>
void check_order(const std::string& function, const Number& alpha) {
  if (alpha > 0 && alpha <= 5) return;
  throw std::invalid_argument(
      fmt::format("{}: alpha = {} has to be in (0, 5]", function, static_cast<double>(alpha)));
}

}  // namespace

BigReal read_argument(const std::string& function, const std::string& name, const std::string& text) {
  try {
    return parse<BigReal>(text);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}: {}", function, name, error.what()));
  }
}

void require_order(const std::string& function, double alpha) { check_order(function, alpha); }
void require_order(const std::string& function, const BigReal& alpha) { check_order(function, alpha); }

void require_digits(const std::string& function, int digits) {
  if (digits < 1)
    throw std::invalid_argument(fmt::format("{}: digits = {} has to be positive", function, digits));
}

DecimalComplex write_complex(const Bounded<BigReal>& x, bool real, int digits) {
  const DecimalText re = write_decimal(real_part<BigReal>(x.value), x.bound, digits);
  if (real) return {re.value, "0", write_bound(re.bound)};
  const DecimalText im = write_decimal(imag_part<BigReal>(x.value), x.bound, digits);
  return {re.value, im.value, write_bound(BigReal(re.bound + im.bound))};
}

}  // namespace fde
