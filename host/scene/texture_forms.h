#pragma once
#include <string>
#include <vector>

#include "scene/properties.h"
#include "scene/textures.h"

// What the rows of textures share.
namespace laver {

namespace textures {
extern const TextureRow constant, stripes, noise, uv, nearest;
}  // namespace textures

namespace xml {

/// `rows`, followed by laver's own properties of the place: scalex, scaley, offsetx, offsety.
std::vector<PropertyRow> placed(std::vector<PropertyRow> rows);
/// Sets the place by these properties.
Texture placed(Texture texture, const Properties& given);

/// Gives the texture to the property of the last mesh's material or light that draft.textured
/// names. A normal map's pictures are linear.
void addTexture(const Properties& given, Texture texture, Draft& draft);

/// Properties of two numbers.
PropertyRow pairOf(const char* name, PropertyType type, double start, const char* meaning);
glm::dvec2 pairIn(const Properties& given, std::string_view name);
/// The factors of uv that `scale` means where it divides them.
glm::dvec2 inverseScale(const Properties& given);

}  // namespace xml
}  // namespace laver
