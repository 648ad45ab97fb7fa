#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "bench/bench.h"
#include "bench/scenes.h"
#include "core/error.h"
#include "scene/obj.h"
#include "scene/text_source.h"

namespace laver::bench {
namespace {

// A file that is removed with the object.
struct TemporaryObj {
  explicit TemporaryObj(const Mesh& mesh)
      : path(std::filesystem::temp_directory_path() / "laver-bench.obj") {
    std::ofstream out(path);
    for (const glm::dvec3& p : mesh.positions)
      out << fmt::format("v {:.6} {:.6} {:.6}\n", p.x, p.y, p.z);
    for (const glm::uvec3& t : mesh.triangles)
      out << fmt::format("f {} {} {}\n", t.x + 1, t.y + 1, t.z + 1);
  }
  ~TemporaryObj() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
  TemporaryObj(const TemporaryObj&) = delete;
  TemporaryObj& operator=(const TemporaryObj&) = delete;

  std::filesystem::path path;
};

template <class Work>
double secondsOf(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void benchFile(Report& report, const std::string& title, const std::string& file,
               std::size_t rounds) {
  const std::string text = xml::readFile(file).text;
  const auto counts = obj::scanPlain(text);
  if (!counts) throw Error(ExitCode::Output, file + " needs a check, or is missing");
  std::vector<double> load, scan, parse, check;
  for (std::size_t round = 0; round < rounds; ++round) {
    load.push_back(secondsOf([&] { obj::load(file); }));
    scan.push_back(secondsOf([&] { obj::scanPlain(text); }));
    parse.push_back(secondsOf([&] { obj::parse(text, *counts); }));
    check.push_back(secondsOf([&] { obj::check(text); }));
  }
  report.section("OBJ file: " + title,
                 {{"bytes", text.size()}, {"triangles", counts->indices / 3}});
  report.timing("load", load);
  report.timing("of it scan", scan, 0, median(load));
  report.timing("of it parse", parse, 0, median(load));
  report.timing("check, for texts that are not plain", check, 0, median(load));
}

}  // namespace

void benchFiles(Report& report, const Rounds& rounds) {
  benchFile(report, "bunny", sceneFile("scenes/meshes/bunny.obj"), rounds.files);
  if (rounds.brief) return;
  const TemporaryObj large(benchScene("bunny", 2, "direct_whitted", 1).meshes.at(0));
  benchFile(report, "bunny x16", large.path.string(), rounds.files);
}

}  // namespace laver::bench
