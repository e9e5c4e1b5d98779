// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "fdebench/benchmarks/equation_files/declaration_reader.hpp"
#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/equation_files/mechanics_reader.hpp"
#include "fdebench/benchmarks/equation_files/table_reader.hpp"

namespace fde::bench {
namespace {

constexpr std::string_view numbers = "a list of numbers or formulas";

class EquationReader : DeclarationReader {
 public:
  using DeclarationReader::DeclarationReader;

  [[nodiscard]] EquationText read(const toml::table& all) const {
    const bool mechanical = all.get("mechanics") != nullptr || all.get("coordinate") != nullptr;
    if (mechanical) {
      require_keys(all, "a file with [mechanics]",
                   {"title", "source", "start", "end", "parameters", "require", "table", "coordinate",
                    "mechanics", "columns", "domain", "path", "exact", "jump", "event"});
    } else {
      require_keys(all, "the file",
                   {"title", "source", "start", "end", "parameters", "require", "table", "unknown", "columns",
                    "domain", "path", "exact", "energy", "constraint", "jump", "event"});
    }
    EquationText read{.file = file()};
    if (const auto* title = all.get("title")) read.title = printable_text(*title, "title");
    if (const auto* source = all.get("source")) read.source = printable_text(*source, "source");
    if (const auto* start = all.get("start")) read.start = formula(*start, "start");
    read.end = formula(required(all, {}, "the file", "end"), "end");
    if (const auto* parameters = all.get("parameters")) read.parameters = parameters_of(*parameters);
    if (const auto* require = all.get("require"))
      read.requirements = requirements_of(*require, read.parameters);
    const std::string_view kind = mechanical ? "coordinate" : "unknown";
    read.unknowns = unknowns_of(required(all, {}, "the file", kind), kind, read.parameters);
    if (mechanical) {
      read.mechanics =
          read_mechanics(file(), text(), required(all, {}, "the file", "mechanics"), read.unknowns);
      require_parameter_names(read);
    }
    if (const auto* tables = all.get("table")) read.tables = read_tables(file(), text(), *tables, read);
    if (const auto* columns = all.get("columns")) read.columns = columns_of(*columns, read.parameters);
    if (const auto* domain = all.get("domain")) read.domain = domain_of(*domain);
    if (const auto* path = all.get("path")) read.path = path_of(*path);
    if (const auto* exact = all.get("exact")) read.exact = formulas_of(*exact, "exact");
    if (std::ranges::any_of(read.unknowns, has_state) && !read.exact.empty()) {
      reject(read.exact.front().position,
             "exact: must not be given with a transfer function or a Riemann-Liouville derivative");
    }
    if (const auto* energy = all.get("energy")) read.energy = energy_of(*energy);
    if (const auto* constraint = all.get("constraint")) read.constraints = constraints_of(*constraint);
    if (const auto* jump = all.get("jump")) read.jumps = jumps_of(*jump);
    if (const auto* event = all.get("event")) {
      for (const auto& entry : entries(*event, "event")) read.events.push_back(event_of(entry, mechanical));
    }
    return read;
  }

 private:
  static bool has_state(const UnknownText& unknown) {
    return unknown.transfer || unknown.is_riemann_liouville;
  }

  // The names of the parameters that constraints add.
  void require_parameter_names(const EquationText& read) const {
    if (read.mechanics->constraints.empty() || read.mechanics->is_vakonomic) return;
    for (const auto& parameter : read.parameters) {
      const auto& name = parameter.declared.name;
      if (name == "formulation" || name == "kappa") {
        reject(read.mechanics->position,
               fmt::format("parameter {}: must be another name, constraints add this one", name));
      }
    }
  }

  [[nodiscard]] std::vector<NamedFormula> formulas_of(const toml::node& node, std::string_view name) const {
    std::vector<NamedFormula> formulas;
    for (const auto& entry : entries(node, name))
      formulas.push_back({entry.name, entry.position, formula(*entry.node, entry.name)});
    return formulas;
  }

  // In the plane or in space.
  [[nodiscard]] std::vector<NamedFormula> path_of(const toml::node& node) const {
    auto path = formulas_of(node, "path");
    if (path.size() < 2 || path.size() > 3)
      reject(position_of(node), fmt::format("path has {} formulas: must be 2 or 3", path.size()));
    return path;
  }

  // The unknowns or the coordinates, as `kind` says.
  [[nodiscard]] std::vector<UnknownText> unknowns_of(const toml::node& node, std::string_view kind,
                                                     const std::vector<ParameterText>& parameters) const {
    const auto found = entries(node, kind);
    if (found.empty() || found.size() > max_unknowns) {
      reject(position_of(node),
             fmt::format("there are {} {}s: must be 1 to {}", found.size(), kind, max_unknowns));
    }
    std::vector<UnknownText> unknowns;
    for (const auto& entry : found) {
      require_name(entry, kind);
      if (is_added_column(entry.name)) {
        reject(entry.position,
               fmt::format("{} {}: must be another name, a column has this one", kind, entry.name));
      }
      const auto is_its_name = [&](const ParameterText& one) { return one.declared.name == entry.name; };
      if (std::ranges::any_of(parameters, is_its_name)) {
        reject(entry.position,
               fmt::format("{} {}: must be another name, a parameter has this one", kind, entry.name));
      }
      unknowns.push_back(kind == "coordinate" ? coordinate_of(entry) : unknown_of(entry, parameters));
    }
    return unknowns;
  }

  [[nodiscard]] UnknownText coordinate_of(const TomlEntry& entry) const {
    const auto name = fmt::format("coordinate {}", entry.name);
    const auto& of = table(*entry.node, name);
    require_keys(of, name, {"initial", "final"});
    UnknownText coordinate{.name = entry.name, .position = entry.position};
    coordinate.initial = formulas(required(of, entry.position, name, "initial"), "initial", numbers);
    if (const auto* last = of.get("final")) coordinate.final = values_at_end(*last, entry.name, numbers);
    return coordinate;
  }

  // A list of values of this unknown.
  [[nodiscard]] std::vector<NamedFormula> values_at_end(const toml::node& node, const std::string& name,
                                                        std::string_view allowed) const {
    std::vector<NamedFormula> values;
    for (auto& value : formulas(node, "final", allowed))
      values.push_back({.name = name, .position = value.position, .formula = value});
    return values;
  }

  // A list with the value of the unknown at the end, or a table of columns with their values.
  [[nodiscard]] std::vector<NamedFormula> final_of(const toml::node& node, const std::string& name) const {
    if (node.is_table()) return formulas_of(node, "final");
    auto values =
        values_at_end(node, name, "a list with the value at the end, or a table of columns with values");
    if (values.size() != 1) {
      reject(
          position_of(node),
          fmt::format("final: has {} values: must have 1, that of {}; derivatives are given in a table, as "
                      "{{ \"D({},1)\" = 0 }}",
                      values.size(), name, name));
    }
    return values;
  }

  [[nodiscard]] UnknownText unknown_of(const TomlEntry& entry,
                                       const std::vector<ParameterText>& parameters) const {
    const auto name = fmt::format("unknown {}", entry.name);
    const auto& of = table(*entry.node, name);
    require_keys(of, name,
                 {"size", "terms", "order", "derivative", "chain", "factor", "rhs", "initial", "final",
                  "before", "outside", "transfer", "input", "unless"});
    UnknownText unknown{.name = entry.name, .position = entry.position};
    if (const auto* size = of.get("size")) unknown.size = formula(*size, "size");
    if (const auto* outside = of.get("outside")) {
      if (!unknown.size)
        reject(position_of(*outside), fmt::format("outside: {}: must be given with size", name));
      unknown.outside = formula(*outside, "outside");
    }
    if (const auto* transfer = of.get("transfer")) {
      require_keys(of, fmt::format("{} with transfer", name), {"transfer", "input", "unless"});
      unknown.transfer = formula(*transfer, "transfer");
      unknown.rhs = formula(required(of, entry.position, name, "input"), "input");
      unknown.unless = unless_of(of, parameters);
      return unknown;
    }
    if (const auto* input = of.get("input"))
      reject(position_of(*input), fmt::format("input: {}: must be given with transfer", name));
    const auto *order = of.get("order"), *terms = of.get("terms");
    if ((order == nullptr) == (terms == nullptr))
      reject(entry.position, fmt::format("{}: must have either order or terms", name));
    unknown.may_be_algebraic = order != nullptr;
    if (order != nullptr) {
      const FormulaText one{.text = "1", .position = entry.position};
      unknown.terms.push_back({one, formula(*order, "order")});
    }
    if (terms != nullptr) read_terms(*terms, unknown);
    if (const auto* derivative = of.get("derivative")) {
      unknown.is_riemann_liouville = is_riemann_liouville(*derivative);
      if (unknown.is_riemann_liouville) {
        require_keys(of, fmt::format("{} with a Riemann-Liouville derivative", name),
                     {"order", "derivative", "rhs", "initial", "unless"});
      }
    }
    if (const auto* chain = of.get("chain")) {
      unknown.is_chain = flag_of(*chain, "chain");
      if (!unknown.is_chain && order == nullptr)
        reject(position_of(*chain), fmt::format("chain: {}: must have order where it is false", name));
    }
    if (const auto* factor = of.get("factor")) unknown.factor = formula(*factor, "factor");
    unknown.rhs = formula(required(of, entry.position, name, "rhs"), "rhs");
    unknown.unless = unless_of(of, parameters);
    unknown.initial = formulas(required(of, entry.position, name, "initial"), "initial", numbers);
    if (const auto* last = of.get("final")) unknown.final = final_of(*last, entry.name);
    if (const auto* before = of.get("before")) unknown.before = formula(*before, "before");
    return unknown;
  }

  [[nodiscard]] bool is_riemann_liouville(const toml::node& node) const {
    constexpr std::string_view name = "derivative", allowed = R"("caputo" or "riemann-liouville")";
    const auto text = node.value_exact<std::string>();
    if (!text) reject_kind(node, name, allowed);
    if (text != "caputo" && text != "riemann-liouville")
      reject(position_of(node), fmt::format("{}: must be {}", name, allowed));
    return text == "riemann-liouville";
  }

  [[nodiscard]] bool flag_of(const toml::node& node, std::string_view name) const {
    if (!node.is_boolean()) reject_kind(node, name, "true or false");
    return **node.as_boolean();
  }

  void read_terms(const toml::node& node, UnknownText& unknown) const {
    constexpr std::string_view allowed = "a list of pairs [coefficient, order]",
                               each = "a pair [coefficient, order], or a table with weight, from and to";
    constexpr std::size_t most = 100;
    const auto& list = array(node, "terms", allowed);
    if (list.empty() || list.size() > most)
      reject(position_of(node), fmt::format("terms: has {} terms, must have 1 to {}", list.size(), most));
    for (const auto& term : list) {
      if (term.is_table()) {
        unknown.distributed.push_back(distributed_of(term));
        continue;
      }
      const auto& pair = array(term, "a term", each);
      if (pair.size() != 2) {
        reject(position_of(term),
               fmt::format("a term has {} entries: must be [coefficient, order]", pair.size()));
      }
      unknown.terms.push_back({formula(*pair.get(0), "coefficient"), formula(*pair.get(1), "order")});
    }
  }

  [[nodiscard]] DistributedText distributed_of(const toml::node& node) const {
    constexpr std::string_view name = "a term";
    const auto& of = table(node, name);
    require_keys(of, name, {"weight", "from", "to"});
    const auto place = position_of(node);
    return {formula(required(of, place, name, "weight"), "weight"),
            formula(required(of, place, name, "from"), "from"),
            formula(required(of, place, name, "to"), "to")};
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
    const auto& list = required(of, position_of(node), "constraint", "f");
    auto constraints = formulas(list, "f");
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

  [[nodiscard]] EventText event_of(const TomlEntry& entry, bool mechanical) const {
    const auto name = fmt::format("event {}", entry.name);
    require_name(entry, "event");
    const auto& of = table(*entry.node, name);
    require_keys(of, name, {"zero", "crossing", "ends", "set"});
    EventText event{.name = entry.name, .zero = formula(required(of, entry.position, name, "zero"), "zero")};
    if (const auto* crossing = of.get("crossing")) event.crossing = crossing_of(*crossing);
    if (const auto* ends = of.get("ends")) event.terminal = flag_of(*ends, "ends");
    if (const auto* set = of.get("set")) {
      if (mechanical) reject(position_of(*set), "set: is not available with [mechanics]");
      if (event.terminal) reject(position_of(*set), "set: must not be given with ends = true");
      event.set = formulas_of(*set, "set");
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

// The table with sorted keys and normalised values, followed by the names of the unknowns in order.
std::string meaning_of(toml::table all, const EquationText& text) {
  all.erase("title");
  all.erase("source");
  write_samples(all, text.tables);
  std::ostringstream meaning;
  meaning << toml::toml_formatter(all);
  for (const auto& unknown : text.unknowns) meaning << "\nunknown " << unknown.name;
  return meaning.str();
}

}  // namespace

EquationText parse_equation_text(const std::string& file, std::string_view text) {
  if (text.size() > max_equation_file_bytes)
    reject_at(file, {}, fmt::format("{} bytes: must be at most {}", text.size(), max_equation_file_bytes));
  toml::table all = parse_toml(file, text);
  EquationText read = EquationReader(file, text).read(all);
  read.meaning = meaning_of(std::move(all), read);
  read.contents = text;
  return read;
}

}  // namespace fde::bench
