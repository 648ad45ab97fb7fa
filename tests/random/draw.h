#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <numbers>

namespace laver::test {

/// The random numbers of a seed: SplitMix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom
/// Number Generators", 2014).
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t x = state_ += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
  }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double a, double b) { return a + (b - a) * unit(); }
  /// Uniform in the logarithm.
  double scale(double a, double b) { return a * std::pow(b / a, unit()); }
  bool chance(double probability) { return unit() < probability; }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(bits() % n); }
  int integer(int a, int b) {
    return a + static_cast<int>(below(static_cast<std::size_t>(b - a + 1)));
  }
  /// In [-1, 1]^3.
  glm::dvec3 point() {
    const double x = between(-1.0, 1.0), y = between(-1.0, 1.0);
    return {x, y, between(-1.0, 1.0)};
  }
  glm::dvec3 color() { return 0.5 + 0.45 * point(); }
  glm::dvec3 direction() {
    const double z = between(-1.0, 1.0), phi = 2.0 * std::numbers::pi * unit();
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }

 private:
  std::uint64_t state_;
};

}  // namespace laver::test
