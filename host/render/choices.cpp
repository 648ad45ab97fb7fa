#include "render/choices.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/materials.h"
#include "render/pack_parts.h"
#include "render/reasons.h"
#include "render/renderer.h"
#include "render/sample_map.h"
#include "render/traversal.h"
#include "scene/layers.h"

namespace laver {
namespace {

/// Texel buffers of fewer texels would divide a pass of samples, which has up to 2^22 (tile()), and
/// refuse scenes that are not small. The least that Vulkan allows is 2^16.
constexpr std::uint32_t kFewTexels = 1U << 22;

/// A stack never holds more entries than there are primitives.
std::uint32_t likelyStack(const Scene& scene, const Normalisation& space) {
  if (space.wide()) return kLikelyStack;
  return static_cast<std::uint32_t>(
      std::clamp<std::uint64_t>((primitivesOf(scene) + 7) / 8 * 8, 8, kLikelyStack));
}

/// Name of the GLSL file of a filter.
std::string filterText(const Filter& filter, bool noriTable) {
  if (noriTable) return "table";
  if (!filter.row->narrowForm) return filter.row->name;
  // exp(alpha * apron) and its inverse must be well within the range of floats.
  const double alpha = 0.5 / (filter.stddev * filter.stddev);
  const std::uint32_t apron = apronOf(filter.radius);
  return apron <= 8 && alpha * apron <= 60.0 ? std::string(filter.row->name) + "_narrow"
                                             : filter.row->name;
}

/// Whether the meshes' records differ in what a surface shows.
bool materialsDiffer(const Scene& scene) {
  const auto& meshes = scene.meshes;
  return std::any_of(meshes.begin(), meshes.end(), [&](const Mesh& m) {
    return !alike(m, meshes.front()) || (hasTextures(m) && meshes.size() > 1);
  });
}

bool emits(const Scene& scene) {
  return std::any_of(scene.meshes.begin(), scene.meshes.end(),
                     [](const Mesh& mesh) { return mesh.light.has_value(); });
}

/// Whether a record says more than an albedo: the BSDF of several, further properties, textures.
bool needsBsdfRecords(const TraceKey& key) {
  return key.bsdfs.size() > 1 || key.layout != MaterialLayout{};
}

void noteImage(const std::shared_ptr<const Picture>& image, TraceKey& key) {
  if (!image) return;
  (std::holds_alternative<Bitmap>(*image) ? key.byteImages : key.floatImages) = true;
}

/// Sets the part of the key for materials, textures and lights.
void keyOfShading(const Scene& scene, const IntegratorRow& row, bool surfaces, TraceKey& key) {
  key.bsdfs = bsdfsOf(scene);
  key.layout = layoutOf(scene);
  key.lights = row.needs.lights && !scene.lights.empty();
  key.shapedLights = key.lights && std::any_of(scene.lights.begin(), scene.lights.end(),
                                               [](const PointLight& light) {
                                                 return light.row != &emitters::point;
                                               });
  key.manyLights =
      key.lights && !row.needs.emitters && scene.lights.size() > shared::LIGHTS_PER_DISPATCH;
  if (row.needs.background && scene.environment) {
    key.background = scene.environment->row->name;
    noteImage(scene.environment->image, key);
  }
  key.emission = row.needs.emitters && emits(scene);
  if (!surfaces) return;
  key.materials = materialsDiffer(scene) || (key.emission && scene.meshes.size() > 1);
  key.bsdfRecords = needsBsdfRecords(key);
  key.textures = texturesOf(scene);
  for (const Mesh& mesh : scene.meshes) {
    for (const Texture* texture : texturesOf(mesh)) noteImage(texture->image, key);
    key.texturedLights |=
        key.emission && mesh.light && mesh.light->texture && shows(*mesh.light->texture);
  }
}

std::string number(double x) {
  const std::string text = fmt::format("{}", static_cast<float>(x));
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

/// A property of a user's integrator as a constant of its kernel.
KernelProperty constantOf(const NamedValue& property) {
  const Value& value = property.value;
  if (const auto* x = std::get_if<double>(&value)) return {"float", property.name, number(*x)};
  if (const auto* i = std::get_if<std::int64_t>(&value))
    return {"int", property.name, std::to_string(*i)};
  if (const auto* b = std::get_if<bool>(&value))
    return {"bool", property.name, *b ? "true" : "false"};
  const glm::dvec3 v = std::get<glm::dvec3>(value);
  return {"vec3", property.name,
          fmt::format("vec3({}, {}, {})", number(v.x), number(v.y), number(v.z))};
}

TraceKey keyOf(const Scene& scene, const Normalisation& space, const RenderOptions& options,
               const IntegratorUse& integrator) {
  const IntegratorRow& row = *integrator.row;
  const bool surfaces = !row.litOnly || !scene.lights.empty();
  TraceKey key;
  key.integrator = row.name;
  key.camera = scene.camera.row->name;
  key.sampler = scene.sampler.row->name;
  key.stack = likelyStack(scene, space);
  if (scene.sampler.row->stream) key.jumpLevels = jumpLevels(scene.sampler.sampleCount);
  key.hits = surfaces || (row.needs.background && scene.environment);
  key.spheres = key.hits && hasSpheres(scene);
  key.caps = key.hits && hasCaps(scene, space);
  key.farParts = space.wide();
  key.farCamera = space.start > 0.0;
  key.normals = surfaces && row.needs.normals &&
                std::any_of(scene.meshes.begin(), scene.meshes.end(),
                            [](const Mesh& m) { return !m.normals.empty(); });
  key.adaptive = options.error > 0.0;
  key.signedValues = row.needs.negative;
  key.bounces = row.bounces || integrator.user;
  if (shades(row)) keyOfShading(scene, row, surfaces, key);
  const bool tracesOn = key.lights || key.bounces || row.needs.numbers || row.looksOn;
  key.slivers = tracesOn && hasSlivers(scene, space);
  for (const PropertyRow& property : row.properties)
    key.properties.push_back({isTriple(property.type) ? "vec3" : "float", property.name, ""});
  if (integrator.user) {
    key.userFile = integrator.user->file;
    key.userText = integrator.user->text;
    for (const NamedValue& value : integrator.values) key.properties.push_back(constantOf(value));
  }
  return key;
}

bool blackMiss(const Scene& scene, const IntegratorRow& row) {
  if (scene.camera.row->lens) return false;
  return row.miss == Miss::Black || (row.miss == Miss::Background && !scene.environment);
}

std::vector<PictureChoice> picturesOf(const Scene& scene, const Normalisation& space,
                                      const RenderOptions& options) {
  std::vector<PictureChoice> pictures;
  const auto add = [&](const IntegratorUse& integrator, std::vector<std::string> channels) {
    pictures.push_back({std::move(channels), keyOf(scene, space, options, integrator), false,
                        blackMiss(scene, *integrator.row), integrator});
  };
  add(scene.integrator, {"R", "G", "B"});
  for (Shown& layer : shownBeside(options.more, options.layers))
    add(useOf(scene, layer.integrator), std::move(layer.channels));
  std::vector<std::string> centres = centreChannels(options.layers);
  if (!centres.empty()) {
    add({&integrators::depth}, std::move(centres));
    PictureChoice& picture = pictures.back();
    picture.key.integrator = "centres";
    picture.key.camera = cameras::perspective.name;
    picture.key.adaptive = false;
    picture.centres = true;
    picture.blackMiss = false;
  }
  return pictures;
}

/// Everything that any of the pictures reads.
Uploads uploadsOf(const Scene& scene, const Normalisation& space,
                  const std::vector<PictureChoice>& pictures, const RenderOptions& options) {
  Uploads uploads;
  uploads.space = space;
  uploads.primitives = false;
  for (const PictureChoice& picture : pictures) {
    const TraceKey& key = picture.key;
    uploads.primitives |= key.hits;
    uploads.normals |= key.normals;
    uploads.attributes |= key.normals || key.materials;
    uploads.materials |= key.bsdfRecords || key.materials;
    uploads.textures |= !key.textures.empty() || (key.bsdfRecords && key.layout.tangents);
    uploads.lights |= key.lights;
    uploads.emission |= picture.integrator.row->needs.emitters;
    uploads.jumpLevels = std::max(uploads.jumpLevels, key.jumpLevels);
    uploads.background |= key.background != "none";
  }
  uploads.layout = layoutOf(scene);
  uploads.bsdfs = bsdfsOf(scene);
  uploads.textureKinds = texturesOf(scene);
  uploads.noriTable = options.noriCompat;
  // Split meshes have more normals.
  uploads.indexBytes = space.wide() ? 4 : indexBytesOf(scene, uploads.normals);
  return uploads;
}

/// The pixels whose pilots decide the sample counts of a part of the picture.
Crop pilotsOf(const Crop& pixels, std::uint32_t apron, const Camera& camera) {
  return pilotArea(cropOf(regionOf(pixels, apron, camera.width, camera.height)), camera.width,
                   camera.height);
}

Tiling tilingOf(const Scene& scene, const RenderOptions& options, const VulkanOptions& vulkan,
                VkPhysicalDeviceLimits limits, const Choices& choices) {
  if (choices.gather.storageTexels)  // one sample's texel has 16 bytes
    limits.maxTexelBufferElements = limits.maxStorageBufferRange / 16;
  const std::uint32_t apron = choices.gather.apron;
  const Camera& camera = scene.camera;
  Crop planned{};
  for (const Strip& strip : stripsOf(scene, options)) {
    const Crop area = options.error == 0.0 ? strip.pixels : pilotsOf(strip.pixels, apron, camera);
    if (area.y1 - area.y0 > planned.y1 - planned.y0) planned = area;
  }
  // Variances depend on the number of samples per pass, which must be that of the whole picture.
  if (options.shard && asks(options.layers, layers::variance)) planned = coreOf(camera, options);
  return tile(limits, {planned, camera.width, camera.height, apron, scene.sampler.sampleCount,
                       vulkan.samplesInFlight, sideBySide(scene)});
}

}  // namespace

std::uint32_t indexBytesOf(const Scene& scene, bool normals) {
  std::uint64_t last = scene.meshes.size(), vertexNormals = 0;
  for (const Mesh& mesh : scene.meshes) vertexNormals += mesh.normals.size();
  if (normals) last = std::max(last, vertexNormals);
  return last <= 0xff ? 1 : last <= 0xffff ? 2 : 4;
}

Uploads uploadsOf(const Scene& scene, const RenderOptions& options) {
  const Normalisation space = normalisationOf(scene);
  return uploadsOf(scene, space, picturesOf(scene, space, options), options);
}

Choices choose(const Scene& scene, const RenderOptions& options, const VulkanOptions& vulkan,
               const DeviceInfo& device) {
  Choices choices;
  TraversalChoice traversal = traversalOf(scene, device, vulkan.traversal);
  const bool chosen = vulkan.traversal.empty();
  if (scene.integrator.row->bounces || (chosen && scene.camera.row->lens))
    traversal = {Traversal::Lane, "its rays share neither origin nor direction"};
  choices.traversal = traversal.traversal;
  const Normalisation space = normalisationOf(scene);
  choices.pictures = picturesOf(scene, space, options);
  for (PictureChoice& picture : choices.pictures) {
    picture.key.traversal = picture.integrator.row->bounces ? Traversal::Lane : choices.traversal;
    picture.key.lockstep = picture.key.bounces && runsPackets(device);
    if (vulkan.wholeFilm) picture.blackMiss = false;
  }
  choices.uploads = uploadsOf(scene, space, choices.pictures, options);
  choices.gather.filter = filterText(scene.filter, options.noriCompat);
  choices.gather.apron = apronOf(scene.filter.radius);
  choices.gather.adaptive = options.error > 0.0;
  // film/gather_strip.glsl supports no wider filters.
  choices.gather.strips = runsPackets(device) && choices.gather.apron <= 4;
  if (device.limits.maxTexelBufferElements < kFewTexels &&
      device.limits.maxPerStageDescriptorStorageBuffers >= shared::BINDINGS)
    choices = generalised(std::move(choices), {"storage texels"});
  if (!vulkan.general.empty()) choices = generalised(std::move(choices), vulkan.general);
  choices.core = coreOf(scene.camera, options);
  choices.strips = stripsOf(scene, options);
  choices.tiling = tilingOf(scene, options, vulkan, device.limits, choices);
  choices.reasons = reasonsOf(scene, options, choices, traversal.why);
  return choices;
}

VkFormat attributeFormat(const Uploads& uploads) {
  switch (uploads.indexBytes) {
    case 1:
      return uploads.normals ? VK_FORMAT_R8G8B8A8_UINT : VK_FORMAT_R8_UINT;
    case 2:
      return uploads.normals ? VK_FORMAT_R16G16B16A16_UINT : VK_FORMAT_R16_UINT;
    default:
      return uploads.normals ? VK_FORMAT_R32G32B32A32_UINT : VK_FORMAT_R32_UINT;
  }
}

std::uint32_t stackFor(std::uint32_t guess, std::uint32_t needed) {
  return needed <= guess ? guess : (needed + 15) / 16 * 16;
}

}  // namespace laver
