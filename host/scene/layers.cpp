#include "scene/layers.h"

#include <algorithm>
#include <array>

namespace laver {
namespace {

constexpr std::array kNames = {"normals", "depth", "albedo", "uv", "position", "id", "samples"};

}  // namespace

std::span<const char* const> layerNames() { return kNames; }

std::optional<Layer> layerFromName(const std::string& name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Layer>(found - kNames.begin());
}

std::vector<Shown> shownBeside(std::span<const IntegratorUse> more, std::span<const Layer> layers) {
  std::vector<Shown> all;
  for (const IntegratorUse& use : more) {
    const std::string name = use.row->name;
    all.push_back({use, {name + ".R", name + ".G", name + ".B"}});
  }
  for (const Layer layer : layers) {
    if (layer == Layer::Normals)
      all.push_back({{&integrators::shadingNormal}, {"N.X", "N.Y", "N.Z"}});
    if (layer == Layer::Albedo)
      all.push_back({{&integrators::albedo}, {"Albedo.R", "Albedo.G", "Albedo.B"}});
  }
  return all;
}

std::vector<std::string> centreChannels(std::span<const Layer> layers) {
  std::vector<std::string> names;
  const auto add = [&](std::initializer_list<const char*> list) {
    names.insert(names.end(), list.begin(), list.end());
  };
  for (const Layer layer : layers) {
    if (layer == Layer::Depth) add({"Z"});
    if (layer == Layer::Uv) add({"u", "v"});
    if (layer == Layer::Position) add({"P.X", "P.Y", "P.Z"});
    if (layer == Layer::Id) add({"shape_index", "prim_index"});
  }
  return names;
}

void writeCentre(std::span<const Layer> layers, const std::optional<CentreHit>& hit, float* out) {
  const CentreHit none;
  const CentreHit& h = hit ? *hit : none;
  const auto id = [&](std::uint32_t number) { return hit ? static_cast<float>(number) : -1.0F; };
  for (const Layer layer : layers) {
    if (layer == Layer::Depth) *out++ = static_cast<float>(h.distance);
    if (layer == Layer::Uv)
      for (int c = 0; c < 2; ++c) *out++ = static_cast<float>(h.uv[c]);
    if (layer == Layer::Position)
      for (int c = 0; c < 3; ++c) *out++ = static_cast<float>(h.position[c]);
    if (layer == Layer::Id) {
      *out++ = id(h.mesh);
      *out++ = id(h.triangle);
    }
  }
}

}  // namespace laver
