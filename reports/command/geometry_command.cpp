// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <ostream>
#include <utility>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reports/command/arguments.hpp"
#include "fdebench/reports/command/command.hpp"

namespace fde::bench {
namespace {

struct GeometryArguments {
  SceneArguments scene;
  std::optional<std::string> place, velocity;
};

// n numbers of an argument, or the initial value.
Vec state_of(std::string_view name, const std::optional<std::string>& text, In at_start) {
  if (!text) return at_start;
  const auto numbers = parse_numbers(name, *text, any_number);
  if (std::ssize(numbers) != at_start.size())
    reject_text(name, *text, fmt::format("{} numbers, one a coordinate", at_start.size()));
  return Eigen::Map<const Vec>(numbers.data(), std::ssize(numbers));
}

// Lines quantity,i,j,k,value. Indices are names of coordinates, of multipliers numbers. Collected first: what
// is not finite leaves nothing printed.
class NumberTable {
 public:
  explicit NumberTable(std::vector<std::string> names) : names_(std::move(names)) {}

  // indices: up to three.
  void add_line(std::string_view quantity, const std::vector<std::string>& indices, double value) {
    if (!std::isfinite(value)) throw NumericalFailure(fmt::format("the {} is not finite there", quantity));
    text_ += quantity;
    for (std::size_t place = 0; place < 3; ++place) {
      text_ += ',';
      if (place < indices.size()) text_ += indices[place];
    }
    text_ += fmt::format(",{:.17g}\n", value);
  }
  void add(std::string_view quantity, const std::vector<std::size_t>& indices, double value) {
    std::vector<std::string> names;
    for (const std::size_t index : indices) names.push_back(names_.at(index));
    add_line(quantity, names, value);
  }
  void add(std::string_view quantity, const Vec& values) {
    for (Eigen::Index i = 0; i < values.size(); ++i) add(quantity, {static_cast<std::size_t>(i)}, values[i]);
  }
  void add(std::string_view quantity, const Matrix& values) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(values.rows()); ++i) {
      for (std::size_t j = 0; j < static_cast<std::size_t>(values.cols()); ++j)
        add(quantity, {i, j}, values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    }
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::vector<std::string> names_;
  std::string text_ = "quantity,i,j,k,value\n";
};

std::string geometry_text(const std::vector<std::string>& names, const Geometry& geometry) {
  NumberTable table(names);
  table.add("metric", geometry.metric);
  for (std::size_t i = 0; i < geometry.christoffel.size(); ++i) {
    const Matrix& symbols = geometry.christoffel[i];
    for (std::size_t j = 0; j < names.size(); ++j) {
      for (std::size_t k = 0; k < names.size(); ++k) {
        const double symbol = symbols(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k));
        table.add("christoffel", {i, j, k}, symbol);
      }
    }
  }
  table.add("connection", geometry.connection);
  table.add("semispray", geometry.semispray);
  for (Eigen::Index i = 0; i < geometry.multipliers.size(); ++i)
    table.add_line("multiplier", {fmt::format("{}", i + 1)}, geometry.multipliers[i]);
  table.add("constrained_semispray", geometry.constrained_semispray);
  table.add("constrained_connection", geometry.constrained_connection);
  return table.text();
}

// The velocities of the argument, which have to keep the constraints at q to a millionth of themselves. Those
// at t = 0 are brought onto the constraints, which at another place may be others.
Vec velocity_at(In q, const StateGeometry& geometry, const std::optional<std::string>& text) {
  constexpr double typed = 1e-6;
  Vec v = state_of("--velocity", text, geometry.velocity);
  if (!geometry.allowed) return v;
  Vec allowed = geometry.allowed(q, v);
  if (text && (v - allowed).norm() > typed * allowed.norm()) {
    reject_text("--velocity", *text,
                fmt::format("velocities that keep the constraints at this place, as {:.17g}",
                            fmt::join(allowed.begin(), allowed.end(), ",")));
  }
  return allowed;
}

void print_geometry(const GeometryArguments& arguments, const Streams& streams, const SceneRegistry& known) {
  const auto variant = read_variant(arguments.scene, known);
  const Scene scene = make_scene_unchecked(*variant.maker, variant.values);
  if (!scene.geometry)
    reject_text("scene", variant.maker->id, "one of mechanics with a metric and constraints");
  const Vec q = state_of("--place", arguments.place, scene.geometry.position),
            v = velocity_at(q, scene.geometry, arguments.velocity);
  streams.out << geometry_text(scene.geometry.coordinates, scene.geometry.at(q, v));
}

}  // namespace

void add_geometry_command(CommandLine& program, const Streams& streams, const SceneRegistry& known) {
  auto arguments = std::make_shared<GeometryArguments>();
  Subcommand command(program, "geometry",
                     "Print metric, Christoffel symbols, connection and semispray of a scene; CSV");
  command.group("Look up");
  add_scene(command, arguments->scene, "id of a scene of mechanics");
  command.option("--place", arguments->place, "coordinates")
      .takes("Q1,Q2,...", any_number)
      .usual("those at t = 0");
  command.option("--velocity", arguments->velocity, "velocities that keep the constraints")
      .takes("V1,V2,...", any_number)
      .usual("those at t = 0");
  command.example("fdebench geometry loxodrome --place 0.7,0",
                  "prints the Christoffel symbols at theta = 0.7.");
  command.example("fdebench geometry knife_edge", "prints the geometry at the start of the motion.");
  command.see_also({"scenes", "solve"});
  command.callback([=, &streams, &known] { print_geometry(*arguments, streams, known); });
}

}  // namespace fde::bench
