#pragma once
#include <fmt/format.h>

#include <glm/glm.hpp>
#include <string>

/// Numbers as Nori prints them.
namespace laver::dump {

/// Replaces negative zero by zero.
inline double plain(double x) { return x == 0.0 ? 0.0 : x; }

inline std::string triple(const glm::dvec3& v) {
  return fmt::format("[{:g}, {:g}, {:g}]", plain(v.x), plain(v.y), plain(v.z));
}

}  // namespace laver::dump
