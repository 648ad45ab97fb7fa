#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "reference/camera.h"
#include "reference/light_sources.h"
#include "reference/sampler.h"
#include "reference/world.h"
#include "scene/scene.h"

namespace laver::reference {

/// A scene ready for rays.
struct Lit {
  const Scene& scene;
  const World& world;
  const LightSources& sources;
};

/// The input of an integrator, integrators/NAME.cpp: a camera ray and its hit.
struct CameraSample {
  const World& world;
  const LightSources& sources;
  const Scene& scene;
  const IntegratorUse& integrator;
  glm::dvec3 origin;
  glm::dvec3 direction;  ///< of the ray, of any length
  std::optional<WorldHit> hit;
  const Numbers& numbers;
};

/// Radiance that arrives along a camera ray.
glm::dvec3 radiance(const Lit& lit, const IntegratorUse& integrator, const CameraRay& camera,
                    const Numbers& numbers);

}  // namespace laver::reference
