// What each primitive has beside its corners: its material, and its vertices' normals.
#include <span>

#include "render/pack_parts.h"

namespace laver {
namespace {

template <class Index>
std::vector<std::byte> attributeBytes(const std::vector<shared::Attributes>& attributes,
                                      bool normals) {
  std::vector<Index> numbers;
  numbers.reserve(attributes.size() * (normals ? 4 : 1));
  for (const shared::Attributes& a : attributes) {
    numbers.push_back(static_cast<Index>(a.material));
    if (normals)
      for (const std::uint32_t n : {a.normalA, a.normalB, a.normalC})
        numbers.push_back(static_cast<Index>(n));
  }
  const auto bytes = std::as_bytes(std::span(numbers));
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::vector<shared::Attributes> inLeafOrder(const std::vector<shared::Attributes>& attributes,
                                            const std::vector<shared::Triangle>& inFileOrder,
                                            const Bvh& bvh) {
  if (inFileOrder.empty()) return {};
  std::vector<std::uint32_t> placeOf(inFileOrder.back().id + 1);
  for (std::uint32_t i = 0; i < inFileOrder.size(); ++i) placeOf[inFileOrder[i].id] = i;
  std::vector<shared::Attributes> sorted(attributes.size());
  for (std::size_t slot = 0; slot < sorted.size(); ++slot)
    sorted[slot] = attributes[placeOf[bvh.triangles[slot].id]];
  return sorted;
}

void packAttributes(const std::vector<shared::Attributes>& attributes, const Uploads& uploads,
                    Packed& packed) {
  const bool normals = uploads.normals;
  switch (uploads.indexBytes) {
    case 1:
      packed.attributes = attributeBytes<std::uint8_t>(attributes, normals);
      break;
    case 2:
      packed.attributes = attributeBytes<std::uint16_t>(attributes, normals);
      break;
    default:
      packed.attributes = attributeBytes<std::uint32_t>(attributes, normals);
  }
}

}  // namespace laver
