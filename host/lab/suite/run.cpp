#include "lab/suite/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <limits>
#include <span>
#include <sstream>
#include <variant>

#include "core/atomic_file.h"
#include "core/error.h"
#include "image/false_colour.h"
#include "image/io.h"
#include "image/picture.h"
#include "lab/process.h"
#include "lab/scratch.h"
#include "scene/text_source.h"

namespace laver::suite {
namespace {

namespace fs = std::filesystem;

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string bytesOf(const std::string& file) {
  xml::FileText read = xml::readFile(file);
  if (!read.problem.empty())
    throw Error(ExitCode::Output, fmt::format("\"{}\": {}", file, read.problem));
  return std::move(read.text);
}

/// The errors that laver printed, without warnings and without its name.
std::string errorsOf(const ProcessRun& run) {
  std::istringstream lines(run.errorOutput);
  std::string all;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.find("warning: ") != std::string::npos) continue;
    if (line.starts_with("laver: ")) line.erase(0, 7);
    all += (all.empty() ? "" : "\n") + line;
  }
  if (run.exitCode > 128)
    all = fmt::format("laver was ended by signal {}{}", run.exitCode - 128,
                      all.empty() ? "" : ": " + all);
  return all.empty() ? fmt::format("laver ended with exit code {}", run.exitCode) : all;
}

/// Values of an 8-bit picture are linear in [0, 1].
Image linear(Picture picture) {
  if (auto* image = std::get_if<Image>(&picture)) return std::move(*image);
  const auto& bitmap = std::get<Bitmap>(picture);
  Image image = rgbImage(bitmap.width, bitmap.height);
  auto to = image.pixels.begin();
  for (const Rgb8& pixel : bitmap.pixels)
    for (const std::uint8_t value : pixel) *to++ = static_cast<float>(linearOfSrgb(value / 255.0));
  return image;
}

/// An expected PNG is compared with the PNG that laver writes.
Image imageOf(const fs::path& file) {
  if (file.extension() == ".png") return linear(readPicture(file.string(), false));
  return withoutPrefix(readExr(file.string()));
}

std::vector<std::byte> pngOf(const Image& image) {
  for (const char* channel : {"R", "G", "B"})
    if (std::ranges::find(image.channels, channel) == image.channels.end()) return {};
  return encodePng(image);
}

/// Runs one test and records its result. Throws where it cannot be run.
class Run {
 public:
  Run(const Test& test, const Options& options, Result& result)
      : test_(test), options_(options), result_(result) {}

  void run() {
    if (!test_.problem.empty()) throw Error(ExitCode::Usage, test_.problem);
    if (test_.kind == Test::Kind::Hypothesis)
      testHypotheses();
    else
      comparePicture();
  }

 private:
  ProcessRun render(std::vector<std::string> more) {
    std::vector<std::string> command = {options_.self, test_.file.string()};
    command.insert(command.end(), options_.options.begin(), options_.options.end());
    command.insert(command.end(), more.begin(), more.end());
    const std::string output = scratch_.file("output.txt");
    const auto start = std::chrono::steady_clock::now();
    bool late = false;
    ProcessRun run = runProcess(std::move(command), output, [&] {
      late = late || secondsSince(start) > options_.timeout;
      return late || options_.stopped();
    });
    result_.output = run.errorOutput + bytesOf(output);
    if (late)
      throw Error(ExitCode::Output,
                  fmt::format("not done after {:g} s (--timeout)", options_.timeout));
    return run;
  }

  /// The last line that laver prints is the count of those that passed.
  void testHypotheses() {
    const ProcessRun run = render({});
    if (run.exitCode == static_cast<int>(ExitCode::Different)) {
      const std::string text = result_.output.substr(0, result_.output.find_last_not_of('\n') + 1);
      result_.reason = "hypotheses are rejected: " + text.substr(text.rfind('\n') + 1);
    } else if (run.exitCode == 0) {
      result_.verdict = Verdict::Passed;
    } else {
      throw Error(ExitCode::Scene, errorsOf(run));
    }
  }

  void comparePicture() {
    Settings settings;
    if (!test_.settings.empty()) settings = readSettings(test_.settings.string(), options_.check);
    if (settings.noise && test_.expected.extension() == ".png")
      throw Error(ExitCode::Usage,
                  "the metric noise needs an expected EXR file, PNG has no variances");
    const bool exists = fs::exists(test_.expected);
    if (!exists && !options_.accept)
      throw Error(ExitCode::Usage, "no expected picture; --accept writes one");
    const std::string exr = scratch_.file("actual.exr");
    std::vector<std::string> more = {"-q", "-o", exr};
    more.insert(more.end(), settings.options.begin(), settings.options.end());
    if (const ProcessRun run = render(more); run.exitCode != 0)
      throw Error(ExitCode::Scene, errorsOf(run));
    actualFile_ = fs::path(exr).replace_extension(test_.expected.extension());
    const Image actual = imageOf(actualFile_);
    if (options_.pictures) result_.actual = pngOf(actual);
    if (!exists) return accept("new");
    try {
      judge(actual, settings);
    } catch (const Error& error) {
      result_.reason = error.what();
    }
    if (!options_.accept) return;
    if (result_.verdict == Verdict::Failed)
      accept("replaced, before: " + (result_.figure ? result_.figure->text : result_.reason));
    else
      result_.change = "unchanged";
  }

  void judge(const Image& actual, const Settings& settings) {
    const Image expected = imageOf(test_.expected);
    if (options_.pictures) result_.expected = pngOf(expected);
    const bool sameSize = actual.width == expected.width && actual.height == expected.height;
    if (sameSize && actual.window != expected.window)
      throw Error(ExitCode::Usage, "the pictures are different parts of a film");
    const std::vector<double> pixels = settings.noise
                                           ? judgeNoise(actual, expected, *settings.noise)
                                           : judgeDistance(actual, expected, settings.bound);
    if (options_.pictures)
      result_.difference = encodePng(drawDistances(pixels, actual.width, actual.height));
    if (result_.figure->within) {
      result_.verdict = Verdict::Passed;
      return;
    }
    const auto worst = std::ranges::max_element(pixels);
    const auto index = static_cast<int>(worst - pixels.begin());
    result_.reason.append(settings.noise
                              ? "the least likely pixel is"
                              : fmt::format("the largest difference is {:.3g}, at pixel", *worst));
    result_.reason.append(fmt::format(" ({}, {})", index % actual.width, index / actual.width));
  }

  /// Differences of the pixels.
  std::vector<double> judgeDistance(const Image& actual, const Image& expected,
                                    const Bound& bound) {
    Measured measured = measure(actual, expected, bound);
    result_.figure = figureOf(laver::figureOf(measured, bound), bound);
    return std::move(measured.pixels);
  }

  /// 1 - p of the pixels.
  std::vector<double> judgeNoise(const Image& actual, const Image& expected,
                                 const NoiseLimits& limits) {
    const std::array files = {actualFile_.string(), test_.expected.string()};
    NoiseTest test = testNoise(actual, expected, limits, filterReachOf(files));
    result_.figure = figureOf(test, limits);
    for (double& p : test.p) p = 1.0 - p;
    return std::move(test.p);
  }

  void accept(const std::string& change) {
    const std::string bytes = bytesOf(actualFile_.string());
    replaceFile(test_.expected.string(), std::as_bytes(std::span(bytes)));
    result_.verdict = Verdict::Passed;
    result_.reason.clear();
    result_.figure.reset();
    result_.change = change;
  }

  const Test& test_;
  const Options& options_;
  Scratch scratch_;
  fs::path actualFile_;
  Result& result_;
};

}  // namespace

Figure figureOf(double value, const Bound& bound) {
  const double limit = limitOf(bound), infinite = std::numeric_limits<double>::infinity();
  Figure figure;
  figure.within = value <= limit;
  figure.share = limit > 0.0 ? value / limit : value > 0.0 ? infinite : 0.0;
  figure.text = bound.maxShare ? fmt::format("share beyond {:g}: {:.3g}, tolerance {:g}",
                                             bound.tolerance, value, *bound.maxShare)
                               : fmt::format("{} {:.3g}, tolerance {:g}", bound.metric, value,
                                             bound.tolerance);
  return figure;
}

Figure figureOf(const NoiseTest& test, const NoiseLimits& limits) {
  Figure figure = figureOf(1.0 - test.agree, Bound{"share", 1.0 - limits.pass, {}});
  // Both tests share the significance.
  figure.share = std::max(figure.share, 0.5 * limits.significance / test.meanP);
  figure.within = test.passed;
  figure.text =
      fmt::format("noise: {:.4g} % of the pixels agree, {:.4g} % must; mean {:+.2g} %, p {:.2g}",
                  100.0 * test.agree, 100.0 * limits.pass, 100.0 * test.meanDifference, test.meanP);
  return figure;
}

Result runTest(const Test& test, const Options& options) {
  Result result;
  result.name = test.name;
  if (!options.skip.empty()) {
    result.verdict = Verdict::Skipped;
    result.reason = options.skip;
    return result;
  }
  const auto start = std::chrono::steady_clock::now();
  try {
    Run(test, options, result).run();
  } catch (const std::exception& error) {
    result.reason = error.what();
  }
  result.seconds = secondsSince(start);
  return result;
}

}  // namespace laver::suite
