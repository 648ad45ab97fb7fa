#include "render/resolve.h"

#include <cstring>
#include <glm/glm.hpp>

#include "core/parallel.h"
#include "shared/layout.h"

namespace laver {

void resolve(std::span<const std::byte> film, int firstRow, Image& image, unsigned threads) {
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

}  // namespace laver
