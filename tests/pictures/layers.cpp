// Layers: their contents, and that they do not change the main picture.
#include <fmt/format.h>

#include <set>

#include "image/io.h"
#include "pictures/command_line.h"
#include "pictures/explain.h"
#include "pictures/harness.h"
#include "render/choices.h"
#include "support/bumpy_sphere.h"

namespace laver::test {
namespace {

/// The given channels of a picture.
Image channelsOf(const Image& image, const std::vector<std::string>& names) {
  Image part = blackImage(image.width, image.height, names);
  for (std::size_t c = 0; c < names.size(); ++c) {
    const auto found = std::find(image.channels.begin(), image.channels.end(), names[c]);
    if (found == image.channels.end()) {
      ADD_FAILURE() << "no channel " << names[c];
      continue;
    }
    const auto from = static_cast<std::size_t>(found - image.channels.begin());
    for (std::size_t i = 0; i < part.pixels.size() / names.size(); ++i)
      part.pixels[i * names.size() + c] = image.pixels[i * image.channels.size() + from];
  }
  return part;
}

/// Pixels that differ by more than `tolerance` * max(1, value).
struct Differing {
  int explained = 0, unexplained = 0;
  std::string first;  ///< the first unexplained one
};

template <class Explains>
Differing differing(const Image& image, const Image& truth, double tolerance,
                    const Explains& explains) {
  Differing result;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < image.channels.size(); ++c) {
        const auto p = static_cast<double>(image.at(x, y, c));
        const auto q = static_cast<double>(truth.at(x, y, c));
        if (std::abs(p - q) <= tolerance * std::max(1.0, std::abs(q))) continue;
        if (explains(x, y)) {
          ++result.explained;
        } else if (result.unexplained++ == 0) {
          result.first = fmt::format("{} at {}, {}: {} and {}", image.channels[c], x, y, p, q);
        }
        break;
      }
  return result;
}

bool tooMany(const Differing& found, const Image& image) {
  return found.explained > kMaxExplained * image.width * image.height;
}

void expectFew(const Differing& found, const Image& image) {
  EXPECT_EQ(found.unexplained, 0) << found.first;
  EXPECT_FALSE(tooMany(found, image)) << found.explained;
}

const std::vector<std::string> kMeans = {"N.X", "N.Y", "N.Z", "Albedo.R", "Albedo.G", "Albedo.B"};
const std::vector<std::string> kPoints = {"Z", "P.X",         "P.Y",        "P.Z",
                                          "u", "shape_index", "prim_index", "v"};

void expectLayersOfTheReference(const Scene& scene) {
  const RenderOptions options = allLayers();
  const Image image = render(scene, onTestDevice(), options);
  const Reference reference(scene);
  const Image truth = reference.render(options).image;
  const Judge judge(scene, reference);
  ASSERT_EQ(image.channels, truth.channels);
  ASSERT_EQ(image.pixels.size(), truth.pixels.size());
  // kTolerance of scenes.cpp. Rounding changes the facet of a sample only at an edge.
  expectFew(differing(channelsOf(image, kMeans), channelsOf(truth, kMeans), 1e-4,
                      [&](int x, int y) { return judge.pixelSeesOtherHit(x, y); }),
            image);
  expectFew(differing(channelsOf(image, kPoints), channelsOf(truth, kPoints), 1e-4,
                      [&](int x, int y) { return judge.otherHit(glm::dvec2(x, y) + 0.5); }),
            image);
  for (const float samples : channelsOf(image, {"samples"}).pixels)
    ASSERT_EQ(samples, static_cast<float>(scene.sampler.sampleCount));
}

TEST(Layers, EqualTheReference) {
  for (const char* name : {"cornell-two-lights.xml", "mirrored-instances.xml", "curved-normals.xml",
                           "clipped.xml", "bunny-normals.xml", "spheres.xml"}) {
    SCOPED_TRACE(name);
    expectLayersOfTheReference(smallScene(name, 96, 3));
  }
}

TEST(Layers, AnErrorAtEveryEdgeIsFound) {
  // An error at every edge, where each difference by itself is explained: their number shows it.
  const Scene scene = smallScene("cornell-two-lights.xml", 96, 1);
  const Reference reference(scene);
  const Image truth = channelsOf(reference.render(allLayers()).image, kPoints);
  const auto idAt = [&](glm::dvec2 film) {
    const auto hit = reference.closest(film);
    return hit ? std::optional(hit->triangle) : std::nullopt;
  };
  const auto atEdge = [&](int x, int y) {
    return idAt({x, y}) != idAt({x + 1, y + 1}) || idAt({x + 1, y}) != idAt({x, y + 1});
  };
  Image wrong = truth;
  for (int y = 0; y < wrong.height; ++y)
    for (int x = 0; x < wrong.width; ++x)
      if (atEdge(x, y)) wrong.at(x, y, 0) += 1.0F;
  const Differing found = differing(wrong, truth, 1e-4, atEdge);
  EXPECT_EQ(found.unexplained, 0);
  EXPECT_TRUE(tooMany(found, wrong)) << found.explained;
  EXPECT_GT(differing(wrong, truth, 1e-4,
                      [&, judge = Judge(scene, reference)](int x, int y) {
                        return judge.otherHit(glm::dvec2(x, y) + 0.5);
                      })
                .unexplained,
            0);
}

TEST(Layers, HoldTheVerticesTextureCoordinates) {
  // u and v of a point of the triangle are its x and y; the copies list their corners in other
  // orders.
  for (const glm::uvec3 order : {glm::uvec3(0, 1, 2), glm::uvec3(2, 0, 1), glm::uvec3(1, 0, 2)}) {
    Scene scene;
    scene.camera.width = scene.camera.height = 32;
    Mesh mesh;
    mesh.positions = {{-1.0, -1.0, 3.0}, {1.0, -1.0, 4.0}, {0.0, 1.0, 5.0}};
    for (const glm::dvec3& p : mesh.positions) mesh.uvs.emplace_back(p);
    mesh.triangles = {order};
    scene.meshes = {mesh};
    const Image image = render(scene, onTestDevice(), allLayers());
    const Image uv = channelsOf(image, {"u", "v"}), xy = channelsOf(image, {"P.X", "P.Y"});
    EXPECT_GT(uv.at(16, 16, 1) * uv.at(16, 16, 1), 0.0F);
    for (std::size_t i = 0; i < uv.pixels.size(); ++i)
      ASSERT_NEAR(uv.pixels[i], xy.pixels[i], 1e-6F);
    expectLayersOfTheReference(scene);
    scene.meshes[0].uvs.clear();
    for (const float v : channelsOf(render(scene, onTestDevice(), allLayers()), {"u", "v"}).pixels)
      ASSERT_EQ(v, 0.0F);
  }
}

TEST(Layers, HoldTheSignsOfNormals) {
  const Scene scene = smallScene("curved-normals.xml", 64, 2);
  const Image normals =
      channelsOf(render(scene, onTestDevice(), allLayers()), {"N.X", "N.Y", "N.Z"});
  const auto [low, high] = std::minmax_element(normals.pixels.begin(), normals.pixels.end());
  EXPECT_LT(*low, -0.5F);
  EXPECT_GT(*high, 0.5F);
}

TEST(Layers, HoldPositionsInSceneSpaceAndTrianglesOfTheirMesh) {
  // Two large spheres far from the origin; the second is seen through the film's centre.
  Scene scene;
  scene.camera.width = scene.camera.height = 33;
  scene.camera.toWorld = glm::dmat4(1.0);
  scene.camera.toWorld[3] = glm::dvec4(5000.0, 100.0, -10.0, 1.0);
  scene.meshes = {bumpySphere(8, 8, 0.0, glm::dvec3(5050.0, 100.0, 0.0)),
                  bumpySphere(40, 40, 0.0, glm::dvec3(5000.0, 100.0, 0.0))};
  const Image image = render(scene, onTestDevice(), allLayers());
  const Image at = channelsOf(image, {"Z", "P.X", "P.Y", "P.Z", "shape_index", "prim_index"});
  EXPECT_NEAR(at.at(16, 16, 0), 9.0F, 0.01F);
  EXPECT_NEAR(at.at(16, 16, 1), 5000.0F, 0.01F);
  EXPECT_NEAR(at.at(16, 16, 2), 100.0F, 0.01F);
  EXPECT_NEAR(at.at(16, 16, 3), -1.0F, 0.01F);
  EXPECT_EQ(at.at(16, 16, 4), 1.0F);
  EXPECT_LT(at.at(16, 16, 5), static_cast<float>(scene.meshes[1].triangles.size()));
  const auto hit = Reference(scene).closest(glm::dvec2(16.5));
  ASSERT_TRUE(hit);
  EXPECT_EQ(at.at(16, 16, 5), static_cast<float>(hit->triangle - scene.meshes[0].triangles.size()));
  // The film's corner sees nothing.
  for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(at.at(0, 0, c), 0.0F);
  for (std::size_t c = 4; c < 6; ++c) EXPECT_EQ(at.at(0, 0, c), -1.0F);
}

TEST(Layers, OfAnEmptySceneAreEmpty) {
  Scene scene;
  scene.camera.width = 40;
  scene.camera.height = 30;
  const Image image = render(scene, onTestDevice(), allLayers());
  EXPECT_EQ(channelsOf(image, {"N.X", "Albedo.R", "Z", "P.X"}).pixels,
            std::vector<float>(std::size_t{40} * 30 * 4, 0.0F));
  EXPECT_EQ(channelsOf(image, {"prim_index"}).pixels,
            std::vector<float>(std::size_t{40} * 30, -1.0F));
}

TEST(Layers, DoNotChangeThePicturesBits) {
  Scene scene = smallScene("mirrored-instances.xml", 96, 5);
  RenderOptions options = allLayers();
  options.more = {{&integrators::depth}, {&integrators::normals}};
  scene.integrator = {&integrators::directWhitted};
  scene.lights.resize(9, scene.lights.at(0));  // more than a dispatch takes
  const Image image = render(scene, onTestDevice(), options);
  EXPECT_EQ(differingFloats(channelsOf(image, {"R", "G", "B"}), render(scene)), 0U);
  scene.integrator = {&integrators::depth};
  EXPECT_EQ(differingFloats(channelsOf(image, {"depth.R", "depth.G", "depth.B"}), render(scene)),
            0U);
  scene.integrator = {&integrators::normals};
  EXPECT_EQ(
      differingFloats(channelsOf(image, {"normals.R", "normals.G", "normals.B"}), render(scene)),
      0U);
}

TEST(Layers, HaveTheSameBitsForAnyTiling) {
  const Scene scene = smallScene("mirrored-instances.xml", 131, 5);
  const RenderOptions options = allLayers();
  const Image whole = render(scene, onTestDevice(), options);
  VulkanOptions pieces = onTestDevice(), generic = onTestDevice();
  pieces.samplesInFlight = std::uint64_t{131} * 7 * 5;
  generic.general = generalParts();
  for (const std::string& traversal : traversals())
    EXPECT_EQ(differingFloats(whole, render(scene, onTestDevice(traversal), options)), 0U)
        << traversal;
  EXPECT_EQ(differingFloats(whole, render(scene, pieces, options)), 0U);
  EXPECT_EQ(differingFloats(whole, render(scene, generic, options)), 0U);
  RenderOptions cropped = options;
  const Crop crop{30, 9, 77, 50};
  cropped.crop = crop;
  const Image part = render(scene, onTestDevice(), cropped);
  Image wanted = blackImage(crop.x1 - crop.x0, crop.y1 - crop.y0, whole.channels);
  for (int y = crop.y0; y < crop.y1; ++y)
    for (int x = crop.x0; x < crop.x1; ++x)
      for (std::size_t c = 0; c < whole.channels.size(); ++c)
        wanted.at(x - crop.x0, y - crop.y0, c) = whole.at(x, y, c);
  EXPECT_EQ(differingFloats(part, wanted), 0U);
}

TEST(Layers, UnfinishedOnesAreCountedInAStoppedRender) {
  const Scene scene = smallScene("cornell-two-lights.xml", 64, 8);
  VulkanOptions vulkan = onTestDevice();
  vulkan.samplesInFlight = 5120;  // several passes
  Stats all;
  Renderer(vulkan).render(scene, {}, all);
  const int picture = static_cast<int>(all.passes);
  ASSERT_GT(picture, 2);
  for (const int passes : {picture - 1, picture, picture + 1}) {
    RenderOptions options = allLayers();
    StopAfter stop(passes);
    options.observers = {&stop};
    Stats stats;
    const auto [image, reached, dropped] = Renderer(vulkan).render(scene, options, stats);
    EXPECT_EQ(reached.wholeRows == 64, passes >= picture);
    EXPECT_EQ(reached.unfinished, 3);  // normals, albedo, and the layers of pixel centres
    const Image samples = channelsOf(image, {"samples"});
    EXPECT_EQ(samples.at(0, 0, 0), 8.0F);
    EXPECT_EQ(samples.at(0, 63, 0) == 8.0F, passes >= picture);
    const Image normals = channelsOf(image, {"N.X", "N.Y", "N.Z"});
    EXPECT_EQ(std::all_of(normals.pixels.begin(), normals.pixels.end(),
                          [](float v) { return v == 0.0F; }),
              passes <= picture);
  }
}

const char* const kVelvet =
    "<scene><integrator type=\"normals\"/><camera type=\"perspective\"/>"
    "<mesh type=\"obj\"><string name=\"filename\" value=\"a.obj\"/>\n"
    "<bsdf type=\"velvet\"/></mesh></scene>";
const char* const kTriangle = "v -1 -1 3\nv 1 -1 3\nv 0 1 3\nf 1 2 3\n";

TEST_F(CommandLine, LayersAreChannelsOfTheFile) {
  write("a.obj", kTriangle);
  write("a.xml", kVelvet);
  for (const char* how : {"--device $device", "--reference"}) {
    const Outcome run = laver(std::string("a.xml -q --size 32x24 --layers normals,depth,id ") +
                              "--integrator normals,depth " + how);
    EXPECT_EQ(run.code, 0) << run.err;
    const Image image = readExr(path("a.exr"));
    const std::set<std::string> names(image.channels.begin(), image.channels.end());
    EXPECT_EQ(names, (std::set<std::string>{"R", "G", "B", "depth.R", "depth.G", "depth.B", "N.X",
                                            "N.Y", "N.Z", "Z", "shape_index", "prim_index"}));
    const Image at = channelsOf(image, {"R", "G", "B", "N.Z", "depth.R", "Z", "shape_index"});
    EXPECT_NEAR(at.at(16, 12, 2), 1.0F, 1e-6F);
    EXPECT_NEAR(at.at(16, 12, 3), 1.0F, 1e-6F);  // by the winding, away from the camera
    EXPECT_NEAR(at.at(16, 12, 4), 1.0F / 3.0F, 1e-3F);
    EXPECT_NEAR(at.at(16, 12, 5), 3.0F, 1e-2F);
    EXPECT_EQ(at.at(16, 12, 6), 0.0F);
  }
}

TEST_F(CommandLine, TheAlbedoLayerNeedsMaterials) {
  write("a.obj", kTriangle);
  write("a.xml", kVelvet);
  const Outcome run = laver("a.xml --device $device --layers albedo");
  EXPECT_EQ(run.code, 3);
  EXPECT_NE(run.err.find("a.xml:2:2: error: laver has no bsdf of type \"velvet\""),
            std::string::npos)
      << run.err;
  EXPECT_EQ(laver("a.xml --device $device -q --size 8x8 --integrator depth,direct_whitted").code,
            3);
  const Outcome uv = laver("a.xml --device $device -q --size 8x8 --layers uv");
  EXPECT_EQ(uv.code, 0);
  EXPECT_NE(uv.err.find("laver: warning: \"a.obj\" has no texture coordinates"), std::string::npos)
      << uv.err;
}

TEST_F(CommandLine, UnknownLayersAreRefused) {
  write("a.xml", kFirstScene);
  for (const char* option :
       {"--layers foo", "--layers id,id", "--layers id,", "--integrator albedo",
        "--integrator depth,depth", "--integrator shading_normal"}) {
    const Outcome run = laver(std::string("a.xml ") + option);
    EXPECT_EQ(run.code, 2) << option;
    EXPECT_EQ(lines(run.err), 1) << run.err;
  }
}

}  // namespace
}  // namespace laver::test
