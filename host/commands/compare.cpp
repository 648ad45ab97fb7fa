#include "image/compare.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "commands/commands.h"
#include "commands/process.h"
#include "image/false_colour.h"
#include "image/io.h"
#include "image/measure.h"

namespace laver {
namespace {

Bound boundOf(const CompareCommand& command) {
  return {command.metric, command.tolerance.value_or(0.0), command.maxShare};
}

nlohmann::ordered_json jsonOf(const Distribution& d) {
  nlohmann::ordered_json json;
  for (const Statistic& statistic : kStatistics) json[statistic.name] = d.*statistic.value;
  json["share"] = d.share;
  return json;
}

/// JSON has no infinity: null.
std::string textOf(const CompareCommand& command, const Measured& all, bool within) {
  const double tolerance = command.tolerance.value_or(0.0);
  if (!command.json) {
    std::string text = describe(all.channels, tolerance);
    if (all.flip)
      text += fmt::format(
          "{}: mean {:.4g}, median {:.4g}, 95th percentile {:.4g}, 99th {:.4g}, maximum {:.4g}, "
          "beyond {:g} {:.4g} %\n",
          command.metric == "flip" ? "HDR-FLIP" : "LDR-FLIP", all.flip->mean, all.flip->median,
          all.flip->percentile95, all.flip->percentile99, all.flip->maximum, tolerance,
          100.0 * all.flip->share);
    return text;
  }
  nlohmann::ordered_json json = {{"a", command.a}, {"b", command.b}, {"metric", command.metric}};
  if (command.tolerance) {
    json["tolerance"] = tolerance;
    json["within"] = within;
  }
  if (all.flip) json["flip"] = jsonOf(*all.flip);
  for (const ChannelDifference& d : all.channels) {
    nlohmann::ordered_json& channel = json["channels"][d.channel];
    channel = jsonOf(d.distances);
    channel["rmse"] = d.rmse;
    channel["relmse"] = d.relativeMse;
  }
  // File names need not be UTF-8.
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

/// Writes FOLDER/difference.exr and .png, and creates the folder if needed. The latter shows
/// `pixels`.
void writeDifference(const CompareCommand& command, const Image& a, const Image& b,
                     const std::vector<double>& pixels) {
  namespace fs = std::filesystem;
  const fs::path folder = command.out;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw Error(ExitCode::Output,
                "cannot make the folder \"" + command.out + "\": " + error.message());
  writeExr((folder / "difference.exr").string(), difference(a, b),
           {{"comments", command.a + " minus " + command.b}});
  writePng((folder / "difference.png").string(), drawDistances(pixels, a.width, a.height));
}

}  // namespace

ExitCode run(const CompareCommand& command) {
  Image a = withoutPrefix(readExr(command.a));
  Image b = withoutPrefix(readExr(command.b));
  if (cutToShared(a, b) && !command.json)
    std::cout << fmt::format("compared where both have pixels: {}x{} from ({}, {})\n", a.width,
                             a.height, a.window.x, a.window.y);
  const Bound bound = boundOf(command);
  const Measured all = measure(a, b, bound);
  const bool within = figureOf(all, bound) <= limitOf(bound);
  std::cout << textOf(command, all, within);
  flushStandardOutput();
  if (!command.out.empty()) writeDifference(command, a, b, all.pixels);
  return !command.tolerance || within ? ExitCode::Ok : ExitCode::Different;
}

}  // namespace laver
