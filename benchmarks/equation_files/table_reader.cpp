// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "fdebench/benchmarks/equation_files/declaration_reader.hpp"
#include "fdebench/benchmarks/files/lines.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {
namespace {

constexpr std::size_t most_samples = 65536, most_tables = 100;

struct Samples {
  std::vector<double> arguments{}, values{};
};

// Adds a sample after those before. Throws FileError.
void add_sample(Samples& samples, const std::string& file, const std::array<TextPosition, 2>& places,
                const std::array<double, 2>& sample) {
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (!std::isfinite(sample[i]))
      reject_at(file, places[i], fmt::format("{}: must be a finite number", sample[i]));
  }
  if (!samples.arguments.empty() && sample[0] <= samples.arguments.back()) {
    reject_at(file, places[0],
              fmt::format("{}: must be above {}, the argument before", sample[0], samples.arguments.back()));
  }
  if (samples.arguments.size() == most_samples)
    reject_at(file, places[0], fmt::format("there are more than {} samples", most_samples));
  samples.arguments.push_back(sample[0]);
  samples.values.push_back(sample[1]);
}

// Two cells. Throws FileError.
std::vector<std::string> cells_of(const std::string& file, int line, std::string_view text) {
  auto cells = split_list(text);
  if (cells.size() != 2) {
    reject_at(
        file, {line, 1},
        fmt::format("the number of cells is {}: must be 2, an argument and a value with a comma between",
                    cells.size()));
  }
  return cells;
}

Samples read_samples(const std::string& file) {
  LineReader line(file);
  if (!line.next()) reject_at(file, {1, 1}, "there is no header");
  const auto header = cells_of(file, line.number(), line.text());
  if (try_parse_number(trimmed(header[0])) && try_parse_number(trimmed(header[1])))
    reject_at(file, {1, 1}, fmt::format("{}: must be a header, two names, as t,u", trimmed(line.text())));
  Samples samples;
  while (line.next()) {
    if (trimmed(line.text()).empty()) continue;
    const auto cells = cells_of(file, line.number(), line.text());
    const std::array places{TextPosition{line.number(), 1}, TextPosition{line.number(), 2}};
    std::array<double, 2> sample{};
    for (std::size_t i = 0; i < sample.size(); ++i) {
      const auto cell = trimmed(cells[i]);
      const auto number = try_parse_number(cell);
      if (!number) {
        reject_at(file, places[i],
                  fmt::format("{}: {}must be a number", is_printable(cell) ? cell : "a cell",
                              double_range_message(cell)));
      }
      sample[i] = *number;
    }
    add_sample(samples, file, places, sample);
  }
  return samples;
}

class TableReader : DeclarationReader {
 public:
  using DeclarationReader::DeclarationReader;

  [[nodiscard]] std::vector<SampledFunction::Pointer> read(const toml::node& node,
                                                           const EquationText& others) const {
    const auto found = entries(node, "table");
    if (found.size() > most_tables) {
      reject(position_of(node),
             fmt::format("there are {} tables: must be at most {}", found.size(), most_tables));
    }
    std::vector<SampledFunction::Pointer> tables;
    for (const auto& entry : found) {
      require_own_name(entry, others);
      tables.push_back(table_of(entry));
    }
    return tables;
  }

 private:
  void require_own_name(const TomlEntry& entry, const EquationText& others) const {
    require_name(entry, "table");
    if (entry.name == "J") reject(entry.position, "table J: must be another name, formulas know this one");
    const auto has_name = [&](std::string_view name) { return name == entry.name; };
    const auto of_parameter = [](const ParameterText& one) -> std::string_view { return one.declared.name; };
    for (const auto& [is_taken, what] :
         {std::pair(std::ranges::any_of(others.parameters, has_name, of_parameter), "a parameter"),
          std::pair(std::ranges::any_of(others.unknowns, has_name, &UnknownText::name), "an unknown")}) {
      if (is_taken) {
        reject(entry.position,
               fmt::format("table {}: must be another name, {} has this one", entry.name, what));
      }
    }
  }

  [[nodiscard]] SampledFunction::Pointer table_of(const TomlEntry& entry) const {
    const auto name = fmt::format("table {}", entry.name);
    const auto& of = table(*entry.node, name);
    require_keys(of, name, {"file", "samples", "between"});
    const auto *named = of.get("file"), *listed = of.get("samples");
    if ((named == nullptr) == (listed == nullptr))
      reject(entry.position, fmt::format("{}: must have either file or samples", name));
    const auto between =
        of.get("between") == nullptr ? Interpolation::linear : between_of(*of.get("between"));
    std::string source = name;
    Samples samples;
    if (named != nullptr) {
      source = printable_text(*named, "file");
      samples = samples_in_file(*named, source);
    } else {
      samples = samples_of(*listed);
    }
    if (samples.arguments.size() < SampledFunction::fewest(between)) {
      reject(entry.position, fmt::format("{}: the number of samples is {}: must be at least {}", name,
                                         samples.arguments.size(), SampledFunction::fewest(between)));
    }
    return SampledFunction::through(entry.name, source, between, std::move(samples.arguments),
                                    std::move(samples.values));
  }

  [[nodiscard]] Interpolation between_of(const toml::node& node) const {
    const auto text = node.value_exact<std::string>();
    if (text == "constant") return Interpolation::constant;
    if (text == "linear") return Interpolation::linear;
    if (text == "cubic") return Interpolation::cubic;
    constexpr std::string_view allowed = R"("constant", "linear" or "cubic")";
    if (!text) reject_kind(node, "between", allowed);
    reject(position_of(node), fmt::format("between: must be {}", allowed));
  }

  // Of a file that is named relative to this one.
  [[nodiscard]] Samples samples_in_file(const toml::node& node, const std::string& name) const {
    const auto path = (std::filesystem::path(file()).parent_path() / name).string();
    try {
      return read_samples(path);
    } catch (const FileError&) {
      throw;
    } catch (const std::invalid_argument& fault) {
      reject(position_of(node), fault.what());
    }
  }

  [[nodiscard]] Samples samples_of(const toml::node& node) const {
    Samples samples;
    for (const auto& one : array(node, "samples", "a list of pairs [argument, value]")) {
      const auto& pair = array(one, "a sample", "a pair [argument, value]");
      if (pair.size() != 2) {
        reject(position_of(one),
               fmt::format("a sample has {} entries: must be [argument, value]", pair.size()));
      }
      const auto &argument = *pair.get(0), &value = *pair.get(1);
      add_sample(samples, file(), {position_of(argument), position_of(value)},
                 {number_of(argument, "an argument"), number_of(value, "a value")});
    }
    return samples;
  }
};

}  // namespace

std::vector<SampledFunction::Pointer> read_tables(const std::string& file, std::string_view text,
                                                  const toml::node& node, const EquationText& others) {
  return TableReader(file, text).read(node, others);
}

void write_samples(toml::table& all, const std::vector<SampledFunction::Pointer>& tables) {
  for (const auto& one : tables) {
    toml::array samples;
    for (std::size_t i = 0; i < one->arguments().size(); ++i)
      samples.push_back(toml::array{one->arguments()[i], one->values()[i]});
    auto& of = *all["table"][one->name()].as_table();
    of.erase("file");
    of.insert_or_assign("samples", std::move(samples));
  }
}

}  // namespace fde::bench
