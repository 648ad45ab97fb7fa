#include "lab/explain/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/numeric.h"

namespace laver {
namespace {

using glm::dvec2;
using glm::dvec3;

/// One sample per pixel that affects no other pixel.
Scene oneSample(Scene scene, const IntegratorUse& integrator) {
  scene.integrator = integrator;
  scene.sampler.sampleCount = 1;
  scene.filter = filterOf(filters::box);
  return scene;
}

bool looksBeyondTheHit(const IntegratorUse& integrator) {
  return integrator.row->needs.lights || integrator.row->needs.numbers || integrator.row->looksOn;
}

/// The scene with one mesh per primitive, whose albedo encodes its number in two parts that floats
/// hold exactly. Coordinates, and so the kernels' tree, are unchanged.
Scene numbered(const Scene& scene) {
  Scene result = oneSample(scene, {&integrators::albedo});
  result.meshes.clear();
  const auto add = [&](Mesh mesh) {
    const std::size_t number = result.meshes.size() + 1;
    mesh.bsdf.set("albedo", dvec3(number & 0xfffU, number >> 12, 0.0));
    result.meshes.push_back(std::move(mesh));
  };
  for (const Mesh& mesh : scene.meshes) {
    Mesh single;
    single.sphere = mesh.sphere;
    if (mesh.sphere) add(single);
    for (const glm::uvec3& t : mesh.triangles) {
      single.positions = {mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
      single.triangles = {glm::uvec3(0, 1, 2)};
      add(single);
    }
  }
  return result;
}

/// The primitive's number that a pixel of numbered() encodes; none for a miss.
std::optional<std::uint32_t> idOf(dvec3 pixel) {
  const auto number =
      static_cast<std::uint32_t>(pixel.x) + (static_cast<std::uint32_t>(pixel.y) << 12);
  return number == 0 ? std::nullopt : std::optional(number - 1);
}

std::string nameOf(std::optional<std::uint32_t> id) { return id ? std::to_string(*id) : "none"; }

dvec3 pixelOf(const Image& image, int x, int y) {
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

void put(ComparedSample& sample, Quantity quantity, double ulps, bool within) {
  sample.ulps[quantity] = ulps;
  sample.within[quantity] = within;
  if (!within && sample.unexplained.empty())
    sample.unexplained = fmt::format("{} off by {:.3g} ulp", kQuantityNames[quantity], ulps);
}

}  // namespace

SampleComparison::SampleComparison(const Scene& scene, const Scene& judged,
                                   const VulkanOptions& vulkan)
    : truth_(oneSample(judged, judged.integrator)),
      normalTruth_(oneSample(judged, {&integrators::normals})),
      reference_(truth_),
      normalReference_(normalTruth_),
      judge_(truth_, reference_),
      bounds_(truth_, judge_.rounding()),
      hasValue_(looksBeyondTheHit(scene.integrator)) {
  Renderer renderer(vulkan);
  const auto render = [&](const Scene& s) {
    Stats stats;
    return renderer.render(s, {}, stats).image;
  };
  ids_ = render(numbered(scene));
  depth_ = render(oneSample(scene, {&integrators::depth}));
  normal_ = render(oneSample(scene, {&integrators::normals}));
  if (hasValue_) value_ = render(oneSample(scene, scene.integrator));
}

// Film positions are floats: some lie on the border of two pixels, and the box filter counts them
// in both.
bool SampleComparison::showsOneSample(int x, int y) const {
  int count = 0;
  for (int py = std::max(y - 1, 0); py <= std::min(y + 1, height() - 1); ++py)
    for (int px = std::max(x - 1, 0); px <= std::min(x + 1, width() - 1); ++px) {
      const glm::vec2 away =
          glm::abs(reference_.samplePosition(px, py, 0) - glm::vec2(x, y) - 0.5F);
      count += away.x <= 0.5F && away.y <= 0.5F ? 1 : 0;
    }
  return count == 1;
}

ComparedSample SampleComparison::at(int x, int y) const {
  ComparedSample sample;
  sample.leftOut = !showsOneSample(x, y);
  if (sample.leftOut) return sample;
  const dvec2 film(reference_.samplePosition(x, y, 0));
  const Hit hit = reference_.closest(film);
  const Id id = idOf(pixelOf(ids_, x, y)), wanted = hit ? Id(hit->triangle) : std::nullopt;
  const double depthSeen = pixelOf(depth_, x, y).x;
  if (id != wanted) {
    sample.otherHit = true;
    sample.explained = explainsHit(film, hit, id, 1.0 / depthSeen);
    if (!sample.explained)
      sample.unexplained = fmt::format("primitive {} instead of {}", nameOf(id), nameOf(wanted));
    return sample;
  }
  std::optional<double> valueBound;
  if (hit) {
    const ValueBounds bounds = bounds_.at(film, *hit);
    const double depth = 1.0 / hit->distance, depthOff = std::abs(depthSeen - depth);
    put(sample, kDepth, depthOff / ulpOf(depth), depthOff <= bounds.depth * depth);
    const double normalOff = maxNorm(pixelOf(normal_, x, y) - normalReference_.radiance(film));
    put(sample, kNormal, normalOff / kUnitRoundoff, normalOff <= bounds.normal);
    valueBound = bounds.radiance;
  }
  if (hasValue_) compareValue(sample, x, y, valueBound);
  return sample;
}

// Without a bound the value is a background's, which interpolates four pixels and takes a product:
// 16 e, or the change within the film positions that rounding may reach.
void SampleComparison::compareValue(ComparedSample& sample, int x, int y,
                                    std::optional<double> bound) const {
  const dvec2 film(reference_.samplePosition(x, y, 0));
  const reference::Numbers numbers = reference_.sampleNumbers(x, y, 0);
  const dvec3 wanted = reference_.radiance(film, numbers);
  const double off = maxNorm(pixelOf(value_, x, y) - wanted), size = maxNorm(wanted);
  const bool within = off <= bound.value_or(16.0 * kUnitRoundoff * size);
  const bool explained = within || judge_.otherValue(film, numbers, 0.5 * off);
  if (within || (!bound && explained)) return put(sample, kValue, off / ulpOf(size), true);
  sample.otherOcclusion = true;
  sample.explained = explained;
  if (!explained) sample.unexplained = fmt::format("value off by {:.3g}", off);
}

// Also explains hits at the same distance, on a coincident surface.
bool SampleComparison::explainsHit(dvec2 film, const Hit& hit, Id id, double distance) const {
  if (judge_.mayHit(film, id, distance)) return true;
  if (!hit || !id) return false;
  return std::abs(hit->distance - distance) <= bounds_.at(film, *hit).depth * distance;
}

std::string SampleComparison::causeAt(int x, int y) const {
  const dvec2 film(reference_.samplePosition(x, y, 0));
  const Hit hit = reference_.closest(film);
  return hit ? bounds_.at(film, *hit).cause : "background";
}

}  // namespace laver
