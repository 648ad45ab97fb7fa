#include "render/scene_coverage.h"

#include <cmath>
#include <limits>
#include <utility>

#include "bvh/walk.h"
#include "core/numeric.h"
#include "shared/box.h"

namespace laver {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr int kSmallBox = 8;  // pixels: smaller boxes are not subdivided
constexpr double kRounding = 0x1p-24;

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Bounds of the film positions of geometry. Points are homogeneous, (x, y, 1) times a factor that
/// is positive in front of the camera; the camera's direction is x X + y Y + Z, so their film
/// position is (size - (x, y)) / 2.
struct Bounds {
  dvec2 size;
  dvec2 low{kFar}, high{-kFar};

  void add(dvec3 p) {
    if (!(p.z > 0.0)) return;
    const dvec2 film = (size - dvec2(p) / p.z) * 0.5;
    low = glm::min(low, film);
    high = glm::max(high, film);
  }

  /// An edge of a box that crosses the camera's plane extends to infinity on the film.
  void addEdge(dvec3 a, dvec3 b) {
    if ((a.z > 0.0) == (b.z > 0.0)) return;
    const dvec2 crossing = (dvec2(a) * b.z - dvec2(b) * a.z) * (b.z > a.z ? 1.0 : -1.0);
    for (int axis = 0; axis < 2; ++axis) {
      if (!(crossing[axis] < 0.0)) low[axis] = -kFar;
      if (!(crossing[axis] > 0.0)) high[axis] = kFar;
    }
  }
};

/// Projects boxes onto the film by the numbers from which the kernels compute camera rays.
class Projector {
 public:
  explicit Projector(const Packed& packed)
      : film_(packed.params.filmSize.x, packed.params.filmSize.y),
        origin_(packed.space.start > 0.0 ? packed.eye : dvec3(packed.params.origin)),
        pad_(static_cast<double>(shared::padOf(packed.params.origin))) {
    const shared::Params& p = packed.params;
    // Starts are rounded as directions are below.
    if (packed.space.start > 0.0)
      pad_ += 5.0 * kRounding *
              (maxNorm(dvec3(p.startX)) * film_.x + maxNorm(dvec3(p.startY)) * film_.y +
               maxNorm(dvec3(p.origin)));
    const glm::dmat3 toScene(dvec3(p.columnX), dvec3(p.columnY), dvec3(p.columnZ));
    toFilm_ = glm::inverse(toScene);
    // Rounding of a direction x X + y Y + Z: two products, two sums, and before that x and y, at
    // most 5 roundings, each relative to the sum of the terms' magnitudes.
    const auto size = [](dvec3 v) { return glm::abs(v); };
    const dvec3 error =
        5.0 * kRounding *
        (size(toScene[0]) * film_.x + size(toScene[1]) * film_.y + size(toScene[2]));
    dvec3 moved(0.0);
    for (int column = 0; column < 3; ++column) moved += size(toFilm_[column]) * error[column];
    margin_ = (dvec2(moved) + film_ * moved.z) / (2.0 * (1.0 - moved.z));
    usable_ = moved.z < 0.5 && std::isfinite(margin_.x + margin_.y);
  }

  /// False for a camera so sheared that rounding alone determines where its rays go.
  bool usable() const { return usable_; }

  /// The pixels whose rays may hit a box; may include more.
  Crop pixels(const shared::Child& box) const {
    // The tests of triangles and boxes may err by the pad (padOf).
    const dvec3 lo = dvec3(box.lo) - pad_ - origin_, hi = dvec3(box.hi) + pad_ - origin_;
    dvec3 corners[8];
    for (int i = 0; i < 8; ++i)
      corners[i] = toFilm_ * dvec3((i & 1) != 0 ? hi.x : lo.x, (i & 2) != 0 ? hi.y : lo.y,
                                   (i & 4) != 0 ? hi.z : lo.z);
    Bounds bounds{film_};
    for (int i = 0; i < 8; ++i) {
      bounds.add(corners[i]);
      for (int bit = 1; bit < 8; bit *= 2)
        if ((i & bit) == 0) bounds.addEdge(corners[i], corners[i | bit]);
    }
    // Samples may lie on either border of a pixel.
    const dvec2 first = glm::ceil(glm::clamp(bounds.low - margin_, dvec2(-1.0), film_ + 1.0)) - 1.0;
    const dvec2 end = glm::floor(glm::clamp(bounds.high + margin_, dvec2(-1.0), film_ + 1.0)) + 1.0;
    return {static_cast<int>(first.x), static_cast<int>(first.y), static_cast<int>(end.x),
            static_cast<int>(end.y)};
  }

 private:
  dvec2 film_;
  dvec3 origin_;
  double pad_;
  glm::dmat3 toFilm_;
  dvec2 margin_;
  bool usable_;
};

/// Collects the coverage of the tree. A box that adds no pixel is skipped with its subtree; a box
/// that looks small is not subdivided.
class Collector {
 public:
  explicit Collector(const Packed& packed)
      : bvh_(packed.bvh),
        projector_(packed),
        covered_(static_cast<int>(packed.params.filmSize.x),
                 static_cast<int>(packed.params.filmSize.y)) {}

  Coverage run() {
    if (!projector_.usable()) return Coverage::whole(covered_.width(), covered_.height());
    std::vector<std::uint32_t> waiting{bvh_.root};
    while (!waiting.empty()) {
      const shared::Node& node = bvh_.nodes[waiting.back()];
      waiting.pop_back();
      for (const shared::Child& child : node.child)
        if (child.ref != shared::REF_NONE && addOrDescend(child)) waiting.push_back(child.ref);
    }
    return std::move(covered_);
  }

 private:
  /// Adds the child's pixels, or returns true if it must be subdivided.
  bool addOrDescend(const shared::Child& child) {
    const Crop pixels = projector_.pixels(child);
    if (covered_.contains(pixels)) return false;
    const bool small = pixels.x1 - pixels.x0 <= kSmallBox && pixels.y1 - pixels.y0 <= kSmallBox;
    if (child.ref < shared::REF_LEAF && !small) return true;
    covered_.add(pixels);
    return false;
  }

  const Bvh& bvh_;
  Projector projector_;
  Coverage covered_;
};

}  // namespace

Coverage coverageOf(const Packed& packed) {
  const glm::uvec2 film = packed.params.filmSize;
  // What stands outside of the tree may be anywhere.
  if (packed.params.capCount != 0)
    return Coverage::whole(static_cast<int>(film.x), static_cast<int>(film.y));
  return Collector(packed).run();
}

}  // namespace laver
