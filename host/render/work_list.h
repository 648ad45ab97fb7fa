#pragma once
#include <vector>

#include "render/coverage.h"
#include "render/sample_map.h"

namespace laver {

/// The part of a work list for one dispatch, in rows of workgroups that respect the device's limit.
struct WorkRange {
  std::uint32_t first, columns, rows;
};

/// Lists the tracing of a pass by workgroups of 2^shift samples side by side: groups of 16 samples
/// of a cell first, the rest by 4, and single samples by blocks of cells. Cells without a `needed`
/// pixel are skipped.
WorkRange listTracing(const SampleMap& map, const shared::Pass& pass, std::uint32_t shift,
                      const Coverage& needed, std::vector<shared::Work>& list);

/// Lists the strips of the core that contain pixels of `gathered` and are reached by samples of the
/// pass. Adds the pixels whose samples they read to `needed`.
WorkRange listGathering(const SampleMap& map, const shared::Pass& pass, std::uint32_t apron,
                        const Coverage& gathered, Coverage& needed,
                        std::vector<shared::Work>& list);

}  // namespace laver
