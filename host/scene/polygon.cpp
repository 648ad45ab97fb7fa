#include "scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>

namespace laver::obj {
namespace {

using glm::dvec2;
using glm::dvec3;

/// Twice the signed area of a triangle, positive if it winds counterclockwise, and a bound of its
/// rounding error (Shewchuk 1997, "Adaptive precision floating-point arithmetic", A).
struct SignedArea {
  double area, bound;
};

SignedArea turn(const dvec2& a, const dvec2& b, const dvec2& c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  return {left - right, 3.4e-16 * (std::abs(left) + std::abs(right))};
}

double areaOf(const dvec2& a, const dvec2& b, const dvec2& c) { return turn(a, b, c).area; }

/// Corners scaled by a power of two, so that no product overflows.
std::vector<dvec3> scaled(const std::vector<dvec3>& corners) {
  double largest = 0.0;
  for (const dvec3& p : corners)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  std::vector<dvec3> result;
  result.reserve(corners.size());
  for (const dvec3& p : corners)
    result.emplace_back(std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent),
                        std::ldexp(p.z, -exponent));
  return result;
}

/// The axis closest to the polygon's normal, and the sign of the normal along it. The normal is
/// Newell's, twice the area of the projections.
std::pair<int, double> facing(const std::vector<dvec3>& corners) {
  dvec3 normal(0.0);
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += glm::cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  dvec3 size = glm::abs(normal);
  // A figure eight may have no area: then the axis of its smallest extent.
  if (normal == dvec3(0.0)) {
    dvec3 low(2.0), high(-2.0);
    for (const dvec3& p : corners) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    size = low - high;
  }
  const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  return {axis, normal[axis]};
}

/// The polygon projected along an axis, winding counterclockwise. The projection of a simple or
/// convex polygon is simple or convex.
std::vector<dvec2> flattened(const std::vector<dvec3>& corners) {
  const std::vector<dvec3> points = scaled(corners);
  const auto [axis, sign] = facing(points);
  std::vector<dvec2> flat;
  flat.reserve(points.size());
  for (const dvec3& p : points) {
    const dvec2 q(p[(axis + 1) % 3], p[(axis + 2) % 3]);
    flat.push_back(sign < 0.0 ? dvec2(q.y, q.x) : q);
  }
  return flat;
}

/// Whether no corner turns clockwise and no triangle of the fan winds clockwise, as it would in a
/// star of {5/2}. Within the rounding error, a clockwise corner counts as straight.
bool isConvex(const std::vector<dvec2>& p) {
  const auto back = [](const SignedArea& t) { return !(t.area >= -t.bound); };
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
    if (back(turn(p[i], p[(i + 1) % n], p[(i + 2) % n])) ||
        (i + 1 < n && back(turn(p[0], p[i], p[i + 1]))))
      return false;
  return true;
}

/// Whether two edges cross in their interiors. Edges that touch do not.
bool crosses(const std::vector<dvec2>& p) {
  struct Edge {
    dvec2 a, b;
    double begin() const { return std::min(a.x, b.x); }
    double end() const { return std::max(a.x, b.x); }
    double low() const { return std::min(a.y, b.y); }
    double high() const { return std::max(a.y, b.y); }
  };
  std::vector<Edge> edges;
  edges.reserve(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) edges.push_back({p[i], p[(i + 1) % p.size()]});
  std::sort(edges.begin(), edges.end(),
            [](const Edge& e, const Edge& f) { return e.begin() < f.begin(); });
  const auto apart = [](double s, double t) {
    return (s < 0.0 && t > 0.0) || (s > 0.0 && t < 0.0);
  };
  for (auto e = edges.begin(); e != edges.end(); ++e)
    for (auto f = e + 1; f != edges.end() && f->begin() < e->end(); ++f)
      if (f->low() < e->high() && e->low() < f->high() &&
          apart(areaOf(e->a, e->b, f->a), areaOf(e->a, e->b, f->b)) &&
          apart(areaOf(f->a, f->b, e->a), areaOf(f->a, f->b, e->b)))
        return true;
  return false;
}

/// Clips ears off a ring of corners. After a clip only its neighbours can have become ears, since
/// the remaining polygon is a subset of the previous one.
class EarClipping {
 public:
  explicit EarClipping(const std::vector<dvec2>& p)
      : p_(p), previous_(p.size()), next_(p.size()), isReflex_(p.size()) {
    const auto n = static_cast<unsigned>(p.size());
    for (unsigned i = 0; i < n; ++i) {
      previous_[i] = (i + n - 1) % n;
      next_[i] = (i + 1) % n;
      untried_.push_back(i);
    }
    for (unsigned i = 0; i < n; ++i) {
      isReflex_[i] = !(areaAt(i) > 0.0);
      if (isReflex_[i]) reflexCorners_.push_back({p[i], i});
    }
    reflexCount_ = reflexCorners_.size();
    std::sort(reflexCorners_.begin(), reflexCorners_.end(),
              [](const ReflexCorner& a, const ReflexCorner& b) { return a.place.x < b.place.x; });
  }

  std::vector<glm::uvec3> run() {
    while (triangles_.size() + 3 < p_.size()) {
      if (untried_.empty()) {
        clip(lastResort());
        continue;
      }
      const unsigned corner = untried_.front();
      untried_.pop_front();
      if (isRemaining(corner) && isEar(corner)) clip(corner);
    }
    triangles_.emplace_back(previous_[remaining_], remaining_, next_[remaining_]);
    return std::move(triangles_);
  }

 private:
  struct ReflexCorner {
    dvec2 place;
    unsigned corner;
  };

  bool isRemaining(unsigned i) const { return next_[previous_[i]] == i; }
  double areaAt(unsigned i) const { return areaOf(p_[previous_[i]], p_[i], p_[next_[i]]); }

  bool isEar(unsigned i) const {
    const dvec2 &a = p_[previous_[i]], &b = p_[i], &c = p_[next_[i]];
    if (!(areaOf(a, b, c) > 0.0)) return false;
    const dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    auto reflex = std::lower_bound(reflexCorners_.begin(), reflexCorners_.end(), low.x,
                                   [](const ReflexCorner& d, double x) { return d.place.x < x; });
    for (; reflex != reflexCorners_.end() && reflex->place.x <= high.x; ++reflex) {
      const dvec2& q = reflex->place;
      if (q.y < low.y || q.y > high.y || !isReflex_[reflex->corner]) continue;
      if (q == a || q == b || q == c) continue;
      if (areaOf(a, b, q) >= 0.0 && areaOf(b, c, q) >= 0.0 && areaOf(c, a, q) >= 0.0) return false;
    }
    return true;
  }

  /// The corner to clip if there is no ear: a corner without area, or else, in a self-intersecting
  /// polygon, any.
  unsigned lastResort() const {
    for (const bool flat : {true, false})
      for (unsigned i = next_[remaining_]; i != remaining_; i = next_[i])
        if (const double area = areaAt(i); flat ? area == 0.0 : area > 0.0) return i;
    return remaining_;
  }

  void clip(unsigned i) {
    const unsigned a = previous_[i], c = next_[i];
    triangles_.emplace_back(a, i, c);
    remaining_ = a;
    next_[a] = c;
    previous_[c] = a;
    markConvex(i);
    for (const unsigned side : {a, c}) {
      if (areaAt(side) > 0.0) markConvex(side);
      untried_.push_back(side);
    }
  }

  void markConvex(unsigned corner) {
    if (!isReflex_[corner]) return;
    isReflex_[corner] = false;
    if (2 * --reflexCount_ > reflexCorners_.size()) return;
    std::erase_if(reflexCorners_,
                  [&](const ReflexCorner& reflex) { return !isReflex_[reflex.corner]; });
  }

  const std::vector<dvec2>& p_;
  std::vector<unsigned> previous_, next_;  // among the remaining corners
  // Reflex and straight corners: only these can lie inside an ear. At least half of
  // `reflexCorners_` are still in this state.
  std::vector<bool> isReflex_;
  std::vector<ReflexCorner> reflexCorners_;  // in order of x
  std::size_t reflexCount_ = 0;
  std::deque<unsigned> untried_;
  unsigned remaining_ = 0;  // any remaining corner
  std::vector<glm::uvec3> triangles_;
};

std::vector<glm::uvec3> fan(std::size_t corners) {
  std::vector<glm::uvec3> triangles;
  for (unsigned i = 2; i < corners; ++i) triangles.emplace_back(0U, i - 1, i);
  return triangles;
}

}  // namespace

Triangulation triangulate(const std::vector<dvec3>& corners) {
  const std::vector<dvec2> flat = flattened(corners);
  if (isConvex(flat)) return {fan(corners.size()), false};
  return {EarClipping(flat).run(), crosses(flat)};
}

}  // namespace laver::obj
