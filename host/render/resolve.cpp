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
  explicit Triangles(const PackedScene& shown)
      : scene_(shown.scene), splits_(shown.packed.splits), space_(shown.packed.space) {
    std::uint32_t end = 0;
    for (std::size_t i = 0; i < scene_.meshes.size(); ++i)
      ends_.push_back(end += static_cast<std::uint32_t>(meshAt(i).primitives()));
  }

  /// Fills in mesh, triangle and uv of the primitive that has the number `id` on the device. uv by
  /// the weights of the corners as the kernels have them: sorted by their rounded positions. 0
  /// where the mesh has none. A sphere's are the last two weights.
  void identify(std::uint32_t id, const glm::dvec3& weights, CentreHit& hit) const {
    const auto end = std::upper_bound(ends_.begin(), ends_.end(), id);
    hit.mesh = static_cast<std::uint32_t>(end - ends_.begin());
    const std::uint32_t number = end == ends_.begin() ? id : id - *(end - 1);
    hit.uv = uv(meshAt(hit.mesh), number, weights);
    hit.triangle = hit.mesh < splits_.size() && splits_[hit.mesh]
                       ? splits_[hit.mesh]->pieces[number].triangle
                       : number;
  }

 private:
  const Mesh& meshAt(std::size_t i) const {
    return i < splits_.size() && splits_[i] ? splits_[i]->mesh : scene_.meshes[i];
  }

  glm::dvec2 uv(const Mesh& mesh, std::uint32_t number, const glm::dvec3& weights) const {
    if (mesh.sphere) return {weights.y, weights.z};
    if (mesh.uvs.empty()) return glm::dvec2(0.0);
    const glm::uvec3& t = mesh.triangles[number];
    std::array<std::uint32_t, 3> sorted = {t.x, t.y, t.z};
    std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t i, std::uint32_t j) {
      const glm::vec3 p(space_.apply(mesh.positions[i])), q(space_.apply(mesh.positions[j]));
      return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
    });
    return weights.x * mesh.uvs[sorted[0]] + weights.y * mesh.uvs[sorted[1]] +
           weights.z * mesh.uvs[sorted[2]];
  }

  const Scene& scene_;
  const std::vector<std::optional<SplitMesh>>& splits_;
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

void resolveCentres(std::span<const std::byte> film, int firstRow, const PackedScene& shown,
                    const RenderOptions& options, Image& image) {
  const Triangles triangles(shown);
  const Normalisation& space = shown.packed.space;
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
        const glm::dvec2 w(pixel.rest);
        triangles.identify(static_cast<std::uint32_t>(pixel.rest.z) |
                               static_cast<std::uint32_t>(pixel.rest.w) << 16,
                           {1.0 - w.x - w.y, w.x, w.y}, *hit);
      }
      writeCentre(options.layers, hit, out + i * channels);
    }
  };
  parallelFor(film.size() / kSize, 1 << 15, options.threads, one);
}

}  // namespace laver
