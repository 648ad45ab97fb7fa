#include "render/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "shared/box.h"

namespace laver {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr int kColumns = 8;     // of a block of slots
constexpr int kUnits = 256;     // at most: as many groups of rows may begin a rectangle
constexpr int kFineEnough = 8;  // pixels: a box that looks smaller is taken as a whole
constexpr double kRounding = 0x1p-24;

/// Projects boxes onto the film by the numbers that the kernels make camera rays of.
class Projector {
 public:
  explicit Projector(const shared::Params& p)
      : film_(p.film.x, p.film.y),
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
    low_ = dvec2(std::numeric_limits<double>::infinity());
    high_ = -low_;
    for (int i = 0; i < 8; ++i) {
      if (corners[i].z > 0.0) see(dvec2(corners[i]) / corners[i].z);
      for (int bit = 1; bit < 8; bit *= 2)
        if ((i & bit) == 0) seeEdge(corners[i], corners[i | bit]);
    }
    // A pixel's samples lie on both of its borders too.
    const dvec2 first = glm::ceil(glm::clamp(low_ - margin_, dvec2(-1.0), film_ + 1.0)) - 1.0;
    const dvec2 end = glm::floor(glm::clamp(high_ + margin_, dvec2(-1.0), film_ + 1.0)) + 1.0;
    return {static_cast<int>(first.x), static_cast<int>(first.y), static_cast<int>(end.x),
            static_cast<int>(end.y)};
  }

 private:
  /// (x, y) of a direction x X + y Y + Z; a film position is (size - (x, y)) / 2.
  void see(dvec2 xy) const {
    const dvec2 film = (film_ - xy) * 0.5;
    low_ = glm::min(low_, film);
    high_ = glm::max(high_, film);
  }

  /// Where an edge of the box comes through the camera's plane it is seen infinitely far off.
  void seeEdge(dvec3 a, dvec3 b) const {
    if ((a.z > 0.0) == (b.z > 0.0)) return;
    const dvec2 crossing = (dvec2(a) * b.z - dvec2(b) * a.z) * (b.z > a.z ? 1.0 : -1.0);
    constexpr double kFar = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 2; ++axis) {
      if (!(crossing[axis] < 0.0)) low_[axis] = -kFar;
      if (!(crossing[axis] > 0.0)) high_[axis] = kFar;
    }
  }

  dvec2 film_;
  dvec3 origin_;
  double pad_;
  glm::dmat3 toFilm_;
  dvec2 margin_;
  bool usable_;
  mutable dvec2 low_, high_;
};

/// A box that adds nothing is left out with all that it holds; one that looks small is not opened.
class Collector {
 public:
  explicit Collector(const SceneData& data)
      : bvh_(data.bvh),
        projector_(data.params),
        seen_(static_cast<int>(data.params.film.x), static_cast<int>(data.params.film.y)) {}

  Footprint run() {
    std::vector<std::uint32_t> waiting;
    if (bvh_.nodes.empty()) return std::move(seen_);
    if (projector_.usable())
      waiting.push_back(bvh_.root);
    else
      seen_ = Footprint::whole(seen_.width(), seen_.height());
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
  Footprint seen_;
};

int multipleBelow(int x) { return x / kColumns * kColumns; }

}  // namespace

void Footprint::Span::widen(const Span& s) {
  if (s.empty()) return;
  *this = empty() ? s : Span{std::min(x0, s.x0), std::max(x1, s.x1)};
}

Footprint::Footprint(int width, int height)
    : width_(width), rows_(static_cast<std::size_t>(height), Span{0, 0}) {}

Footprint Footprint::whole(int width, int height) {
  Footprint all(width, height);
  all.add({0, 0, width, height});
  return all;
}

void Footprint::add(const Crop& pixels) {
  const Span span{std::max(pixels.x0, 0), std::min(pixels.x1, width_)};
  const int end = std::min(pixels.y1, height());
  for (int y = std::max(pixels.y0, 0); y < end; ++y) rows_[static_cast<std::size_t>(y)].widen(span);
}

bool Footprint::holds(const Crop& pixels) const {
  const Span span{std::max(pixels.x0, 0), std::min(pixels.x1, width_)};
  if (span.empty()) return true;
  const int end = std::min(pixels.y1, height());
  for (int y = std::max(pixels.y0, 0); y < end; ++y) {
    const Span& row = rows_[static_cast<std::size_t>(y)];
    if (row.empty() || row.x0 > span.x0 || row.x1 < span.x1) return false;
  }
  return true;
}

bool Footprint::meets(const Crop& pixels) const {
  const int end = std::min(pixels.y1, height());
  for (int y = std::max(pixels.y0, 0); y < end; ++y) {
    const Span& row = rows_[static_cast<std::size_t>(y)];
    if (std::max(row.x0, pixels.x0) < std::min(row.x1, pixels.x1)) return true;
  }
  return false;
}

Footprint Footprint::grown(int reach) const {
  Footprint all(width_, height());
  for (int y = 0; y < height(); ++y) {
    const Span& row = rows_[static_cast<std::size_t>(y)];
    if (!row.empty()) all.add({row.x0 - reach, y - reach, row.x1 + reach, y + reach + 1});
  }
  return all;
}

Footprint::Span Footprint::ofRows(int y0, int y1) const {
  Span hull{0, 0};
  for (int y = y0; y < y1; ++y) hull.widen(rows_[static_cast<std::size_t>(y)]);
  return hull;
}

double Footprint::share(const Crop& area) const {
  double pixels = 0;
  for (int y = area.y0; y < area.y1; ++y) {
    const Span& row = rows_[static_cast<std::size_t>(y)];
    pixels += std::max(0, std::min(row.x1, area.x1) - std::max(row.x0, area.x0));
  }
  return pixels / (static_cast<double>(area.x1 - area.x0) * (area.y1 - area.y0));
}

std::vector<Crop> Footprint::parts(const Crop& area, const Costs& costs) const {
  std::vector<Crop> units;
  const int unit = (area.y1 - area.y0 + kUnits - 1) / kUnits;
  for (int y = area.y0; y < area.y1; y += unit) {
    const int end = std::min(y + unit, area.y1);
    const Span hull = ofRows(y, end);
    const int x0 = area.x0 + multipleBelow(std::max(hull.x0 - area.x0, 0));
    units.push_back({x0, y, std::min(hull.x1, area.x1), end});
  }
  // least[i]: of the first i units; from[i]: where the last rectangle of those begins.
  std::vector<double> least(units.size() + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> from(units.size() + 1);
  least[0] = 0;
  for (std::size_t i = 0; i < units.size(); ++i) {
    Span hull{0, 0};
    for (std::size_t j = i + 1; j-- > 0;) {
      hull.widen({units[j].x0, units[j].x1});
      const double width = hull.x1 - hull.x0;
      const double cost =
          hull.empty() ? 0.0 : width * (units[i].y1 - units[j].y0 + costs.column) + costs.each;
      if (least[j] + cost < least[i + 1]) {
        least[i + 1] = least[j] + cost;
        from[i + 1] = j;
      }
    }
  }
  std::vector<Crop> rectangles;
  for (std::size_t end = units.size(); end != 0; end = from[end]) {
    Span hull{0, 0};
    for (std::size_t j = from[end]; j < end; ++j) hull.widen({units[j].x0, units[j].x1});
    if (hull.empty()) continue;
    int y0 = units[from[end]].y0, y1 = units[end - 1].y1;
    while (ofRows(y0, y0 + 1).empty()) ++y0;
    while (ofRows(y1 - 1, y1).empty()) --y1;
    rectangles.push_back({hull.x0, y0, hull.x1, y1});
  }
  std::reverse(rectangles.begin(), rectangles.end());
  return rectangles;
}

Footprint footprintOf(const SceneData& data) { return Collector(data).run(); }

}  // namespace laver
