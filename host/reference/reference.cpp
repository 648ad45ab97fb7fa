#include "reference/reference.h"

#include <algorithm>

#include "core/error.h"
#include "core/parallel.h"
#include "reference/camera.h"
#include "reference/film.h"
#include "reference/integrators.h"
#include "reference/openness.h"
#include "reference/sampler.h"
#include "reference/world.h"

namespace laver {

struct Reference::Impl {
  Impl(const Scene& theScene, unsigned threads)
      : scene(theScene),
        world(theScene, threads),
        sources(theScene, world),
        view(theScene.camera, world.centre()) {}

  const Scene& scene;
  reference::World world;
  reference::LightSources sources;
  reference::View view;

  reference::Lit lit() const { return {scene, world, sources}; }
};

Reference::Reference(const Scene& scene, unsigned threads)
    : impl_(std::make_unique<Impl>(scene, threads)) {}
Reference::~Reference() = default;
Reference::Reference(Reference&&) noexcept = default;
Reference& Reference::operator=(Reference&&) noexcept = default;

glm::dvec3 Reference::radiance(glm::dvec2 film, const reference::Numbers& numbers) const {
  return reference::radiance(impl_->lit(), impl_->scene.integrator,
                             impl_->view.through(film, numbers), numbers);
}

std::optional<Reference::Hit> Reference::closest(glm::dvec2 film) const {
  const reference::CameraRay camera = impl_->view.through(film);
  const auto hit = impl_->world.closest(camera.ray, camera.tmin, camera.tmax);
  if (!hit) return {};
  Hit result{hit->id(),
             hit->t,
             0.0,
             0.0,
             hit->t * glm::length(camera.ray.direction),
             camera.ray.origin + hit->t * camera.ray.direction + impl_->world.centre()};
  if (hit->triangle) {
    const reference::Weights weights = hit->triangle->triangle->asGiven(hit->triangle->weights);
    result.u = weights[1];
    result.v = weights[2];
  }
  return result;
}

double Reference::blockerDistance(glm::dvec2 film) const {
  const reference::CameraRay camera = impl_->view.through(film);
  const auto hit = impl_->world.closest(camera.ray, camera.tmin, camera.tmax);
  if (!hit) return 0.0;
  const reference::Surface surface = impl_->world.surface(*hit);
  double farthest = 0.0;
  for (const PointLight& light : impl_->world.lights()) {
    const glm::dvec3 direction = light.position - surface.position;
    const glm::dvec3 from = reference::offsetOrigin(surface, direction);
    if (!impl_->world.blocked(from, light.position)) continue;
    const auto blocker = impl_->world.closest({from, light.position - from}, 0.0, 1.0);
    if (blocker) farthest = std::max(farthest, blocker->t * glm::length(light.position - from));
  }
  return farthest;
}

glm::vec2 Reference::samplePosition(int x, int y, std::uint32_t sample) const {
  return reference::samplePosition(impl_->scene.camera, impl_->scene.sampler, x, y, sample);
}

reference::Numbers Reference::sampleNumbers(int x, int y, std::uint32_t sample) const {
  return {impl_->scene.camera, impl_->scene.sampler, {x, y, sample}};
}

namespace {

void requireTwins(const Scene& scene, const IntegratorUse& integrator) {
  const auto refuse = [](const std::string& file) {
    throw Error(ExitCode::Scene,
                file + ": the reference renders laver's own integrators and BSDFs only");
  };
  if (integrator.user) refuse(integrator.user->file);
  if (!integrator.row->needs.materials) return;
  for (const Mesh& mesh : scene.meshes)
    if (mesh.bsdf.user) refuse(mesh.bsdf.user->file);
}

}  // namespace

Rendered Reference::render(const RenderOptions& options) const {
  requireTwins(impl_->scene, impl_->scene.integrator);
  Observers observers(options.observers);
  observers.started("reference");
  const std::vector<Shown> more = shownBeside(options.more, options.layers);
  for (const Shown& layer : more) requireTwins(impl_->scene, layer.integrator);
  const std::size_t count = 1 + more.size();
  std::optional<PixelVariances> variances;
  if (asks(options.layers, layers::variance))
    variances.emplace(stripsOf(impl_->scene, options),
                      reference::FilterWeights(impl_->scene.filter, options.noriCompat),
                      options.threads);
  Rendered all = picture(impl_->scene.integrator, options,
                         {0, count, variances ? &*variances : nullptr}, observers);
  const int width = all.image.width, height = all.image.height;
  std::vector<Image> parts;
  parts.push_back(std::move(all.image));
  for (std::size_t i = 0; i < more.size(); ++i) {
    Rendered one =
        picture(useOf(impl_->scene, more[i].integrator), options, {i + 1, count}, observers);
    one.image.channels = more[i].channels;
    if (!one.whole()) ++all.reached.unfinished;
    all.droppedSamples += one.droppedSamples;
    parts.push_back(std::move(one.image));
  }
  if (!centreChannels(options.layers).empty()) parts.push_back(centres(options));
  if (asks(options.layers, layers::samples)) {
    parts.push_back(blackImage(width, height, layers::samples.channels));
    const std::uint32_t wanted = impl_->scene.sampler.sampleCount;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        parts.back().at(x, y, 0) = static_cast<float>(all.reached.samplesIn(y, wanted));
  }
  if (variances) parts.push_back(variances->image());
  all.image = joined(std::move(parts));
  observers.finished(all.image);
  return all;
}

Rendered Reference::picture(const IntegratorUse& integrator, const RenderOptions& options,
                            Place place, Observers& observers) const {
  const auto radianceAt = [&](glm::dvec2 film, const reference::Numbers& numbers) {
    return reference::radiance(impl_->lit(), integrator, impl_->view.through(film, numbers),
                               numbers);
  };
  return reference::renderFilm(
      impl_->scene, options,
      {radianceAt, integrator.row->needs.negative, place.index, place.count, place.variances},
      observers);
}

std::optional<CentreHit> Reference::centre(glm::dvec2 film) const {
  const reference::CameraRay camera = impl_->view.through(film);
  const reference::World& world = impl_->world;
  const auto hit = world.closest(camera.ray, camera.tmin, camera.tmax);
  if (!hit) return {};
  const std::uint32_t id = hit->id();
  const std::size_t mesh = world.meshOf(id);
  const reference::Surface surface = world.surface(*hit);
  return CentreHit{hit->t * glm::length(camera.ray.direction), surface.position + world.centre(),
                   surface.uv, static_cast<std::uint32_t>(mesh),
                   id - static_cast<std::uint32_t>(world.firstOf(mesh))};
}

Image Reference::centres(const RenderOptions& options) const {
  const std::vector<Strip> strips = stripsOf(impl_->scene, options);
  const Crop first = strips.front().pixels;
  Image image = blackImage(first.x1 - first.x0, rowsOf(strips), centreChannels(options.layers));
  const std::size_t channels = image.channels.size();
  const auto width = static_cast<std::size_t>(image.width);
  parallelFor(image.pixels.size() / channels, 256, options.threads,
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                  const int row = static_cast<int>(i / width);
                  const Strip& strip = stripAt(strips, row);
                  const glm::dvec2 pixel(first.x0 + static_cast<int>(i % width),
                                         strip.pixels.y0 + row - strip.row);
                  writeCentre(options.layers, centre(pixel + 0.5), &image.pixels[i * channels]);
                }
              });
  return image;
}

}  // namespace laver
