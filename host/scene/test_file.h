#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace laver {

/// A file with the root <test>, as courses hand them out: hypotheses about BSDFs, about lights
/// without extent, or about the mean of scenes' pictures.
struct TestFile {
  enum class Kind {
    Student,    ///< `ttest`: means against reference values
    ChiSquared  ///< `chi2test`: sampled directions against the density
  };
  Kind kind = Kind::Student;
  double significanceLevel = 0.01;  ///< of all tests of the file together
  std::vector<double> references;   ///< luminances, one a test
  std::vector<double> angles;       ///< of incidence, degrees
  std::vector<double> distances;    ///< of points (0, 0, distance) from the origin, for lights
  std::uint32_t sampleCount = 0;    ///< of a test
  std::uint32_t resolution = 10;    ///< cells of cos(theta) in [-1, 1]; twice as many of phi
  std::uint32_t minExpFrequency = 5;
  std::uint32_t testCount = 5;  ///< directions of incidence for each BSDF
  std::vector<Bsdf> bsdfs;
  std::vector<PointLight> lights;
  std::vector<Scene> scenes;
  std::vector<std::string> warnings;
};

/// Whether a regular file has the root <test>; the rest of it need not be well-formed.
bool isTestFile(const std::string& file);

/// Reads a test file and the files of its scenes. Throws Error(Scene) as loadScene() does.
TestFile loadTestFile(const std::string& file, const SceneOverrides& overrides);

}  // namespace laver
