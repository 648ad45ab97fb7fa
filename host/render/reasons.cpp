#include "render/reasons.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/sample_map.h"
#include "render/scene_reasons.h"
#include "shared/layout.h"

namespace laver {
namespace {

Reason integrator(const Facts& f) {
  const char* name = f.scene.integrator.row->name;
  if (f.choices.pictures.size() == 1)
    return {"integrator", name, "the scene or --integrator names it", "all others", 0};
  return {"integrator", name,
          fmt::format("{} from one upload, a kernel each",
                      countOf(f.choices.pictures.size(), "picture")),
          "all others", 0};
}

Reason sampler(const Facts& f) {
  return {"sampler", f.scene.sampler.row->name,
          countOf(f.scene.sampler.sampleCount, "sample") + " per pixel", "the other samplers", 0};
}

Reason samplerTables(const Facts& f) {
  const std::uint32_t levels = f.first.jumpLevels;
  if (levels == 0)
    return {"sampler tables", "none", "positions are hashed, not drawn from a stream", "", 0};
  return {"sampler tables", fmt::format("{} of 3", levels),
          countOf(f.scene.sampler.sampleCount, "sample") + " per pixel",
          levels == 3 ? "" : countOf(3 - levels, "jump") + " per sample", 0};
}

Reason filter(const Facts& f) {
  const std::uint32_t reach = 2 * f.choices.gather.apron + 1;
  return {"filter",
          fmt::format("{}, {} x {} pixels",
                      f.uploads.noriTable ? std::string("Nori's table") : f.choices.gather.filter,
                      reach, reach),
          fmt::format("its radius is {:g}", f.scene.filter.radius),
          "the other filters, and pixels out of reach", 0};
}

Reason film(const Facts& f) {
  if (!f.choices.pictures.front().blackMiss)
    return {"film", "all of it",
            f.scene.camera.row->lens ? "a lens sees around edges"
                                     : "rays that hit nothing may not be black",
            "", 0};
  return {"film", "the part that the scene covers", "rays that hit nothing are black",
          "rays and sums elsewhere", 0};
}

Reason adaptive(const Facts& f) {
  if (f.options.error == 0.0)
    return {"adaptive", "off", "no --error", "counts of cells, and lists of work", 0};
  return {"adaptive", fmt::format("1 to {} samples per pixel", maxSamplesOf(f.scene, f.options)),
          fmt::format("to an error of {:g}, which {} pilots of 1 sample decide", f.options.error,
                      pilotCount(f.scene)),
          "", 0};
}

Reason arrays(const Facts& f) {
  if (f.choices.gather.storageTexels)
    return {"arrays", "storage buffers", "the device's texel buffers are small", "", 0};
  return {"arrays", "texel buffers", "the device's are large", "widening small formats", 0};
}

Reason sideBySide(const Facts& f) {
  const Tiling& tiling = f.choices.tiling;
  const double density =
      static_cast<double>(f.primitives) / f.scene.camera.width / f.scene.camera.height;
  const std::uint32_t samples = samplesSideBySide(tiling, f.options.error != 0.0);
  return {"side by side", countOf(samples, "sample") + " of a pixel",
          samples < tiling.sideBySide ? "no more in a pass"
                                      : fmt::format("{:.2g} triangles per pixel", density),
          "", 0};
}

Reason passes(const Facts& f) {
  const Tiling& tiling = f.choices.tiling;
  return {"passes",
          fmt::format("{}{} x {} in {}", f.options.error == 0.0 ? "" : "up to ",
                      passesOf(maxSamplesOf(f.scene, f.options), tiling),
                      countOf(tiling.samplesPerPass, "sample"),
                      countOf(bandsOf(f.choices.strips, tiling), "band")),
          fmt::format("{} MiB of samples in flight, {} MiB of film",
                      tiling.sampleSlots * kBytesInFlight >> 20,
                      tiling.bandPixels * sizeof(shared::FilmPixel) >> 20),
          "", 0};
}

}  // namespace

std::string countOf(std::uint64_t n, const char* one, const char* more) {
  const std::string plural = more == nullptr ? std::string(one) + 's' : more;
  return fmt::format("{} {}", n, n == 1 ? one : plural);
}

std::vector<Reason> reasonsOf(const Scene& scene, const RenderOptions& options,
                              const Choices& choices, const std::string& traversal) {
  const Facts f(scene, options, choices);
  std::vector<Reason> reasons = {integrator(f),
                                 {"traversal", traversalName(choices.traversal), traversal, "", 0}};
  for (const auto reason : {raysReason,
                            coordinatesReason,
                            spheresReason,
                            planesReason,
                            normalsReason,
                            materialsReason,
                            materialBsdfsReason,
                            surfaceTexturesReason,
                            imagesReason,
                            backgroundReason,
                            uvsReason,
                            indicesReason,
                            lightsReason,
                            shadowRaysReason,
                            sampler,
                            samplerTables,
                            filter,
                            film,
                            adaptive,
                            arrays,
                            sideBySide,
                            passes})
    reasons.push_back(reason(f));
  return reasons;
}

}  // namespace laver
