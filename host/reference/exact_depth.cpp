#include "reference/exact_depth.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace laver::reference {

namespace {

/// Terms by size, the smallest first; none is 0.
class Expansion {
 public:
  Expansion() = default;
  explicit Expansion(double x) {
    if (x != 0.0) terms_.push_back(x);
  }

  int sign() const {
    if (terms_.empty()) return 0;
    return terms_.back() > 0.0 ? 1 : -1;
  }

  Expansion operator-() const {
    Expansion negated = *this;
    for (double& term : negated.terms_) term = -term;
    return negated;
  }

  Expansion& operator+=(const Expansion& other) {
    for (const double term : other.terms_) add(term);
    return *this;
  }

  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    Expansion product;
    for (const double x : a.terms_)
      for (const double y : b.terms_) {
        const double rounded = x * y;
        product.add(std::fma(x, y, -rounded));
        product.add(rounded);
      }
    return product;
  }

 private:
  /// Knuth's two-sum with each term in turn; the rests are exact.
  void add(double x) {
    std::size_t kept = 0;
    for (const double term : terms_) {
      const double sum = x + term, part = sum - x;
      const double rest = (x - (sum - part)) + (term - part);
      if (rest != 0.0) terms_[kept++] = rest;
      x = sum;
    }
    terms_.resize(kept);
    if (x != 0.0) terms_.push_back(x);
  }

  std::vector<double> terms_;
};

Expansion operator+(Expansion a, const Expansion& b) { return a += b; }
Expansion operator-(Expansion a, const Expansion& b) { return a += -b; }

using Vector = std::array<Expansion, 3>;

Vector vectorOf(const glm::dvec3& p) { return {Expansion(p.x), Expansion(p.y), Expansion(p.z)}; }

Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Expansion dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// t as a quotient.
struct Depth {
  Expansion above, below;
};

Depth depthOf(const ExactRay& ray, const Corners& corners) {
  const Vector a = vectorOf(corners[0]);
  const Vector normal = cross(vectorOf(corners[1]) - a, vectorOf(corners[2]) - a);
  const Vector away = a - vectorOf(ray.origin) - vectorOf(ray.start);
  return {dot(normal, away), dot(normal, vectorOf(ray.direction))};
}

}  // namespace

int compareDepths(const ExactRay& ray, const Corners& one, const Corners& other) {
  const Depth a = depthOf(ray, one), b = depthOf(ray, other);
  return (a.above * b.below - b.above * a.below).sign() * a.below.sign() * b.below.sign();
}

}  // namespace laver::reference
