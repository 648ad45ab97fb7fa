#include "image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "commands/commands.h"
#include "commands/process.h"
#include "image/false_colour.h"
#include "image/io.h"

namespace laver {
namespace {

double valueOf(const ChannelDifference& d, const std::string& metric) {
  if (metric == "rmse") return d.rmse;
  if (metric == "relmse") return d.relativeMse;
  if (metric == "p999") return d.percentile999;
  return d.maximum;
}

/// Writes FOLDER/difference.exr and .png, and creates the folder if needed.
void writeDifference(const CompareCommand& command, const Image& a, const Image& b) {
  namespace fs = std::filesystem;
  const fs::path folder = command.out;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw Error(ExitCode::Output,
                "cannot make the folder \"" + command.out + "\": " + error.message());
  writeExr((folder / "difference.exr").string(), difference(a, b),
           {{"comments", command.a + " minus " + command.b}});
  writePng((folder / "difference.png").string(),
           drawDistances(largestDistances(a, b), a.width, a.height));
}

}  // namespace

ExitCode run(const CompareCommand& command) {
  Image a = withoutPrefix(readExr(command.a));
  Image b = withoutPrefix(readExr(command.b));
  if (cutToShared(a, b))
    std::cout << fmt::format("compared where both have pixels: {}x{} from ({}, {})\n", a.width,
                             a.height, a.window.x, a.window.y);
  const double tolerance = command.tolerance.value_or(0.0);
  const auto differences = compare(a, b, tolerance);
  std::cout << describe(differences, tolerance);
  flushStandardOutput();
  if (!command.out.empty()) writeDifference(command, a, b);
  if (!command.tolerance) return ExitCode::Ok;
  // Written so that NaN is beyond any tolerance.
  const bool within = std::all_of(differences.begin(), differences.end(), [&](const auto& d) {
    return valueOf(d, command.metric) <= tolerance;
  });
  return within ? ExitCode::Ok : ExitCode::Different;
}

}  // namespace laver
