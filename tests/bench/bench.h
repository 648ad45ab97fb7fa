#pragma once
#include "bench/embree_scene.h"
#include "bench/report.h"

namespace laver::bench {

/// Embree with all instruction sets of the processor, and limited to AVX2.
struct EmbreeDevices {
  EmbreeDevice native{"threads=2"};
  EmbreeDevice avx2{"threads=2,isa=avx2"};
};

/// Numbers of measurements.
struct Rounds {
  std::size_t passes = 9, renders = 3, builds = 5, processes = 5, files = 5;
  bool brief = false;  ///< leaves out subdivided meshes, and renders of many samples
};

/// Renders by laver: times of trace, reconstruction and compilation.
void benchPasses(Report& report, const Rounds& rounds);
/// Traversal alone, laver's and Embree's, with rays and hits in memory.
void benchRays(Report& report, const EmbreeDevices& devices, const Rounds& rounds);
/// Tree builders of both: seconds and SAH cost.
void benchBuilds(Report& report, const EmbreeDevices& devices, const Rounds& rounds);
/// OBJ files: seconds to load, in total and per stage.
void benchFiles(Report& report, const Rounds& rounds);
/// Reconstruction with a Gaussian filter at many samples, and whole processes of `laver`.
void benchProcesses(Report& report, const Rounds& rounds);

}  // namespace laver::bench
