#include "kernels/compose.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/error.h"
#include "kernels/text.h"

namespace laver {
namespace {

void extensions(Text& text, bool subgroups) {
  text.line("#version 460");
  text.line("#extension GL_GOOGLE_cpp_style_line_directive : require");
  text.line("#extension GL_EXT_control_flow_attributes : require");
  text.line("#extension GL_EXT_samplerless_texture_functions : require");
  if (!subgroups) return;
  text.line("#extension GL_KHR_shader_subgroup_basic : require");
  text.line("#extension GL_KHR_shader_subgroup_shuffle : require");
  text.line("#extension GL_ARB_gpu_shader_int64 : require");
}

std::uint32_t raysPerInvocation(Traversal traversal) {
  switch (traversal) {
    case Traversal::Packet32:
      return 4;
    case Traversal::Packet64:
      return 8;
    case Traversal::Lane:
      break;
  }
  return 1;
}

void traceConstants(const TraceKey& key, Text& text) {
  text.number("R", raysPerInvocation(key.traversal));
  text.flag("SHARES_TESTS", key.traversal == Traversal::Packet32);
  text.number("STACK", key.stack);
  text.number("APRON", 0);
  text.number("JUMP_LEVELS", key.jumpLevels);
  text.flag("HAS_HITS", key.hits);
  text.flag("HAS_NORMALS", key.normals);
  text.flag("HAS_MATERIALS", key.materials);
  text.flag("HAS_SPHERES", key.spheres);
  text.flag("BOUNCES", key.bounces);
  text.flag("HAS_CAPS", key.caps);
  text.flag("HAS_FAR_PARTS", key.farParts);
  text.flag("HAS_SLIVERS", key.slivers);
  text.flag("FAR_CAMERA", key.farCamera);
  text.flag("WALKS_PORTIONS", key.portions);
  text.flag("HAS_LIGHTS", key.lights);
  text.flag("HAS_SHAPED_LIGHTS", key.shapedLights);
  text.flag("MANY_LIGHTS", key.manyLights);
  text.flag("HAS_EMISSION", key.emission);
  text.flag("HAS_BACKGROUND", key.background != "none");
  text.flag("HAS_BYTE_IMAGES", key.byteImages);
  text.flag("HAS_FLOAT_IMAGES", key.floatImages);
  text.flag("ADAPTIVE", key.adaptive);
  text.flag("SIGNED", key.signedValues);
  text.flag("CENTRES", key.integrator == "centres");
}

/// Materials and emitters.
void shading(const TraceKey& key, Text& text) {
  text.append(materialText(key));
  text.include("emitter/point.glsl");
  text.include("emitter/shaped.glsl");
  text.line("#include \"emitter/{}.glsl\"", key.background);
}

/// Defines each property of the integrator as `xml_NAME`: a constant if the key holds its value,
/// else one or three components of params.properties.
void properties(const TraceKey& key, Text& text) {
  std::size_t used = 0;
  const auto component = [&] {
    const std::size_t i = used++;
    return fmt::format("params.properties[{}][{}]", i / 4, i % 4);
  };
  for (const KernelProperty& p : key.properties) {
    if (!p.value.empty()) {
      text.line("const {} xml_{} = {};", p.type, p.name, p.value);
    } else if (p.type == "vec3") {
      const std::string x = component(), y = component(), z = component();
      text.line("#define xml_{} vec3({}, {}, {})", p.name, x, y, z);
    } else {
      text.line("#define xml_{} {}", p.name, component());
    }
  }
}

/// Parses `#line N "FILE"`: sets `name` and returns the number of the directive's own line.
std::size_t takeLine(std::string_view line, std::string& name) {
  const std::size_t quote = line.find('"');
  name = std::string(line.substr(quote + 1, line.rfind('"') - quote - 1));
  return std::stoul(std::string(line.substr(6, quote - 6))) - 1;
}

/// Appends `text` with its includes expanded; `seen` holds the files that `out` has already.
void expand(std::string_view text, std::string name, std::set<std::string>& seen,
            std::string& out) {
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (line.starts_with("#line ")) number = takeLine(line, name);
    constexpr std::string_view kInclude = "#include \"";
    if (!line.starts_with(kInclude)) {
      out += line;
      out += '\n';
      continue;
    }
    const std::string_view rest = line.substr(kInclude.size());
    const std::string path(rest.substr(0, rest.find('"')));
    if (shaderText(path).empty())
      throw Error(ExitCode::Scene, fmt::format("{}:{}: error: laver has no file \"{}\" to include",
                                               name, number, path));
    if (seen.insert(path).second) {
      out += fmt::format("#line 1 \"{}\"\n", path);
      expand(shaderText(path), path, seen, out);
      out += fmt::format("#line {} \"{}\"\n", number + 1, name);
    } else {
      out += '\n';
    }
  }
}

std::string traceText(const TraceKey& key, std::string_view main) {
  Text text;
  const bool packet = isPacket(key.traversal);
  extensions(text, packet || key.lockstep);
  traceConstants(key, text);
  text.include(packet ? "film/stored_longs.glsl" : "film/stored_floats.glsl");
  text.include(key.storageTexels ? "texels_in_storage.glsl" : "texel_buffers.glsl");
  text.include("resources.glsl");
  text.include("trace/rays.glsl");
  text.include(packet || key.lockstep ? "trace/any_of_subgroup.glsl" : "trace/any_of_lane.glsl");
  text.include(packet         ? "trace/packet.glsl"
               : key.portions ? "trace/portions.glsl"
                              : "trace/lane.glsl");
  text.append(main);
  return expandIncludes(text.str(), "kernel");
}

}  // namespace

const char* traversalName(Traversal traversal) {
  switch (traversal) {
    case Traversal::Packet32:
      return "packet32";
    case Traversal::Packet64:
      return "packet64";
    case Traversal::Lane:
      break;
  }
  return "lane";
}

bool isPacket(Traversal traversal) { return traversal != Traversal::Lane; }

std::string expandIncludes(std::string_view text, const std::string& name) {
  std::set<std::string> seen;
  std::string out;
  out.reserve(1 << 17);
  expand(text, name, seen, out);
  return out;
}

std::string composeWith(const TraceKey& key, std::string_view main) { return traceText(key, main); }

std::string compose(const TraceKey& key) {
  Text text;
  text.line("#include \"camera/{}.glsl\"", key.camera);
  text.line("#include \"sampler/{}.glsl\"", key.sampler);
  text.include("trace/camera_rays.glsl");
  if (key.bsdfs.empty())
    text.include("trace/surface.glsl");
  else
    shading(key, text);
  properties(key, text);
  if (!key.userFile.empty()) {
    text.user(key.userFile, key.userText);
  } else if (key.integrator == "centres") {
    text.include("film/centres.glsl");
  } else {
    text.line("#include \"integrators/{}.glsl\"", key.integrator);
  }
  text.include("trace/main.glsl");
  return traceText(key, text.str());
}

std::string compose(const GatherKey& key) {
  Text text;
  extensions(text, key.strips);
  text.number("APRON", key.apron);
  text.flag("ADAPTIVE", key.adaptive);
  text.include("film/stored_floats.glsl");
  text.include(key.storageTexels ? "texels_in_storage.glsl" : "texel_buffers.glsl");
  text.include("resources.glsl");
  text.line("#include \"filter/{}.glsl\"", key.filter);
  text.include(key.strips ? "film/gather_strip.glsl" : "film/gather_lane.glsl");
  text.include("film/gather.glsl");
  return expandIncludes(text.str(), "kernel");
}

}  // namespace laver
