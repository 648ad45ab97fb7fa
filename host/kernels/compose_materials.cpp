#include <bit>

#include "kernels/compose.h"
#include "kernels/text.h"

namespace laver {
namespace {

/// Components of a texel.
constexpr const char* kWord[] = {"x", "y", "z", "w"};

/// The member of Material that holds the i-th colour or number.
std::string colorMember(std::size_t i) { return i == 0 ? "albedo" : fmt::format("color{}", i); }
std::string numberMember(std::size_t i) { return fmt::format("number{}", i); }

void materialStruct(const MaterialLayout& layout, Text& text) {
  text.line("struct Material {{");
  text.line("  uint bsdf;");
  text.line("  vec3 tangent;  // any length");
  for (std::uint32_t i = 0; i < layout.colors; ++i) text.line("  vec3 {};", colorMember(i));
  for (std::uint32_t i = 0; i < layout.numbers; ++i) text.line("  float {};", numberMember(i));
  text.line("}};");
}

/// A function that calls NAME + suffix of the one of `names` that `which` says; the last of them
/// where it says none.
void dispatch(Text& text, const std::vector<std::string>& names, const char* suffix,
              const char* head, const char* which, const char* arguments) {
  text.line("{} {{", head);
  for (std::size_t i = 0; i + 1 < names.size(); ++i)
    text.line("  if ({} == {}u) return {}{}({});", which, i, names[i], suffix, arguments);
  text.line("  return {}{}({});", names.back(), suffix, arguments);
  text.line("}}");
}

void textures(const TraceKey& key, Text& text) {
  if (key.textures.empty()) return;
  text.include("texture/record.glsl");
  for (const std::string& texture : key.textures)
    text.line("#include \"texture/{}.glsl\"", texture);
  dispatch(text, key.textures, "Texture",
           "vec3 textureColour(uint which, TextureRecord t, vec2 st)", "which", "t, st");
  text.include("texture/textured.glsl");
}

/// Reads texel after texel of a record, and word after word of those that hold four numbers.
class RecordText {
 public:
  RecordText(Text& text, std::uint32_t texels) : text_(text) {
    text.line("  const int texel = int(s.material * {}u);", texels);
  }
  /// A texel with a name of its own.
  std::string texel() {
    text_.line("  const uvec4 texel{0} = texelFetch(materialTexels, texel + {0});", next_);
    words_ = 4;
    return fmt::format("texel{}", next_++);
  }
  std::string word() {
    if (words_ == 4) {
      last_ = texel();
      words_ = 0;
    }
    return last_ + '.' + kWord[words_++];
  }
  /// What follows begins a texel.
  void align() { words_ = 4; }

 private:
  Text& text_;
  std::string last_;
  int next_ = 0, words_ = 4;
};

void readRecord(const TraceKey& key, Text& text) {
  const MaterialLayout& layout = key.layout;
  RecordText record(text, layout.texels());
  for (std::uint32_t i = 0; i < layout.colors; ++i) {
    const std::string texel = record.texel();
    text.line("  m.{} = texelVec3({});", colorMember(i), texel);
    if (i == 0 && key.bsdfRecords) text.line("  m.bsdf = {}.w;", texel);
  }
  record.align();
  for (std::uint32_t i = 0; i < layout.numbers; ++i) {
    const std::string word = record.word();
    text.line("  m.{} = uintBitsToFloat({});", numberMember(i), word);
  }
  if (key.textures.empty()) return;
  record.align();
  const auto show = [&](const std::string& member, const char* as) {
    const std::string word = record.word();
    text.line("  if ({0} != TEXTURE_NONE) m.{1} = {2}(textureAt({0} - 1u, s.id, s.weights));", word,
              member, as);
  };
  for (std::uint32_t i = 0; i < layout.colors; ++i)
    if (layout.texturedColors >> i & 1U) show(colorMember(i), "");
  for (std::uint32_t i = 0; i < layout.numbers; ++i)
    if (layout.texturedNumbers >> i & 1U) show(numberMember(i), "luminanceOf");
}

/// The normal for BSDFs: the surface's own, or that of its mesh's normal map, whose reference is
/// the last texel of a record.
void bsdfNormal(const TraceKey& key, Text& text) {
  if (key.layout.normalMaps && !key.textures.empty()) text.include("texture/normal_map.glsl");
  text.line("vec3 bsdfNormal(Surface s) {{");
  if (key.layout.normalMaps && !key.textures.empty()) {
    text.line("  const uint map = texelFetch(materialTexels, int(s.material * {0}u) + {1}).x;",
              key.layout.texels(), key.layout.texels() - 1);
    text.line("  if (map != TEXTURE_NONE) return mappedNormal(s, map - 1u);");
  }
  text.line("  return s.normal;");
  text.line("}}");
}

/// The radiance that a mesh emits at a point of a primitive.
void radianceOf(const TraceKey& key, Text& text) {
  text.line("vec3 radianceOf(uint mesh, uint id, vec3 weights) {{");
  text.line("  const vec3 radiance = texelVec3(texelFetch(emissionTexels, int(mesh) * 2));");
  if (key.texturedLights) {
    text.line("  const uint shown = texelFetch(emissionTexels, int(mesh) * 2 + 1).x;");
    text.line("  if (shown != TEXTURE_NONE) return radiance * textureAt(shown - 1u, id, weights);");
  }
  text.line("  return radiance;");
  text.line("}}");
}

void materialOf(const TraceKey& key, Text& text) {
  text.line("Material materialOf(Surface s) {{");
  text.line("  Material m;");
  text.line("  m.bsdf = 0u;");
  text.line("  m.tangent = vec3(0.0);");
  if (key.materials || key.bsdfRecords) {
    readRecord(key, text);
    if (key.layout.tangents) {
      const std::uint32_t texels = key.layout.texels();
      text.line("  const uvec4 frame = texelFetch(materialTexels, int(s.material * {0}u) + {1});",
                texels, texels - 1);
      text.line("  if (frame.z != 0u) m.tangent = alongU(s, 3u * (s.id + frame.y));");
    }
  } else {
    text.line("  m.albedo = params.albedo;");
  }
  text.line("  return m;");
  text.line("}}");
}

/// A BSDF, whose properties have their names while its text lasts.
void bsdf(const BsdfText& b, Text& text) {
  const auto define = [&](const std::vector<std::string>& names,
                          std::string (*member)(std::size_t)) {
    for (std::size_t i = 0; i < names.size(); ++i)
      text.line("#define xml_{} m.{}", names[i], member(i));
  };
  define(b.colors, colorMember);
  define(b.numbers, numberMember);
  if (b.file.empty())
    text.line("#include \"bsdf/{}.glsl\"", b.name);
  else
    text.user(b.file, b.text);
  for (const auto* names : {&b.colors, &b.numbers})
    for (const std::string& name : *names) text.line("#undef xml_{}", name);
}

}  // namespace

std::uint32_t MaterialLayout::texels() const {
  const auto references =
      static_cast<std::uint32_t>(std::popcount(texturedColors) + std::popcount(texturedNumbers));
  return colors + (numbers + 3) / 4 + (references + 3) / 4 + (frames() ? 1U : 0U);
}

std::string materialText(const TraceKey& key) {
  Text text;
  text.include("bsdf/material.glsl");
  materialStruct(key.layout, text);
  textures(key, text);
  text.flag("HAS_TANGENTS", key.layout.tangents);
  if (key.layout.tangents) text.include("texture/along_u.glsl");
  materialOf(key, text);
  bsdfNormal(key, text);
  radianceOf(key, text);
  std::vector<std::string> names;
  for (const BsdfText& b : key.bsdfs) {
    bsdf(b, text);
    names.push_back(b.name);
  }
  dispatch(text, names, "Eval",
           "vec3 evalBsdf(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light)", "m.bsdf",
           "m, normal, wi, wo, light");
  dispatch(text, names, "Pdf", "float pdfBsdf(Material m, vec3 normal, vec3 wi, vec3 wo)", "m.bsdf",
           "m, normal, wi, wo");
  dispatch(text, names, "Sample",
           "vec3 sampleBsdf(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo)", "m.bsdf",
           "m, normal, wi, numbers, wo");
  return text.str();
}

}  // namespace laver
