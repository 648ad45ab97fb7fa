#pragma once
#include <volk.h>

#include <cstddef>
#include <vector>

#include "render/scene_data.h"

namespace laver {

/// How attributes lie on the device: four numbers a triangle, or its material alone where
/// no kernel reads normals, each of SPEC_INDEX_BYTES bytes.
VkFormat attributeFormat(const SpecConstants& constants);

/// data.attributes in that form.
std::vector<std::byte> attributeBytes(const SceneData& data);

}  // namespace laver
