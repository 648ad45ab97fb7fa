#pragma once
#include "bench/embree_scene.h"
#include "bench/report.h"

namespace laver::bench {

/// Embree twice: with all that the machine has, and held to AVX2.
struct EmbreeDevices {
  EmbreeDevice native{"threads=2"};
  EmbreeDevice avx2{"threads=2,isa=avx2"};
};

/// One scene in Embree's forms.
struct EmbreeScenes {
  EmbreeScenes(const EmbreeDevices& devices, const Scene& scene);
  EmbreeMesh mesh;
  EmbreeScene robust, plain, robustAvx2, plainAvx2, robustHigh;
};

/// Rounds of each measurement; --quick takes few.
struct Rounds {
  std::size_t passes = 9, renders = 3, builds = 5, processes = 5, files = 5;
};

/// Whole passes: generate, trace, store.
void benchPasses(Report& report, const EmbreeDevices& devices, const Rounds& rounds);
/// Traversal only: rays from memory, hits to memory.
void benchRays(Report& report, const EmbreeDevices& devices, const Rounds& rounds);
/// Trees: seconds and SAH cost.
void benchBuilds(Report& report, const EmbreeDevices& devices, const Rounds& rounds);
/// OBJ files: seconds to load, and the parts of it.
void benchFiles(Report& report, const Rounds& rounds);
/// Many samples with a gaussian filter, and whole processes of `laver`.
void benchProcesses(Report& report, const Rounds& rounds);

}  // namespace laver::bench
