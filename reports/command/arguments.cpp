#include "command/arguments.hpp"

#include "scenes/number_text.hpp"

namespace fde {

ComplexText split_complex(std::string_view text) {
  if (!text.ends_with('i')) return {std::string(text), "0"};
  text.remove_suffix(1);
  // the last sign that begins a number and not an exponent
  auto sign = text.find_last_of("+-");
  while (sign != std::string_view::npos && sign > 0 && (text[sign - 1] == 'e' || text[sign - 1] == 'E'))
    sign = text.find_last_of("+-", sign - 1);
  const std::size_t begin = sign == std::string_view::npos ? 0 : sign;
  std::string im(text.substr(begin));
  if (im.empty() || im == "+" || im == "-") im += "1";
  return {begin == 0 ? "0" : std::string(text.substr(0, begin)), im};
}

Grid parse_grid(std::string_view text, double end, int steps) {
  constexpr std::string_view graded = "graded:";
  Grid grid{.end = end, .steps = steps};
  if (text.starts_with(graded)) {
    grid.grading = parse_number("--grid graded", text.substr(graded.size()), {.low = 1.0, .high = 100.0});
  } else if (text != "uniform") {
    reject_text("--grid", text, "uniform or graded:R with R in [1, 100]");
  }
  return grid;
}

const Scheme& scheme_named(std::string_view id) { return entry_named(schemes(), "scheme", id); }

}  // namespace fde
