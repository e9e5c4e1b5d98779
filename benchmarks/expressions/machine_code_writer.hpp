// SPDX-License-Identifier: MIT
#pragma once

#ifdef __x86_64__

#include <asmjit/x86.h>

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "fdebench/benchmarks/expressions/instructions.hpp"

namespace fde::bench {

// Writes a list of instructions as a function `void(double t, const double* y, double* results)`. Each
// instruction is rounded as `apply<double>` rounds it: SSE2 without fused operations, and calls of the same
// functions of the standard library.
class MachineCodeWriter {
 public:
  MachineCodeWriter(const InstructionList& list, asmjit::x86::Compiler& compiler);
  void write();

 private:
  using Register = asmjit::x86::Xmm;
  using Memory = asmjit::x86::Mem;

  static constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63U;

  void count_uses();
  void find_pairs();
  void write_instruction(const Instruction& instruction, int slot);
  Register value_of(const Instruction& instruction, int slot);
  Register binary(asmjit::x86::Inst::Id id, int a, int b);
  Register commuting(asmjit::x86::Inst::Id id, int a, int b);
  Register masked(asmjit::x86::Inst::Id id, int a, std::uint64_t mask);
  Register constant(double value);
  Register square_root(int a);
  Register sign(int a);
  Register step(int a);
  Register call(double (*function)(double), int a);
  Register call(double (*function)(double, double), int a, int b);
  Register call(const SampledFunction& function, int a);
  void call_sine_and_cosine(int a, int sine, int cosine);
  void store(int slot);

  // Whether the slot is t or that of an instruction; the others are in memory.
  [[nodiscard]] bool in_register(int slot) const { return slot == 0 || slot >= list_.first(); }
  // Whether an instruction and no later one needs the value; where uses of that instruction are taken off.
  [[nodiscard]] bool is_last_use(int slot) const;
  [[nodiscard]] Memory memory(int slot);
  [[nodiscard]] asmjit::Operand operand(int slot);
  [[nodiscard]] Register loaded(int slot);      // only to be read
  [[nodiscard]] Register changeable(int slot);  // a copy, except at the last use
  [[nodiscard]] Memory both_halves(std::uint64_t bits);

  const InstructionList& list_;
  asmjit::x86::Compiler& compiler_;
  asmjit::x86::Gp y_, results_;
  std::vector<Register> registers_;          // of each slot
  std::vector<int> uses_;                    // of each slot: by instructions that are not yet written
  std::vector<int> partners_;                // of sin(x), the slot of cos(x), and conversely; 0: none
  std::multimap<int, Eigen::Index> places_;  // of the results, by slot
  std::optional<Memory> sine_and_cosine_{};
};

}  // namespace fde::bench

#endif
