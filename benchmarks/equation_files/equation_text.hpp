// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/scenes/parameters.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde::bench {

class SampledFunction;

// A position in a file: line and column, from 1.
struct TextPosition {
  int line = 1, column = 1;
};

// Bytes of a text that stand side by side in a line of the file, from byte `first` of the text on.
struct LinePiece {
  std::size_t first;
  TextPosition position;
};

// A formula as written in an equation file, or a number as its shortest decimal.
struct FormulaText {
  std::string text{};
  TextPosition position{};          // of its first byte
  std::vector<LinePiece> pieces{};  // in order; empty: all bytes stand side by side from `position` on
  int index = 0, size = 0;          // i and size in a formula of a component; 0: it is of none
};

struct TermText {
  FormulaText coefficient, order;
};

struct NamedFormula {
  std::string name{};
  TextPosition position{};
  FormulaText formula{};
};

// The term int_from^to weight(q) D^q x dq of an unknown x; the variable of the weight is q.
struct DistributedText {
  FormulaText weight, from, to;
};

// The equation of an unknown: sum of the terms = rhs. A `factor` multiplies all terms but the first.
struct UnknownText {
  std::string name{};
  TextPosition position{};
  std::vector<TermText> terms{};
  std::vector<DistributedText> distributed{};  // further terms
  std::vector<double> quadrature_orders{};     // of the terms that with_quadrature() has added; no columns
  bool may_be_algebraic = false;               // given by the key `order`, for which 0 means 0 = rhs
  bool is_riemann_liouville = false;           // its derivative; otherwise Caputo's
  bool is_chain = true;                        // false: one row of its order, also above 1
  std::optional<FormulaText> factor{};
  FormulaText rhs{};
  std::optional<FormulaText> transfer{};  // a transfer function, of which rhs is the input; terms are empty
  std::vector<FormulaText> initial{};
  std::optional<FormulaText> before{};  // its value for t < 0
  std::vector<NamedFormula> final{};    // values at the end, each of the column that it names
  ParameterValues unless{};
  std::optional<FormulaText> size{};     // of a vector; empty: it is a number
  std::optional<FormulaText> outside{};  // of a vector: its components besides 1 ... size
  bool is_implied = false;  // no unknown of the file, but a state or an integral; it is no column
  std::string meaning{};    // of one that is implied, as messages name it
};

// An output over a power of t, with which it is finite at t = 0: the column of an output that is infinite
// there.
struct WeightedText {
  std::string name{};
  FormulaText value{};  // of t and the state
  FormulaText scale{};  // the power of t
};

// A name for a sum of derivatives of an unknown, the state, and a formula of t (with_states,
// with_caputo_derivatives).
struct OutputText {
  std::string name{}, state{};
  std::vector<TermText> terms{};
  std::optional<FormulaText> of_time{};
  std::optional<WeightedText> weighted{};
};

// A vector of unknowns, which are unknowns[first], unknowns[first + 1], ... of the file (with_components).
struct VectorText {
  std::string name{};
  std::size_t first = 0;
  int size = 0;
  std::optional<FormulaText> outside{};
};

struct EnergyText {
  FormulaText value{};
  std::optional<FormulaText> power{};
};

// A parameter; `formula` is the default of a derived number.
struct ParameterText {
  Parameter declared{};
  FormulaText formula{};
};

// [[require]]: a condition on a parameter, with the words for what is allowed.
struct RequirementText {
  enum class Condition { not_zero, is_not_negative, is_positive };
  std::string parameter{}, allowed{};
  Condition condition = Condition::not_zero;
  FormulaText formula{};
  ParameterValues unless{};
};

// [columns]: a column of the output as a formula of t, the unknowns and their derivatives.
struct ColumnText {
  std::string name{};
  TextPosition position{};
  FormulaText formula{};
  ParameterValues unless{};
};

// [domain]: where the right-hand sides are defined, positive > 0; `edge` names where they end.
struct DomainText {
  std::string edge{};
  FormulaText positive{};
};

// [event.NAME]: a function whose zeros along the trajectory are located, and unknowns that are set there.
struct EventText {
  std::string name{};
  FormulaText zero{};
  Crossing crossing = Crossing::either;
  bool terminal = false;
  std::vector<NamedFormula> set{};  // what becomes of unknowns and of nodes of their chains
};

// [mechanics]: a Lagrangian with forces and constraints; the coordinates are the unknowns of the file.
struct MechanicsText {
  TextPosition position{};
  FormulaText lagrangian{};
  std::vector<NamedFormula> forces{};  // by coordinate
  std::vector<FormulaText> constraints{};
  bool is_vakonomic = false;               // principle = "vakonomic"
  std::vector<FormulaText> multipliers{};  // of a vakonomic problem, at t = 0; empty: 0
  std::string formulation{};               // the default; empty: the first that exists
  bool projects_velocity = false;          // the default of the parameter initial_velocity
};

// The contents of an equation file with unparsed formulas: docs/equation_files.md. Parts with `unless` are
// left out if all these parameters have these values.
struct EquationText {
  std::string file{};
  bool is_built_in = false;
  std::string title{}, source{};
  std::optional<FormulaText> start{};  // the base point of derivatives; empty: 0
  FormulaText end{};
  std::vector<ParameterText> parameters{};  // parameters and unknowns are in file order
  std::vector<RequirementText> requirements{};
  std::vector<std::shared_ptr<const SampledFunction>> tables{};
  std::vector<UnknownText> unknowns{};
  std::vector<VectorText> vectors{};
  std::vector<OutputText> outputs{};
  std::optional<MechanicsText> mechanics{};    // then the unknowns are coordinates
  std::vector<std::string> absent_unknowns{};  // those that present_parts() has left out
  std::vector<ColumnText> columns{};           // empty: the unknowns and the nodes of their chains
  std::optional<DomainText> domain{};
  std::vector<NamedFormula> path{};  // [path]: coordinates of the point whose path is drawn, in the columns
  std::vector<NamedFormula> exact{};
  std::optional<EnergyText> energy{};
  std::vector<FormulaText> constraints{};
  std::vector<FormulaText> jumps{};
  std::vector<EventText> events{};
  std::string meaning{};   // all fields except title and source, normalised, with the samples of files
  std::string contents{};  // as read
};

// The text without the parts that these parameters leave out.
EquationText present_parts(EquationText text, const Parameters& parameters);

inline constexpr std::size_t max_equation_file_bytes = std::size_t{1} << 20;  // bytes
inline constexpr std::size_t max_unknowns = 100;                              // names of unknowns
inline constexpr std::size_t max_components = 10'000;  // unknowns, with those of vectors and integrals

// The bytes of a regular file. Throws std::invalid_argument naming the file and why it cannot be read.
std::string read_text_file(const std::filesystem::path& file, std::size_t most_bytes);

// Each throws std::invalid_argument naming file, line and column, the text there and what is allowed.
EquationText read_equation_text(const std::filesystem::path& file);
EquationText parse_equation_text(const std::string& file, std::string_view text);

// An error in a file: "FILE: line L, column C: what".
struct FileError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};
[[noreturn]] void reject_at(const std::string& file, const TextPosition& place, std::string_view what);
// The position of a byte of a formula.
TextPosition position_of(const FormulaText& formula, std::size_t byte);
// An error at a byte of a formula.
[[noreturn]] void reject_in(const std::string& file, const FormulaText& formula, std::size_t byte,
                            std::string_view what);

// The text with a term for each D(x, q) of a right-hand side whose order q, below the leading one of x, no
// term of x has: D(x, q) is added to both sides of the equation of x, which makes it a node of the chain of
// x. So variable coefficients are written as they are: y'' = -sin(t) D^0.5 y. An equation with a factor or
// without chain is left as it is.
EquationText with_implied_terms(EquationText text, const Parameters& parameters);

}  // namespace fde::bench
