#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene/bsdfs.h"

namespace laver::test {

/// A BSDF with values of its properties.
struct BsdfCase {
  std::string name;
  Bsdf bsdf;
};

/// Each BSDF of the table: with its defaults, but for colours; with further values where these
/// change what it does; and with a checker for each of its colours and numbers.
std::vector<BsdfCase> bsdfCases();

/// About the width in radians of the narrowest lobe; 1 where there is none.
double narrowestLobe(const Bsdf& bsdf);

/// A unit direction at an angle from +z.
glm::dvec3 directionAt(double theta, double phi);

/// The chi-squared statistic of directions against the density of a BSDF's twin, as a normal
/// deviate: above 4 by chance once in 30,000 times. Of `samples`, which were drawn for wi, those
/// of weight 0 are the zero vector; they count in no cell.
double deviateOf(const Bsdf& bsdf, glm::dvec2 uv, glm::dvec3 wi,
                 const std::vector<glm::dvec3>& samples);

/// For INSTANTIATE_TEST_SUITE_P.
inline std::string nameOf(const testing::TestParamInfo<BsdfCase>& instance) {
  return instance.param.name;
}
inline void PrintTo(const BsdfCase& one, std::ostream* out) { *out << one.name; }

}  // namespace laver::test
