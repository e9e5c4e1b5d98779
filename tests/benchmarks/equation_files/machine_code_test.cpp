// SPDX-License-Identifier: MIT
// Machine code of expressions: the same bits as the interpreter's.

#include "fdebench/benchmarks/expressions/machine_code.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include "fdebench/benchmarks/expressions/formula.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/expressions/sampled_function.hpp"

#ifdef __x86_64__

namespace fde::bench {
namespace {

constexpr int unknowns = 4;

// The same bits; NaN has many.
bool are_same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

InstructionList list_of(const ExpressionPool& pool, const std::vector<Expression>& results) {
  std::vector<Eigen::Index> places(results.size());
  std::iota(places.begin(), places.end(), Eigen::Index{0});
  return instructions_of(pool, results, places, unknowns);
}

class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : generator_(seed) {}

  int below(std::size_t count) {
    return std::uniform_int_distribution(0, static_cast<int>(count) - 1)(generator_);
  }
  // Of usual size, of any size, or a special value.
  double number() {
    using Limits = std::numeric_limits<double>;
    constexpr std::array special{0.0,
                                 -0.0,
                                 1.0,
                                 -1.0,
                                 0.5,
                                 Limits::max(),
                                 -Limits::max(),
                                 Limits::min(),
                                 3e-310,
                                 -5e-324,
                                 1e16,
                                 -1e300,
                                 Limits::infinity(),
                                 -Limits::infinity(),
                                 Limits::quiet_NaN(),
                                 M_PI};
    const int kind = below(8);
    if (kind < 5) return std::uniform_real_distribution(-3.0, 3.0)(generator_);
    if (kind < 7) return special[static_cast<std::size_t>(below(special.size()))];
    return std::bit_cast<double>(std::uniform_int_distribution<std::uint64_t>()(generator_));
  }
  std::array<double, unknowns + 1> inputs() {
    std::array<double, unknowns + 1> values{};
    std::ranges::generate(values, [&] { return number(); });
    return values;
  }

 private:
  std::mt19937 generator_;
};

constexpr std::array plain_operations{Operation::add,    Operation::subtract, Operation::multiply,
                                      Operation::divide, Operation::negate,   Operation::sqrt,
                                      Operation::abs,    Operation::sign,     Operation::step,
                                      Operation::min,    Operation::max};
constexpr std::array called_operations{
    Operation::power, Operation::sin,   Operation::cos,        Operation::tan,   Operation::asin,
    Operation::acos,  Operation::atan,  Operation::sinh,       Operation::cosh,  Operation::tanh,
    Operation::exp,   Operation::log,   Operation::atan2,      Operation::gamma, Operation::erf,
    Operation::erfc,  Operation::floor, Operation::alternation};

bool has_two_arguments(Operation operation) {
  constexpr std::array two{Operation::add, Operation::subtract, Operation::multiply, Operation::divide,
                           Operation::min, Operation::max,      Operation::power,    Operation::atan2};
  return std::ranges::find(two, operation) != two.end();
}

// Expressions of the inputs, of numbers and of one another; the share of calls is given in percent.
std::vector<Expression> random_expressions(ExpressionPool& pool, RandomNumbers& random, int count,
                                           int calls) {
  std::vector<Expression> made{pool.number("2.5"), pool.number("-0.75"), pool.number(1)};
  for (int variable = 0; variable <= unknowns; ++variable) made.push_back(pool.variable(variable));
  for (int i = 0; i < count; ++i) {
    const bool called = random.below(100) < calls;
    const auto operation =
        called ? called_operations[static_cast<std::size_t>(random.below(called_operations.size()))]
               : plain_operations[static_cast<std::size_t>(random.below(plain_operations.size()))];
    const auto any = [&] { return made[static_cast<std::size_t>(random.below(made.size()))]; };
    const auto a = any(), b = has_two_arguments(operation) ? any() : ExpressionPool::none;
    made.push_back(pool.make_expression(operation, a, b));
  }
  return made;
}

void expect_same(const InstructionList& list, RandomNumbers& random, int times) {
  const auto code = machine_code(list);
  ASSERT_TRUE(code);
  std::vector<double> interpreted(list.results.size()), computed(list.results.size());
  for (int i = 0; i < times; ++i) {
    const auto inputs = random.inputs();
    interpret(list, inputs[0], inputs.data() + 1, interpreted);
    code.get()(inputs[0], inputs.data() + 1, computed.data());
    for (std::size_t r = 0; r < computed.size(); ++r)
      ASSERT_TRUE(are_same(interpreted[r], computed[r])) << r << ": " << interpreted[r] << " " << computed[r];
  }
}

TEST(MachineCode, HasTheBitsOfTheInterpreterForEachOperation) {
  RandomNumbers random(1);
  std::vector<Operation> operations(plain_operations.begin(), plain_operations.end());
  operations.insert(operations.end(), called_operations.begin(), called_operations.end());
  for (const auto operation : operations) {
    ExpressionPool pool(NumberStorage::decimals);
    const auto x = pool.variable(1), y = pool.variable(2), number = pool.number("0.3");
    std::vector<Expression> results;
    if (has_two_arguments(operation)) {
      for (const auto& [a, b] :
           {std::pair{x, y}, std::pair{x, number}, std::pair{number, x}, std::pair{x, x}})
        results.push_back(pool.make_expression(operation, a, b));
    } else {
      for (const auto a : {x, number, pool.variable(0)})
        results.push_back(pool.make_expression(operation, a));
    }
    expect_same(list_of(pool, results), random, 20'000);
    if (HasFatalFailure()) FAIL() << static_cast<int>(operation);
  }
}

TEST(MachineCode, HasTheBitsOfTheInterpreterForRandomExpressions) {
  RandomNumbers random(2);
  for (int i = 0; i < 300; ++i) {
    ExpressionPool pool(NumberStorage::values);
    const auto all = random_expressions(pool, random, 3 + random.below(60), i % 4 == 0 ? 50 : 10);
    expect_same(list_of(pool, all), random, 50);
    expect_same(list_of(pool, {all.back()}), random, 50);
    if (HasFatalFailure()) FAIL() << i;
  }
}

TEST(MachineCode, HasTheBitsOfTheInterpreterForDerivatives) {
  RandomNumbers random(3);
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    ExpressionPool pool(NumberStorage::values);
    const auto all = random_expressions(pool, random, 12, 25);
    std::vector<Expression> slopes;
    try {
      for (int variable = 1; variable <= unknowns; ++variable)
        slopes.push_back(pool.derivative(all.back(), variable));
    } catch (const std::invalid_argument&) {  // of gamma
      continue;
    }
    ++compared;
    expect_same(list_of(pool, slopes), random, 50);
    if (HasFatalFailure()) FAIL() << i;
  }
  EXPECT_GT(compared, 100);
}

// One call gives both.
TEST(MachineCode, HasTheBitsOfSineAndCosine) {
  ExpressionPool pool(NumberStorage::values);
  const auto x = pool.variable(1);
  const auto list =
      list_of(pool, {pool.make_expression(Operation::cos, x), pool.make_expression(Operation::sin, x)});
  RandomNumbers random(4);
  expect_same(list, random, 1'000'000);
}

TEST(MachineCode, HasTheBitsOfTables) {
  ExpressionPool pool(NumberStorage::values);
  const auto table =
      SampledFunction::through("u", "u", Interpolation::cubic, {-2, -1, 0, 1.5, 3}, {1, 0.3, -1, 2, 0.7});
  const auto x = pool.variable(1), sine = pool.make_expression(Operation::sin, pool.variable(2));
  const auto product =
      pool.make_expression(Operation::multiply, pool.sampled(table, sine), pool.sampled(table, x));
  RandomNumbers random(6);
  expect_same(list_of(pool, {product, pool.derivative(product, 1), pool.sampled(table, x)}), random, 100'000);
}

// More values at a time than there are registers, and calls between them.
TEST(MachineCode, HasTheBitsOfTheInterpreterForThousandsOfInstructions) {
  RandomNumbers random(5);
  for (const int calls : {0, 5}) {
    ExpressionPool pool(NumberStorage::values);
    const auto all = random_expressions(pool, random, 6'000, calls);
    const auto list = list_of(pool, all);
    ASSERT_GT(list.instructions.size(), 3'000U);
    expect_same(list, random, 30);
  }
}

// Inputs, numbers and a result that is wanted twice, backwards and with a gap.
TEST(MachineCode, WritesResultsToTheirPlaces) {
  ExpressionPool pool(NumberStorage::values);
  const auto x = pool.variable(1), sum = pool.make_expression(Operation::add, x, pool.variable(2));
  const auto list =
      instructions_of(pool, {sum, x, pool.number("0.25"), sum, pool.variable(0)}, {6, 4, 3, 1, 0}, unknowns);
  const std::array y{2.0, 3.0, 0.0, 0.0};
  std::array results{-1.0, -1.0, -1.0, -1.0, -1.0, -1.0, -1.0};
  const auto code = machine_code(list);
  ASSERT_TRUE(code);
  code.get()(7.0, y.data(), results.data());
  EXPECT_EQ(results, (std::array{7.0, 5.0, -1.0, 0.25, 2.0, -1.0, 5.0}));
}

TEST(MachineCode, IsNotMadeOfWhatMayThrowOrIsLong) {
  ExpressionPool pool(NumberStorage::values);
  const auto x = pool.variable(1);
  EXPECT_FALSE(machine_code(
      list_of(pool, {pool.make_expression(Operation::mittag_leffler, pool.number(1), pool.number(1), x)})));
  auto sum = x;
  for (std::size_t i = 0; i <= most_compiled_instructions; ++i)
    sum = pool.make_expression(Operation::add, sum, pool.variable(static_cast<int>(i % 2)));
  EXPECT_FALSE(machine_code(list_of(pool, {sum})));
}

// Across the translation, by many threads, by copies of which some are gone.
TEST(Program, GivesTheSameBeforeAndAfterItsTranslation) {
  RandomNumbers random(6);
  ExpressionPool pool(NumberStorage::values);
  const auto all = random_expressions(pool, random, 40, 20);
  const auto list = list_of(pool, all);
  Program program(pool, all, unknowns);
  constexpr int evaluations = 2 * Program::interpreted_evaluations(60);
  std::vector<std::array<double, unknowns + 1>> inputs(evaluations);
  std::ranges::generate(inputs, [&] { return random.inputs(); });
  std::array<int, 8> different{};
  {
    std::vector<std::jthread> threads;
    for (auto& count : different) {
      threads.emplace_back([&count, &inputs, &list, copy = program] {
        std::vector<double> interpreted(list.results.size()), computed(list.results.size());
        for (const auto& input : inputs) {
          interpret(list, input[0], input.data() + 1, interpreted);
          copy.evaluate(input[0], Eigen::Map<const Vec>(input.data() + 1, unknowns), computed);
          if (!std::ranges::equal(interpreted, computed, are_same)) ++count;
        }
      });
    }
    program = {};
  }
  EXPECT_EQ(different, (std::array<int, 8>{}));
}

TEST(ExpressionPool, DifferentiatesManyExpressionsAsOne) {
  RandomNumbers random(7);
  for (int i = 0; i < 50; ++i) {
    ExpressionPool pool(NumberStorage::values);
    std::vector<Expression> some;
    for (const auto e : random_expressions(pool, random, 30, 0)) some.push_back(e);
    for (int variable = 1; variable <= unknowns; ++variable) {
      const auto together = pool.derivatives(some, variable);
      for (std::size_t e = 0; e < some.size(); ++e)
        EXPECT_EQ(together[e], pool.derivative(some[e], variable)) << i;
    }
  }
}

}  // namespace
}  // namespace fde::bench

#endif
