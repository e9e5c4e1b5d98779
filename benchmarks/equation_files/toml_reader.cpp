// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <sstream>
#include <utility>

#include "fdebench/benchmarks/equation_files/deep_keys.hpp"
#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/expressions/formula.hpp"
#include "fdebench/benchmarks/equation_files/toml_text.hpp"
#include "fdebench/benchmarks/references/checksum.hpp"
#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {
namespace {

class EquationReader : TomlReader {
 public:
  using TomlReader::TomlReader;

  [[nodiscard]] EquationText read(const toml::table& all) const {
    require_keys(all, "the file",
                 {"title", "end", "parameters", "unknown", "exact", "energy", "constraint", "jump", "event"});
    EquationText read{.file = file()};
    if (const auto* title = all.get("title")) read.title = title_of(*title);
    read.end = formula(required(all, {}, "the file", "end"), "end");
    if (const auto* parameters = all.get("parameters")) read.parameters = parameters_of(*parameters);
    read.unknowns = unknowns_of(required(all, {}, "the file", "unknown"), read.parameters);
    if (const auto* exact = all.get("exact")) {
      for (const auto& entry : entries(*exact, "exact"))
        read.exact.push_back({entry.name, entry.position, formula(*entry.node, entry.name)});
    }
    if (const auto* energy = all.get("energy")) read.energy = energy_of(*energy);
    if (const auto* constraint = all.get("constraint")) read.constraints = constraints_of(*constraint);
    if (const auto* jump = all.get("jump")) read.jumps = jumps_of(*jump);
    if (const auto* event = all.get("event")) {
      for (const auto& entry : entries(*event, "event")) read.events.push_back(event_of(entry));
    }
    return read;
  }

 private:
  [[nodiscard]] std::string title_of(const toml::node& node) const {
    constexpr std::size_t longest = 200;
    const auto* text = node.as_string();
    if (text == nullptr) reject_kind(node, "title", "a text");
    const std::string& title = text->get();
    if (title.size() > longest || !is_printable(title))
      reject(position_of(node), fmt::format("title: must be at most {} bytes that print", longest));
    return title;
  }

  // A name that can be used in formulas.
  void require_name(const TomlEntry& entry, std::string_view kind) const {
    if (!is_name(entry.name)) {
      reject(entry.position, fmt::format("{} {}: must be letters, digits and _, at most 64, a letter first",
                                         kind, entry.name));
    }
    if (is_symbol(entry.name) || (kind != "parameter" && is_function(entry.name))) {
      reject(entry.position,
             fmt::format("{} {}: must be another name, formulas know this one", kind, entry.name));
    }
  }

  [[nodiscard]] std::vector<ParameterText> parameters_of(const toml::node& node) const {
    std::vector<ParameterText> parameters;
    for (const auto& entry : entries(node, "parameters")) {
      require_name(entry, "parameter");
      if (entry.name == "until")
        reject(entry.position, "parameter until: must be another name, this one sets the end");
      const auto number = entry.node->value<double>();
      if (!entry.node->is_number()) reject_kind(*entry.node, entry.name, "a number");
      if (!std::isfinite(*number)) {
        reject(position_of(*entry.node),
               fmt::format("{} = {}: must be a finite number", entry.name, *number));
      }
      parameters.push_back({entry.name, *number});
    }
    return parameters;
  }

  [[nodiscard]] std::vector<UnknownText> unknowns_of(const toml::node& node,
                                                     const std::vector<ParameterText>& parameters) const {
    constexpr std::array<std::string_view, 3> columns{"energy", "constraint", "bound"};
    const auto found = entries(node, "unknown");
    if (found.empty() || found.size() > max_unknowns) {
      reject(position_of(node),
             fmt::format("there are {} unknowns: must be 1 to {}", found.size(), max_unknowns));
    }
    std::vector<UnknownText> unknowns;
    for (const auto& entry : found) {
      require_name(entry, "unknown");
      if (std::ranges::find(columns, entry.name) != columns.end()) {
        reject(entry.position,
               fmt::format("unknown {}: must be another name, a column has this one", entry.name));
      }
      if (std::ranges::find(parameters, entry.name, &ParameterText::name) != parameters.end()) {
        reject(entry.position,
               fmt::format("unknown {}: must be another name, a parameter has this one", entry.name));
      }
      unknowns.push_back(unknown_of(entry));
    }
    return unknowns;
  }

  [[nodiscard]] UnknownText unknown_of(const TomlEntry& entry) const {
    const auto name = fmt::format("unknown {}", entry.name);
    const auto& of = table(*entry.node, name);
    require_keys(of, name, {"terms", "order", "rhs", "initial"});
    UnknownText unknown{.name = entry.name, .position = entry.position};
    const auto *order = of.get("order"), *terms = of.get("terms");
    if ((order == nullptr) == (terms == nullptr))
      reject(entry.position, fmt::format("{}: must have either order or terms", name));
    unknown.may_be_algebraic = order != nullptr;
    if (order != nullptr) {
      const FormulaText one{.text = "1", .position = entry.position};
      unknown.terms.push_back({one, formula(*order, "order")});
    }
    if (terms != nullptr) unknown.terms = terms_of(*terms);
    unknown.rhs = formula(required(of, entry.position, name, "rhs"), "rhs");
    const auto& initial = required(of, entry.position, name, "initial");
    for (const auto& value : array(initial, "initial", "a list of numbers or formulas"))
      unknown.initial.push_back(formula(value, "initial"));
    return unknown;
  }

  [[nodiscard]] std::vector<TermText> terms_of(const toml::node& node) const {
    constexpr std::string_view allowed = "a list of pairs [coefficient, order]";
    constexpr std::size_t most = 100;
    const auto& list = array(node, "terms", allowed);
    if (list.empty() || list.size() > most)
      reject(position_of(node), fmt::format("terms: has {} terms, must have 1 to {}", list.size(), most));
    std::vector<TermText> terms;
    for (const auto& term : list) {
      const auto& pair = array(term, "a term", "a pair [coefficient, order]");
      if (pair.size() != 2) {
        reject(position_of(term),
               fmt::format("a term has {} entries: must be [coefficient, order]", pair.size()));
      }
      terms.push_back({formula(*pair.get(0), "coefficient"), formula(*pair.get(1), "order")});
    }
    return terms;
  }

  [[nodiscard]] EnergyText energy_of(const toml::node& node) const {
    const auto& of = table(node, "energy");
    require_keys(of, "energy", {"value", "power"});
    EnergyText energy{.value = formula(required(of, position_of(node), "energy", "value"), "value")};
    if (const auto* power = of.get("power")) energy.power = formula(*power, "power");
    return energy;
  }

  [[nodiscard]] std::vector<FormulaText> constraints_of(const toml::node& node) const {
    constexpr std::size_t most = 100;
    const auto& of = table(node, "constraint");
    require_keys(of, "constraint", {"f"});
    std::vector<FormulaText> constraints;
    const auto& list = required(of, position_of(node), "constraint", "f");
    for (const auto& value : array(list, "f", "a list of formulas"))
      constraints.push_back(formula(value, "f"));
    if (constraints.empty() || constraints.size() > most) {
      reject(position_of(list),
             fmt::format("f: has {} formulas, must have 1 to {}", constraints.size(), most));
    }
    return constraints;
  }

  [[nodiscard]] std::vector<FormulaText> jumps_of(const toml::node& node) const {
    constexpr std::size_t most = 1000;
    std::vector<FormulaText> jumps;
    const auto& list = array(node, "jump", "tables [[jump]]");
    if (list.size() > most)
      reject(position_of(node), fmt::format("there are {} jumps: must be at most {}", list.size(), most));
    for (const auto& value : list) {
      const auto& of = table(value, "jump");
      require_keys(of, "jump", {"at"});
      jumps.push_back(formula(required(of, position_of(value), "jump", "at"), "at"));
    }
    return jumps;
  }

  [[nodiscard]] EventText event_of(const TomlEntry& entry) const {
    const auto name = fmt::format("event {}", entry.name);
    require_name(entry, "event");
    const auto& of = table(*entry.node, name);
    require_keys(of, name, {"zero", "crossing", "ends"});
    EventText event{.name = entry.name, .zero = formula(required(of, entry.position, name, "zero"), "zero")};
    if (const auto* crossing = of.get("crossing")) event.crossing = crossing_of(*crossing);
    if (const auto* ends = of.get("ends")) {
      if (!ends->is_boolean()) reject_kind(*ends, "ends", "true or false");
      event.terminal = **ends->as_boolean();
    }
    return event;
  }

  [[nodiscard]] Crossing crossing_of(const toml::node& node) const {
    constexpr std::string_view allowed = R"("rising", "falling" or "either")";
    const auto text = node.value_exact<std::string>();
    if (!text) reject_kind(node, "crossing", allowed);
    if (text == "rising") return Crossing::rising;
    if (text == "falling") return Crossing::falling;
    if (text != "either") reject(position_of(node), fmt::format("crossing: must be {}", allowed));
    return Crossing::either;
  }
};

// SHA-256 of the table with sorted keys and normalised values, followed by the names of the unknowns in
// order.
std::string checksum_of(toml::table all, const EquationText& text) {
  all.erase("title");
  std::ostringstream meaning;
  meaning << toml::toml_formatter(all);
  for (const auto& unknown : text.unknowns) meaning << "\nunknown " << unknown.name;
  return sha256(meaning.str());
}

}  // namespace

EquationText parse_equation_text(const std::string& file, std::string_view text) {
  if (text.size() > max_equation_file_bytes)
    reject_at(file, {}, fmt::format("{} bytes: must be at most {}", text.size(), max_equation_file_bytes));
  if (const auto deep = find_deep_key(text))
    reject_at(file, *deep, fmt::format("a key of more than {} parts", max_key_parts));
  try {
    toml::table all = toml::parse(text);
    EquationText read = EquationReader(file, text).read(all);
    read.checksum = checksum_of(std::move(all), read);
    return read;
  } catch (const toml::parse_error& fault) {
    reject_at(file, position_of(fault.source()), fmt::format("no TOML: {}", fault.description()));
  }
}

}  // namespace fde::bench
