#include "render/materials.h"

#include <algorithm>

#include "shared/layout.h"

namespace laver {
namespace {

std::vector<std::string> namesOf(const BsdfRow& row, PropertyType type) {
  std::vector<std::string> names;
  for (const PropertyRow* property : propertiesOf(row, type)) names.emplace_back(property->name);
  return names;
}

BsdfText bsdfText(const Bsdf& bsdf) {
  const BsdfRow& row = *bsdf.row;
  BsdfText text{.name = row.name,
                .colors = namesOf(row, PropertyType::Color),
                .numbers = namesOf(row, PropertyType::Float)};
  if (bsdf.user) {
    text.file = bsdf.user->file;
    text.text = bsdf.user->text;
  }
  return text;
}

/// Bits of the properties for which textures stand.
std::uint32_t texturedOf(const Bsdf& bsdf, PropertyType type) {
  std::uint32_t bits = 0, i = 0;
  for (const PropertyRow* property : propertiesOf(*bsdf.row, type)) {
    const Texture* texture = bsdf.texture(property->name);
    if (texture != nullptr && shows(*texture)) bits |= 1U << i;
    ++i;
  }
  return bits;
}

std::uint32_t wordOf(double x) { return shared::floatBitsToUint(static_cast<float>(x)); }

void alignToTexel(std::vector<std::uint32_t>& words) { words.resize((words.size() + 3) / 4 * 4); }

}  // namespace

std::vector<BsdfText> bsdfsOf(const Scene& scene) {
  std::vector<BsdfText> texts;
  for (const Mesh& mesh : scene.meshes)
    if (std::none_of(texts.begin(), texts.end(),
                     [&](const BsdfText& text) { return text.name == mesh.bsdf.row->name; }))
      texts.push_back(bsdfText(mesh.bsdf));
  if (texts.empty()) texts.push_back(bsdfText({}));
  std::sort(texts.begin(), texts.end(),
            [](const BsdfText& a, const BsdfText& b) { return a.name < b.name; });
  return texts;
}

std::vector<std::string> texturesOf(const Scene& scene) {
  std::vector<std::string> names;
  for (const Mesh& mesh : scene.meshes)
    for (const Texture* texture : texturesOf(mesh)) names.emplace_back(texture->row->name);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::vector<std::string> allTextureNames() {
  std::vector<std::string> names;
  for (const TextureRow* row : textureRows()) names.emplace_back(row->name);
  std::sort(names.begin(), names.end());
  return names;
}

MaterialLayout layoutOf(const Scene& scene) {
  MaterialLayout layout;
  for (const Mesh& mesh : scene.meshes) {
    const auto count = [&](PropertyType type) {
      return static_cast<std::uint32_t>(propertiesOf(*mesh.bsdf.row, type).size());
    };
    layout.colors = std::max(layout.colors, count(PropertyType::Color));
    layout.numbers = std::max(layout.numbers, count(PropertyType::Float));
    layout.texturedColors |= texturedOf(mesh.bsdf, PropertyType::Color);
    layout.texturedNumbers |= texturedOf(mesh.bsdf, PropertyType::Float);
    const Texture* map = mesh.bsdf.texture(kNormalMap);
    layout.normalMaps |= map != nullptr && shows(*map);
    layout.tangents |= usesTangent(mesh.bsdf);
  }
  return layout;
}

bool shows(const Texture& texture) { return !texture.row->picture || texture.image; }

std::vector<const Texture*> texturesOf(const Mesh& mesh) {
  std::vector<const Texture*> textures;
  for (const NamedTexture& named : mesh.bsdf.textures)
    if (shows(named.texture)) textures.push_back(&named.texture);
  if (mesh.light && mesh.light->texture && shows(*mesh.light->texture))
    textures.push_back(mesh.light->texture.get());
  return textures;
}

bool hasTextures(const Mesh& mesh) { return !texturesOf(mesh).empty(); }

bool alike(const Mesh& a, const Mesh& b) {
  return a.bsdf.row == b.bsdf.row && colorsOf(a.bsdf) == colorsOf(b.bsdf) &&
         numbersOf(a.bsdf) == numbersOf(b.bsdf);
}

glm::dvec3 albedoOf(const Mesh& mesh) {
  const PropertyRow* property = albedoOf(*mesh.bsdf.row);
  return property != nullptr ? mesh.bsdf.color(property->name) : glm::dvec3(1.0);
}

std::vector<std::uint32_t> recordOf(const Bsdf& bsdf, const MaterialLayout& layout,
                                    const std::vector<BsdfText>& bsdfs,
                                    const std::function<std::uint32_t(const Texture&)>& placeOf,
                                    std::uint32_t uvs) {
  std::vector<glm::dvec3> colors = colorsOf(bsdf);
  std::vector<double> numbers = numbersOf(bsdf);
  colors.resize(layout.colors, glm::dvec3(1.0));
  numbers.resize(layout.numbers, 0.0);
  std::vector<std::uint32_t> words;
  for (const glm::dvec3& color : colors)
    words.insert(words.end(), {wordOf(color.x), wordOf(color.y), wordOf(color.z), 0U});
  const auto place = std::find_if(bsdfs.begin(), bsdfs.end(), [&](const BsdfText& text) {
    return text.name == bsdf.row->name;
  });
  words[3] = static_cast<std::uint32_t>(place - bsdfs.begin());
  for (const double number : numbers) words.push_back(wordOf(number));
  alignToTexel(words);
  const auto refer = [&](PropertyType type, std::uint32_t textured) {
    const auto properties = propertiesOf(*bsdf.row, type);
    for (std::uint32_t i = 0; i < 32; ++i) {
      if ((textured >> i & 1U) == 0) continue;
      const Texture* texture = i < properties.size() ? bsdf.texture(properties[i]->name) : nullptr;
      words.push_back(texture != nullptr && shows(*texture) ? placeOf(*texture) + 1
                                                            : shared::TEXTURE_NONE);
    }
  };
  refer(PropertyType::Color, layout.texturedColors);
  refer(PropertyType::Float, layout.texturedNumbers);
  alignToTexel(words);
  if (layout.frames()) {
    const Texture* map = bsdf.texture(kNormalMap);
    words.push_back(map != nullptr && shows(*map) ? placeOf(*map) + 1 : shared::TEXTURE_NONE);
    words.push_back(uvs);
    words.push_back(usesTangent(bsdf) ? 1 : 0);
    alignToTexel(words);
  }
  return words;
}

}  // namespace laver
