#include "kernels/compose.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/error.h"

namespace laver {
namespace {

/// Collects lines of GLSL.
class Text {
 public:
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    text_ += fmt::format(format, std::forward<Args>(args)...);
    text_ += '\n';
  }
  void flag(const char* name, bool value) { line("const bool {} = {};", name, value); }
  void number(const char* name, std::uint32_t value) { line("const uint {} = {}u;", name, value); }
  void include(std::string_view path) { line("#include \"{}\"", path); }
  void append(std::string_view text) { text_ += text; }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

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
  text.flag("HAS_LIGHTS", key.lights);
  text.flag("MANY_LIGHTS", key.manyLights);
  text.flag("HAS_EMISSION", key.emission);
  text.flag("HAS_SOURCES", key.sources);
  text.flag("HAS_BACKGROUND", key.background != "none");
  text.flag("HAS_BSDF_RECORDS", key.bsdfRecords);
  text.flag("HAS_BYTE_IMAGES", key.byteImages);
  text.flag("HAS_FLOAT_IMAGES", key.floatImages);
  text.flag("ADAPTIVE", key.adaptive);
  text.flag("SIGNED", key.signedValues);
  text.flag("CENTRES", key.integrator == "centres");
}

/// Writes a function that calls NAME + suffix for the NAME of index `which` in `names`, the last
/// for any larger index.
void dispatch(Text& text, const std::vector<std::string>& names, const char* suffix,
              const char* head, const char* which, const char* arguments) {
  text.line("{} {{", head);
  for (std::size_t i = 0; i + 1 < names.size(); ++i)
    text.line("  if ({} == {}u) return {}{}({});", which, i, names[i], suffix, arguments);
  text.line("  return {}{}({});", names.back(), suffix, arguments);
  text.line("}}");
}

/// A user's text, with #line so that errors show the user's file and line.
void userText(const std::string& file, const std::string& source, Text& text) {
  text.line("#line 1 \"{}\"", file);
  text.append(source);
  text.line("");
}

/// A user's BSDF. Its numbers are named xml_NAME within its text.
void userBsdf(const UserBsdfText& bsdf, Text& text) {
  const char* components[] = {"x", "y", "z", "w"};
  for (std::size_t i = 0; i < bsdf.numbers.size(); ++i)
    text.line("#define xml_{} m.numbers.{}", bsdf.numbers[i], components[i]);
  userText(bsdf.file, bsdf.text, text);
  for (const std::string& number : bsdf.numbers) text.line("#undef xml_{}", number);
}

/// Materials and emitters.
void shading(const TraceKey& key, Text& text) {
  if (key.textures.empty()) {
    text.include("texture/plain.glsl");
  } else {
    text.include("texture/record.glsl");
    for (const std::string& texture : key.textures)
      text.line("#include \"texture/{}.glsl\"", texture);
    dispatch(text, key.textures, "Texture",
             "vec3 textureColour(uint which, TextureRecord t, vec2 st)", "which", "t, st");
    text.include("texture/textured.glsl");
  }
  text.include("bsdf/material.glsl");
  for (const std::string& bsdf : key.bsdfs) {
    const auto own = std::find_if(key.userBsdfs.begin(), key.userBsdfs.end(),
                                  [&](const UserBsdfText& u) { return u.name == bsdf; });
    if (own != key.userBsdfs.end())
      userBsdf(*own, text);
    else
      text.line("#include \"bsdf/{}.glsl\"", bsdf);
  }
  dispatch(text, key.bsdfs, "Eval",
           "vec3 evalBsdf(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light)", "m.bsdf",
           "m, normal, wi, wo, light");
  dispatch(text, key.bsdfs, "Pdf", "float pdfBsdf(Material m, vec3 normal, vec3 wi, vec3 wo)",
           "m.bsdf", "m, normal, wi, wo");
  dispatch(text, key.bsdfs, "Sample",
           "vec3 sampleBsdf(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo)", "m.bsdf",
           "m, normal, wi, numbers, wo");
  text.include("emitter/point.glsl");
  text.line("#include \"emitter/{}.glsl\"", key.background);
}

/// Defines each property of the integrator as `xml_NAME`: a constant if the key holds its value,
/// else a component of params.properties.
void properties(const TraceKey& key, Text& text) {
  const char* parameters[] = {"x", "y", "z", "w"};
  for (std::size_t i = 0; i < key.properties.size(); ++i) {
    const KernelProperty& p = key.properties[i];
    if (p.value.empty())
      text.line("#define xml_{} params.properties.{}", p.name, parameters[i]);
    else
      text.line("const {} xml_{} = {};", p.type, p.name, p.value);
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
  text.include("resources.glsl");
  text.include("trace/rays.glsl");
  text.include(packet || key.lockstep ? "trace/any_of_subgroup.glsl" : "trace/any_of_lane.glsl");
  text.include(packet ? "trace/packet.glsl" : "trace/lane.glsl");
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
    userText(key.userFile, key.userText, text);
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
  text.include("resources.glsl");
  text.line("#include \"filter/{}.glsl\"", key.filter);
  text.include(key.strips ? "film/gather_strip.glsl" : "film/gather_lane.glsl");
  text.include("film/gather.glsl");
  return expandIncludes(text.str(), "kernel");
}

}  // namespace laver
