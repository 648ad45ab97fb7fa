#include "stability/spirv_lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace laver::test {
namespace {

/// Functions whose error bounds count every rounding: all of their arithmetic must be
/// NoContraction, or some of it if the rest may round freely. The fused products of
/// differenceOfProducts() are explicit and need none.
enum class Precise { All, Some };
const std::map<std::string, Precise> kPrecise = {
    {"differenceOfProducts",
     Precise::All},                // triangle.h: Kahan's correction must not be folded away
    {"dotProduct", Precise::All},  // triangle.h: both triangles of an edge see the same bits
    {"shearOf", Precise::All},
    {"edgesOf", Precise::All},
    {"depthOf", Precise::All},
    {"boxSpan", Precise::All},   // box.h: the pad counts its roundings
    {"pointAt", Precise::Some},  // point.h: weights and position; the rest are calls and quotients
    {"accurateDifference", Precise::All},  // point.h
    {"shadingNormal", Precise::All},
    {"chordOf", Precise::Some},  // sphere.h; the rest are scalings by a power of two
    {"endsOf", Precise::All},
    {"plus", Precise::All},  // sphere.h: two-sum is all rounding errors
    {"plusProduct", Precise::All},
    {"spherePointAt", Precise::Some},   // sphere.h; Newton's steps may round as they like
    {"blocksSegment", Precise::All},    // triangle.h
    {"cosSinOfTurn", Precise::Some},    // direction.h; not precise: which quarter turn is taken out
    {"sphereDirection", Precise::All},  // direction.h
    {"uniformDirection", Precise::All},  // direction.h
    {"filmPosition", Precise::All},      // sampler.glsl: pixel + jitter is Nori's float sum
    {"insidePixel", Precise::All},       // sampler.glsl
    {"pinholeDirection", Precise::All},
    {"expOf", Precise::Some},  // exp.glsl: Cody and Waite's reduction; the last is a scaling
    {"addCompensated", Precise::All},  // gather.glsl: two-sum is all rounding errors
};

bool isPrecise(Precise precise, const FunctionCounts& counts) {
  return counts.decorated > 0 &&
         (precise == Precise::Some || counts.decorated == counts.arithmetic);
}

/// Functions that may use FMin, FMax and FClamp, with the reason why no operand is NaN or why NaN
/// does not matter. Any other function that uses one is a defect: state the reason here or write a
/// select.
const std::map<std::string, const char*> kMayCompare = {
    {"unitOr", "largest |component|: NaN stays NaN or becomes a fallback, both dropped as such"},
    {"largestOf", "coordinates of vertices, finite"},
    {"pointAt", "depths of corners, finite; a quotient by 0 is excluded by a select"},
    {"filterAt", "distances of a pixel's centre, finite"},
    {"filterWeights", "products of exponentials that choices.cpp keeps finite"},
};

bool startsWith(const std::string& text, const char* prefix) { return text.rfind(prefix, 0) == 0; }

bool isArithmetic(const std::string& op) {
  static const std::set<std::string> ops = {"OpFAdd",
                                            "OpFSub",
                                            "OpFMul",
                                            "OpFDiv",
                                            "OpFNegate",
                                            "OpDot",
                                            "OpVectorTimesScalar",
                                            "OpMatrixTimesVector",
                                            "OpVectorTimesMatrix",
                                            "OpMatrixTimesScalar",
                                            "OpMatrixTimesMatrix"};
  return ops.contains(op);
}

/// Comparisons and conversions have a result of another type and are not counted.
bool isIntegerArithmetic(const std::string& op) {
  for (const char* prefix : {"OpI", "OpU", "OpS", "OpBit", "OpNot", "OpAtomic"})
    if (startsWith(op, prefix)) return op != "OpBitcast" && op != "OpSelect";
  return false;
}

/// Finds functions that execute group operations, directly or by calls, where some lanes may be
/// inactive.
class Divergence {
 public:
  void read(const std::string& line) {
    std::istringstream words(line);
    std::string first, second, operation, type, callee;
    words >> first >> second >> operation >> type >> callee;
    if (first == "OpSelectionMerge") merge_ = second;
    if (first == "OpBranchConditional") {
      if (!merge_.empty() && !constants_.contains(second)) arms_.push_back(merge_);
      merge_.clear();
    }
    if (startsWith(operation, "OpSpecConstant") || startsWith(operation, "OpConstant"))
      constants_.insert(first);
    if (operation == "OpFunction") function_ = first;
    if (operation == "OpLabel") {
      const auto end = std::find(arms_.begin(), arms_.end(), first);
      arms_.erase(end, arms_.end());
    }
    if (startsWith(operation, "OpGroupNonUniform"))
      calls_.push_back({function_, "", !arms_.empty()});
    if (operation == "OpFunctionCall") calls_.push_back({function_, callee, !arms_.empty()});
  }

  /// Names of functions, one entry per such place.
  std::vector<std::string> places() const {
    std::set<std::string> groups{""};  // the callee of a group operation
    for (std::size_t known = 0; known != groups.size();) {
      known = groups.size();
      for (const Call& call : calls_)
        if (groups.contains(call.callee)) groups.insert(call.caller);
    }
    std::vector<std::string> places;
    for (const Call& call : calls_)
      if (call.inArm && groups.contains(call.callee)) places.push_back(call.caller);
    return places;
  }

 private:
  struct Call {
    std::string caller, callee;
    bool inArm;
  };
  std::set<std::string> constants_;
  std::vector<std::string> arms_;  // labels where those end that are open
  std::vector<Call> calls_;
  std::string function_, merge_;
};

/// Whether a line is in a loop that is marked for unrolling.
class UnrolledLoops {
 public:
  void read(const std::string& line) {
    std::istringstream words(line);
    std::string first, second, third, control;
    words >> first >> second >> third >> control;
    if (first == "OpLoopMerge" && control == "Unroll") open_.push_back(second);
    if (third == "OpLabel") open_.erase(std::find(open_.begin(), open_.end(), first), open_.end());
  }
  bool inside() const { return !open_.empty(); }

 private:
  std::vector<std::string> open_;  // labels where those end that are open
};

}  // namespace

KernelCounts countOf(const std::string& disassembly) {
  KernelCounts kernel;
  std::map<std::string, std::string> names;
  std::set<std::string> decorated, longs;
  FunctionCounts* current = nullptr;
  Divergence divergence;
  UnrolledLoops unrolled;
  std::istringstream lines(disassembly);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first, second, third;
    words >> first >> second;
    divergence.read(line);
    unrolled.read(line);
    if (first == "OpName") {
      std::string quoted;
      words >> quoted;
      names[second] = quoted.substr(1, quoted.find_first_of("(\"", 1) - 1);
    } else if (first == "OpDecorate") {
      words >> third;
      if (third == "NoContraction") decorated.insert(second);
    } else if (first == "OpCapability") {
      kernel.doubles += second == "Float64" ? 1 : 0;
      kernel.longs += second == "Int64" ? 1 : 0;
    } else if (second == "=") {
      words >> third;
      std::string type, set, function;
      if (third == "OpFunction") current = &kernel.functions[names[first]];
      if (third == "OpTypeFloat" || third == "OpTypeInt" || third == "OpTypeVector") words >> type;
      if (third == "OpTypeFloat" && type == "64") ++kernel.doubles;
      if (third == "OpTypeInt" && type == "64") ++kernel.longs;
      if ((third == "OpTypeInt" && type == "64") ||
          (third == "OpTypeVector" && longs.contains(type)))
        longs.insert(first);
      if (current == nullptr) continue;
      if (isIntegerArithmetic(third)) {
        words >> type;
        kernel.longArithmetic += longs.contains(type) ? 1 : 0;
      }
      if (isArithmetic(third)) {
        ++current->arithmetic;
        current->decorated += decorated.contains(first) ? 1 : 0;
        current->unrolled += decorated.contains(first) && unrolled.inside() ? 1 : 0;
      } else if (third == "OpExtInst") {
        words >> type >> set >> function;
        if (function == "FMin" || function == "FMax" || function == "FClamp")
          ++current->nanSensitive;
      }
    }
  }
  for (const std::string& function : divergence.places())
    ++kernel.functions[names[function]].divergent;
  return kernel;
}

std::vector<std::string> lint(const KernelCounts& kernel, bool packet) {
  std::vector<std::string> faults;
  if (kernel.doubles != 0) faults.emplace_back("64-bit floats");
  if (kernel.longs != 0 && !packet) faults.emplace_back("64-bit integers");
  if (kernel.longArithmetic != 0)
    faults.push_back(
        fmt::format("{} instructions compute with 64-bit integers", kernel.longArithmetic));
  for (const auto& [name, counts] : kernel.functions) {
    const auto precise = kPrecise.find(name);
    if (precise != kPrecise.end() && !isPrecise(precise->second, counts))
      faults.push_back(fmt::format("{}: {} of {} instructions are NoContraction, expected {}", name,
                                   counts.decorated, counts.arithmetic,
                                   precise->second == Precise::All ? "all" : "some"));
    if (counts.nanSensitive != 0 && !kMayCompare.contains(name))
      faults.push_back(fmt::format("{}: {} of FMin, FMax, FClamp without a stated reason", name,
                                   counts.nanSensitive));
    if (counts.unrolled != 0)
      faults.push_back(fmt::format("{}: {} NoContraction instructions in a loop that is unrolled",
                                   name, counts.unrolled));
    if (counts.divergent != 0)
      faults.push_back(fmt::format("{}: {} group operations where lanes may be missing", name,
                                   counts.divergent));
    // Without names in the debug information the lint would find nothing.
    if (name.empty() || startsWith(name, "%")) faults.emplace_back("a function without a name");
  }
  return faults;
}

double decoratedShare(const KernelCounts& kernel) {
  int arithmetic = 0, decorated = 0;
  for (const auto& [name, counts] : kernel.functions) {
    arithmetic += counts.arithmetic;
    decorated += counts.decorated;
  }
  return static_cast<double>(decorated) / arithmetic;
}

FunctionCounts preciseArithmetic(const KernelCounts& kernel) {
  FunctionCounts sum;
  for (const auto& [name, counts] : kernel.functions) {
    const auto precise = kPrecise.find(name);
    if (precise == kPrecise.end()) continue;
    sum.arithmetic += counts.arithmetic;
    sum.decorated += counts.decorated;
  }
  return sum;
}

}  // namespace laver::test
