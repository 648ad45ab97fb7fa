#include "lab/device_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>

#include "core/error.h"
#include "image/compare.h"
#include "image/io.h"
#include "lab/process.h"
#include "lab/scratch.h"
#include "reference/reference.h"
#include "render/traversal.h"
#include "scene/scene.h"

namespace laver {
namespace {

/// A floor and a tetrahedron.
constexpr const char* kMesh =
    "v -3 0 -3\nv 3 0 -3\nv 3 0 3\nv -3 0 3\nf 4 3 2 1\n"
    "v -1.4 0 0.9\nv -0.4 0 -0.2\nv -0.2 0 1.2\nv -0.7 1.3 0.6\nf 5 6 8\nf 6 7 8\nf 7 5 8\n";

constexpr const char* kShapes =
    "<mesh type=\"obj\"><string name=\"filename\" value=\"check.obj\"/>"
    "<bsdf type=\"diffuse\"><texture type=\"checkerboard_color\" name=\"albedo\">"
    "<color name=\"value1\" value=\"0.2 0.4 0.6\"/><color name=\"value2\" value=\"0.8 0.7 0.3\"/>"
    "</texture></bsdf></mesh>"
    "<mesh type=\"sphere\"><point name=\"center\" value=\"0.7 0.6 0\"/>"
    "<float name=\"radius\" value=\"0.6\"/>{}</mesh>"
    "<sampler type=\"independent\"><integer name=\"sampleCount\" value=\"8\"/></sampler>"
    "<camera type=\"perspective\"><integer name=\"width\" value=\"64\"/>"
    "<integer name=\"height\" value=\"48\"/><float name=\"fov\" value=\"45\"/>"
    "<transform name=\"toWorld\"><lookat origin=\"0.5 2 -5\" target=\"0 0.4 0\" up=\"0 1 0\"/>"
    "</transform></camera>";

struct CheckScene {
  const char* name;
  const char* integrator;
  const char* bsdf;
  const char* lights;
};

constexpr CheckScene kScenes[] = {
    {"normals", "normals", "", ""},
    {"lights", "direct_whitted", "",
     "<emitter type=\"point\"><point name=\"position\" value=\"-2 4 -2\"/>"
     "<color name=\"power\" value=\"600 500 400\"/></emitter>"
     "<emitter type=\"point\"><point name=\"position\" value=\"3 3 -1\"/>"
     "<color name=\"power\" value=\"100 200 300\"/></emitter>"},
    {"paths", "path_mis", "<bsdf type=\"dielectric\"/>",
     "<mesh type=\"sphere\"><point name=\"center\" value=\"-1.5 3 -1\"/>"
     "<float name=\"radius\" value=\"0.5\"/><emitter type=\"area\">"
     "<color name=\"radiance\" value=\"12 11 9\"/></emitter></mesh>"}};

/// Values that differ by more than this do not count as equal.
constexpr double kApart = 1e-4;
/// The share of them that a right picture may have: rounding decides on which side of an edge a
/// sample is, and of paths where they go on (tests/pictures/paths.cpp).
double shareOf(bool paths) { return paths ? 0.03 : 0.01; }

void write(const std::string& file, const std::string& text) {
  if (!(std::ofstream(file) << text)) throw Error(ExitCode::Output, file + ": cannot be written");
}

std::string lastLine(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

class Checks {
 public:
  Checks(std::string self, std::size_t index, double limit)
      : self_(std::move(self)), index_(index), limit_(limit) {
    write(scratch_.file("check.obj"), kMesh);
  }

  /// What the reference shows, and whether it follows paths.
  struct Wanted {
    Image image;
    bool paths;
  };

  Wanted prepare(const CheckScene& scene) {
    file_ = scratch_.file("check.xml");
    write(file_, fmt::format("<scene><integrator type=\"{}\"/>{}{}</scene>", scene.integrator,
                             fmt::format(fmt::runtime(kShapes), scene.bsdf), scene.lights));
    const Scene loaded = loadScene(file_, {.dialectNamed = true}).scene;
    return {Reference(loaded).render({}).image, loaded.integrator.row->bounces};
  }

  DeviceCheck run(const CheckScene& scene, const Wanted& wanted, Traversal traversal) {
    DeviceCheck check{fmt::format("{}, {}", scene.name, traversalName(traversal))};
    const std::string picture = scratch_.file("check.exr");
    const auto start = std::chrono::steady_clock::now();
    const auto since = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const ProcessRun run = runProcess({self_, file_, "-q", "--device", std::to_string(index_),
                                       "--traversal", traversalName(traversal), "-o", picture},
                                      "/dev/null", [&] { return since() > limit_; });
    check.seconds = run.seconds;
    if (run.seconds > limit_) {
      check.finding = fmt::format("no picture within {:g} s", limit_);
    } else if (run.exitCode != 0) {
      check.finding =
          fmt::format("no picture, exit code {}: {}", run.exitCode, lastLine(run.errorOutput));
    } else {
      double share = 0.0;
      for (const ChannelDifference& d : compare(readExr(picture), wanted.image, kApart))
        share = std::max(share, d.distances.share);
      check.right = share <= shareOf(wanted.paths);
      check.finding = fmt::format("{:.2f} % of the pixels differ", 100.0 * share);
    }
    return check;
  }

 private:
  Scratch scratch_;
  std::string self_, file_;
  std::size_t index_;
  double limit_;
};

}  // namespace

void checkDevice(const std::string& self, std::size_t index, const DeviceInfo& device, double limit,
                 const std::function<void(const DeviceCheck&)>& report) {
  Checks checks(self, index, limit);
  for (const CheckScene& scene : kScenes) {
    const Checks::Wanted wanted = checks.prepare(scene);
    for (const Traversal traversal : {Traversal::Lane, Traversal::Packet32, Traversal::Packet64}) {
      if (isPacket(traversal) && (wanted.paths || !runsPackets(device))) continue;
      report(checks.run(scene, wanted, traversal));
    }
  }
}

}  // namespace laver
