#include "render/scene_reasons.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/layout.h"

namespace laver {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

}  // namespace

Reason raysReason(const Facts& f) {
  const bool unlit = f.choices.pictures.size() == 1 && f.scene.integrator.row->needs.lights &&
                     f.scene.lights.empty() && !f.followsPaths;
  if (f.traced())
    return {"camera rays", "traced", unlit ? "misses are visible" : "hits are visible", "", 0};
  return {"camera rays", "none traced", "a scene without lights is black",
          "the tree is not built, no ray is traced", f.primitives * sizeof(shared::Triangle)};
}

/// See render/space.h.
Reason coordinatesReason(const Facts& f) {
  const Normalisation& space = f.uploads.space;
  const std::string start =
      space.start > 0.0 ? fmt::format("; rays start at z = {:.4g} of the camera", space.start) : "";
  if (!space.wide())
    return {"coordinates", "centred on the box of all meshes" + start,
            start.empty() ? "nothing visible is near beside that box" : "pixels are narrow",
            "splitting large triangles", 0};
  return {"coordinates", "centred on what is near" + start,
          fmt::format("something visible is near beside the box: {:.4g} units", space.unit), "", 0};
}

Reason spheresReason(const Facts& f) {
  if (f.hasSpheres) return {"spheres", countOf(f.spheres, "sphere"), "the scene has them", "", 0};
  return {"spheres", "left out", f.spheres == 0 ? "the scene has none" : "no ray is traced",
          "a sphere test in each leaf", 0};
}

Reason planesReason(const Facts& f) {
  if (f.slivers)
    return {"planes", "accurate", "a triangle is too narrow for a plain cross product", "", 0};
  return {"planes", "plain", "no ray starts on a narrow triangle", "products of halves", 0};
}

Reason normalsReason(const Facts& f) {
  if (f.uploads.normals)
    return {"vertex normals", countOf(f.normals, "normal"),
            f.lit || f.followsPaths ? "shading reads them" : "the integrator shows them", "", 0};
  const std::uint64_t bytes = f.traced() ? (f.normals + 1) * sizeof(glm::vec4) +
                                               f.attributeBytes(true, indexBytesOf(f.scene, true)) -
                                               f.attributeBytes()
                                         : 0;
  return {"vertex normals", "left out",
          !f.traced()      ? "no ray is traced"
          : f.normals == 0 ? "no mesh has any"
                           : fmt::format("{} shows none", f.shownBy()),
          "4 loads per hit, interpolation", bytes};
}

Reason materialsReason(const Facts& f) {
  const std::size_t meshes = f.scene.meshes.size();
  if (f.uploads.attributes && (f.uploads.materials || f.uploads.textures))
    return {"materials", countOf(meshes, f.uploads.textures ? "texture" : "material"),
            "the meshes differ", "", 0};
  const std::uint64_t records =
      f.uploads.materials ? 0 : meshes * f.uploads.layout.texels() * sizeof(glm::uvec4);
  const std::uint64_t bytes =
      f.traced()
          ? records + f.attributeBytes(f.uploads.normals, f.uploads.indexBytes) - f.attributeBytes()
          : 0;
  const bool one = f.coloured && f.traced();
  return {"materials",
          !one                 ? "left out"
          : f.uploads.textures ? "one texture"
                               : "one albedo, a parameter",
          one           ? "all meshes agree"
          : !f.traced() ? "no ray is traced"
                        : fmt::format("{} shows none", f.shownBy()),
          "1 load per hit", bytes};
}

Reason materialBsdfsReason(const Facts& f) {
  if (!f.coloured || !f.traced())
    return {"BSDFs", "left out", fmt::format("{} shows none", f.shownBy()), "", 0};
  std::vector<std::string> names;
  for (const BsdfText& bsdf : f.uploads.bsdfs) names.push_back(bsdf.name);
  return {"BSDFs", joined(names), "those of the meshes", "the others", 0};
}

Reason surfaceTexturesReason(const Facts& f) {
  if (!f.uploads.textures)
    return {"textures", "left out", "no texture is shown", "the loads of a hit", 0};
  return {"textures", joined(f.uploads.textureKinds), "those of the meshes", "the others", 0};
}

Reason imagesReason(const Facts& f) {
  if (!f.byteImages && !f.floatImages)
    return {"images", "left out", "no texture and no background has one", "", 0};
  return {"images",
          f.byteImages && f.floatImages ? "of 8 bits and of floats"
          : f.byteImages                ? "of 8 bits"
                                        : "of floats",
          "as their files have them", f.byteImages && f.floatImages ? "" : "the other kind", 0};
}

Reason backgroundReason(const Facts& f) {
  if (f.background == "none")
    return {"background", "black",
            f.scene.environment ? fmt::format("{} shows none", f.shownBy()) : "the scene has none",
            "", 0};
  if (f.background == "constant")
    return {"background", "one radiance", "it has no image", "a direction's place in one", 0};
  if (f.background == "distantdisk")
    return {"background", "a disk", "the scene's distantdisk", "an image", 0};
  return {"background", "an image", "the scene's environment", "", 0};
}

Reason uvsReason(const Facts& f) {
  if (f.uploads.textures)
    return {"texture coordinates", "those of textured meshes", "a texture reads them", "", 0};
  return {"texture coordinates", "left out", "no texture reads them", "",
          f.uvs * 2 * sizeof(float)};
}

Reason indicesReason(const Facts& f) {
  if (!f.uploads.attributes)
    return {"indices", "left out", "there is nothing to point into", "", 0};
  const std::uint64_t last = f.uploads.normals
                                 ? std::max<std::uint64_t>(f.normals, f.scene.meshes.size())
                                 : f.scene.meshes.size() - 1;
  return {"indices", fmt::format("{} bits", f.uploads.indexBytes * 8),
          fmt::format("the largest is {}", last), "",
          f.attributeBytes(f.uploads.normals, 4) - f.attributeBytes()};
}

Reason lightsReason(const Facts& f) {
  const std::size_t lights = f.scene.lights.size();
  if (f.followsPaths)
    return {"lights",
            fmt::format("{}, {} that {}{}", countOf(lights, "light"),
                        countOf(f.lamps, "mesh", "meshes"), f.lamps == 1 ? "emits" : "emit",
                        f.background == "none" ? "" : ", the background"),
            fmt::format("{} follows paths", f.scene.integrator.row->name), "", 0};
  if (!f.lit)
    return {"lights", "left out",
            lights == 0 ? "the scene has none"
                        : fmt::format("{} shows none", f.scene.integrator.row->name),
            "no shadow ray is traced", lights * sizeof(shared::Light)};
  constexpr std::uint32_t kOnce = shared::LIGHTS_PER_DISPATCH;
  if (lights <= kOnce)
    return {"lights", countOf(lights, "light") + " in one dispatch",
            fmt::format("{} or fewer", kOnce), "reading back what earlier dispatches summed", 0};
  return {
      "lights",
      fmt::format("{} in {} dispatches", countOf(lights, "light"), (lights + kOnce - 1) / kOnce),
      fmt::format("more than {}", kOnce), "", 0};
}

Reason shadowRaysReason(const Facts& f) {
  if (f.followsPaths) return {"shadow rays", "the integrator's own", "it follows paths", "", 0};
  if (!f.lit) return {"shadow rays", "none", "no light is shown", "", 0};
  return {"shadow rays", "where n.l > 0 and n.v > 0", "elsewhere no light arrives",
          "those of surfaces that face away", 0};
}

}  // namespace laver
