#include "render/plan_lines.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/attribute_form.h"
#include "vulkan/buffer.h"

namespace laver {
namespace {

using Line = ScenePlan::Line;

/// "direct_whitted", or that and what is rendered beside it.
std::string shownBy(const Facts& f) {
  return std::string(f.scene.integrator.row->name) + (f.pictures > 1 ? " and its layers" : "");
}

/// Bytes of the attributes of all triangles in a form, without the tables they point into.
std::uint64_t indexBytesOf(const Facts& f, SpecConstants constants) {
  const bool any = constants[shared::SPEC_NORMALS] != 0 || constants[shared::SPEC_ALBEDOS] != 0;
  return any ? f.data.triangles * texelBytes(attributeFormat(constants)) : 0;
}

Line rays(const Facts& f) {
  const bool unlit = f.shaded && f.pictures == 1 && f.scene.lights.empty();
  if (f.traced())
    return {"camera rays", "traced", unlit ? "what they miss shows" : "what they hit shows", "", 0};
  return {"camera rays", "none traced", "a scene without lights is black",
          "the tree is not built, no ray is traced", f.triangles * sizeof(shared::Triangle)};
}

Line tree(const Facts& f) {
  const Bvh& bvh = f.data.bvh;
  if (!f.traced()) return {"tree", "not built", "no ray is traced", "", 0};
  return {
      "tree",
      fmt::format("{} of up to 8 children, depth {}", countOf(bvh.nodes.size(), "node"), bvh.depth),
      "built for this plan: nothing else tells its depth", "", 0};
}

Line stack(const Facts& f) {
  const std::uint32_t entries = f.constant(shared::SPEC_STACK), needed = f.data.bvh.stack;
  const std::uint32_t generic =
      generalise(f.data.constants, 1U << shared::SPEC_STACK)[shared::SPEC_STACK];
  Line line{"stack", fmt::format("{} entries", entries), "", "", 0};
  line.reason = entries > f.likelyStack
                    ? fmt::format("the tree needs {}: the kernel is compiled anew", needed)
                : entries < generic
                    ? fmt::format("{} never fill more; the tree needs {}",
                                  countOf(f.triangles, "triangle"), needed)
                    : fmt::format(
                          "the tree needs {}; set before it is there, so that kernels "
                          "compile beside it",
                          needed);
  if (entries < generic) line.saving = fmt::format("{} entries", generic - entries);
  return line;
}

Line spheres(const Facts& f) {
  if (f.constant(shared::SPEC_SPHERES) != 0)
    return {"spheres", countOf(f.spheres, "sphere"), "a kernel that tests them", "", 0};
  return {"spheres", "left out", f.spheres == 0 ? "the scene has none" : "no ray is traced",
          "their test beside the triangles'", 0};
}

Line normals(const Facts& f) {
  if (f.constant(shared::SPEC_NORMALS) != 0)
    return {"vertex normals", countOf(f.normals, "normal"),
            f.shaded ? "shading reads them" : "the integrator shows them", "", 0};
  SpecConstants with = f.data.constants;
  with[shared::SPEC_NORMALS] = 1;
  with[shared::SPEC_INDEX_BYTES] = indexBytes(f.scene, true);
  const std::uint64_t bytes = f.traced()
                                  ? (f.normals + 1) * sizeof(glm::vec4) + indexBytesOf(f, with) -
                                        indexBytesOf(f, f.data.constants)
                                  : 0;
  return {"vertex normals", "left out",
          !f.traced()      ? "no ray is traced"
          : f.normals == 0 ? "no mesh has any"
                           : fmt::format("{} shows none", shownBy(f)),
          "4 loads a hit, interpolation", bytes};
}

Line materials(const Facts& f) {
  const std::size_t meshes = f.scene.meshes.size();
  if (f.constant(shared::SPEC_ALBEDOS) != 0)
    return {"materials",
            countOf(meshes, f.constant(shared::SPEC_TEXTURES) != 0 ? "texture" : "albedo"),
            "the meshes differ", "", 0};
  SpecConstants with = f.data.constants;
  with[shared::SPEC_ALBEDOS] = 1;
  const std::uint64_t bytes =
      f.traced() ? f.materialBytes() + indexBytesOf(f, with) - indexBytesOf(f, f.data.constants)
                 : 0;
  const bool one = f.coloured && f.traced();
  const bool textured = f.constant(shared::SPEC_TEXTURES) != 0;
  return {"materials",
          !one       ? "left out"
          : textured ? "one texture"
                     : "one albedo, a parameter",
          one           ? "all meshes agree"
          : !f.traced() ? "no ray is traced"
                        : fmt::format("{} shows none", shownBy(f)),
          "1 load a hit and light", bytes};
}

Line textures(const Facts& f) {
  const std::uint32_t kinds = f.constant(shared::SPEC_TEXTURES);
  if (kinds == 0) return {"textures", "left out", "no texture is shown", "the loads of a hit", 0};
  const char* names[] = {"", "checkers", "pictures", "checkers and pictures"};
  return {"textures", names[kinds], countOf(f.data.textures.size(), "mesh", "meshes"),
          kinds == 3 ? "" : "the other kind", 0};
}

Line pictures(const Facts& f) {
  const std::uint32_t kinds = f.constant(shared::SPEC_IMAGES);
  if (kinds == 0) return {"pictures", "left out", "no texture and no background has one", "", 0};
  const char* names[] = {"", "of 8 bits", "of floats", "of 8 bits and of floats"};
  return {"pictures", names[kinds],
          countOf(f.data.images.size() * sizeof(f.data.images[0]), "byte") + " with their tables",
          kinds == 3 ? "" : "the other kind", 0};
}

Line background(const Facts& f) {
  switch (f.constant(shared::SPEC_BACKGROUND)) {
    case shared::BACKGROUND_BLACK:
      return {"background", "black",
              f.scene.environment ? fmt::format("{} shows none", shownBy(f)) : "the scene has none",
              "", 0};
    case shared::BACKGROUND_CONSTANT:
      return {"background", "one radiance", "it has no picture", "a direction's place in one", 0};
    default:
      return {"background", "a picture", "the scene's environment", "", 0};
  }
}

Line uvs(const Facts& f) {
  if (f.constant(shared::SPEC_TEXTURES) != 0)
    return {"texture coordinates", countOf(f.data.uvs.size() / 3, "triangle"),
            "those that show a texture", "", 0};
  return {"texture coordinates", "left out", "no texture reads them", "",
          f.uvs * 2 * sizeof(float)};
}

Line indices(const Facts& f) {
  const bool any = f.constant(shared::SPEC_NORMALS) != 0 || f.constant(shared::SPEC_ALBEDOS) != 0;
  if (!any) return {"indices", "left out", "there is nothing to point into", "", 0};
  const std::uint32_t bytes = f.constant(shared::SPEC_INDEX_BYTES);
  const std::uint64_t wide =
      indexBytesOf(f, generalise(f.data.constants, 1U << shared::SPEC_INDEX_BYTES));
  return {"indices", fmt::format("{} bits", bytes * 8),
          fmt::format("the largest is {}",
                      f.constant(shared::SPEC_NORMALS) != 0
                          ? std::max<std::uint64_t>(f.normals, f.scene.meshes.size())
                          : f.scene.meshes.size() - 1),
          "", wide - indexBytesOf(f, f.data.constants)};
}

Line lights(const Facts& f) {
  const std::size_t lights = f.scene.lights.size();
  switch (f.constant(shared::SPEC_LIGHTS)) {
    case shared::LIGHTS_NONE:
      return {"lights", "left out",
              lights == 0 ? "the scene has none"
                          : fmt::format("{} shows none", f.scene.integrator.row->name),
              "no shadow ray is traced", lights * sizeof(shared::Light)};
    case shared::LIGHTS_FEW:
      return {"lights", countOf(lights, "light") + " in one dispatch",
              fmt::format("{} or fewer", shared::LIGHTS_A_DISPATCH),
              "reading back what earlier dispatches summed", 0};
    default:
      return {"lights",
              fmt::format("{} in {} dispatches", countOf(lights, "light"),
                          (lights + shared::LIGHTS_A_DISPATCH - 1) / shared::LIGHTS_A_DISPATCH),
              fmt::format("more than {}", shared::LIGHTS_A_DISPATCH), "", 0};
  }
}

Line shadowRays(const Facts& f) {
  if (f.constant(shared::SPEC_LIGHTS) == shared::LIGHTS_NONE)
    return {"shadow rays", "none", "no light is shown", "", 0};
  return {"shadow rays", "where n.l > 0 and n.v > 0", "elsewhere no light arrives",
          "those of surfaces that face away", 0};
}

Line sampler(const Facts& f) {
  return {"sampler", f.scene.sampler.row->name,
          countOf(f.scene.sampler.sampleCount, "sample") + " a pixel", "the other samplers", 0};
}

Line samplerTables(const Facts& f) {
  if (!f.scene.sampler.row->stream)
    return {"sampler tables", "none", "positions are hashed, not drawn from a stream", "", 0};
  const std::uint32_t levels = f.constant(shared::SPEC_JUMP_LEVELS);
  return {"sampler tables", fmt::format("{} of 3", levels),
          countOf(f.scene.sampler.sampleCount, "sample") + " a pixel",
          levels == 3 ? "" : countOf(3 - levels, "jump") + " a sample", 0};
}

Line filter(const Facts& f) {
  const char* names[] = {"gaussian, an exponential a weight", "Mitchell", "tent", "box",
                         "gaussian, weights by products"};
  const std::uint32_t apron = f.constant(shared::SPEC_APRON);
  return {
      "filter",
      fmt::format("{}, {} x {} pixels",
                  f.constant(shared::SPEC_NORI_TABLE) != 0 ? "Nori's table"
                                                           : names[f.constant(shared::SPEC_FILTER)],
                  2 * apron + 1, 2 * apron + 1),
      fmt::format("its radius is {:g}", f.scene.filter.radius),
      "the other filters, and pixels out of reach", 0};
}

}  // namespace

std::string countOf(std::uint64_t n, const char* one, const char* more) {
  const std::string plural = more == nullptr ? std::string(one) + 's' : more;
  return fmt::format("{} {}", n, n == 1 ? one : plural);
}

std::vector<Line> sceneLines(const Facts& f) {
  return {rays(f),       tree(f),     stack(f),         spheres(f), normals(f), materials(f),
          textures(f),   pictures(f), background(f),    uvs(f),     indices(f), lights(f),
          shadowRays(f), sampler(f),  samplerTables(f), filter(f)};
}

}  // namespace laver
