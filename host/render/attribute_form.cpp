#include "render/attribute_form.h"

#include <cstring>
#include <span>

namespace laver {
namespace {

template <class Index>
std::vector<std::byte> bytesOf(const SceneData& data) {
  const bool normals = data.constants[shared::SPEC_NORMALS] != 0;
  std::vector<Index> numbers;
  numbers.reserve(data.attributes.size() * (normals ? 4 : 1));
  for (const shared::Attributes& a : data.attributes) {
    numbers.push_back(static_cast<Index>(a.material));
    if (normals)
      for (const std::uint32_t n : {a.normalA, a.normalB, a.normalC})
        numbers.push_back(static_cast<Index>(n));
  }
  const auto bytes = std::as_bytes(std::span(numbers));
  return {bytes.begin(), bytes.end()};
}

}  // namespace

VkFormat attributeFormat(const SpecConstants& constants) {
  const bool normals = constants[shared::SPEC_NORMALS] != 0;
  switch (constants[shared::SPEC_INDEX_BYTES]) {
    case 1:
      return normals ? VK_FORMAT_R8G8B8A8_UINT : VK_FORMAT_R8_UINT;
    case 2:
      return normals ? VK_FORMAT_R16G16B16A16_UINT : VK_FORMAT_R16_UINT;
    default:
      return normals ? VK_FORMAT_R32G32B32A32_UINT : VK_FORMAT_R32_UINT;
  }
}

std::vector<std::byte> attributeBytes(const SceneData& data) {
  switch (data.constants[shared::SPEC_INDEX_BYTES]) {
    case 1:
      return bytesOf<std::uint8_t>(data);
    case 2:
      return bytesOf<std::uint16_t>(data);
    default:
      return bytesOf<std::uint32_t>(data);
  }
}

}  // namespace laver
