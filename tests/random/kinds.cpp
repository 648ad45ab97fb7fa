#include "random/kinds.h"

#include <algorithm>
#include <numeric>

#include "pictures/harness.h"
#include "random/draw.h"
#include "scene/texture_forms.h"

namespace laver::test {
namespace {

/// One of the defaults, or one with other parameters.
Filter filterOfKind(std::uint64_t kind, Draw& draw) {
  Filter filter = filterOf(*filterRows()[kind % filterRows().size()]);
  if (!filter.row->members.empty() && draw.chance(0.5)) {
    filter.radius = draw.between(0.6, 3.5);
    filter.stddev = draw.between(0.3, 1.0);
    filter.B = draw.between(0.0, 1.0);
    filter.C = 0.5 * (1.0 - filter.B);
  }
  return filter;
}

std::vector<std::string> traversalsOf(const Kind& kind, Draw& draw) {
  // Paths have no packets.
  if (kind.integrator->bounces || traversals().size() == 1) return {"lane"};
  const std::string packet = draw.chance(0.5) ? "packet32" : "packet64";
  if (draw.chance(0.5)) return {"lane", packet};
  return {draw.chance(0.5) ? "lane" : packet};
}

}  // namespace

Kind kindOf(std::uint64_t seed) {
  const std::uint64_t kind = seed / kBlock % kKinds;
  Draw draw(kind);
  const auto& bsdfs = bsdfRows();
  const std::vector<const TextureRow*> textures{&textures::checker, &textures::stripes,
                                                &textures::uv, &textures::constant};
  const std::vector<const EmitterRow*> skies{nullptr, &emitters::constant, nullptr,
                                             &emitters::distantdisk};
  Kind result{.number = kind,
              .integrator = integratorRows()[kind % integratorRows().size()],
              .sampler = samplerRows()[draw.below(samplerRows().size())],
              .filter = filterOfKind(kind / 16 + kind, draw),
              .bsdfs = {},
              .texture = draw.chance(0.3) ? textures[draw.below(textures.size())] : nullptr,
              .sky = skies[draw.below(skies.size())],
              .lamp = draw.chance(0.6),
              .lens = draw.chance(0.15),
              .general = kind % 10 != 5,
              .traversals = {}};
  // All BSDFs come with each kind of integrator.
  for (std::uint64_t i = 0; i < 3; ++i)
    result.bsdfs.push_back(bsdfs[(kind / 16 * 3 + i + kind) % bsdfs.size()]);
  if (result.texture != nullptr) result.bsdfs[0] = &bsdfs::diffuse;
  result.traversals = traversalsOf(result, draw);
  Draw more(kind ^ 0xadded00000000000U);
  if (more.chance(0.4)) result.shown = textures[more.below(textures.size())];
  if (more.chance(0.3)) result.bends = textures[more.below(textures.size())];
  result.anisotropic = more.chance(0.4);
  return result;
}

std::vector<std::uint64_t> seedsByKind(std::uint64_t from, std::uint64_t to) {
  std::vector<std::uint64_t> seeds(to - from);
  std::iota(seeds.begin(), seeds.end(), from);
  std::stable_sort(seeds.begin(), seeds.end(), [](std::uint64_t a, std::uint64_t b) {
    return a / kBlock % kKinds < b / kBlock % kKinds;
  });
  return seeds;
}

}  // namespace laver::test
