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

class PixelVariances;

/// Double-precision CPU renderer that checks the Vulkan renderer. The two share the scene structs
/// and nothing else.
class Reference {
 public:
  /// The nearest hit of a camera ray.
  struct Hit {
    std::uint32_t triangle;  ///< number in file order over all meshes, including spheres
    double t;                ///< of the camera ray, whose direction is toWorld times a unit vector
    double u, v;  ///< barycentric weights of the triangle's second and third corner; 0 on a sphere
    double distance;      ///< from the camera
    glm::dvec3 position;  ///< in the scene's own space
  };

  /// Builds the tree. The scene must outlive this object. Throws Error(Scene) for 2^31 triangles or
  /// more.
  explicit Reference(const Scene& scene, unsigned threads = 0);
  ~Reference();
  Reference(Reference&&) noexcept;
  Reference& operator=(Reference&&) noexcept;

  /// Radiance along the camera ray through `film`, in pixels from the top left. Integrators that
  /// sample directions use `numbers`.
  glm::dvec3 radiance(glm::dvec2 film, const reference::Numbers& numbers = glm::dvec2(0.5)) const;

  /// The nearest hit of that ray between the clipping planes. Of hits at the same t the triangle
  /// with the smallest number wins, whatever the order of its corners.
  std::optional<Hit> closest(glm::dvec2 film) const;

  /// Distance from the hit of the ray through `film` to the first blocker towards a light: the
  /// largest of all lights, 0 where none is blocked.
  double blockerDistance(glm::dvec2 film) const;

  /// The film position of a sample of a pixel, as the scene's sampler generates it.
  glm::vec2 samplePosition(int x, int y, std::uint32_t sample) const;
  /// The sample's other random numbers, for radiance().
  reference::Numbers sampleNumbers(int x, int y, std::uint32_t sample) const;

  /// The nearest hit of the ray through `film` for the layers of pixel centres. uv is 0 if the mesh
  /// has no texture coordinates.
  std::optional<CentreHit> centre(glm::dvec2 film) const;

  /// Renders, until an observer stops it; values are rounded to float only at the end. Throws
  /// Error(Usage) if the crop is empty or not inside the film, and Error(Scene) if the render needs
  /// a user's code, which the reference cannot run.
  Rendered render(const RenderOptions& options = {}) const;

 private:
  /// The index of a picture among those of the render.
  struct Place {
    std::size_t index, count;
    PixelVariances* variances = nullptr;
  };
  Rendered picture(const IntegratorUse& integrator, const RenderOptions& options, Place place,
                   Observers& observers) const;
  Image centres(const RenderOptions& options) const;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace laver
