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

/// The hit of the ray through a pixel's centre.
struct CentreHit {
  double distance = 0.0;     ///< from the camera, scene units
  glm::dvec3 position{0.0};  ///< scene space
  glm::dvec2 uv{0.0};
  std::uint32_t mesh = 0, triangle = 0;  ///< index in the scene, and in the mesh
};

/// An additional layer of the EXR file: the picture of an integrator, reconstructed by the same
/// filter; or properties of the hit of the ray through the pixel's centre, for which a mean across
/// an edge would be meaningless; or neither: the number of samples, or the variance.
struct LayerRow {
  const char* name;
  std::vector<const char*> spellings{};
  std::vector<std::string> channels{};  ///< in the file
  const IntegratorRow* integrator = nullptr;
  /// Writes one value per channel; `hit` is nullptr for a miss.
  void (*write)(const CentreHit* hit, float* out) = nullptr;
};

namespace layers {
extern const LayerRow normals, depth, albedo, uv, position, id, samples, variance;
}  // namespace layers

const Rows<LayerRow>& layerRows();

inline bool asks(const Rows<LayerRow>& layers, const LayerRow& layer) {
  return std::find(layers.begin(), layers.end(), &layer) != layers.end();
}

/// A layer that is the picture of an integrator, and its channels in the file.
struct Shown {
  IntegratorUse integrator;
  std::vector<std::string> channels;
};

/// The pictures for further integrators and layers.
std::vector<Shown> shownBeside(std::span<const IntegratorUse> more, const Rows<LayerRow>& layers);

/// Channels of the layers of pixel centres, in the order of `layers`.
std::vector<std::string> centreChannels(const Rows<LayerRow>& layers);

/// Writes a pixel's values of these layers to `out`, one float per channel: 0 for a miss, ids -1.
void writeCentre(const Rows<LayerRow>& layers, const std::optional<CentreHit>& hit, float* out);

}  // namespace laver
