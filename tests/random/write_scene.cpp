#include <fmt/format.h>

#include <fstream>
#include <numbers>

#include "random/shrink.h"
#include "scene/texture_forms.h"

namespace laver::test {
namespace {

std::string triple(glm::dvec3 v) { return fmt::format("{}, {}, {}", v.x, v.y, v.z); }

std::string tag(const char* type, std::string_view name, const std::string& value) {
  return fmt::format("    <{} name=\"{}\" value=\"{}\"/>\n", type, name, value);
}

std::string real(std::string_view name, double value) {
  return tag("float", name, fmt::format("{}", value));
}

std::string integer(std::string_view name, std::int64_t value) {
  return tag("integer", name, std::to_string(value));
}

std::string matrix(const glm::dmat4& m) {
  std::string values;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) values += fmt::format("{} ", m[column][row]);
  values.pop_back();
  return fmt::format("    <transform name=\"toWorld\"><matrix value=\"{}\"/></transform>\n",
                     values);
}

std::string property(const PropertyRow& row, const Value& value) {
  const char* const types[] = {"string", "boolean", "float", "integer",
                               "vector", "point",   "color", "transform"};
  return tag(types[static_cast<std::size_t>(row.type)], row.name, textOf(value));
}

std::string properties(const std::vector<PropertyRow>& rows, const Values& given) {
  std::string text;
  for (const PropertyRow& row : rows)
    for (const NamedValue& value : given)
      if (row.isCalled(value.name)) text += property(row, value.value);
  return text;
}

std::string open(const char* tag, const char* type) {
  return fmt::format("  <{} type=\"{}\">\n", tag, type);
}

std::string element(const char* tag, const char* type, const std::string& inside) {
  return open(tag, type) + inside + fmt::format("  </{}>\n", tag);
}

std::string textureText(const std::string& name, const Texture& t) {
  const auto texture = [&](const char* type, const std::string& inside) {
    return fmt::format("  <texture type=\"{}\" name=\"{}\">\n{}  </texture>\n", type, name, inside);
  };
  if (t.row == &textures::uv) return texture("uvtexture", "");
  if (t.row == &textures::constant)
    return texture("constant_color", tag("color", "value", triple(t.colors[0])));
  const std::string colors =
      tag("color", "color1", triple(t.colors[0])) + tag("color", "color2", triple(t.colors[1]));
  if (t.row == &textures::checker)
    return texture("checker", colors + real("scalex", t.scale.x) + real("scaley", t.scale.y) +
                                  real("offsetx", t.offset.x) + real("offsety", t.offset.y));
  // A scale of 0 in v, which stripes ignore, has no reciprocal.
  const double v = t.scale.y == 0.0 ? 1.0 : 1.0 / t.scale.y;
  return texture("proceduraltexture",
                 colors + tag("vector", "scale", triple({1.0 / t.scale.x, v, 0.0})) +
                     tag("point", "delta", triple({-t.offset.x, -t.offset.y, 0.0})));
}

std::string lightText(const PointLight& light) {
  const std::string at = tag("point", "position", triple(light.position));
  const std::string axis = tag("vector", "direction", triple(light.axis));
  if (light.row == &emitters::point)
    return element("emitter", "pointlight", at + tag("color", "radiance", triple(light.radiance)));
  if (light.row == &emitters::directional)
    return element("emitter", "directional",
                   axis + tag("color", "radiance", triple(light.radiance)));
  // Other falls are written as one of these.
  const bool linear = light.falloff == Falloff::Angle;
  return element("emitter", "spotlight",
                 at + axis +
                     tag("color", linear ? "color" : "power",
                         triple(light.radiance * (4.0 * std::numbers::pi))) +
                     real("cosTotalWidth", light.outer) + real("cosFalloffStart", light.inner));
}

void writeObj(const Mesh& mesh, const std::string& file) {
  std::ofstream out(file);
  for (const glm::dvec3& p : mesh.positions) out << fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (const glm::dvec2& p : mesh.uvs) out << fmt::format("vt {} {}\n", p.x, p.y);
  for (const glm::dvec3& p : mesh.normals) out << fmt::format("vn {} {} {}\n", p.x, p.y, p.z);
  const bool uv = !mesh.uvs.empty(), normal = !mesh.normals.empty();
  for (const glm::uvec3& t : mesh.triangles) {
    out << 'f';
    for (int i = 0; i < 3; ++i) {
      out << fmt::format(" {}", t[i] + 1);
      if (uv || normal) out << '/' << (uv ? std::to_string(t[i] + 1) : "");
      if (normal) out << '/' << t[i] + 1;
    }
    out << '\n';
  }
}

std::string meshText(const Mesh& mesh, const std::string& name) {
  std::string inside;
  if (mesh.sphere)
    inside =
        tag("point", "center", triple(mesh.sphere->centre)) + real("radius", mesh.sphere->radius);
  else
    inside = tag("string", "filename", name);
  std::string bsdf = properties(mesh.bsdf.row->properties, mesh.bsdf.values);
  for (const NamedTexture& named : mesh.bsdf.textures)
    bsdf += textureText(named.property == kNormalMap ? "normal" : named.property, named.texture);
  inside += element("bsdf", mesh.bsdf.row->name, bsdf);
  if (mesh.light)
    inside += element("emitter", "area",
                      mesh.light->texture ? textureText("radiance", *mesh.light->texture)
                                          : tag("color", "radiance", triple(mesh.light->radiance)));
  return element("mesh", mesh.sphere ? "sphere" : "obj", inside);
}

std::string cameraText(const Camera& camera, const std::string& filter) {
  std::string inside = matrix(camera.toWorld) + integer("width", camera.width) +
                       integer("height", camera.height) + real("fov", camera.fov) +
                       real("nearClip", camera.nearClip) + real("farClip", camera.farClip);
  if (camera.row->lens)
    inside +=
        real("aperture_radius", camera.lensRadius) + real("focus_distance", camera.focalDistance);
  return element("camera", camera.row->name, inside + filter);
}

std::string filterText(const Filter& filter) {
  std::string inside;
  for (std::size_t i = 0; i < filter.row->members.size(); ++i)
    inside += real(filter.row->properties[i].name, filter.*filter.row->members[i]);
  return element("rfilter", filter.row->name, inside);
}

std::string skyText(const Environment& sky) {
  const std::string radiance = tag("color", "radiance", triple(sky.radiance));
  if (sky.row != &emitters::distantdisk) return element("emitter", sky.row->name, radiance);
  return element("emitter", "distantdisk",
                 radiance + real("thetaA", sky.angle) + matrix(sky.toWorld));
}

}  // namespace

void writeScene(const Scene& scene, const std::string& folder) {
  std::string text = "<scene>\n";
  text += element("integrator", scene.integrator.row->name,
                  properties(scene.integrator.row->properties, scene.integrator.values));
  text += element(
      "sampler", scene.sampler.row->name,
      integer("sampleCount", scene.sampler.sampleCount) + integer("seed", scene.sampler.seed));
  text += cameraText(scene.camera, filterText(scene.filter));
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const std::string name = fmt::format("mesh{}.obj", i);
    if (!scene.meshes[i].sphere) writeObj(scene.meshes[i], folder + "/" + name);
    text += meshText(scene.meshes[i], name);
  }
  for (const PointLight& light : scene.lights) text += lightText(light);
  if (scene.environment) text += skyText(*scene.environment);
  std::ofstream(folder + "/scene.xml") << text + "</scene>\n";
}

}  // namespace laver::test
