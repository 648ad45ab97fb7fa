#include "scene/layers.h"

namespace laver {
namespace {

void writeDepth(const CentreHit* hit, float* out) {
  *out = hit == nullptr ? 0.0F : static_cast<float>(hit->distance);
}

void writeUv(const CentreHit* hit, float* out) {
  for (int c = 0; c < 2; ++c) out[c] = hit == nullptr ? 0.0F : static_cast<float>(hit->uv[c]);
}

void writePosition(const CentreHit* hit, float* out) {
  for (int c = 0; c < 3; ++c) out[c] = hit == nullptr ? 0.0F : static_cast<float>(hit->position[c]);
}

void writeId(const CentreHit* hit, float* out) {
  out[0] = hit == nullptr ? -1.0F : static_cast<float>(hit->mesh);
  out[1] = hit == nullptr ? -1.0F : static_cast<float>(hit->triangle);
}

}  // namespace

namespace layers {

const LayerRow normals{.name = "normals",
                       .channels = {"N.X", "N.Y", "N.Z"},
                       .integrator = &integrators::shadingNormal};
const LayerRow depth{.name = "depth", .channels = {"Z"}, .write = writeDepth};
const LayerRow albedo{.name = "albedo",
                      .channels = {"Albedo.R", "Albedo.G", "Albedo.B"},
                      .integrator = &integrators::albedo};
const LayerRow uv{.name = "uv", .channels = {"u", "v"}, .write = writeUv};
const LayerRow position{
    .name = "position", .channels = {"P.X", "P.Y", "P.Z"}, .write = writePosition};
const LayerRow id{.name = "id", .channels = {"shape_index", "prim_index"}, .write = writeId};
const LayerRow samples{.name = "samples", .channels = {"samples"}};
const LayerRow variance{.name = "variance", .channels = {"variance.R", "variance.G", "variance.B"}};

}  // namespace layers

const Rows<LayerRow>& layerRows() {
  using namespace layers;
  static const Rows<LayerRow> rows = {&normals,  &depth, &albedo,  &uv,
                                      &position, &id,    &samples, &variance};
  return rows;
}

std::vector<Shown> shownBeside(std::span<const IntegratorUse> more, const Rows<LayerRow>& layers) {
  std::vector<Shown> all;
  for (const IntegratorUse& use : more) {
    const std::string name = use.row->name;
    all.push_back({use, {name + ".R", name + ".G", name + ".B"}});
  }
  for (const LayerRow* layer : layers)
    if (layer->integrator != nullptr) all.push_back({{layer->integrator}, layer->channels});
  return all;
}

std::vector<std::string> centreChannels(const Rows<LayerRow>& layers) {
  std::vector<std::string> names;
  for (const LayerRow* layer : layers)
    if (layer->write != nullptr)
      names.insert(names.end(), layer->channels.begin(), layer->channels.end());
  return names;
}

void writeCentre(const Rows<LayerRow>& layers, const std::optional<CentreHit>& hit, float* out) {
  for (const LayerRow* layer : layers) {
    if (layer->write == nullptr) continue;
    layer->write(hit ? &*hit : nullptr, out);
    out += layer->channels.size();
  }
}

}  // namespace laver
