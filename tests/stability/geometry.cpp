// Handling of bad geometry, and the messages. tests/unit/obj_*.cpp and scene_*.cpp test each
// message; these cases go through the whole program.
#include <gtest/gtest.h>

#include <fstream>

#include "pictures/harness.h"
#include "stability/record.h"
#include "stability/subject.h"
#include "support/scene_files.h"

namespace laver::test {
namespace {

struct Bad {
  const char* name;
  std::string obj;
  std::string transform;  ///< inside <transform>
  std::string says;       ///< part of the error; empty: it renders
  std::string behaviour;
};

const std::string kSquare = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";

const std::vector<Bad> kBad = {
    {"vertex normals of no length", kSquare + "vn 0 0 0\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n", "",
     "", "the geometric normal"},
    {"opposite vertex normals",
     kSquare + "vn 0 0 1\nvn 0 0 -1\nf 1//1 2//2 3//1\nf 1//1 3//2 4//1\n", "", "",
     "the geometric normal where they cancel"},
    {"a triangle of no area", kSquare + "f 1 2 3\nf 1 3 4\nf 1 1 2\nf 1 2 2\n", "", "",
     "dropped and counted"},
    {"a face of 5 corners", kSquare + "v 0 2 0\nf 1 2 3 5 4\n", "", "", "a fan"},
    {"NaN", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "", "is not a finite number", "refused"},
    {"infinity", "v inf 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "", "is not a finite number", "refused"},
    {"an index beyond the end", kSquare + "f 1 2 9\n", "",
     "vertex index 9 is out of range, the file has 4", "refused"},
    {"index 0", kSquare + "f 0 1 2\n", "", "vertex index 0, OBJ counts from 1", "refused"},
    {"a singular transform", kSquare + "f 1 2 3\n", "<scale value=\"1,0,1\"/>", "singular",
     "refused"},
    {"a transform of NaN", kSquare + "f 1 2 3\n", "<scale value=\"nan,1,1\"/>", "finite",
     "refused"},
};

std::string sceneOf(const Bad& bad) {
  return "<scene><integrator type=\"normals\"/><camera type=\"perspective\">"
         "<integer name=\"width\" value=\"64\"/><integer name=\"height\" value=\"64\"/>"
         "<transform name=\"toWorld\"><lookat origin=\"0,0,9\" target=\"0,0,0\" up=\"0,1,0\"/>"
         "</transform></camera><mesh type=\"obj\"><string name=\"filename\" value=\"bad.obj\"/>" +
         (bad.transform.empty() ? std::string()
                                : "<transform name=\"toWorld\">" + bad.transform + "</transform>") +
         "</mesh></scene>";
}

LAVER_STABILITY(Geometry, "Bad geometry: stated behaviour, with the message") {
  std::vector<std::vector<std::string>> cells{{"input", "behaviour", "message"}};
  std::uint64_t wrong = 0;
  for (const Bad& bad : kBad) {
    SceneFiles files;
    files.write("bad.obj", bad.obj);
    if (!bad.says.empty()) {
      const std::string error = files.errors(sceneOf(bad));
      const bool said = error.find(bad.says) != std::string::npos;
      EXPECT_TRUE(said) << bad.name << ": \"" << error << '"';
      wrong += said ? 0 : 1;
      cells.push_back({bad.name, bad.behaviour, error});
      continue;
    }
    const Scene scene = files.load(sceneOf(bad)).scene;
    VulkanOptions vulkan;
    vulkan.device = testDevice();
    Stats stats;
    const Image image = Renderer(vulkan).render(scene, {}, stats).image;
    EXPECT_EQ(stats.droppedSamples, 0U) << bad.name;
    // n| is a unit vector wherever the square is; here it faces the camera.
    const bool right = std::abs(image.at(32, 20, 2) - 1.0F) < 1e-6F &&
                       std::all_of(image.pixels.begin(), image.pixels.end(),
                                   [](float v) { return std::isfinite(v); });
    EXPECT_TRUE(right) << bad.name << ": " << image.at(32, 20, 2);
    wrong += right ? 0 : 1;
    cells.push_back({bad.name, bad.behaviour,
                     stats.droppedTriangles == 0
                         ? ""
                         : std::to_string(stats.droppedTriangles) + " triangles dropped"});
  }
  record.table("Bad geometry", cells);
  record.add({"all kinds of the table below", "laver", kBad.size(), std::nullopt,
              static_cast<double>(wrong), 0.0, "surprises"});
}

}  // namespace
}  // namespace laver::test
