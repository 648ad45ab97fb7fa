#include "random/verdict.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "pictures/harness.h"
#include "random/compared.h"
#include "reference/reference.h"

namespace laver::test {
namespace {

using enum Verdict::Result;

/// Parts that differ between scenes of a kind. General ones have the same bits
/// (pictures/savings.cpp).
const std::vector<std::string> kGeneral{
    "stack",         "normals",     "materials",   "bsdf records", "lights",
    "shaped lights", "many lights", "jump levels", "index bytes",  "hits",
    "spheres",       "caps",        "far parts",   "far camera",   "slivers"};

/// Limits for paths and lenses, whose later hits have no bound: see tests/README.md.
constexpr double kMaxUnexplained = 0.05;
constexpr double kMaxDrift = 5.0;

std::string notFinite(const Image& image) {
  for (const float value : image.pixels)
    if (!std::isfinite(value)) return "a pixel is not finite";
  return {};
}

std::string problemOf(const Compared& c, const Kind& kind) {
  const std::string counts = fmt::format("{} of {} pixels differ, {} unexplained: {}", c.differing,
                                         c.pixels, c.unexplained, c.first);
  if (kind.explained()) return c.unexplained == 0 ? "" : counts;
  if (c.unexplained > 2 + kMaxUnexplained * c.pixels) return counts;
  if (std::abs(c.drift) > kMaxDrift)
    return fmt::format("the mean is off by {:.2g} standard errors; {}", c.drift, counts);
  return {};
}

}  // namespace

struct Court::Impl {
  std::uint64_t kind = 0;
  std::map<std::string, Renderer> renderers;

  Renderer& renderer(const Kind& wanted, const std::string& traversal);
  Rendered render(const RandomScene& random, const std::string& traversal);
};

Court::Court() : impl_(std::make_unique<Impl>()) {}
Court::~Court() = default;

Renderer& Court::Impl::renderer(const Kind& wanted, const std::string& traversal) {
  const std::string name = wanted.general ? "general " + traversal : traversal;
  if (const auto found = renderers.find(name); found != renderers.end()) return found->second;
  VulkanOptions options = onTestDevice(traversal);
  options.keepsKernels = true;
  options.poisoned = true;
  if (wanted.general) options.general = kGeneral;
  return renderers.try_emplace(name, options).first->second;
}

Rendered Court::Impl::render(const RandomScene& random, const std::string& traversal) {
  Stats stats;
  return renderer(random.kind, traversal).render(random.scene, {}, stats);
}

Verdict Court::judge(const RandomScene& random) try {
  if (impl_->kind != random.kind.number) impl_->renderers.clear();
  impl_->kind = random.kind.number;
  const auto& traversals = random.kind.traversals;
  Rendered rendered;
  try {
    rendered = impl_->render(random, traversals.front());
  } catch (const Error& error) {
    if (error.code() == ExitCode::Device) return {Refused, error.what()};
    throw;
  }
  if (rendered.droppedSamples != 0)
    return {Dropped, fmt::format("{} samples were dropped", rendered.droppedSamples)};
  if (const std::string problem = notFinite(rendered.image); !problem.empty())
    return {NotFinite, problem};
  for (std::size_t i = 1; i < traversals.size(); ++i)
    if (const auto bits =
            differingFloats(rendered.image, impl_->render(random, traversals[i]).image);
        bits != 0)
      return {OtherBits, fmt::format("{} values of {} have other bits", bits, traversals[i])};
  const Reference reference(random.scene);
  const Rendered truth = reference.render();
  if (const std::string problem = notFinite(truth.image); !problem.empty())
    return {NotFinite, "of the reference " + problem};
  const Compared compared = compare(rendered.image, truth.image, random, reference);
  Verdict verdict;
  verdict.differing = static_cast<double>(compared.differing) / compared.pixels;
  verdict.unexplained = static_cast<double>(compared.unexplained) / compared.pixels;
  verdict.why = problemOf(compared, random.kind);
  if (!verdict.why.empty()) verdict.result = Different;
  return verdict;
} catch (const std::exception& fault) {
  return {Threw, fault.what()};
}

}  // namespace laver::test
