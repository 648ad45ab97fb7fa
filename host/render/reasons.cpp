#include "render/reasons.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/sample_map.h"
#include "shared/layout.h"

namespace laver {
namespace {

/// Numbers and flags from which the reasons are made.
struct Facts {
  Facts(const Scene& s, const RenderOptions& o, const Choices& c)
      : scene(s), options(o), choices(c), uploads(c.uploads), first(c.pictures.front().key) {
    primitives = primitivesOf(s);
    for (const Mesh& mesh : s.meshes) {
      spheres += mesh.sphere ? 1 : 0;
      normals += mesh.normals.size();
      lamps += mesh.light ? 1 : 0;
      uvs += mesh.uvs.size();
    }
    for (const PictureChoice& picture : c.pictures) {
      const TraceKey& key = picture.key;
      hasSpheres |= key.spheres;
      slivers |= key.slivers;
      followsPaths |= picture.integrator.row->needs.emitters;
      coloured |= !key.bsdfs.empty() && (key.lights || key.background == "none" || followsPaths);
      byteImages |= key.byteImages;
      floatImages |= key.floatImages;
      if (key.background != "none") background = key.background;
      lit |= key.lights;
    }
  }

  bool traced() const { return uploads.primitives; }
  std::string shownBy() const {
    return std::string(scene.integrator.row->name) +
           (choices.pictures.size() > 1 ? " and its layers" : "");
  }
  /// Bytes of the attributes of all triangles in a format, without the arrays to which they refer.
  std::uint64_t attributeBytes(bool withNormals, std::uint32_t indexBytes) const {
    return primitives * indexBytes * (withNormals ? 4 : 1);
  }
  std::uint64_t attributeBytes() const {
    return uploads.attributes ? attributeBytes(uploads.normals, uploads.indexBytes) : 0;
  }

  const Scene& scene;
  const RenderOptions& options;
  const Choices& choices;
  const Uploads& uploads;
  const TraceKey& first;
  std::uint64_t primitives = 0, spheres = 0, normals = 0, uvs = 0, lamps = 0;
  bool hasSpheres = false, slivers = false, coloured = false, lit = false, byteImages = false,
       floatImages = false;
  bool followsPaths = false;  ///< light comes from all emitters
  std::string background = "none";
};

Reason integrator(const Facts& f) {
  const char* name = f.scene.integrator.row->name;
  if (f.choices.pictures.size() == 1)
    return {"integrator", name, "the scene or --integrator names it", "all others", 0};
  return {"integrator", name,
          fmt::format("{} from one upload, a kernel each",
                      countOf(f.choices.pictures.size(), "picture")),
          "all others", 0};
}

Reason rays(const Facts& f) {
  const bool unlit = f.choices.pictures.size() == 1 && f.scene.integrator.row->needs.lights &&
                     f.scene.lights.empty() && !f.followsPaths;
  if (f.traced())
    return {"camera rays", "traced", unlit ? "misses are visible" : "hits are visible", "", 0};
  return {"camera rays", "none traced", "a scene without lights is black",
          "the tree is not built, no ray is traced", f.primitives * sizeof(shared::Triangle)};
}

/// See render/space.h.
Reason coordinates(const Facts& f) {
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

Reason spheres(const Facts& f) {
  if (f.hasSpheres) return {"spheres", countOf(f.spheres, "sphere"), "the scene has them", "", 0};
  return {"spheres", "left out", f.spheres == 0 ? "the scene has none" : "no ray is traced",
          "a sphere test in each leaf", 0};
}

Reason planes(const Facts& f) {
  if (f.slivers)
    return {"planes", "accurate", "a triangle is too narrow for a plain cross product", "", 0};
  return {"planes", "plain", "no ray starts on a narrow triangle", "products of halves", 0};
}

Reason normals(const Facts& f) {
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

Reason materials(const Facts& f) {
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

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

Reason materialBsdfs(const Facts& f) {
  if (!f.coloured || !f.traced())
    return {"BSDFs", "left out", fmt::format("{} shows none", f.shownBy()), "", 0};
  std::vector<std::string> names;
  for (const BsdfText& bsdf : f.uploads.bsdfs) names.push_back(bsdf.name);
  return {"BSDFs", joined(names), "those of the meshes", "the others", 0};
}

Reason surfaceTextures(const Facts& f) {
  if (!f.uploads.textures)
    return {"textures", "left out", "no texture is shown", "the loads of a hit", 0};
  return {"textures", joined(f.uploads.textureKinds), "those of the meshes", "the others", 0};
}

Reason images(const Facts& f) {
  if (!f.byteImages && !f.floatImages)
    return {"images", "left out", "no texture and no background has one", "", 0};
  return {"images",
          f.byteImages && f.floatImages ? "of 8 bits and of floats"
          : f.byteImages                ? "of 8 bits"
                                        : "of floats",
          "as their files have them", f.byteImages && f.floatImages ? "" : "the other kind", 0};
}

Reason background(const Facts& f) {
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

Reason uvs(const Facts& f) {
  if (f.uploads.textures)
    return {"texture coordinates", "those of textured meshes", "a texture reads them", "", 0};
  return {"texture coordinates", "left out", "no texture reads them", "",
          f.uvs * 2 * sizeof(float)};
}

Reason indices(const Facts& f) {
  if (!f.uploads.attributes)
    return {"indices", "left out", "there is nothing to point into", "", 0};
  const std::uint64_t last = f.uploads.normals
                                 ? std::max<std::uint64_t>(f.normals, f.scene.meshes.size())
                                 : f.scene.meshes.size() - 1;
  return {"indices", fmt::format("{} bits", f.uploads.indexBytes * 8),
          fmt::format("the largest is {}", last), "",
          f.attributeBytes(f.uploads.normals, 4) - f.attributeBytes()};
}

Reason lights(const Facts& f) {
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

Reason shadowRays(const Facts& f) {
  if (f.followsPaths) return {"shadow rays", "the integrator's own", "it follows paths", "", 0};
  if (!f.lit) return {"shadow rays", "none", "no light is shown", "", 0};
  return {"shadow rays", "where n.l > 0 and n.v > 0", "elsewhere no light arrives",
          "those of surfaces that face away", 0};
}

Reason sampler(const Facts& f) {
  return {"sampler", f.scene.sampler.row->name,
          countOf(f.scene.sampler.sampleCount, "sample") + " per pixel", "the other samplers", 0};
}

Reason samplerTables(const Facts& f) {
  const std::uint32_t levels = f.first.jumpLevels;
  if (levels == 0)
    return {"sampler tables", "none", "positions are hashed, not drawn from a stream", "", 0};
  return {"sampler tables", fmt::format("{} of 3", levels),
          countOf(f.scene.sampler.sampleCount, "sample") + " per pixel",
          levels == 3 ? "" : countOf(3 - levels, "jump") + " per sample", 0};
}

Reason filter(const Facts& f) {
  const std::uint32_t reach = 2 * f.choices.gather.apron + 1;
  return {"filter",
          fmt::format("{}, {} x {} pixels",
                      f.uploads.noriTable ? std::string("Nori's table") : f.choices.gather.filter,
                      reach, reach),
          fmt::format("its radius is {:g}", f.scene.filter.radius),
          "the other filters, and pixels out of reach", 0};
}

Reason film(const Facts& f) {
  if (!f.choices.pictures.front().blackMiss)
    return {"film", "all of it",
            f.scene.camera.row->lens ? "a lens sees around edges"
                                     : "rays that hit nothing may not be black",
            "", 0};
  return {"film", "the part that the scene covers", "rays that hit nothing are black",
          "rays and sums elsewhere", 0};
}

Reason adaptive(const Facts& f) {
  if (f.options.error == 0.0)
    return {"adaptive", "off", "no --error", "counts of cells, and lists of work", 0};
  return {"adaptive", fmt::format("1 to {} samples per pixel", maxSamplesOf(f.scene, f.options)),
          fmt::format("to an error of {:g}, which {} pilots of 1 sample decide", f.options.error,
                      kPilots),
          "", 0};
}

Reason sideBySide(const Facts& f) {
  const Tiling& tiling = f.choices.tiling;
  const double density =
      static_cast<double>(f.primitives) / f.scene.camera.width / f.scene.camera.height;
  const std::uint32_t samples = samplesSideBySide(tiling, f.options.error != 0.0);
  return {"side by side", countOf(samples, "sample") + " of a pixel",
          samples < tiling.sideBySide ? "no more in a pass"
                                      : fmt::format("{:.2g} triangles per pixel", density),
          "", 0};
}

Reason passes(const Facts& f) {
  const Tiling& tiling = f.choices.tiling;
  return {"passes",
          fmt::format("{}{} x {} in {}", f.options.error == 0.0 ? "" : "up to ",
                      passesOf(maxSamplesOf(f.scene, f.options), tiling),
                      countOf(tiling.samplesPerPass, "sample"),
                      countOf(bandsOf(f.choices.core, tiling), "band")),
          fmt::format("{} MiB of samples in flight, {} MiB of film",
                      tiling.sampleSlots * kBytesInFlight >> 20,
                      tiling.bandPixels * sizeof(shared::FilmPixel) >> 20),
          "", 0};
}

}  // namespace

std::string countOf(std::uint64_t n, const char* one, const char* more) {
  const std::string plural = more == nullptr ? std::string(one) + 's' : more;
  return fmt::format("{} {}", n, n == 1 ? one : plural);
}

std::vector<Reason> reasonsOf(const Scene& scene, const RenderOptions& options,
                              const Choices& choices, const std::string& traversal) {
  const Facts f(scene, options, choices);
  std::vector<Reason> reasons = {integrator(f),
                                 {"traversal", traversalName(choices.traversal), traversal, "", 0}};
  for (const auto reason :
       {rays,          coordinates,     spheres, planes,        normals, materials,
        materialBsdfs, surfaceTextures, images,  background,    uvs,     indices,
        lights,        shadowRays,      sampler, samplerTables, filter,  film,
        adaptive,      sideBySide,      passes})
    reasons.push_back(reason(f));
  return reasons;
}

}  // namespace laver
