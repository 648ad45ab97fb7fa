#include "lab/suite/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
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
    ProcessRun run = runProcess(std::move(command), output, options_.stopped);
    result_.output = run.errorOutput + bytesOf(output);
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
      judge(actual, settings.bound);
    } catch (const Error& error) {
      result_.reason = error.what();
    }
    if (!options_.accept) return;
    if (result_.verdict == Verdict::Failed)
      accept("replaced, before: " + (result_.figure ? result_.figure->text() : result_.reason));
    else
      result_.change = "unchanged";
  }

  void judge(const Image& actual, const Bound& bound) {
    const Image expected = imageOf(test_.expected);
    if (options_.pictures) result_.expected = pngOf(expected);
    const Measured measured = measure(actual, expected, bound);
    if (actual.window != expected.window)
      throw Error(ExitCode::Usage, "the pictures are different parts of a film");
    if (options_.pictures)
      result_.difference = encodePng(drawDistances(measured.pixels, actual.width, actual.height));
    result_.figure = Figure{bound, figureOf(measured, bound)};
    if (result_.figure->isWithin()) {
      result_.verdict = Verdict::Passed;
      return;
    }
    const auto worst = std::ranges::max_element(measured.pixels);
    const auto index = static_cast<int>(worst - measured.pixels.begin());
    result_.reason = fmt::format("the largest difference is {:.3g}, at pixel ({}, {})", *worst,
                                 index % actual.width, index / actual.width);
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

std::string Figure::text() const {
  if (bound.maxShare)
    return fmt::format("share beyond {:g}: {:.3g}, tolerance {:g}", bound.tolerance, value,
                       *bound.maxShare);
  return fmt::format("{} {:.3g}, tolerance {:g}", bound.metric, value, bound.tolerance);
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
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace laver::suite
