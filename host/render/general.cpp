// Kernels that leave nothing out for the scene: part by part, for tests and measurements.
#include <algorithm>

#include "render/choices.h"
#include "render/materials.h"
#include "scene/scene.h"

namespace laver {

// Not the BSDFs: compilers round one differently beside others, though alike in every traversal.
const std::vector<std::string>& generalParts() {
  static const std::vector<std::string> parts = {
      "stack",       "normals",     "materials",     "bsdf records", "lights",   "shaped lights",
      "many lights", "jump levels", "apron",         "strips",       "textures", "images",
      "background",  "hits",        "index bytes",   "spheres",      "caps",     "far parts",
      "far camera",  "slivers",     "storage texels"};
  return parts;
}

namespace {

/// Any property may be a texture.
MaterialLayout allTextured(MaterialLayout layout) {
  layout.texturedColors = (1U << layout.colors) - 1;
  layout.texturedNumbers = (1U << layout.numbers) - 1;
  layout.normalMaps = layout.tangents = true;
  return layout;
}

void generaliseKey(TraceKey& key, const std::string& part, bool stream) {
  if (part == "stack") key.stack = std::max(key.stack, kLikelyStack);
  if (part == "normals") key.normals = true;
  if (part == "materials") key.materials = true;
  if (part == "bsdf records") key.bsdfRecords = true;
  if (part == "lights" || part == "many lights") key.lights = true;
  if (part == "shaped lights") key.lights = key.shapedLights = true;
  if (part == "many lights") key.manyLights = true;
  if (part == "jump levels" && stream) key.jumpLevels = 3;
  if (part == "textures" && !key.bsdfs.empty()) {
    key.textures = allTextureNames();
    key.layout = allTextured(key.layout);
    key.bsdfRecords = true;
    key.texturedLights = key.emission;
  }
  if (part == "images") key.byteImages = key.floatImages = true;
  if (part == "background") key.background = "environment";
  if (part == "hits") key.hits = true;
  if (part == "spheres") key.spheres = true;
  if (part == "caps") key.caps = true;
  if (part == "far parts") key.farParts = true;
  if (part == "slivers") key.slivers = true;
  if (part == "far camera") key.farCamera = true;
  if (part == "storage texels") key.storageTexels = true;
}

}  // namespace

Choices generalised(Choices choices, const std::vector<std::string>& parts) {
  Uploads& uploads = choices.uploads;
  for (const std::string& part : parts) {
    for (PictureChoice& picture : choices.pictures)
      generaliseKey(picture.key, part, picture.key.jumpLevels != 0);
    if (part == "normals") {
      uploads.normals = uploads.attributes = true;
      uploads.indexBytes = 4;
    }
    if (part == "materials") uploads.attributes = true;
    if (part == "materials" || part == "bsdf records") uploads.materials = true;
    if (part == "strips") choices.gather.strips = false;
    if (part == "textures") {
      uploads.textures = uploads.materials = true;
      uploads.layout = allTextured(uploads.layout);
      uploads.textureKinds = allTextureNames();
    }
    if (part == "jump levels" && uploads.jumpLevels != 0) uploads.jumpLevels = 3;
    if (part == "storage texels") choices.gather.storageTexels = true;
    if (part == "hits") uploads.primitives = true;
    if (part == "index bytes") uploads.indexBytes = 4;
    // The widest filter that film/gather_strip.glsl supports.
    if (part == "apron") choices.gather.apron = std::max(4U, choices.gather.apron);
  }
  return choices;
}

}  // namespace laver
