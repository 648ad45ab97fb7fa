#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "image/image.h"
#include "reference/sampler.h"
#include "render/observer.h"
#include "render/options.h"
#include "render/rendered.h"
#include "scene/scene.h"

namespace laver {

/// Double-precision CPU renderer, the judge of the Vulkan one: it shares the scene structs with it
/// and nothing else.
class Reference {
 public:
  /// What a camera ray meets first.
  struct Hit {
    std::uint32_t triangle;  ///< number in file order over all meshes, spheres too
    double t;                ///< of the camera ray: toWorld times the unit camera direction
    double u, v;  ///< barycentric weights of the triangle's second and third corner; 0 on a sphere
    double distance;      ///< from the camera
    glm::dvec3 position;  ///< in the scene's own space
  };

  /// Builds its tree. The scene must outlive it. Throws Error(Scene) for 2^31 triangles or more.
  explicit Reference(const Scene& scene, unsigned threads = 0);
  ~Reference();
  Reference(Reference&&) noexcept;
  Reference& operator=(Reference&&) noexcept;

  /// Radiance along the camera ray through `film`, in pixels from the top left. `numbers`
  /// serve integrators that draw directions.
  glm::dvec3 radiance(glm::dvec2 film, const reference::Numbers& numbers = glm::dvec2(0.5)) const;

  /// The first hit of that ray between the clipping planes. Of hits at the same t the triangle
  /// of the smallest number wins, also where the copies list their corners differently.
  std::optional<Hit> closest(glm::dvec2 film) const;

  /// Film position of a sample of a pixel, as the scene's sampler draws it.
  glm::vec2 samplePosition(int x, int y, std::uint32_t sample) const;
  /// The sample's other numbers, for radiance().
  reference::Numbers sampleNumbers(int x, int y, std::uint32_t sample) const;

  /// The first hit of the ray through `film` as the centre layers show it. Without vertex
  /// coordinates uv is 0.
  std::optional<CentreHit> centre(glm::dvec2 film) const;

  /// Samples, reconstructs, and rounds to float at the very end, up to where an observer ends it.
  /// Throws Error(Usage) if the crop is empty or not inside the film, and Error(Scene) where code
  /// of the user's own is shown, which has no twin.
  Rendered render(const RenderOptions& options = {}) const;

 private:
  /// Which of a render's pictures.
  struct Place {
    std::size_t index, count;
  };
  Rendered picture(const IntegratorUse& shown, const RenderOptions& options, Place place,
                   Observers& observers) const;
  Image centres(const RenderOptions& options) const;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace laver
