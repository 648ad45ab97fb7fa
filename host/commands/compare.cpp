#include "image/compare.h"

#include <fmt/format.h>

#include <array>
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

// File names need not be UTF-8.
std::string dumped(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

/// The files, and the pixels that are compared if they are not all of both.
nlohmann::ordered_json filesOf(const CompareCommand& command, const Image& a, bool cut) {
  nlohmann::ordered_json json = {{"a", command.a}, {"b", command.b}};
  if (cut)
    json["compared"] = {
        {"width", a.width}, {"height", a.height}, {"x", a.window.x}, {"y", a.window.y}};
  return json;
}

/// The report as text or as JSON, where infinity and NaN become null.
std::string textOf(const CompareCommand& command, nlohmann::ordered_json json, const Measured& all,
                   bool within) {
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
  json["metric"] = command.metric;
  if (command.tolerance) {
    json["tolerance"] = tolerance;
    if (command.maxShare) json["maxShare"] = *command.maxShare;
    json["within"] = within;
  }
  if (all.flip) json["flip"] = jsonOf(*all.flip);
  for (const ChannelDifference& d : all.channels) {
    nlohmann::ordered_json& channel = json["channels"][d.channel];
    channel = jsonOf(d.distances);
    channel["rmse"] = d.rmse;
    channel["relmse"] = d.relativeMse;
  }
  return dumped(json);
}

/// Creates a folder if needed.
std::filesystem::path folderFor(const std::string& name) {
  std::error_code error;
  std::filesystem::create_directories(name, error);
  if (error)
    throw Error(ExitCode::Output, "cannot create the folder \"" + name + "\": " + error.message());
  return name;
}

/// Writes FOLDER/difference.exr and, in false colours, `pixels` as difference.png.
void writeDifference(const CompareCommand& command, const Image& a, const Image& b,
                     const std::vector<double>& pixels) {
  const std::filesystem::path folder = folderFor(command.out);
  writeExr((folder / "difference.exr").string(), difference(a, b),
           {{"comments", command.a + " minus " + command.b}});
  writePng((folder / "difference.png").string(), drawDistances(pixels, a.width, a.height));
}

std::string textOf(const CompareCommand& command, nlohmann::ordered_json json,
                   const NoiseTest& test) {
  if (command.json) {
    json["noise"] = {{"significance", command.limits.significance},
                     {"pass", command.limits.pass},
                     {"pixels", test.pixels},
                     {"agree", test.agree},
                     {"smallestP", test.smallest},
                     {"mean", {{"relativeDifference", test.meanDifference}, {"p", test.meanP}}},
                     {"equal", test.passed}};
    return dumped(json);
  }
  return fmt::format(
      "noise: {:.4f} % of {} pixels agree, {:.4f} % must; smallest p {:.3g}\n"
      "mean: relative difference {:.3g}, p {:.3g}\n{} at significance {:g}\n",
      100.0 * test.agree, test.pixels, 100.0 * command.limits.pass, test.smallest,
      test.meanDifference, test.meanP,
      test.passed ? "noise explains the difference" : "noise does not explain the difference",
      command.limits.significance);
}

/// FOLDER/p.exr and p.png: the corrected p of each pixel, in the picture as 1 - p.
void writeNoise(const CompareCommand& command, const NoiseTest& test, const Image& a) {
  const std::filesystem::path folder = folderFor(command.out);
  Image p = blackImage(a.width, a.height, {"p"});
  p.window = a.window;
  std::vector<double> oneMinusP;
  for (std::size_t i = 0; i < test.p.size(); ++i) {
    p.pixels[i] = static_cast<float>(test.p[i]);
    oneMinusP.push_back(1.0 - test.p[i]);
  }
  writeExr((folder / "p.exr").string(), p,
           {{"comments", "p of equal expectations: " + command.a + " and " + command.b}});
  writePng((folder / "p.png").string(), drawDistances(oneMinusP, a.width, a.height));
}

ExitCode runNoise(const CompareCommand& command, const Image& a, const Image& b, bool cut) {
  const std::array files = {command.a, command.b};
  const NoiseTest test = testNoise(a, b, command.limits, filterReachOf(files));
  std::cout << textOf(command, filesOf(command, a, cut), test);
  flushStandardOutput();
  if (!command.out.empty()) writeNoise(command, test, a);
  return test.passed ? ExitCode::Ok : ExitCode::Different;
}

}  // namespace

ExitCode run(const CompareCommand& command) {
  Image a = withoutPrefix(readExr(command.a));
  Image b = withoutPrefix(readExr(command.b));
  const bool cut = cutToShared(a, b);
  if (cut && !command.json)
    std::cout << fmt::format("compared where both have pixels: {}x{} from ({}, {})\n", a.width,
                             a.height, a.window.x, a.window.y);
  if (command.noise) return runNoise(command, a, b, cut);
  const Bound bound = boundOf(command);
  const Measured all = measure(a, b, bound);
  const bool within = figureOf(all, bound) <= limitOf(bound);
  std::cout << textOf(command, filesOf(command, a, cut), all, within);
  flushStandardOutput();
  if (!command.out.empty()) writeDifference(command, a, b, all.pixels);
  return !command.tolerance || within ? ExitCode::Ok : ExitCode::Different;
}

}  // namespace laver
