// SPDX-License-Identifier: MIT
#ifdef __x86_64__

#include "fdebench/benchmarks/expressions/machine_code_writer.hpp"

#include <cmath>
#include <cstddef>
#include <unordered_map>

#include "fdebench/benchmarks/expressions/apply.hpp"

namespace fde::bench {

namespace x86 = asmjit::x86;

namespace {

// The operation as a function of its only argument; nullptr for that of a table.
double (*function_of(Operation operation))(double) {
  switch (operation) {
#define FDE_OPERATION(name, arguments, value)                                          \
  case Operation::name:                                                                \
    if constexpr (Operation::name == Operation::sampled) {                             \
      return nullptr;                                                                  \
    } else {                                                                           \
      return [](double a) { return value_of<Operation::name>(a, 0.0, 0.0, nullptr); }; \
    }
#include "fdebench/benchmarks/expressions/operations.def"
    default:
      return nullptr;
  }
}

}  // namespace

MachineCodeWriter::MachineCodeWriter(const InstructionList& list, x86::Compiler& compiler)
    : list_(list),
      compiler_(compiler),
      y_(compiler.newIntPtr()),
      results_(compiler.newIntPtr()),
      registers_(list.slots()),
      uses_(list.slots(), 0),
      partners_(list.slots(), 0) {
  for (std::size_t i = 0; i < list.results.size(); ++i) places_.emplace(list.results[i], list.places[i]);
  count_uses();
  find_pairs();
}

void MachineCodeWriter::count_uses() {
  uses_[0] = static_cast<int>(list_.slots());  // t is not overwritten
  for (const auto& [operation, a, b, c, function] : list_.instructions) {
    if (signature(operation).arguments > 0) ++uses_[static_cast<std::size_t>(a)];
    if (signature(operation).arguments > 1) ++uses_[static_cast<std::size_t>(b)];
  }
}

// The instructions sin(x) and cos(x) of the same x.
void MachineCodeWriter::find_pairs() {
  std::unordered_map<int, int> sines, cosines;
  for (std::size_t i = 0; i < list_.instructions.size(); ++i) {
    const auto& [operation, a, b, c, function] = list_.instructions[i];
    if (operation == Operation::sin) sines[a] = list_.first() + static_cast<int>(i);
    if (operation == Operation::cos) cosines[a] = list_.first() + static_cast<int>(i);
  }
  for (const auto& [a, sine] : sines) {
    const auto cosine = cosines.find(a);
    if (cosine == cosines.end()) continue;
    partners_[static_cast<std::size_t>(sine)] = cosine->second;
    partners_[static_cast<std::size_t>(cosine->second)] = sine;
  }
}

void MachineCodeWriter::write() {
  auto* const function = compiler_.addFunc(asmjit::FuncSignatureT<void, double, const double*, double*>());
  registers_[0] = compiler_.newXmmSd();
  function->setArg(0, registers_[0]);
  function->setArg(1, y_);
  function->setArg(2, results_);
  for (int slot = 0; slot < list_.first(); ++slot) store(slot);
  int slot = list_.first();
  for (const auto& instruction : list_.instructions) write_instruction(instruction, slot++);
  compiler_.ret();
  compiler_.endFunc();
}

void MachineCodeWriter::write_instruction(const Instruction& instruction, int slot) {
  auto& made = registers_[static_cast<std::size_t>(slot)];
  const auto arguments = signature(instruction.operation).arguments;
  if (arguments > 0) --uses_[static_cast<std::size_t>(instruction.a)];
  if (arguments > 1) --uses_[static_cast<std::size_t>(instruction.b)];
  if (!made.isValid()) made = value_of(instruction, slot);
  store(slot);
}

MachineCodeWriter::Register MachineCodeWriter::value_of(const Instruction& instruction, int slot) {
  const auto& [operation, a, b, c, function] = instruction;
  switch (operation) {
    case Operation::add:
      return commuting(x86::Inst::kIdAddsd, a, b);
    case Operation::subtract:
      return binary(x86::Inst::kIdSubsd, a, b);
    case Operation::multiply:
      return commuting(x86::Inst::kIdMulsd, a, b);
    case Operation::divide:
      return binary(x86::Inst::kIdDivsd, a, b);
    // min(a, b) is b < a ? b : a, and the instruction chooses its second operand where neither is less.
    case Operation::min:
      return binary(x86::Inst::kIdMinsd, b, a);
    case Operation::max:
      return binary(x86::Inst::kIdMaxsd, b, a);
    case Operation::negate:
      return masked(x86::Inst::kIdXorpd, a, sign_bit);
    case Operation::abs:
      return masked(x86::Inst::kIdAndpd, a, ~sign_bit);
    case Operation::sqrt:
      return square_root(a);
    case Operation::sign:
      return sign(a);
    case Operation::step:
      return step(a);
    case Operation::pi:
      return constant(SpecialFunctions<double>::pi());
    case Operation::power:
      return call(std::pow, a, b);
    case Operation::atan2:
      return call(std::atan2, a, b);
    case Operation::sampled:
      return call(*function, a);
    case Operation::sin:
    case Operation::cos:
      if (const int partner = partners_[static_cast<std::size_t>(slot)]; partner != 0) {
        const bool sine = operation == Operation::sin;
        call_sine_and_cosine(a, sine ? slot : partner, sine ? partner : slot);
        return registers_[static_cast<std::size_t>(slot)];
      }
      return call(function_of(operation), a);
    default:
      return call(function_of(operation), a);
  }
}

}  // namespace fde::bench

#endif
