#pragma once
#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/integrators.h"
#include "scene/rows.h"

namespace laver {

/// The first hit of the ray through a pixel's centre.
struct CentreHit {
  double distance = 0.0;     ///< from the camera, scene units
  glm::dvec3 position{0.0};  ///< scene space
  glm::dvec2 uv{0.0};
  std::uint32_t mesh = 0, triangle = 0;  ///< numbers in the scene, in the mesh
};

/// What a file can show beside the picture: the picture of an integrator, reconstructed by the
/// picture's own filter; or, where a mean across an edge would mean nothing, the point that the ray
/// through the pixel's centre hits; or neither, the number of samples.
struct LayerRow {
  const char* name;
  std::vector<const char*> spellings{};
  std::vector<std::string> channels{};  ///< in the file
  const IntegratorRow* integrator = nullptr;
  /// Writes a value for each channel; `hit` is nullptr where nothing is hit.
  void (*write)(const CentreHit* hit, float* out) = nullptr;
};

namespace layers {
extern const LayerRow normals, depth, albedo, uv, position, id, samples;
}  // namespace layers

const Rows<LayerRow>& layerRows();

inline bool asks(const Rows<LayerRow>& layers, const LayerRow& layer) {
  return std::find(layers.begin(), layers.end(), &layer) != layers.end();
}

/// A picture that is reconstructed beside the scene's own, and its channels in the file.
struct Shown {
  IntegratorUse integrator;
  std::vector<std::string> channels;
};

/// What further integrators and layers ask to reconstruct.
std::vector<Shown> shownBeside(std::span<const IntegratorUse> more, const Rows<LayerRow>& layers);

/// Channels of the layers that are taken at pixels' centres, in the order of `layers`.
std::vector<std::string> centreChannels(const Rows<LayerRow>& layers);

/// Writes the centre layers' values of a pixel to `out`, one float per channel. Without a hit they
/// are 0, ids -1.
void writeCentre(const Rows<LayerRow>& layers, const std::optional<CentreHit>& hit, float* out);

}  // namespace laver
