#pragma once
#include <map>
#include <string>
#include <vector>

namespace laver::test {

/// Counts over one function of a disassembled kernel.
struct FunctionCounts {
  int arithmetic = 0;    ///< float +, -, *, /, negation, dot: what a driver may contract
  int decorated = 0;     ///< of these, with NoContraction
  int unrolled = 0;      ///< of those, in a loop marked for unrolling, which drops NoContraction
  int nanSensitive = 0;  ///< FMin, FMax, FClamp: undefined where an operand is NaN
  int divergent = 0;  ///< group operations, also by calls, in an arm of an `if` or of a `?:` that
                      ///< no constant decides: lanes may be missing
};

/// What a lint wants to know of a kernel.
struct KernelCounts {
  std::map<std::string, FunctionCounts> functions;  ///< by source name
  int doubles = 0;                                  ///< 64-bit float types and their capability
  int longs = 0;                                    ///< 64-bit integer types and their capability
  int longArithmetic = 0;                           ///< instructions that compute with them
};

/// Reads what spirv-dis prints.
KernelCounts countOf(const std::string& disassembly);

/// The faults of one kernel, one line each. Those of packets may pass on pairs of floats as 64-bit
/// integers, which `packet` asks of a device; others need no more than any device has.
std::vector<std::string> lint(const KernelCounts& kernel, bool packet = false);

/// Share of the kernel's arithmetic that carries NoContraction, over all its functions.
double decoratedShare(const KernelCounts& kernel);

/// Arithmetic of the kernel that must carry NoContraction, and how much of it does.
FunctionCounts preciseArithmetic(const KernelCounts& kernel);

}  // namespace laver::test
