#pragma once
#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace laver {

/// What a file can show beside the picture. Normals and Albedo are means over all samples by the
/// picture's own filter, 0 where nothing is hit. Depth, Uv, Position and Id would mean nothing as
/// such means across an edge: they are those of the one point that the ray through the pixel's
/// centre meets.
enum class Layer { Normals, Depth, Albedo, Uv, Position, Id, Samples };

/// "normals", "depth", ... in the order of the enumeration.
std::span<const char* const> layerNames();
std::optional<Layer> layerFromName(const std::string& name);

inline bool asks(std::span<const Layer> layers, Layer layer) {
  return std::find(layers.begin(), layers.end(), layer) != layers.end();
}

/// A picture that is reconstructed beside the scene's own, and its channels in the file.
struct Shown {
  IntegratorUse integrator;
  std::vector<std::string> channels;
};

/// What further integrators and layers ask to reconstruct.
std::vector<Shown> shownBeside(std::span<const IntegratorUse> more, std::span<const Layer> layers);

/// Channels of the layers that are taken at pixels' centres, in the order of `layers`.
std::vector<std::string> centreChannels(std::span<const Layer> layers);

/// The first hit of the ray through a pixel's centre.
struct CentreHit {
  double distance = 0.0;     ///< from the camera, scene units
  glm::dvec3 position{0.0};  ///< scene space
  glm::dvec2 uv{0.0};
  std::uint32_t mesh = 0, triangle = 0;  ///< numbers in the scene, in the mesh
};

/// Writes the centre layers' values of a pixel to `out`, one float a channel. Without a hit they
/// are 0, ids -1.
void writeCentre(std::span<const Layer> layers, const std::optional<CentreHit>& hit, float* out);

}  // namespace laver
