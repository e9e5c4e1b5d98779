// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/vector_components.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/file_formulas.hpp"
#include "fdebench/benchmarks/expressions/formula_tokens.hpp"

namespace fde::bench {
namespace {

// Changes the formulas of a vector to those of one component.
class Component {
 public:
  Component(const VectorText& vector, int index) : vector_(vector), index_(index) {}

  void bind(FormulaText& formula) const {
    formula.index = index_;
    formula.size = vector_.size;
  }
  void bind(std::optional<FormulaText>& formula) const {
    if (formula) bind(*formula);
  }
  void bind(NamedFormula& one) const {
    one.name = with_index(one.name);
    bind(one.formula);
  }

  [[nodiscard]] UnknownText of(UnknownText unknown) const {
    unknown.name = with_index(unknown.name);
    for (auto& [coefficient, order] : unknown.terms) bind(coefficient), bind(order);
    for (auto& [weight, from, to] : unknown.distributed) bind(weight), bind(from), bind(to);
    bind(unknown.factor);
    bind(unknown.rhs);
    for (auto& value : unknown.initial) bind(value);
    bind(unknown.before);
    for (auto& value : unknown.final) bind(value);
    return unknown;
  }

  // The name of the vector, alone or in D(u, q), with the index behind it.
  [[nodiscard]] std::string with_index(const std::string& column) const {
    const auto place = name_in(column, vector_.name);
    std::string name = column;
    return place ? name.insert(*place, fmt::format("[{}]", index_)) : name;
  }

  // The byte behind the name of a vector in a column; nullopt if it is another column, or has an index.
  static std::optional<std::size_t> name_in(const std::string& column, const std::string& vector) {
    for (auto token = next_token(column, 0); !token.text.empty();) {
      const auto end = token.byte_offset + token.text.size();
      const auto following = next_token(column, end);
      if (token.text == vector && following.text != "[") return end;
      token = following;
    }
    return std::nullopt;
  }

 private:
  const VectorText& vector_;
  int index_;
};

// What formulas of components call their number and the size of their vector.
void require_free_names(const EquationText& text, const UnknownText& vector) {
  constexpr std::array<std::string_view, 2> names{"i", "size"};
  const auto require = [&](const std::string& name, std::string_view kind) {
    if (std::ranges::find(names, name) == names.end()) return;
    reject_at(text.file, vector.position,
              fmt::format("{} {}: must have another name, the formulas of {} have this one", kind, name,
                          vector.name));
  };
  for (const auto& parameter : text.parameters) require(parameter.declared.name, "parameter");
  for (const auto& unknown : text.unknowns) require(unknown.name, "unknown");
}

int size_of(const UnknownText& unknown, std::size_t others, FileFormulas& formulas) {
  const Range allowed{.low = 1.0, .high = static_cast<double>(max_components)};
  const double size = formulas.constant(*unknown.size, "size", allowed);
  if (size != std::floor(size))
    formulas.reject(*unknown.size, fmt::format("size = {}: must be a whole number", size));
  if (others + static_cast<std::size_t>(size) > max_components) {
    formulas.reject(*unknown.size,
                    fmt::format("there are more than {} unknowns, with those of vectors", max_components));
  }
  return static_cast<int>(size);
}

// The formulas of [exact], each of a vector once for every component.
std::vector<NamedFormula> with_components(const std::vector<NamedFormula>& exact,
                                          const std::vector<VectorText>& vectors) {
  std::vector<NamedFormula> all;
  for (const auto& one : exact) {
    const auto vector = std::ranges::find_if(
        vectors, [&](const VectorText& of) { return Component::name_in(one.name, of.name).has_value(); });
    if (vector == vectors.end()) {
      all.push_back(one);
      continue;
    }
    for (int index = 1; index <= vector->size; ++index) {
      all.push_back(one);
      Component(*vector, index).bind(all.back());
    }
  }
  return all;
}

}  // namespace

EquationText with_components(EquationText text, const Parameters& parameters) {
  const auto has_size = [](const UnknownText& one) { return one.size.has_value(); };
  if (std::ranges::none_of(text.unknowns, has_size)) return text;
  const EquationText given = text;
  FileFormulas formulas(given, parameters, NumberStorage::values);
  text.unknowns.clear();
  for (const auto& unknown : given.unknowns) {
    if (!unknown.size) {
      text.unknowns.push_back(unknown);
      continue;
    }
    require_free_names(given, unknown);
    const int size = size_of(unknown, text.unknowns.size(), formulas);
    const auto& vector =
        text.vectors.emplace_back(VectorText{unknown.name, text.unknowns.size(), size, unknown.outside});
    for (int index = 1; index <= size; ++index) text.unknowns.push_back(Component(vector, index).of(unknown));
  }
  text.exact = with_components(text.exact, text.vectors);
  return text;
}

}  // namespace fde::bench
