#include "render/resolve.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <tuple>

#include "core/parallel.h"
#include "scene/layers.h"

namespace laver {
namespace {

/// Looks up the scene's primitives by their numbers over all meshes.
class Triangles {
 public:
  Triangles(const Scene& scene, const Normalisation& space) : scene_(scene), space_(space) {
    std::uint32_t end = 0;
    for (const Mesh& mesh : scene.meshes)
      ends_.push_back(end += static_cast<std::uint32_t>(mesh.primitives()));
  }

  void number(std::uint32_t id, CentreHit& hit) const {
    const auto mesh = std::upper_bound(ends_.begin(), ends_.end(), id);
    hit.mesh = static_cast<std::uint32_t>(mesh - ends_.begin());
    hit.triangle = mesh == ends_.begin() ? id : id - *(mesh - 1);
  }

  /// Texture coordinates at a hit from the weights of the corners in the kernels' order, which is
  /// sorted by rounded positions. 0 if the mesh has none. A sphere's are the last two weights.
  glm::dvec2 uv(const CentreHit& hit, const glm::dvec3& weights) const {
    const Mesh& mesh = scene_.meshes[hit.mesh];
    if (mesh.sphere) return {weights.y, weights.z};
    if (mesh.uvs.empty()) return glm::dvec2(0.0);
    const glm::uvec3& t = mesh.triangles[hit.triangle];
    std::array<std::uint32_t, 3> sorted = {t.x, t.y, t.z};
    std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t i, std::uint32_t j) {
      const glm::vec3 p(space_.apply(mesh.positions[i])), q(space_.apply(mesh.positions[j]));
      return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    });
    return weights.x * mesh.uvs[sorted[0]] + weights.y * mesh.uvs[sorted[1]] +
           weights.z * mesh.uvs[sorted[2]];
  }

 private:
  const Scene& scene_;
  const Normalisation& space_;
  std::vector<std::uint32_t> ends_;
};

}  // namespace

void resolve(std::span<const std::byte> film, int firstRow, unsigned threads, Image& image) {
  const std::size_t first =
      static_cast<std::size_t>(firstRow) * static_cast<std::size_t>(image.width);
  constexpr std::size_t kSize = sizeof(shared::FilmPixel);
  parallelFor(film.size() / kSize, 1 << 15, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      shared::FilmPixel pixel;
      std::memcpy(&pixel, &film[i * kSize], kSize);
      const glm::dvec4 total = glm::dvec4(pixel.sum) + glm::dvec4(pixel.rest);
      const glm::vec3 rgb =
          total.w == 0.0 ? glm::vec3(0.0F) : glm::vec3(glm::dvec3(total) / total.w);
      std::memcpy(&image.pixels[(first + i) * 3], &rgb, sizeof rgb);
    }
  });
}

void resolveCentres(std::span<const std::byte> film, int firstRow, const Scene& scene,
                    const Normalisation& space, const RenderOptions& options, Image& image) {
  const Triangles triangles(scene, space);
  const std::size_t channels = image.channels.size();
  float* const out = &image.pixels[static_cast<std::size_t>(firstRow) *
                                   static_cast<std::size_t>(image.width) * channels];
  constexpr std::size_t kSize = sizeof(shared::FilmPixel);
  const auto one = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      shared::FilmPixel pixel;
      std::memcpy(&pixel, &film[i * kSize], kSize);
      std::optional<CentreHit> hit;
      if (pixel.sum.w > 0.0F) {
        hit.emplace();
        hit->distance = static_cast<double>(pixel.sum.w);
        hit->position = glm::dvec3(pixel.sum) / space.scale + space.centre;
        triangles.number(static_cast<std::uint32_t>(pixel.rest.z) |
                             static_cast<std::uint32_t>(pixel.rest.w) << 16,
                         *hit);
        const glm::dvec2 w(pixel.rest);
        hit->uv = triangles.uv(*hit, {1.0 - w.x - w.y, w.x, w.y});
      }
      writeCentre(options.layers, hit, out + i * channels);
    }
  };
  parallelFor(film.size() / kSize, 1 << 15, options.threads, one);
}

}  // namespace laver
