#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "render/scene_data.h"

namespace laver {

/// One of the pictures that are made of a scene from one upload.
struct Rendering {
  std::string kernel;                 ///< shaders/<kernel>.comp
  std::vector<std::string> channels;  ///< in the file
  SpecConstants constants;
  bool centres = false;      ///< not samples, but the ray through each pixel's centre
  bool blackMisses = false;  ///< what meets nothing shows black
};

/// The scene's own picture first, then what the options ask for beside it. `generic` is as
/// generalise() takes it.
std::vector<Rendering> renderingsOf(const Scene& scene, const RenderOptions& options,
                                    std::uint32_t generic = 0);

/// Constants of the scene's data that serve the kernels of all.
SpecConstants constantsOfAll(std::span<const Rendering> pictures);

/// Fills a picture of the centre layers from `firstRow` on from what centres.comp has left in the
/// film.
void resolveCentres(std::span<const std::byte> film, int firstRow, const Scene& scene,
                    const Normalisation& space, const RenderOptions& options, Image& image);

}  // namespace laver
