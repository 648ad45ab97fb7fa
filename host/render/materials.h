#pragma once
#include <string>
#include <vector>

#include "render/choices.h"
#include "scene/scene.h"

// The kernels' view of meshes' materials.
namespace laver {

/// Names of GLSL files in bsdf/ and texture/.
std::string bsdfName(const Mesh& mesh);
std::string textureName(const Texture& texture);
const std::vector<std::string>& allTextureNames();

/// Whether a texture is more than a colour; an image that was not read is not.
bool isVisible(const std::optional<Texture>& texture);

/// Whether a BSDF has numbers besides its colour.
bool hasNumbers(const Mesh& mesh);
/// Whether two meshes' records are the same.
bool sameMaterial(const Mesh& a, const Mesh& b);

glm::dvec3 albedoOf(const Mesh& mesh);
/// The record of a mesh; its BSDF is an index into `bsdfs`.
shared::Material materialOf(const Mesh& mesh, const std::vector<std::string>& bsdfs);

}  // namespace laver
