// `laver chart` as a user runs it: files, resuming, caches, peers.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "image/io.h"
#include "lab/chart/choices.h"
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
    const std::string samples = more.find("--spp") == std::string::npos ? "--spp 4 " : "";
    return laver("chart s.xml --out c --size 16x12 --runs 1 --reference-spp 16 --device cpu " +
                 samples + more);
  }
  nlohmann::json json() { return nlohmann::json::parse(contents(folder_ / "c/chart.json")); }
  std::map<std::string, fs::file_time_type> keptTimes() {
    std::map<std::string, fs::file_time_type> times;
    for (const auto& entry : fs::directory_iterator(folder_ / "c/kept"))
      times[entry.path().filename().string()] = fs::last_write_time(entry.path());
    return times;
  }
};

TEST_F(ChartCommandLine, MakesFourFilesOnceAndThenTakesWhatIsKept) {
  Outcome run = chart();
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("Wrote chart.html"), std::string::npos) << run.out;
  const nlohmann::json first = json();
  EXPECT_EQ(first["width"], 16);
  EXPECT_GE(first["points"].size(), 8U);  // 1 and 4 samples by four filters at least
  std::set<std::string> filters, traversals;
  for (const auto& point : first["points"]) {
    filters.insert(point["filter"]);
    traversals.insert(point["traversal"]);
    EXPECT_GT(point["rmse"], 0.0);
    EXPECT_GT(point["seconds"]["median"], 0.0);
    EXPECT_GT(point["processSeconds"]["median"], point["seconds"]["median"]);
    EXPECT_EQ(point.contains("mismatches"), !point["adaptive"]) << point["command"];
    if (point.contains("mismatches")) {
      EXPECT_EQ(point["mismatches"]["unexplained"], 0);
    }
  }
  EXPECT_EQ(filters.size(), 4U);
  ASSERT_EQ(laver("s.xml --size 16x12 --spp 1 --device cpu --stats=s.json -o s.exr --quiet").code,
            0);
  const auto stats = nlohmann::json::parse(contents(folder_ / "s.json"));
  std::set<std::string> expected{""};
  for (const auto& other : chart::traversalsBeside(stats["traversal"])) expected.insert(other);
  EXPECT_EQ(traversals, expected);
  EXPECT_GT(first["reference"]["filters"][0]["band"], 0.0);
  EXPECT_EQ(contents(folder_ / "c/chart.png").substr(1, 3), "PNG");
  EXPECT_GT(fs::file_size(folder_ / "c/chart.html"), 10000U);
  EXPECT_EQ(lines(contents(folder_ / "c/chart.csv")), static_cast<int>(first["points"].size()) + 1);

  // Again: nothing is measured anew.
  const auto times = keptTimes();
  run = chart("--quiet");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(keptTimes(), times);
  EXPECT_EQ(json()["points"], first["points"]);

  // One kept part is damaged: it alone is made anew, and no figure of it is believed.
  const fs::path broken = folder_ / "c/kept" / times.begin()->first;
  std::string bytes = contents(broken);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(broken, std::ios::binary | std::ios::trunc) << bytes;
  ASSERT_EQ(chart().code, 0);
  const auto after = keptTimes();
  EXPECT_EQ(after.size(), times.size());
  for (const auto& [name, time] : times)
    EXPECT_EQ(after.at(name) == time, name != broken.filename().string()) << name;

  // Another mesh is another chart.
  write("t.obj", "v -1 -1 0\nv 1 -1 0\nv 0 0.5 0\nf 1 2 3\n");
  ASSERT_EQ(chart().code, 0);
  EXPECT_GE(keptTimes().size(), 2 * times.size() - 2);
  EXPECT_NE(json()["points"][0]["rmse"], first["points"][0]["rmse"]);
}

TEST_F(ChartCommandLine, APeersPictureAndTimeStandBesideOurs) {
  ASSERT_EQ(laver("s.xml --reference --size 16x12 --spp 64 -o peer.exr --quiet").code, 0);
  ASSERT_EQ(chart("--spp 1 --peer Nori 0.25 peer.exr --peer Other 2e-3 peer.exr").code, 0)
      << contents(folder_ / "err.txt");
  const nlohmann::json points = json()["points"];
  const auto &nori = points[points.size() - 2], &other = points[points.size() - 1];
  EXPECT_EQ(nori["program"], "Nori");
  EXPECT_EQ(nori["seconds"]["median"], 0.25);
  EXPECT_EQ(nori["processSeconds"]["median"], 0.25);
  EXPECT_EQ(other["program"], "Other");
  EXPECT_EQ(other["seconds"]["median"], 0.002);
  EXPECT_EQ(other["rmse"], nori["rmse"]);
  EXPECT_LT(nori["rmse"], points[0]["rmse"]);  // 64 samples against 1
  EXPECT_NE(contents(folder_ / "c/chart.html").find("Nori"), std::string::npos);
}

TEST_F(ChartCommandLine, AProgramThatTakesLaversOptionsIsRunBesideIt) {
  ASSERT_EQ(chart("--spp 1").code, 0) << contents(folder_ / "err.txt");
  const auto before = keptTimes();
  write("old", "#!/bin/sh\nexec '" LAVER_BINARY "' \"$@\"\n");
  fs::permissions(folder_ / "old", fs::perms::owner_all);
  ASSERT_EQ(chart("--spp 1 --program old ./old").code, 0) << contents(folder_ / "err.txt");
  std::map<std::string, double> errors;
  const nlohmann::json all = json();
  for (const auto& point : all["points"])
    if (!point["adaptive"])
      errors[point["program"].get<std::string>() + " " + point["sampler"].get<std::string>() + " " +
             point["filter"].get<std::string>()] = point["rmse"];
  for (const std::string sampler : {" independent ", " stratified ", " sobol "})
    for (const char* filter : {"box", "tent", "gaussian", "mitchell"})
      EXPECT_EQ(errors.at("old" + sampler + filter), errors.at("laver" + sampler + filter));

  // laver's renders of those pictures were measured again, in turns with the program's.
  const auto after = keptTimes();
  const auto anew = std::count_if(before.begin(), before.end(), [&](const auto& kept) {
    return after.at(kept.first) != kept.second;
  });
  EXPECT_EQ(anew, 3 * 4);  // samplers, filters
}

TEST_F(ChartCommandLine, BadArgumentsAreOneLine) {
  write("text.exr", "no picture");
  writeExr(path("small.exr"), rgbImage(5, 5));
  Image grey = rgbImage(16, 12);
  grey.channels = {"X", "Y", "Z"};
  writeExr(path("grey.exr"), grey);
  constexpr const char* kSelf = "--program laver '" LAVER_BINARY "'";
  for (const char* more :
       {"--peer Nori 1", "--peer Nori fast small.exr", "--peer Nori 0 small.exr",
        "--peer Nori -1 small.exr", "--peer Nori 1 small.exr", "--peer Nori 1 none.exr",
        "--peer Nori 1 text.exr", "--peer Nori 1 grey.exr", "--program embree",
        "--program embree none", kSelf, "--metric ssim", "--size 16", "--size 0x4", "--runs 0",
        "--spp 0"}) {
    const Outcome run = chart(more);
    EXPECT_EQ(run.code, 2) << more << ": " << run.err;
    EXPECT_EQ(lines(run.err), 1) << more << ": " << run.err;
  }
  EXPECT_FALSE(fs::exists(folder_ / "c"));
  for (const char* arguments :
       {"chart", "chart s.xml --size 16", "chart s.xml --size 0x4", "chart s.xml --runs 0"})
    EXPECT_EQ(laver(arguments).code, 2) << arguments;
  EXPECT_EQ(laver("chart none.xml").code, 3);
  const Outcome failing = chart("--program broken /bin/false");
  EXPECT_EQ(failing.code, 1);
  EXPECT_EQ(lines(failing.err), 1) << failing.err;
  write("file", "x");
  EXPECT_EQ(laver("chart s.xml --out file/c --size 16x12").code, 1);
}

TEST_F(ChartCommandLine, GoesOnAfterCtrlC) {
  // A reference of so many samples takes minutes.
  const std::vector<std::string> arguments{"chart",  "s.xml", "--out",           "c",
                                           "--size", "64x48", "--spp",           "1",
                                           "--runs", "1",     "--reference-spp", "100000"};
  {
    Child child(folder_, arguments);
    while (!fs::exists(folder_ / "c/kept/running.json") && !child.ended()) ::usleep(2000);
    ::usleep(300000);
    child.send(SIGINT);
    EXPECT_EQ(child.wait(), 130);
  }
  EXPECT_NE(contents(folder_ / "err.txt").find("the same command goes on"), std::string::npos)
      << contents(folder_ / "err.txt");
  EXPECT_FALSE(fs::exists(folder_ / "c/chart.json"));
  EXPECT_FALSE(fs::exists(folder_ / "c/kept/running.exr"));
  EXPECT_GE(keptTimes().size(), 1U);  // the part of the reference that was done
}

}  // namespace
}  // namespace laver::test
