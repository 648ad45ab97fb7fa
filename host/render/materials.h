#pragma once
#include <functional>
#include <string>
#include <vector>

#include "render/choices.h"
#include "scene/scene.h"

// The kernels' view of meshes' materials.
namespace laver {

/// What the kernels of a scene hold of its BSDFs, sorted by name; `diffuse` where it has no mesh.
std::vector<BsdfText> bsdfsOf(const Scene& scene);
/// Names of the textures that show, sorted: GLSL files below texture/.
std::vector<std::string> texturesOf(const Scene& scene);
std::vector<std::string> allTextureNames();
/// The records of its meshes.
MaterialLayout layoutOf(const Scene& scene);

/// Whether a texture shows more than a colour: an image that was not read shows none.
bool shows(const Texture& texture);
/// The textures of a mesh's BSDF and light that do.
std::vector<const Texture*> texturesOf(const Mesh& mesh);
/// Whether there are any.
bool hasTextures(const Mesh& mesh);

/// Whether two meshes' records are the same, their textures aside.
bool alike(const Mesh& a, const Mesh& b);

/// The first colour of its BSDF; white where it has none.
glm::dvec3 albedoOf(const Mesh& mesh);

/// The record of a mesh, whose BSDF is numbered by its place in `bsdfs`. `placeOf` says where in
/// their array a texture stands, `uvs` where the mesh's texture coordinates do
/// (shared::Texture::uvs).
std::vector<std::uint32_t> recordOf(const Bsdf& bsdf, const MaterialLayout& layout,
                                    const std::vector<BsdfText>& bsdfs,
                                    const std::function<std::uint32_t(const Texture&)>& placeOf,
                                    std::uint32_t uvs);

}  // namespace laver
