// `laver chart` as a user runs it: files, peers, interruption.
#include "lab/chart/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "image/compare.h"
#include "image/io.h"
#include "lab/chart/truth.h"
#include "pictures/child.h"
#include "pictures/command_line.h"

namespace laver::test {
namespace {

/// A lit triangle on a film of 16 x 12.
class ChartCommandLine : public CommandLine {
 protected:
  ChartCommandLine() {
    write("t.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
    write("s.xml", kScene);
  }
  static constexpr const char* kScene =
      "<scene><integrator type=\"direct_whitted\"/><camera type=\"perspective\">"
      "<integer name=\"width\" value=\"160\"/><integer name=\"height\" value=\"120\"/>"
      "<transform name=\"toWorld\"><lookat origin=\"0,0,4\" target=\"0,0,0\" up=\"0,1,0\"/>"
      "</transform></camera><emitter type=\"pointlight\"><point name=\"position\" value=\"1,1,3\"/>"
      "<color name=\"radiance\" value=\"20,20,20\"/></emitter><mesh type=\"obj\">"
      "<string name=\"filename\" value=\"t.obj\"/></mesh></scene>";

  Outcome chart(const std::string& more = "") {
    const auto unlessGiven = [&](const std::string& name, const std::string& value) {
      return more.find(name) == std::string::npos ? name + " " + value + " " : "";
    };
    return laver("chart s.xml --out c --size 16x12 --runs 1 --device $device " +
                 unlessGiven("--reference-spp", "16") + unlessGiven("--spp", "4") + more);
  }
  nlohmann::json json() { return nlohmann::json::parse(contents(folder_ / "c/chart.json")); }
  void script(const std::string& name, const std::string& text) {
    write(name, "#!/bin/sh\n" + text);
    fs::permissions(folder_ / name, fs::perms::owner_all);
  }
};

TEST_F(ChartCommandLine, MakesItsFiles) {
  const Outcome run = chart();
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("Wrote chart.svg"), std::string::npos) << run.out;
  const nlohmann::json all = json();
  EXPECT_EQ(all["width"], 16);
  EXPECT_GT(all["reference"]["rmse"], 0.0);
  std::set<std::string> names;
  std::size_t points = 0;
  for (const auto& series : all["series"]) {
    names.insert(series["name"]);
    EXPECT_GE(series["points"].size(), 2U) << series["name"];  // 1 and 4 samples, or four errors
    for (const auto& point : series["points"]) {
      EXPECT_GT(point["rmse"], 0.0);
      EXPECT_GT(point["seconds"]["median"], 0.0);
      EXPECT_GT(point["processSeconds"]["median"], point["seconds"]["median"]);
      EXPECT_EQ(point.contains("mismatches"), !series["adaptive"]) << point["command"];
      if (point.contains("mismatches")) {
        EXPECT_EQ(point["mismatches"]["unexplained"], 0);
      }
      ++points;
    }
  }
  std::set<std::string> expected;
  ASSERT_EQ(
      laver("s.xml --size 16x12 --spp 1 --device $device --stats=s.json -o s.exr --quiet").code, 0);
  const auto stats = nlohmann::json::parse(contents(folder_ / "s.json"));
  for (const auto& series : chart::seriesFor(stats["traversal"], {})) expected.insert(series.name);
  EXPECT_EQ(names, expected);
  EXPECT_EQ(contents(folder_ / "c/chart.png").substr(1, 3), "PNG");
  EXPECT_NE(contents(folder_ / "c/chart.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(lines(contents(folder_ / "c/chart.csv")), static_cast<int>(points) + 1);
  EXPECT_FALSE(fs::exists(folder_ / "c/running.exr"));
}

TEST_F(ChartCommandLine, TheReferencesErrorIsNearItsEstimate) {
  ASSERT_EQ(chart("--spp 1 --quiet").code, 0) << contents(folder_ / "err.txt");
  ASSERT_EQ(laver("s.xml --reference --sampler stratified --size 16x12 --spp 4096 -o better.exr "
                  "--quiet")
                .code,
            0);
  const double estimate = json()["reference"]["rmse"];
  double squares = 0;
  for (const auto& channel :
       compare(readExr(path("c/reference.exr")), readExr(path("better.exr")), 0))
    squares += channel.rmse * channel.rmse / 3.0;
  // Some 30 edge pixels determine an RMSE to a sixth, and the estimate is as uncertain.
  EXPECT_GT(estimate, std::sqrt(squares) * 0.4);
  EXPECT_LT(estimate, std::sqrt(squares) * 2.5);
}

/// The triangle in the light of a sphere, by paths.
std::string pathScene() {
  return "<scene><integrator type=\"path_mis\"/><camera type=\"perspective\"><transform "
         "name=\"toWorld\"><lookat origin=\"0,0,4\" target=\"0,0,0\" up=\"0,1,0\"/></transform>"
         "</camera><mesh type=\"obj\"><string name=\"filename\" value=\"t.obj\"/></mesh>"
         "<mesh type=\"sphere\"><point name=\"center\" value=\"1,1,2\"/><float name=\"radius\" "
         "value=\"0.3\"/><emitter type=\"area\"><color name=\"radiance\" value=\"5 5 "
         "5\"/></emitter>"
         "</mesh></scene>";
}

TEST_F(ChartCommandLine, OfPathsTakesTheDevicesPictureThatTheReferenceConfirms) {
  write("s.xml", pathScene());
  ASSERT_EQ(chart("--reference-spp 256").code, 0) << contents(folder_ / "err.txt");
  const nlohmann::json all = json();
  EXPECT_EQ(all["reference"]["origin"].get<std::string>().rfind(
                "the device, equal to double precision with 16 samples per pixel by a z-test (", 0),
            0U)
      << all["reference"]["origin"];
  std::set<std::string> names;
  for (const auto& series : all["series"]) {
    names.insert(series["name"]);
    const auto& points = series["points"];
    EXPECT_GT(points.front()["rmse"], points.back()["rmse"]) << series["name"];
  }
  EXPECT_TRUE(names.contains("sobol") && names.contains("independent, adaptive"));
}

// A device that renders another light: here another file for the reference's scene.
TEST_F(ChartCommandLine, OfPathsTakesTheReferencesPictureWhereTheDevicesIsWrong) {
  std::string other = pathScene();
  other.replace(other.find("5 5 5"), 5, "1 5 5");
  write("s.xml", pathScene());
  write("device.xml", other);
  script("wrong",
         "shift; cd '" + folder_.string() + "'; exec '" LAVER_BINARY "' device.xml \"$@\"\n");
  chart::Options options;
  options.scene = path("s.xml");
  options.folder = folder_.string();
  options.size = {16, 12};
  options.device = testDevice();
  options.truthSamples = 256;
  options.self = path("wrong");
  std::string said;
  options.say = [&](const std::string& line) { said += line; };
  const chart::Measurement measurement(options);
  const chart::Truth truth = chart::truthOf(chart::sceneOf(options), options, measurement);
  EXPECT_EQ(truth.origin, "double precision");
  EXPECT_EQ(said.rfind("The device's picture is not that of double precision", 0), 0U) << said;
}

TEST_F(ChartCommandLine, APeerIsMeasuredWithLaver) {
  script("old", "exec '" LAVER_BINARY "' \"$@\"\n");
  ASSERT_EQ(chart("--spp 4 --peer 'an older laver' \"./old --device $device\"").code, 0)
      << contents(folder_ / "err.txt");
  std::map<std::string, std::vector<double>> errors;
  const nlohmann::json all = json();
  for (const auto& series : all["series"])
    for (const auto& point : series["points"]) errors[series["name"]].push_back(point["rmse"]);
  EXPECT_EQ(errors.at("an older laver").size(), 2U);
  EXPECT_EQ(errors.at("an older laver"), errors.at("independent"));
  EXPECT_TRUE(all["missing"].empty());
}

TEST_F(ChartCommandLine, AMissingPeerIsNamedAndLeftOut) {
  script("none", "echo 'none: it is not installed' >&2; exit 69\n");
  ASSERT_EQ(chart("--spp 1 --peer None ./none --peer Two 'env no-such-program'").code, 0)
      << contents(folder_ / "err.txt");
  const nlohmann::json all = json();
  ASSERT_EQ(all["missing"].size(), 2U);
  EXPECT_EQ(all["missing"][0], "None: none: it is not installed");
  for (const auto& series : all["series"]) EXPECT_EQ(series["program"], "laver");
}

TEST_F(ChartCommandLine, BadArgumentsAreRefusedInOneLine) {
  script("broken", "echo 'no picture' >&2; exit 1\n");
  for (const char* more : {"--peer Nori", "--peer laver ./broken", "--peer Nori ''",
                           "--peer A ./broken --peer A ./broken", "--peer Nori ./nothing",
                           "--size 16", "--size 0x4", "--runs 0", "--spp 0"}) {
    const Outcome run = chart(more);
    EXPECT_EQ(run.code, 2) << more << ": " << run.err;
    EXPECT_EQ(lines(run.err), 1) << more << ": " << run.err;
  }
  EXPECT_EQ(laver("chart").code, 2);
  EXPECT_EQ(laver("chart none.xml").code, 3);
  const Outcome failing = chart("--peer Broken ./broken");
  EXPECT_EQ(failing.code, 1);
  EXPECT_EQ(failing.err, "laver: Broken failed: no picture\n");
  write("file", "x");
  EXPECT_EQ(laver("chart s.xml --out file/c --size 16x12").code, 1);
  EXPECT_FALSE(fs::exists(folder_ / "c/chart.json"));
}

TEST_F(ChartCommandLine, CtrlCEndsItWithoutAChart) {
  // A reference of so many samples takes minutes.
  const std::vector<std::string> arguments{"chart",  "s.xml", "--out",           "c",
                                           "--size", "64x48", "--spp",           "1",
                                           "--runs", "1",     "--reference-spp", "100000"};
  Child child(folder_, arguments);
  while (!fs::exists(folder_ / "c/running.json") && !child.ended()) ::usleep(2000);
  ::usleep(300000);
  child.send(SIGINT);
  EXPECT_EQ(child.wait(), 130);
  EXPECT_NE(contents(folder_ / "err.txt").find("no chart is written"), std::string::npos)
      << contents(folder_ / "err.txt");
  EXPECT_FALSE(fs::exists(folder_ / "c/chart.json"));
  EXPECT_FALSE(fs::exists(folder_ / "c/running.exr"));
}

}  // namespace
}  // namespace laver::test
