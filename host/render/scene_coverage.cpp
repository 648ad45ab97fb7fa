#include "render/scene_coverage.h"

#include <cmath>
#include <limits>
#include <utility>

#include "bvh/walk.h"
#include "shared/box.h"

namespace laver {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr int kFineEnough = 8;  // pixels: a box that looks smaller is taken as a whole
constexpr double kRounding = 0x1p-24;

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Film positions between which geometry is seen. Points are given as (x, y, 1) times a factor
/// that is positive before the camera, where the direction is x X + y Y + Z: seen at (size - (x,
/// y)) / 2.
struct Bounds {
  dvec2 size;
  dvec2 low{kFar}, high{-kFar};

  void see(dvec3 p) {
    if (!(p.z > 0.0)) return;
    const dvec2 film = (size - dvec2(p) / p.z) * 0.5;
    low = glm::min(low, film);
    high = glm::max(high, film);
  }

  /// Where an edge of a box comes through the camera's plane it is seen infinitely far off.
  void seeEdge(dvec3 a, dvec3 b) {
    if ((a.z > 0.0) == (b.z > 0.0)) return;
    const dvec2 crossing = (dvec2(a) * b.z - dvec2(b) * a.z) * (b.z > a.z ? 1.0 : -1.0);
    for (int axis = 0; axis < 2; ++axis) {
      if (!(crossing[axis] < 0.0)) low[axis] = -kFar;
      if (!(crossing[axis] > 0.0)) high[axis] = kFar;
    }
  }
};

/// Projects boxes onto the film by the numbers that the kernels make camera rays of.
class Projector {
 public:
  explicit Projector(const shared::Params& p)
      : film_(p.filmSize.x, p.filmSize.y),
        origin_(p.origin),
        pad_(static_cast<double>(shared::padOf(glm::vec3(p.origin)))) {
    const glm::dmat3 toScene(dvec3(p.columnX), dvec3(p.columnY), dvec3(p.columnZ));
    toFilm_ = glm::inverse(toScene);
    // A direction x X + y Y + Z is made with two roundings of a product and two of sums, and x and
    // y are rounded before: 5 of them at most, each of what the terms' sizes add up to.
    const auto size = [](dvec3 v) { return glm::abs(v); };
    const dvec3 error =
        5.0 * kRounding *
        (size(toScene[0]) * film_.x + size(toScene[1]) * film_.y + size(toScene[2]));
    dvec3 moved(0.0);
    for (int column = 0; column < 3; ++column) moved += size(toFilm_[column]) * error[column];
    margin_ = (dvec2(moved) + film_ * moved.z) / (2.0 * (1.0 - moved.z));
    usable_ = moved.z < 0.5 && std::isfinite(margin_.x + margin_.y);
  }

  /// False for a camera so askew that rounding alone decides where its rays go.
  bool usable() const { return usable_; }

  /// The pixels that may see something of a box, and perhaps more of them.
  Crop pixels(const shared::Child& box) const {
    // What the test of triangles and boxes may err by; see padOf.
    const dvec3 lo = dvec3(box.lo) - pad_ - origin_, hi = dvec3(box.hi) + pad_ - origin_;
    dvec3 corners[8];
    for (int i = 0; i < 8; ++i)
      corners[i] = toFilm_ * dvec3((i & 1) != 0 ? hi.x : lo.x, (i & 2) != 0 ? hi.y : lo.y,
                                   (i & 4) != 0 ? hi.z : lo.z);
    Bounds bounds{film_};
    for (int i = 0; i < 8; ++i) {
      bounds.see(corners[i]);
      for (int bit = 1; bit < 8; bit *= 2)
        if ((i & bit) == 0) bounds.seeEdge(corners[i], corners[i | bit]);
    }
    // A pixel's samples lie on both of its borders too.
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

/// A box that adds nothing is left out with all that it holds; one that looks small is not opened.
class Collector {
 public:
  explicit Collector(const Packed& packed)
      : bvh_(packed.bvh),
        projector_(packed.params),
        seen_(static_cast<int>(packed.params.filmSize.x),
              static_cast<int>(packed.params.filmSize.y)) {}

  Coverage run() {
    if (!projector_.usable()) return Coverage::whole(seen_.width(), seen_.height());
    std::vector<std::uint32_t> waiting{bvh_.root};
    while (!waiting.empty()) {
      const shared::Node& node = bvh_.nodes[waiting.back()];
      waiting.pop_back();
      for (const shared::Child& child : node.child)
        if (child.ref != shared::REF_NONE && look(child)) waiting.push_back(child.ref);
    }
    return std::move(seen_);
  }

 private:
  /// True if the child is to be opened.
  bool look(const shared::Child& child) {
    const Crop pixels = projector_.pixels(child);
    if (seen_.holds(pixels)) return false;
    const bool small = pixels.x1 - pixels.x0 <= kFineEnough && pixels.y1 - pixels.y0 <= kFineEnough;
    if (child.ref < shared::REF_LEAF && !small) return true;
    seen_.add(pixels);
    return false;
  }

  const Bvh& bvh_;
  Projector projector_;
  Coverage seen_;
};

}  // namespace

Coverage coverageOf(const Packed& packed) { return Collector(packed).run(); }

}  // namespace laver
