#pragma once
#include <vector>

#include "render/coverage.h"
#include "render/sample_map.h"

namespace laver {

/// The workgroups of a dispatch in a list of work, as rows that a device's limit allows.
struct WorkRange {
  std::uint32_t first, columns, rows;
};

/// Lists what is to be traced of a pass by workgroups of 2^shift samples side by side: as many of a
/// cell's samples as go by 16, the rest by 4, and those of a block of cells that have one by 1.
/// Cells without a pixel that is `needed` are left out.
WorkRange listTracing(const SampleMap& map, const shared::Pass& pass, std::uint32_t shift,
                      const Coverage& needed, std::vector<shared::Work>& list);

/// Lists the strips of the core that have pixels in `gathered` and that samples of a pass reach.
/// Adds what these take samples of to `needed`.
WorkRange listGathering(const SampleMap& map, const shared::Pass& pass, std::uint32_t apron,
                        const Coverage& gathered, Coverage& needed,
                        std::vector<shared::Work>& list);

}  // namespace laver
