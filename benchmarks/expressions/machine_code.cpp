// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/machine_code.hpp"

#include <algorithm>

#include "fdebench/benchmarks/expressions/machine_code_writer.hpp"

#ifdef __x86_64__
#include <asmjit/x86.h>
#endif

namespace fde::bench {

#ifdef __x86_64__

namespace {

// Keeps the first error: the interpreter is the way out.
struct FirstError : asmjit::ErrorHandler {
  void handleError(asmjit::Error error, const char* /*message*/, asmjit::BaseEmitter* /*origin*/) override {
    if (first == asmjit::kErrorOk) first = error;
  }
  asmjit::Error first = asmjit::kErrorOk;
};

// The functions share it, so that it outlives all of them, those of static objects too.
const std::shared_ptr<asmjit::JitRuntime>& process_runtime() {
  static const auto runtime = std::make_shared<asmjit::JitRuntime>();
  return runtime;
}

bool has_machine_code(const InstructionList& list) {
  return list.instructions.size() <= most_compiled_instructions &&
         std::ranges::none_of(list.instructions, [](const Instruction& instruction) {
           return instruction.operation == Operation::mittag_leffler;
         });
}

}  // namespace

std::shared_ptr<MachineFunction> machine_code(const InstructionList& list) {
  if (!has_machine_code(list)) return nullptr;
  const auto& runtime = process_runtime();
  FirstError errors;
  asmjit::CodeHolder code;
  if (code.init(runtime->environment()) != asmjit::kErrorOk) return nullptr;
  code.setErrorHandler(&errors);
  asmjit::x86::Compiler compiler(&code);
  MachineCodeWriter(list, compiler).write();
  compiler.finalize();
  MachineFunction* function = nullptr;
  if (errors.first != asmjit::kErrorOk || runtime->add(&function, &code) != asmjit::kErrorOk) return nullptr;
  return {function, [runtime](MachineFunction* made) { runtime->release(made); }};
}

#else

std::shared_ptr<MachineFunction> machine_code(const InstructionList& /*list*/) { return nullptr; }

#endif

}  // namespace fde::bench
