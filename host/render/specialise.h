#pragma once
#include <array>
#include <cstdint>

#include "render/options.h"
#include "scene/scene.h"
#include "shared/layout.h"

namespace laver {

/// What the kernels leave out because the scene does not need it: values of SPEC_*.
using SpecConstants = std::array<std::uint32_t, shared::SPEC_CONSTANTS>;

/// The constants of a scene, which take no time and no tree, so that its kernels can be compiled
/// while the tree is built. The stack is a guess; requireStack corrects it.
SpecConstants specialise(const Scene& scene, const RenderOptions& options);
/// The same for a picture of that scene that shows something else than its integrator says.
SpecConstants specialise(const Scene& scene, Integrator shown, const RenderOptions& options);

/// The same with what any scene could need in each constant c whose bit 1 << c is in `which`: for
/// tests and benches, which show that the picture keeps its bits and what that costs.
SpecConstants generalise(SpecConstants constants, std::uint32_t which);
inline constexpr std::uint32_t kAllConstants = (1U << shared::SPEC_CONSTANTS) - 1;

/// FILTER_* of a filter.
std::uint32_t filterConstant(const Filter& filter);

/// Bytes that hold any index of a triangle's attributes: 1, 2 or 4.
std::uint32_t indexBytes(const Scene& scene, bool normals);

/// Makes room for `entries` on the traversal stack; true if there was less.
bool requireStack(SpecConstants& constants, std::uint32_t entries);

/// Pixels on each side of a sample's own that a filter of that radius can reach.
std::uint32_t apronOf(double radius);

}  // namespace laver
