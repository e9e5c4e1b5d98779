// SPDX-License-Identifier: MIT
#ifdef __x86_64__

#include <array>
#include <bit>
#include <new>
#include <utility>

#include "fdebench/benchmarks/expressions/machine_code_writer.hpp"
#include "fdebench/benchmarks/expressions/sampled_function.hpp"

namespace fde::bench {

namespace x86 = asmjit::x86;

using Register = x86::Xmm;

namespace {

constexpr int bytes = sizeof(double);

template <class Result, class... Arguments>
asmjit::InvokeNode& called(x86::Compiler& compiler, Result (*function)(Arguments...)) {
  asmjit::InvokeNode* made = nullptr;
  compiler.invoke(&made, reinterpret_cast<std::uintptr_t>(function),
                  asmjit::FuncSignatureT<Result, Arguments...>());
  if (made == nullptr) throw std::bad_alloc();
  return *made;
}

}  // namespace

bool MachineCodeWriter::is_last_use(int slot) const {
  return in_register(slot) && uses_[static_cast<std::size_t>(slot)] == 0;
}

x86::Mem MachineCodeWriter::memory(int slot) {
  if (slot < list_.inputs) return x86::qword_ptr(y_, (slot - 1) * bytes);
  return compiler_.newDoubleConst(asmjit::ConstPoolScope::kLocal, list_.numbers[slot - list_.inputs]);
}

asmjit::Operand MachineCodeWriter::operand(int slot) {
  if (in_register(slot)) return registers_[static_cast<std::size_t>(slot)];
  return memory(slot);
}

Register MachineCodeWriter::loaded(int slot) {
  return in_register(slot) ? registers_[static_cast<std::size_t>(slot)] : changeable(slot);
}

Register MachineCodeWriter::changeable(int slot) {
  if (is_last_use(slot)) return registers_[static_cast<std::size_t>(slot)];
  const auto copy = compiler_.newXmmSd();
  if (in_register(slot)) {
    compiler_.movapd(copy, registers_[static_cast<std::size_t>(slot)]);
  } else {
    compiler_.movsd(copy, memory(slot));
  }
  return copy;
}

x86::Mem MachineCodeWriter::both_halves(std::uint64_t bits) {
  const std::array halves{bits, bits};
  return compiler_.newConst(asmjit::ConstPoolScope::kLocal, halves.data(), sizeof(halves));
}

Register MachineCodeWriter::binary(x86::Inst::Id id, int a, int b) {
  const auto value = changeable(a);
  compiler_.emit(id, value, operand(b));
  return value;
}

Register MachineCodeWriter::commuting(x86::Inst::Id id, int a, int b) {
  const bool second = is_last_use(b) && !is_last_use(a);
  return second ? binary(id, b, a) : binary(id, a, b);
}

Register MachineCodeWriter::masked(x86::Inst::Id id, int a, std::uint64_t mask) {
  const auto value = changeable(a);
  compiler_.emit(id, value, both_halves(mask));
  return value;
}

Register MachineCodeWriter::constant(double value) {
  const auto made = compiler_.newXmmSd();
  compiler_.movsd(made, compiler_.newDoubleConst(asmjit::ConstPoolScope::kLocal, value));
  return made;
}

Register MachineCodeWriter::square_root(int a) {
  const auto value = changeable(a);
  compiler_.sqrtsd(value, value);
  return value;
}

// With the mask m of x < 0 or 0 < x: (m and (1 with the sign of x)) or (not m and x). Of 0 and NaN it is x.
Register MachineCodeWriter::sign(int a) {
  const auto x = loaded(a);
  const auto below = compiler_.newXmmSd(), mask = compiler_.newXmmSd(), one = compiler_.newXmmSd();
  const auto zero = compiler_.newXmmSd();
  compiler_.xorpd(zero, zero);
  compiler_.xorpd(mask, mask);
  compiler_.cmpsd(mask, x, static_cast<std::uint8_t>(x86::CmpImm::kLT));
  compiler_.movapd(below, x);
  compiler_.cmpsd(below, zero, static_cast<std::uint8_t>(x86::CmpImm::kLT));
  compiler_.orpd(mask, below);
  compiler_.movapd(one, x);
  compiler_.andpd(one, both_halves(sign_bit));
  compiler_.orpd(one, both_halves(std::bit_cast<std::uint64_t>(1.0)));
  compiler_.andpd(one, mask);
  compiler_.andnpd(mask, x);
  compiler_.orpd(mask, one);
  return mask;
}

Register MachineCodeWriter::step(int a) {
  const auto value = sign(a);
  compiler_.addsd(value, compiler_.newDoubleConst(asmjit::ConstPoolScope::kLocal, 1.0));
  compiler_.mulsd(value, compiler_.newDoubleConst(asmjit::ConstPoolScope::kLocal, 0.5));
  return value;
}

Register MachineCodeWriter::call(double (*function)(double), int a) {
  const auto x = loaded(a), value = compiler_.newXmmSd();
  auto& made = called(compiler_, function);
  made.setArg(0, x);
  made.setRet(0, value);
  return value;
}

Register MachineCodeWriter::call(double (*function)(double, double), int a, int b) {
  const auto x = loaded(a), y = loaded(b), value = compiler_.newXmmSd();
  auto& made = called(compiler_, function);
  made.setArg(0, x);
  made.setArg(1, y);
  made.setRet(0, value);
  return value;
}

Register MachineCodeWriter::call(const SampledFunction& function, int a) {
  const auto x = loaded(a), value = compiler_.newXmmSd();
  auto& made = called<double, const SampledFunction*, double>(
      compiler_, +[](const SampledFunction* of, double at) { return of->at(at); });
  made.setArg(0, asmjit::imm(&function));
  made.setArg(1, x);
  made.setRet(0, value);
  return value;
}

// One call, as compilers make of sin(x) and cos(x); the library rounds both as it does alone.
void MachineCodeWriter::call_sine_and_cosine(int a, int sine, int cosine) {
  if (!sine_and_cosine_) sine_and_cosine_ = compiler_.newStack(2 * bytes, bytes);
  const auto first = *sine_and_cosine_, second = first.cloneAdjusted(bytes);
  const auto x = loaded(a);
  const auto to_sine = compiler_.newIntPtr(), to_cosine = compiler_.newIntPtr();
  compiler_.lea(to_sine, first);
  compiler_.lea(to_cosine, second);
  auto& made = called<void, double, double*, double*>(compiler_, ::sincos);
  made.setArg(0, x);
  made.setArg(1, to_sine);
  made.setArg(2, to_cosine);
  for (const auto& [slot, where] : {std::pair{sine, first}, std::pair{cosine, second}}) {
    registers_[static_cast<std::size_t>(slot)] = compiler_.newXmmSd();
    compiler_.movsd(registers_[static_cast<std::size_t>(slot)], where);
  }
}

void MachineCodeWriter::store(int slot) {
  const auto [first, last] = places_.equal_range(slot);
  if (first == last) return;
  const auto value = loaded(slot);
  for (auto place = first; place != last; ++place)
    compiler_.movsd(x86::qword_ptr(results_, static_cast<std::int32_t>(place->second) * bytes), value);
}

}  // namespace fde::bench

#endif
