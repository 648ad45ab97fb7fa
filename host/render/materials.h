#pragma once
#include <string>
#include <vector>

#include "render/choices.h"
#include "scene/scene.h"

// Meshes' materials as the kernels know them.
namespace laver {

/// Names of GLSL files below bsdf/ and texture/.
std::string bsdfName(const Mesh& mesh);
std::string textureName(const Texture& texture);
const std::vector<std::string>& allTextureNames();

/// Whether a texture shows more than a colour: an image that was not read shows none.
bool shows(const std::optional<Texture>& texture);

/// Whether a BSDF has numbers besides its colour.
bool hasNumbers(const Mesh& mesh);
/// Whether two meshes' records are the same.
bool alike(const Mesh& a, const Mesh& b);

glm::dvec3 albedoOf(const Mesh& mesh);
/// The record of a mesh, whose BSDF is numbered by its place in `bsdfs`.
shared::Material materialOf(const Mesh& mesh, const std::vector<std::string>& bsdfs);

}  // namespace laver
