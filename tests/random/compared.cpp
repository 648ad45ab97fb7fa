#include "random/compared.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <tuple>
#include <vector>

#include "render/tiling.h"

namespace laver::test {
namespace {

using glm::dvec2;
using glm::dvec3;

dvec3 pixelOf(const Image& image, int x, int y) {
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

double levelOf(const Image& image, double least) {
  std::vector<double> values;
  for (const float value : image.pixels)
    if (value != 0.0F) values.push_back(std::abs(static_cast<double>(value)));
  if (values.empty()) return least;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return std::max(*middle, least);
}

/// The largest difference of a channel beyond the tolerance, else 0.
double differenceOf(dvec3 got, dvec3 wanted, double level) {
  double largest = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double d = std::abs(got[c] - wanted[c]);
    if (d > kTolerance * std::max(level, std::abs(wanted[c]))) largest = std::max(largest, d);
  }
  return largest;
}

/// The scene with white surfaces, lit by point lights only, for bounds of what they show.
Scene boundedBy(Scene scene) {
  for (Mesh& mesh : scene.meshes) {
    mesh.bsdf = {};
    mesh.bsdf.set("albedo", dvec3(1.0));
  }
  // One of the sources is drawn, as if it were all of them. Powers may differ.
  const auto sources = static_cast<double>(scene.lights.size() + 2);
  if (scene.integrator.row->bounces)
    for (PointLight& light : scene.lights) light.radiance *= sources;
  if (scene.integrator.row->looksOn)
    scene.lights = {{scene.integrator.triple("position"),
                     scene.integrator.triple("energy") / (4.0 * std::numbers::pi)}};
  return scene;
}

/// What a primitive covers: corners in some order, or of a sphere its centre and its box.
using Shape = std::array<dvec3, 3>;

Shape shapeOf(const Mesh& mesh, std::uint32_t number) {
  if (mesh.sphere) {
    const Sphere& s = *mesh.sphere;
    return {s.centre, s.centre - s.radius, s.centre + s.radius};
  }
  const glm::uvec3 t = mesh.triangles[number];
  Shape corners{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
  std::ranges::sort(corners, [](const dvec3& p, const dvec3& q) {
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  });
  return corners;
}

/// Returns its shape. Primitives after it are numbered anew.
Shape removePrimitive(Scene& scene, std::uint32_t number) {
  auto mesh = scene.meshes.begin();
  for (; number >= mesh->primitives(); ++mesh)
    number -= static_cast<std::uint32_t>(mesh->primitives());
  const Shape shape = shapeOf(*mesh, number);
  if (mesh->sphere)
    scene.meshes.erase(mesh);
  else
    mesh->triangles.erase(mesh->triangles.begin() + number);
  return shape;
}

/// The scene with its lights moved by what floats may do to a light beside a surface: the roundings
/// of light and surface and the offset of the shadow ray (shared/point.h), in a direction of three
/// digits -1, 0 or 1.
Scene withLightsMoved(Scene scene, const Normalisation& space, dvec3 way) {
  const auto moved = [&](dvec3 p) {
    const double step = 16.0 * kUnitRoundoff * (glm::length(p - space.centre) + 4.0 / space.scale);
    return p + step * way;
  };
  for (PointLight& light : scene.lights) light.position = moved(light.position);
  if (scene.integrator.row->looksOn)
    scene.integrator.set("position", moved(scene.integrator.triple("position")));
  return scene;
}

/// A scene and its reference.
struct Variant {
  explicit Variant(Scene changed) : scene(std::move(changed)), reference(scene, 1) {}
  Variant(const Variant&) = delete;
  Variant& operator=(const Variant&) = delete;

  Scene scene;
  Reference reference;
};

/// Accounts for differences of pixels.
class Explainer {
 public:
  Explainer(const RandomScene& random, const Reference& reference)
      : scene_(random.scene),
        reference_(reference),
        bounded_(boundedBy(random.scene)),
        judge_(scene_, reference),
        bounds_(bounded_, judge_.rounding()) {
    if (random.kind.explained() && (!scene_.lights.empty() || scene_.integrator.row->looksOn))
      for (int way = 0; way < 27; ++way)
        lightsMoved_.push_back(std::make_unique<Variant>(withLightsMoved(
            scene_, judge_.rounding().space(), dvec3(way % 3 - 1, way / 3 % 3 - 1, way / 9 - 1))));
  }

  /// Whether some sample that the pixel's filter reaches may differ by half as much.
  bool explains(int x, int y, double difference) const {
    const int apron = static_cast<int>(apronOf(scene_.filter.radius));
    const Camera& camera = scene_.camera;
    for (int v = std::max(y - apron, 0); v <= std::min(y + apron, camera.height - 1); ++v)
      for (int u = std::max(x - apron, 0); u <= std::min(x + apron, camera.width - 1); ++u)
        for (std::uint32_t s = 0; s < scene_.sampler.sampleCount; ++s)
          if (mayDiffer(dvec2(reference_.samplePosition(u, v, s)),
                        reference_.sampleNumbers(u, v, s), 0.5 * difference))
            return true;
    return false;
  }

 private:
  bool mayDiffer(dvec2 film, const reference::Numbers& numbers, double difference) const {
    if (judge_.otherValue(film, numbers, difference)) return true;
    if (scene_.camera.row->lens) return false;  // the hit depends on the lens, too
    const auto hit = reference_.closest(film);
    if (!hit) return false;
    if (contested(film, numbers, *hit, difference)) return true;
    const dvec3 own = reference_.radiance(film, numbers);
    for (const auto& variant : lightsMoved_) {
      const dvec3 d = glm::abs(variant->reference.radiance(film, numbers) - own);
      if (std::max({d.x, d.y, d.z}) > difference) return true;
    }
    const ValueBounds bounds = bounds_.at(film, *hit);
    const IntegratorRow& row = *scene_.integrator.row;
    const std::string name = row.name;
    if (name == "depth") return bounds.depth >= difference * hit->distance;
    if (name.ends_with("normals")) return bounds.normal >= difference;
    if (bounds.radiance >= difference) return true;
    // The normal of a sliver turns what is sampled or shaded with it.
    return row.needs.numbers && turned(film, numbers, bounds.normal, difference);
  }

  /// The hit may be on another surface at the same distance, as far as floats tell. Of equal ones
  /// the first counts, which floats tell exactly.
  bool contested(dvec2 film, const reference::Numbers& numbers, const Reference::Hit& hit,
                 double difference) const {
    const double reach = 2.0 * bounds_.at(film, hit).depth * hit.distance;
    const dvec3 own = reference_.radiance(film, numbers);
    Scene without = scene_;
    std::vector<Shape> before;
    std::uint32_t number = hit.triangle;
    while (true) {
      const Shape shape = removePrimitive(without, number);
      const Reference reference(without, 1);
      const auto next = reference.closest(film);
      if (before.size() > 8 || !next || next->distance - hit.distance > reach) return false;
      before.push_back(shape);
      number = next->triangle;
      Scene copy = without;
      if (std::ranges::find(before, removePrimitive(copy, number)) != before.end()) continue;
      const dvec3 d = glm::abs(reference.radiance(film, numbers) - own);
      if (std::max({d.x, d.y, d.z}) > difference) return true;
    }
  }

  bool turned(dvec2 film, const reference::Numbers& numbers, double angle,
              double difference) const {
    const dvec3 own = reference_.radiance(film, numbers);
    for (const dvec2 by : {dvec2(1, 0), dvec2(-1, 0), dvec2(0, 1), dvec2(0, -1)}) {
      const dvec3 d = glm::abs(reference_.radiance(film, numbers.moved(angle * by)) - own);
      if (std::max({d.x, d.y, d.z}) > difference) return true;
    }
    return false;
  }

  const Scene& scene_;
  const Reference& reference_;
  Scene bounded_;
  Judge judge_;
  BoundsOf bounds_;
  std::vector<std::unique_ptr<Variant>> lightsMoved_;
};

/// Of the paired differences of pixels' means. A sample reaches (2 apron + 1)^2 pixels, of which
/// only one counts as independent. Means that agree to the tolerance have none.
double driftOf(const Image& image, const Image& truth, int apron) {
  double sum = 0.0, squares = 0.0, count = 0.0, level = 0.0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const double d = static_cast<double>(image.pixels[i]) - static_cast<double>(truth.pixels[i]);
    level += std::abs(static_cast<double>(truth.pixels[i]));
    sum += d;
    squares += d * d;
    count += 1.0;
  }
  const double mean = sum / count, variance = squares / count - mean * mean;
  if (std::abs(sum) <= kTolerance * std::max(level, kLeastLevel * count)) return 0.0;
  const double independent = std::max(1.0, count / 3.0 / std::pow(2.0 * apron + 1.0, 2));
  return mean / std::sqrt(std::max(variance, 1e-12 * mean * mean) / independent);
}

}  // namespace

Compared compare(const Image& image, const Image& truth, const RandomScene& random,
                 const Reference& reference) {
  Compared result;
  result.pixels = image.width * image.height;
  const bool isDepth = random.scene.integrator.is(integrators::depth);
  const double level = levelOf(truth, isDepth ? std::numeric_limits<double>::min() : kLeastLevel);
  std::optional<Explainer> explainer;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const dvec3 got = pixelOf(image, x, y), wanted = pixelOf(truth, x, y);
      const double difference = differenceOf(got, wanted, level);
      if (difference == 0.0) continue;
      ++result.differing;
      if (!explainer) explainer.emplace(random, reference);
      if (explainer->explains(x, y, difference)) continue;
      if (result.unexplained++ == 0)
        result.first = fmt::format("pixel {}, {} is {:.6g} {:.6g} {:.6g}, not {:.6g} {:.6g} {:.6g}",
                                   x, y, got.x, got.y, got.z, wanted.x, wanted.y, wanted.z);
    }
  result.drift = driftOf(image, truth, static_cast<int>(apronOf(random.scene.filter.radius)));
  return result;
}

}  // namespace laver::test
