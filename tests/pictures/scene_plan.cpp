// `laver plan` agrees with the render.
#include "render/scene_plan.h"

#include <nlohmann/json.hpp>

#include "pictures/command_line.h"
#include "pictures/harness.h"
#include "render/packed.h"

namespace laver::test {
namespace {

const Reason& line(const ScenePlan& plan, const std::string& what) {
  for (const Reason& candidate : plan.reasons)
    if (candidate.what == what) return candidate;
  throw std::out_of_range(what);
}

/// Bytes that a scene's upload grows by if this part is made general.
std::uint64_t bytesSaved(const Scene& scene, const std::string& part) {
  const Choices needed = choicesOf(scene);
  Uploads general = generalised(needed, {part}).uploads;
  general.indexBytes = part == "normals" ? indexBytesOf(scene, true) : general.indexBytes;
  return bytesOf(pack(scene, {}, general)) - bytesOf(pack(scene, {}, needed.uploads));
}

TEST(ScenePlan, SavedBytesAreTheDifferenceToAGeneralRender) {
  for (const char* name : {"bunny-depth.xml", "bunny-whitted.xml", "cornell-two-lights.xml",
                           "curved-normals.xml", "mirrored-instances.xml"}) {
    const Scene scene = smallScene(name, 16, 1);
    const ScenePlan plan = planScene(scene, {}, {}, testDeviceInfo());
    const auto expect = [&](const char* what, const char* part) {
      EXPECT_EQ(line(plan, what).bytesNotUploaded, bytesSaved(scene, part)) << name << ' ' << what;
    };
    expect("vertex normals", "normals");
    expect("materials", "materials");
    if (line(plan, "indices").choice != "left out") expect("indices", "index bytes");
  }
}

TEST(ScenePlan, NumbersEqualTheRenders) {
  int less = 0;
  for (const char* name : {"bunny-whitted.xml", "cornell-two-lights.xml"}) {
    const Scene scene = smallScene(name, 300, 37);
    RenderOptions options;
    options.crop = Crop{10, 20, 290, 150};
    const auto figures = planScene(scene, options, {}, testDeviceInfo()).figures;
    Stats stats;
    Renderer(onTestDevice()).render(scene, options, stats);
    EXPECT_EQ(figures["bands"], stats.bands);
    EXPECT_EQ(figures["passesPerBand"].get<unsigned>() * stats.bands, stats.passes);
    EXPECT_EQ(figures["samplesPerPass"], stats.samplesPerPass);
    EXPECT_EQ(figures["nodes"], stats.nodes);
    EXPECT_EQ(figures["seen"], stats.coverage);
    EXPECT_EQ(figures["depth"], stats.depth);
    EXPECT_EQ(figures["stackNeeded"], stats.stack);
    less += stats.coverage < 1.0 ? 1 : 0;
  }
  EXPECT_EQ(less, 1);  // the crop of the box has no black edge
}

TEST(ScenePlan, NamesTheTraversalOfTheRender) {
  Scene scene = smallScene("bunny-normals.xml", 16, 1);  // 69,666 triangles for 256 rays
  for (const int width : {16, 768}) {
    scene.camera.width = scene.camera.height = width;
    Stats stats;
    Renderer(onTestDevice()).render(scene, {}, stats);
    EXPECT_EQ(planScene(scene, {}, {}, testDeviceInfo()).traversal, stats.traversal) << width;
  }
  EXPECT_EQ(planScene(scene, {}, onTestDevice("lane"), testDeviceInfo()).traversal, "lane");
}

TEST(ScenePlan, ShowsTheEffectsOfSamplerAdaptionAndDensity) {
  Scene scene = smallScene("bunny-normals.xml", 200, 85);  // 1.7 triangles per pixel
  ScenePlan plan = planScene(scene, {}, {}, testDeviceInfo());
  EXPECT_EQ(line(plan, "sampler").choice, "independent");
  EXPECT_EQ(line(plan, "adaptive").choice, "off");
  EXPECT_EQ(line(plan, "side by side").choice, "64 samples of a pixel");
  scene.camera.width = scene.camera.height = 300;
  EXPECT_EQ(planScene(scene, {}, {}, testDeviceInfo()).figures["samplesSideBySide"], 16);
  scene.sampler.row = &samplers::sobol;
  RenderOptions options;
  options.error = 0.01;
  plan = planScene(scene, options, {}, testDeviceInfo());
  EXPECT_EQ(line(plan, "sampler").choice, "sobol");
  EXPECT_EQ(line(plan, "sampler tables").choice, "none");
  EXPECT_EQ(line(plan, "adaptive").choice, "1 to 84 samples per pixel");
}

TEST(ScenePlan, ListsTexturesBackgroundAndLayers) {
  Scene scene = smallScene("curved-normals.xml", 16, 1);
  scene.integrator = {&integrators::directWhitted};
  scene.lights.clear();
  scene.meshes[0].bsdf.show("albedo", Texture());
  ScenePlan plan = planScene(scene, {}, {}, testDeviceInfo());
  EXPECT_EQ(line(plan, "camera rays").choice, "none traced");
  EXPECT_EQ(line(plan, "textures").choice, "left out");
  EXPECT_EQ(line(plan, "background").choice, "black");
  scene.environment = Environment();
  plan = planScene(scene, {}, {}, testDeviceInfo());
  EXPECT_EQ(line(plan, "camera rays").why, "misses are visible");
  EXPECT_EQ(line(plan, "background").choice, "one radiance");
  EXPECT_EQ(line(plan, "vertex normals").choice, "left out");
  RenderOptions options;
  options.layers = {&layers::albedo, &layers::normals};
  plan = planScene(scene, options, {}, testDeviceInfo());
  EXPECT_EQ(plan.figures["pictures"], 3);
  EXPECT_EQ(line(plan, "camera rays").why, "hits are visible");
  EXPECT_EQ(line(plan, "textures").choice, "checker");
  EXPECT_EQ(line(plan, "images").choice, "left out");
  EXPECT_NE(line(plan, "vertex normals").choice, "left out");
}

TEST(ScenePlan, SaysWhatPathsMeet) {
  const ScenePlan box = planScene(smallScene("box-glass.xml", 16, 1), {}, {}, testDeviceInfo());
  EXPECT_EQ(line(box, "BSDFs").choice, "dielectric, diffuse, mirror");
  EXPECT_EQ(line(box, "lights").choice, "0 lights, 1 mesh that emits");
  const ScenePlan lens = planScene(smallScene("lens.xml", 16, 1), {}, {}, testDeviceInfo());
  EXPECT_EQ(line(lens, "lights").choice, "2 lights, 0 meshes that emit");
  const ScenePlan sky = planScene(smallScene("open-sky.xml", 16, 1), {}, {}, testDeviceInfo());
  EXPECT_EQ(line(sky, "lights").choice, "0 lights, 0 meshes that emit, the background");
}

TEST(ScenePlan, NamesTheCentreOfCoordinates) {
  const auto choice = [](Scene scene) {
    return line(planScene(scene, {}, {}, testDeviceInfo()), "coordinates").choice;
  };
  Scene scene = smallScene("bunny-whitted.xml", 16, 1);
  EXPECT_EQ(choice(scene), "centred on the box of all meshes");
  scene.camera.fov = 3e-3;
  EXPECT_NE(choice(scene).find("; rays start at z = "), std::string::npos) << choice(scene);
  scene = smallScene("bunny-whitted.xml", 16, 1);
  scene.meshes.push_back(
      quad({{{-1e5, 0, -1e5}, {-1e5, 0, 1e5}, {1e5, 0, 1e5}, {1e5, 0, -1e5}}}, {0.5, 0.5, 0.5}));
  EXPECT_EQ(choice(scene), "centred on what is near");
}

TEST(ScenePlan, NamesPlanesOfNarrowTriangles) {
  EXPECT_EQ(
      line(planScene(smallScene("bunny-whitted.xml", 16, 1), {}, {}, testDeviceInfo()), "planes")
          .choice,
      "accurate");
  EXPECT_EQ(
      line(planScene(smallScene("spheres.xml", 16, 1), {}, {}, testDeviceInfo()), "planes").choice,
      "plain");
}

TEST(ScenePlan, ListsSpheres) {
  const Scene scene = smallScene("spheres.xml", 16, 1);
  const ScenePlan plan = planScene(scene, {}, {}, testDeviceInfo());
  EXPECT_EQ(line(plan, "spheres").choice, "5 spheres");
  EXPECT_EQ(plan.figures["triangles"], 1157U);
  EXPECT_EQ(
      line(planScene(smallScene("bunny-depth.xml", 16, 1), {}, {}, testDeviceInfo()), "spheres")
          .choice,
      "left out");
}

TEST_F(CommandLine, PlanPrintsTextAndJsonAndWritesNothing) {
  write("test.xml", kFirstScene);
  const Outcome text = laver("plan test.xml --device $device --spp 7");
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("sampler tables       2 of 3: 7 samples per pixel"), std::string::npos)
      << text.out;
  const Outcome json = laver("plan test.xml --device $device --json --size 40x30 --crop 3,4,13,24");
  ASSERT_EQ(json.code, 0) << json.err;
  const auto plan = nlohmann::json::parse(json.out);
  EXPECT_EQ(plan["figures"]["width"], 10);
  EXPECT_EQ(plan["figures"]["height"], 20);
  EXPECT_EQ(files(), std::set<std::string>{"test.xml"});
}

TEST_F(CommandLine, PlanFailsAsRenderingDoes) {
  write("test.xml", kFirstScene);
  write("bad.xml", "<scene><camera type=\"perspectiv\"/></scene>");
  EXPECT_EQ(laver("plan").code, 2);
  EXPECT_EQ(laver("plan test.xml --size 12").code, 2);
  EXPECT_EQ(laver("plan test.xml --crop 0,0,5000,2 --device $device").code, 2);
  EXPECT_EQ(laver("plan test.xml --error 0.1 --spp 3 --device $device").code, 2);
  EXPECT_EQ(laver("plan test.xml --traversal sideways --device $device").code, 2);
  EXPECT_EQ(laver("plan bad.xml").code, 3);
  EXPECT_EQ(laver("plan nowhere.xml").code, 3);
  EXPECT_EQ(laver("plan test.xml --device nonesuch").code, 4);
}

}  // namespace
}  // namespace laver::test
