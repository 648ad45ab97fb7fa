#include "reference/reference.h"

#include "reference/camera.h"
#include "reference/film.h"
#include "reference/sampler.h"
#include "reference/world.h"

namespace laver {

struct Reference::Impl {
  Impl(const Scene& theScene, unsigned threads)
      : scene(theScene), world(theScene, threads), view(theScene.camera, world.centre()) {}

  const Scene& scene;
  reference::World world;
  reference::View view;
};

Reference::Reference(const Scene& scene, unsigned threads)
    : impl_(std::make_unique<Impl>(scene, threads)) {}
Reference::~Reference() = default;
Reference::Reference(Reference&&) noexcept = default;
Reference& Reference::operator=(Reference&&) noexcept = default;

glm::dvec3 Reference::radiance(glm::dvec2 film, glm::dvec2 numbers) const {
  return reference::radiance(impl_->world, impl_->scene, impl_->view.through(film), numbers);
}

std::optional<Reference::Hit> Reference::closest(glm::dvec2 film) const {
  const reference::CameraRay camera = impl_->view.through(film);
  const auto hit = impl_->world.tree().closest(camera.ray, camera.tmin, camera.tmax);
  if (!hit) return {};
  const reference::Weights weights = hit->triangle->asGiven(hit->weights);
  return Hit{hit->triangle->id, hit->t, weights[1], weights[2]};
}

bool Reference::decided(glm::dvec2 film, double delta, double tolerance, glm::dvec2 numbers) const {
  const glm::dvec3 centre = radiance(film, numbers);
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      if (x == 0 && y == 0) continue;
      const glm::dvec3 away = glm::abs(radiance(film + delta * glm::dvec2(x, y), numbers) - centre);
      if (!(away.x <= tolerance && away.y <= tolerance && away.z <= tolerance)) return false;
    }
  }
  return true;
}

glm::vec2 Reference::samplePosition(int x, int y, std::uint32_t sample) const {
  return reference::samplePosition(impl_->scene.camera, impl_->scene.sampler, x, y, sample);
}

glm::vec2 Reference::sampleNumbers(int x, int y, std::uint32_t sample) const {
  return reference::sampleAperture(impl_->scene.camera, impl_->scene.sampler, x, y, sample);
}

Image Reference::render(const RenderOptions& options) const {
  std::uint64_t dropped = 0;
  Reached reached;
  return render(options, dropped, reached);
}

Image Reference::render(const RenderOptions& options, std::uint64_t& dropped,
                        Reached& reached) const {
  return reference::renderFilm(
      impl_->scene, options,
      [this](glm::dvec2 film, glm::dvec2 numbers) { return radiance(film, numbers); }, dropped,
      reached);
}

}  // namespace laver
