#pragma once
#include <map>
#include <string>
#include <vector>

namespace laver::test {

/// Counts over one function of a disassembled kernel.
struct FunctionCounts {
  int arithmetic = 0;    ///< float +, -, *, /, negation, dot, which a driver may contract
  int decorated = 0;     ///< arithmetic with NoContraction
  int unrolled = 0;      ///< decorated, but in a loop marked for unrolling, which drops it
  int nanSensitive = 0;  ///< FMin, FMax, FClamp: undefined if an operand is NaN
  int divergent = 0;  ///< group operations, also by calls, in an arm of an `if` or of a `?:` that
                      ///< no constant decides: lanes may be missing
};

/// The properties of a kernel that lint() checks.
struct KernelCounts {
  std::map<std::string, FunctionCounts> functions;  ///< by source name
  int doubles = 0;                                  ///< 64-bit float types and their capability
  int longs = 0;                                    ///< 64-bit integer types and their capability
  int longArithmetic = 0;                           ///< instructions that compute with them
};

/// Parses the output of spirv-dis.
KernelCounts countOf(const std::string& disassembly);

/// The defects of one kernel, one line each. Kernels for packets may use 64-bit integers to pass
/// pairs of floats, for which `packet` is true; others must not require optional features.
std::vector<std::string> lint(const KernelCounts& kernel, bool packet = false);

/// Share of the kernel's arithmetic that carries NoContraction, over all its functions.
double decoratedShare(const KernelCounts& kernel);

/// Arithmetic of the kernel that must carry NoContraction, and how much of it does.
FunctionCounts preciseArithmetic(const KernelCounts& kernel);

}  // namespace laver::test
