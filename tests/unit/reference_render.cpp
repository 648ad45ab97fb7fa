#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "core/error.h"
#include "reference/filter.h"
#include "reference/reference.h"
#include "support/bumpy_sphere.h"
#include "unit/reference_scenes.h"

namespace laver::test {
namespace {

Scene bumpyScene(const FilterRow* kind, double radius, std::uint32_t samples) {
  Scene scene;
  scene.integrator = {&integrators::directWhitted};
  scene.meshes = {bumpySphere(12, 16, 0.1, glm::dvec3(0.0))};
  scene.lights = {{{3, 4, 5}, glm::dvec3(50, 40, 30)}};
  scene.camera = test::downCamera({0, 0, 4}, 40, 70);
  scene.filter.row = kind;
  scene.filter.radius = radius;
  scene.sampler = {samples, 3};
  return scene;
}

// A pixel by its definition: the weighted mean of all samples of the film.
glm::vec3 pixelByDefinition(const Scene& scene, const Reference& renderer, int x, int y,
                            bool noriCompat) {
  const reference::FilterWeights weights(scene.filter, noriCompat);
  glm::dvec3 sum(0);
  double total = 0;
  for (std::uint32_t s = 0; s < scene.sampler.sampleCount; ++s) {
    for (int v = 0; v < scene.camera.height; ++v) {
      for (int u = 0; u < scene.camera.width; ++u) {
        const glm::dvec2 film(renderer.samplePosition(u, v, s));
        const double weight = weights(film.x - x - 0.5) * weights(film.y - y - 0.5);
        if (weight == 0) continue;
        sum += weight * renderer.radiance(film);
        total += weight;
      }
    }
  }
  return total == 0 ? glm::vec3(0) : glm::vec3(sum / total);
}

void expectSamePixels(const Image& image, const Image& full, Crop crop) {
  ASSERT_EQ(image.width, crop.x1 - crop.x0);
  ASSERT_EQ(image.height, crop.y1 - crop.y0);
  for (int y = crop.y0; y < crop.y1; ++y) {
    for (int x = crop.x0; x < crop.x1; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_EQ(image.at(x - crop.x0, y - crop.y0, c), full.at(x, y, c)) << x << ' ' << y;
      }
    }
  }
}

struct FilterCase {
  const FilterRow* kind;
  double radius;
  bool noriCompat;
};

class ReferenceRender : public testing::TestWithParam<FilterCase> {
 protected:
  Scene scene(std::uint32_t samples) const {
    return bumpyScene(GetParam().kind, GetParam().radius, samples);
  }
  RenderOptions options() const {
    RenderOptions result;
    result.noriCompat = GetParam().noriCompat;
    return result;
  }
};

TEST_P(ReferenceRender, PixelsFollowTheDefinition) {
  const Scene scene = this->scene(2);
  const Reference renderer(scene);
  const Image image = renderer.render(options()).image;
  const glm::ivec2 pixels[] = {{0, 0}, {69, 69}, {31, 32}, {20, 40}, {17, 33}, {60, 30}};
  for (const glm::ivec2 p : pixels) {
    const glm::vec3 expected = pixelByDefinition(scene, renderer, p.x, p.y, GetParam().noriCompat);
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(image.at(p.x, p.y, static_cast<std::size_t>(c)), expected[c]) << p.x << ' ' << p.y;
    }
  }
}

TEST_P(ReferenceRender, CropEqualsFull) {
  const Scene scene = this->scene(3);
  const Reference renderer(scene);
  const Image full = renderer.render(options()).image;
  for (const Crop crop : {Crop{20, 25, 40, 44}, Crop{0, 0, 5, 70}, Crop{69, 69, 70, 70}}) {
    RenderOptions cropped = options();
    cropped.crop = crop;
    expectSamePixels(renderer.render(cropped).image, full, crop);
  }
}

TEST_P(ReferenceRender, ThreadsDoNotMatter) {
  const Scene scene = this->scene(2);
  RenderOptions one = options(), two = options();
  one.threads = 1;
  two.threads = 2;
  EXPECT_EQ(Reference(scene, 1).render(one).image.pixels,
            Reference(scene, 2).render(two).image.pixels);
}

TEST_P(ReferenceRender, FlatFieldIsExactlyOne) {
  Scene scene = this->scene(2);
  scene.integrator = {&integrators::normals};
  scene.meshes = {test::square(10, 0)};
  const Image image = Reference(scene).render(options()).image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      ASSERT_EQ(image.at(x, y, 2), 1.0f) << x << ' ' << y;
      ASSERT_EQ(image.at(x, y, 0), 0.0f) << x << ' ' << y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Filters, ReferenceRender,
                         testing::Values(FilterCase{&filters::gaussian, 2.0, false},
                                         FilterCase{&filters::gaussian, 2.0, true},
                                         FilterCase{&filters::mitchell, 2.0, false},
                                         FilterCase{&filters::tent, 1.0, false},
                                         FilterCase{&filters::box, 0.5, false},
                                         FilterCase{&filters::box, 0.5, true}));

TEST(ReferenceFilm, BandsDoNotShow) {
  // So wide that the film and the crop are traced in different bands.
  Scene scene = bumpyScene(&filters::gaussian, 2.0, 1);
  scene.integrator = {&integrators::normals};
  scene.camera.width = 16500;
  scene.camera.height = 37;
  scene.camera.fov = 175;
  const Reference renderer(scene);
  const Image full = renderer.render().image;
  const Crop crop{8000, 9, 8500, 24};
  RenderOptions options;
  options.crop = crop;
  const Image part = renderer.render(options).image;
  EXPECT_GT(*std::max_element(part.pixels.begin(), part.pixels.end()), 0.5f);
  expectSamePixels(part, full, crop);
}

TEST(ReferenceFilm, BatchesOfSamplesDoNotShow) {
  // More samples than one batch holds: 12 x 12 pixels and 4000 samples.
  Scene scene = bumpyScene(&filters::tent, 1.0, 4000);
  scene.camera.width = scene.camera.height = 12;
  const Reference renderer(scene);
  const Image image = renderer.render().image;
  const glm::vec3 expected = pixelByDefinition(scene, renderer, 4, 5, false);
  EXPECT_EQ(image.at(4, 5, 0), expected.x);
  EXPECT_EQ(image.at(4, 5, 2), expected.z);
}

TEST(ReferenceFilm, UnusableSamplesAreDroppedWithTheirWeight) {
  Scene scene = bumpyScene(&filters::gaussian, 2.0, 2);
  scene.meshes = {test::square(10, 0)};
  scene.meshes[0].bsdf.set("albedo", glm::dvec3(1));
  const Image clean = Reference(scene).render().image;
  for (const double bad :
       {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    // The second light reaches only the part right of its plane, which limits the bad samples to
    // it.
    Scene broken = scene;
    Mesh wall;
    wall.positions = {{0, -99, -1}, {0, 99, -1}, {0, 99, 99}, {0, -99, 99}};
    wall.triangles = {{0, 1, 2}, {2, 3, 0}};
    broken.meshes.push_back(wall);
    scene.meshes.resize(1);
    scene.meshes.push_back(wall);
    const Image expected = Reference(scene).render().image;
    broken.lights.push_back({{5, 0, 1}, glm::dvec3(0, bad * 1e9, 0)});
    const Reference renderer(broken);
    const auto [image, reached, dropped] = renderer.render();
    std::uint64_t count = 0;
    for (int y = 0; y < 70; ++y) {
      for (int x = 0; x < 70; ++x) {
        for (std::uint32_t s = 0; s < 2; ++s) {
          const glm::dvec3 value = renderer.radiance(renderer.samplePosition(x, y, s));
          count += !(value.y >= 0 && value.y < 1e300);
        }
      }
    }
    EXPECT_EQ(dropped, count) << bad;
    EXPECT_GT(dropped, 4000u);
    EXPECT_LT(dropped, 5600u);
    RenderOptions cropped;
    cropped.crop = Crop{0, 0, 40, 70};
    const std::uint64_t left = renderer.render(cropped).droppedSamples;
    cropped.crop = Crop{40, 0, 70, 70};
    const std::uint64_t right = renderer.render(cropped).droppedSamples;
    EXPECT_EQ(left + right, dropped);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(image.at(60, 35, c), 0.0f);
      EXPECT_EQ(image.at(10, 35, c), expected.at(10, 35, c));
      EXPECT_GE(image.at(35, 35, c), 0.0f);
    }
  }
  EXPECT_EQ(Reference(scene).render().droppedSamples, 0u);
}

TEST(ReferenceFilm, NoSamplesAreBlack) {
  const Scene scene = bumpyScene(&filters::gaussian, 2.0, 0);
  for (const float value : Reference(scene).render().image.pixels) ASSERT_EQ(value, 0.0f);
}

TEST(ReferenceFilm, EmptySceneIsBlack) {
  Scene scene = bumpyScene(&filters::gaussian, 2.0, 1);
  scene.meshes.clear();
  for (const float value : Reference(scene).render().image.pixels) ASSERT_EQ(value, 0.0f);
}

TEST(ReferenceFilm, RefusesCropsOutsideTheFilm) {
  const Scene scene = bumpyScene(&filters::box, 0.5, 1);
  const Reference renderer(scene);
  for (const Crop crop :
       {Crop{-1, 0, 5, 5}, Crop{0, 0, 71, 5}, Crop{5, 5, 5, 9}, Crop{0, 60, 9, 71}}) {
    RenderOptions options;
    options.crop = crop;
    try {
      renderer.render(options);
      ADD_FAILURE() << crop.x0;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::Usage);
    }
  }
}

TEST(ReferenceFilm, ProgressRisesToOne) {
  Scene scene = bumpyScene(&filters::box, 0.5, 1);
  scene.camera.width = 9000;
  scene.camera.height = 64;
  struct : Observer {
    std::vector<double> shares{0.0};
    void progress(double share, std::uint64_t /*samples*/) override { shares.push_back(share); }
  } seen;
  RenderOptions options;
  options.more = {{&integrators::depth}};
  options.observers = {&seen};
  Reference(scene).render(options);
  const std::vector<double>& shares = seen.shares;
  EXPECT_GT(shares.size(), 2u);
  for (std::size_t i = 1; i < shares.size(); ++i) EXPECT_GT(shares[i], shares[i - 1]);
  EXPECT_EQ(shares.back(), 1.0);
}

}  // namespace
}  // namespace laver::test
