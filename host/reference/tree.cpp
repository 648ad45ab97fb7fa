#include "reference/tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.h"

namespace laver::reference {

namespace {

// Ray against box, never a false miss. Let M bound the sum of |coordinate| of the ray's origin and
// of any corner, m the direction's largest component, and u = 2^-53 M. crossing() accepts a
// triangle only if the exact ray passes it within 6 u (ray.h) at some t*, and its t is off t* by
// less than 16 u / m. Here each box grows by 64 u, of which the roundings of the grown face, the
// difference, the reciprocal and the product use less than 8 u: on each axis the interval found
// holds t* with (64 - 8 - 6) u / m to spare on both sides, more than the 16 u / m.
class BoxTest {
 public:
  BoxTest(const Ray& ray, const Box& scene) {
    const glm::dvec3 reach =
        glm::abs(ray.origin) + glm::max(glm::abs(scene.lo), glm::abs(scene.hi));
    const double margin = 0x1p-47 * std::max({reach.x, reach.y, reach.z});
    lo_ = ray.origin + margin;
    hi_ = ray.origin - margin;
    const glm::dvec3 size = glm::abs(ray.direction);
    const double largest = std::max({size.x, size.y, size.z});
    for (int i = 0; i < 3; ++i) {
      // A component below 2^-200 of the largest does not move the ray inside the scene. With this
      // bound the reciprocal is finite, so that no product is NaN.
      const double smallest = std::max(0x1p-200 * largest, std::numeric_limits<double>::min());
      reciprocal_[i] = std::copysign(1.0 / std::max(size[i], smallest), ray.direction[i]);
    }
  }

  // The smallest t that a crossing inside the box can have; infinite if there is none from tmin on.
  double entry(const Box& box, double tmin) const {
    const glm::dvec3 a = (box.lo - lo_) * reciprocal_;
    const glm::dvec3 b = (box.hi - hi_) * reciprocal_;
    const glm::dvec3 in = glm::min(a, b), out = glm::max(a, b);
    const double near = std::max({in.x, in.y, in.z});
    const double far = std::min({out.x, out.y, out.z});
    if (near <= far && far >= tmin) return near;
    return std::numeric_limits<double>::infinity();
  }

 private:
  glm::dvec3 lo_, hi_, reciprocal_;
};

}  // namespace

// Relative difference of t below which the order of two crossings may not be that of double
// precision.
constexpr double kNearTie = 0x1p-24;

Tree::Tree(std::vector<Triangle> triangles, unsigned threads, Originals originals)
    : triangles_(std::move(triangles)), originals_(std::move(originals)) {
  if (triangles_.size() >= 1u << 31) {
    throw Error(ExitCode::Scene, "the reference renderer takes fewer than 2147483648 triangles");
  }
  nodes_ = buildTree(triangles_, threads);
}

// Calls visit(triangle, tmax) for every triangle whose box the ray hits, near boxes first, until it
// returns false. visit() may lower tmax.
template <typename Visit>
void Tree::walk(const Ray& ray, double tmin, double tmax, const Visit& visit) const {
  if (nodes_.empty()) return;
  struct Waiting {
    std::uint32_t node;
    double entry;
  };
  const BoxTest test(ray, nodes_[0].box);
  std::array<Waiting, maxDepth + 1> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {0, test.entry(nodes_[0].box, tmin)};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.entry > tmax) continue;
    const Node& node = nodes_[next.node];
    if (node.count > 0) {
      for (std::uint32_t i = node.next; i < node.next + node.count; ++i) {
        if (!visit(triangles_[i], tmax)) return;
      }
      continue;
    }
    Waiting near{next.node + 1, test.entry(nodes_[next.node + 1].box, tmin)};
    Waiting far{node.next, test.entry(nodes_[node.next].box, tmin)};
    if (far.entry < near.entry) std::swap(near, far);
    if (far.entry <= tmax) stack[waiting++] = far;
    if (near.entry <= tmax) stack[waiting++] = near;
  }
}

std::optional<TreeHit> Tree::closest(const Ray& ray, double tmin, double tmax) const {
  return nearest(ray, tmin, tmax, crossing);
}

std::optional<TreeHit> Tree::closestAhead(const Ray& ray) const {
  const auto hitAhead = [&](const Triangle& triangle, const Shear& shear) {
    std::optional<Crossing> found = crossing(triangle, shear);
    if (!found || !ahead(triangle, ray)) return std::optional<Crossing>();
    found->t = std::max(found->t, 0.0);
    return found;
  };
  return nearest(ray, 0.0, std::numeric_limits<double>::infinity(), hitAhead);
}

// crossing() is off sideways by less than 2^-47 of the magnitude of coordinates, and along the ray
// by that over the cosine. Where a cosine is below 2^-20 or not a number, the plane is seen edge-on
// and double precision decides: its exact depth may lie far outside of the triangle.
bool Tree::nearer(const Ray& ray, const TreeHit& one, const TreeHit& other) const {
  const bool sooner = one.t != other.t ? one.t < other.t : one.triangle->id < other.triangle->id;
  const double apart = std::abs(one.t - other.t);
  if (apart > kNearTie * std::max(std::abs(one.t), std::abs(other.t))) return sooner;
  double size = 0.0, cosine = 1.0;
  const glm::dvec3 direction = glm::normalize(ray.direction);
  for (const Triangle* triangle : {one.triangle, other.triangle}) {
    for (const glm::dvec3& p : triangle->corner) {
      const glm::dvec3 sum = glm::abs(p) + glm::abs(ray.origin);
      size = std::max({size, sum.x, sum.y, sum.z});
    }
    const glm::dvec3 normal = glm::normalize(glm::dvec3(triangle->normal()));
    const double c = std::abs(glm::dot(normal, direction));
    if (!(c >= 0x1p-20)) return sooner;
    cosine = std::min(cosine, c);
  }
  const double doubt = 0x1p-45 * size / (glm::length(ray.direction) * cosine);
  if (apart > doubt) return sooner;
  const auto corners = [&](const TreeHit& hit) {
    return originals_.corners ? originals_.corners(hit.triangle->id) : hit.triangle->corner;
  };
  const Corners a = corners(one), b = corners(other);
  const int order =
      a == b ? 0 : compareDepths({originals_.centre, ray.origin, ray.direction}, a, b);
  return order != 0 ? order < 0 : one.triangle->id < other.triangle->id;
}

template <typename Test>
std::optional<TreeHit> Tree::nearest(const Ray& ray, double tmin, double tmax,
                                     const Test& test) const {
  const Shear shear(ray);
  std::optional<TreeHit> best;
  walk(ray, tmin, tmax, [&](const Triangle& triangle, double& end) {
    const std::optional<Crossing> found = test(triangle, shear);
    if (!found || !(found->t >= tmin && found->t <= end)) return true;
    const TreeHit hit{&triangle, found->t, found->weights};
    if (best && !nearer(ray, hit, *best)) return true;
    best = hit;
    // Triangles that exact arithmetic may put before it must still be visited.
    end = std::min(tmax, found->t + kNearTie * std::abs(found->t));
    return true;
  });
  if (best) best->t = planeT(*best->triangle, ray, best->t);
  return best;
}

bool Tree::blocked(const glm::dvec3& from, const glm::dvec3& to) const {
  const Ray ray{from, to - from};
  if (ray.direction == glm::dvec3(0.0)) return false;
  const Shear shear(ray);
  bool found = false;
  walk(ray, 0.0, 1.0, [&](const Triangle& triangle, double&) {
    found = crossing(triangle, shear) && separates(triangle, from, to);
    return !found;
  });
  return found;
}

}  // namespace laver::reference
