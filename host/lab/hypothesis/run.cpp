#include "lab/hypothesis/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "lab/hypothesis/bsdf_source.h"
#include "lab/hypothesis/statistics.h"
#include "reference/bsdf.h"
#include "reference/emitter.h"
#include "reference/pcg32.h"
#include "reference/reference.h"
#include "scene/bsdfs.h"

namespace laver {
namespace {

using Print = std::function<void(const std::string&)>;

/// Runs one file's tests, in order, with one sequence of random numbers.
class Run {
 public:
  Run(const TestFile& file, const TestOptions& options, const Print& print)
      : file_(file),
        options_(options),
        print_(print),
        level_(sidakLevel(file.significanceLevel, testsOf(file))) {
    outcome_.tests = testsOf(file);
  }

  TestOutcome run() {
    if (!file_.scenes.empty()) {
      studentOfScenes();
    } else if (!file_.lights.empty()) {
      studentOfLights();
    } else {
      const BsdfSource source(file_.bsdfs, options_);
      if (file_.kind == TestFile::Kind::Student)
        studentOfBsdfs(source);
      else
        chiSquaredOfBsdfs(source);
    }
    print_(fmt::format("Passed {}/{} tests.\n", outcome_.passed, outcome_.tests));
    return outcome_;
  }

 private:
  static std::size_t testsOf(const TestFile& file) {
    return file.kind == TestFile::Kind::Student ? file.references.size()
                                                : file.bsdfs.size() * file.testCount;
  }

  void conclude(const Tested& tested, const std::string& statistic, const std::string& flaw) {
    const bool accepted = flaw.empty() && tested.p >= level_;
    print_(
        fmt::format("{} = {:.6g} (d.o.f. = {})\n{} the null hypothesis (p-value = {:.6g}, "
                    "significance level = {:.6g}){}\n\n",
                    statistic, tested.statistic, tested.freedom,
                    accepted ? "Accepted" : "***** Rejected *****", tested.p, level_, flaw));
    outcome_.passed += accepted ? 1 : 0;
  }

  void conclude(const Moments& sample, double reference, const std::string& flaw) {
    print_(
        fmt::format("Sample mean = {:.6g} (reference value = {:.6g})\nSample variance = {:.6g}\n",
                    sample.mean(), reference, sample.variance()));
    conclude(studentTest(sample, reference), "t-statistic", flaw);
  }

  void studentOfBsdfs(const BsdfSource& source) {
    std::size_t test = 0;
    for (std::size_t which = 0; which < file_.bsdfs.size(); ++which)
      for (const double degrees : file_.angles) {
        const double angle = degrees * std::numbers::pi / 180.0;
        print_(fmt::format("Testing BSDF {} ({}) at {} degrees, {} samples\n", which + 1,
                           file_.bsdfs[which].row->name, degrees, file_.sampleCount));
        Moments sample;
        std::size_t invalid = 0;
        for (const BsdfAnswer& a :
             source.answers(which, drawn({std::sin(angle), 0.0, std::cos(angle)}))) {
          const double value = reference::luminance(a.weight);
          if (std::isfinite(value))
            sample.add(value);
          else
            ++invalid;
        }
        conclude(sample, file_.references[test++], flawOf(invalid));
      }
  }

  void chiSquaredOfBsdfs(const BsdfSource& source) {
    for (std::size_t which = 0; which < file_.bsdfs.size(); ++which)
      for (std::uint32_t test = 0; test < file_.testCount; ++test) {
        const double cosine = random_.nextFloat(), sine = std::sqrt(1.0 - cosine * cosine);
        const double phi = 2.0 * std::numbers::pi * double{random_.nextFloat()};
        const glm::dvec3 wi(sine * std::cos(phi), sine * std::sin(phi), cosine);
        print_(fmt::format("Testing BSDF {} ({}), wi = ({:.4f}, {:.4f}, {:.4f}), {} samples\n",
                           which + 1, file_.bsdfs[which].row->name, wi.x, wi.y, wi.z,
                           file_.sampleCount));
        std::size_t invalid = 0;
        const std::vector<double> observed = histogram(source.answers(which, drawn(wi)), invalid);
        conclude(chiSquaredTest(observed, expectation(source, which, wi), file_.minExpFrequency),
                 "Chi^2 statistic", flawOf(invalid));
      }
  }

  static std::string flawOf(std::size_t invalid) {
    return invalid == 0 ? "" : fmt::format(": {} samples are not finite", invalid);
  }

  /// Questions with numbers of their own.
  std::vector<BsdfQuestion> drawn(const glm::dvec3& wi) {
    std::vector<BsdfQuestion> questions(file_.sampleCount, BsdfQuestion{});
    for (BsdfQuestion& q : questions) {
      q.wi = glm::vec3(wi);
      q.first = random_.nextFloat();
      q.second = random_.nextFloat();
      q.uv = {0.5F, 0.5F};
    }
    return questions;
  }

  /// Cells: rows of cos(theta) from -1 to 1, with columns of phi from 0 to 2 pi. Directions without
  /// weight end a path and are in no cell.
  std::vector<double> histogram(const std::vector<BsdfAnswer>& answers,
                                std::size_t& invalid) const {
    const auto rows = file_.resolution, columns = 2 * rows;
    std::vector<double> cells(std::size_t{rows} * columns);
    for (const BsdfAnswer& a : answers) {
      if (a.weight == glm::vec3(0.0F)) continue;
      const glm::dvec3 wo(a.wo), weight(a.weight);
      if (!std::isfinite(wo.x + wo.y + wo.z + weight.x + weight.y + weight.z)) {
        ++invalid;
        continue;
      }
      const auto cellOf = [](double share, std::uint32_t count) {
        const double place = std::floor(share * count);
        return static_cast<std::size_t>(std::clamp(place, 0.0, count - 1.0));
      };
      const double phi = std::atan2(wo.y, wo.x) / (2.0 * std::numbers::pi);
      cells[cellOf(0.5 * (wo.z + 1.0), rows) * columns +
            cellOf(phi < 0.0 ? phi + 1.0 : phi, columns)] += 1.0;
    }
    return cells;
  }

  /// The density's integral over each cell, times the number of samples: by the midpoint rule, with
  /// 640 rows. A lobe 0.1 wide is off by (0.2 / 64 / 0.1)^2 / 24 = 4e-5 of itself, where a million
  /// samples tell 1e-3 apart.
  std::vector<double> expectation(const BsdfSource& source, std::size_t which,
                                  const glm::dvec3& wi) const {
    const auto rows = file_.resolution, columns = 2 * rows;
    const std::uint32_t side = std::max(4U, 640U / rows);
    const double area =
        4.0 * std::numbers::pi / (static_cast<double>(rows) * columns * side * side);
    std::vector<double> cells(std::size_t{rows} * columns);
    for (std::uint32_t row = 0; row < rows; ++row) {
      std::vector<BsdfQuestion> questions;
      questions.reserve(std::size_t{columns} * side * side);
      for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < columns * side; ++x) {
          const double z = 2.0 * (row * side + y + 0.5) / (static_cast<double>(rows) * side) - 1.0;
          const double phi =
              2.0 * std::numbers::pi * (x + 0.5) / (static_cast<double>(columns) * side);
          const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
          const glm::vec3 wo(glm::dvec3(r * std::cos(phi), r * std::sin(phi), z));
          questions.push_back({.wi = glm::vec3(wi), .wo = wo, .uv = {0.5F, 0.5F}});
        }
      const auto answers = source.answers(which, questions);
      for (std::size_t i = 0; i < answers.size(); ++i)
        cells[std::size_t{row} * columns + i % (std::size_t{columns} * side) / side] +=
            double{answers[i].pdf} * area * file_.sampleCount;
    }
    return cells;
  }

  /// Lights without extent are not sampled: what arrives is one number, in double precision.
  void studentOfLights() {
    std::size_t test = 0;
    for (std::size_t which = 0; which < file_.lights.size(); ++which)
      for (const double distance : file_.distances) {
        const PointLight& light = file_.lights[which];
        print_(fmt::format("Testing emitter {} ({}) at (0, 0, {})\n", which + 1, light.row->name,
                           distance));
        const glm::dvec3 arriving =
            light.row->sample(light, {0.0, 0.0, distance}, std::abs(distance)).radiance;
        Moments sample;
        for (std::uint32_t i = 0; i < file_.sampleCount; ++i)
          sample.add(reference::luminance(arriving));
        conclude(sample, file_.references[test++], "");
      }
  }

  void studentOfScenes() {
    std::optional<Renderer> renderer;
    if (!options_.reference) renderer.emplace(options_.vulkan);
    for (std::size_t i = 0; i < file_.scenes.size(); ++i) {
      const Scene scene = sampled(file_.scenes[i]);
      print_(fmt::format("Testing scene {} ({}), {} samples\n", i + 1, scene.integrator.row->name,
                         scene.camera.width * scene.camera.height));
      Stats stats;
      const Rendered rendered = renderer ? renderer->render(scene, {}, stats)
                                         : Reference(scene, options_.threads).render();
      const Image& image = rendered.image;
      Moments sample;
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
          sample.add(
              reference::luminance({image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)}));
      conclude(sample, file_.references[i], flawOf(rendered.droppedSamples));
    }
  }

  /// The scene with a film of the same shape whose pixels are single samples, at least as many as
  /// the test wants. They cover the film evenly, so that their mean is nearer to the truth than the
  /// t-test assumes.
  Scene sampled(Scene scene) const {
    Camera& camera = scene.camera;
    const int divisor = std::gcd(camera.width, camera.height);
    const int width = camera.width / divisor, height = camera.height / divisor;
    const double shapes = static_cast<double>(file_.sampleCount) / width / height;
    const int side = std::max(1, static_cast<int>(std::ceil(std::sqrt(shapes))));
    camera.subpixels = std::max(1, (side + divisor - 1) / divisor);
    camera.width = width * side;
    camera.height = height * side;
    scene.filter = {&filters::box, 0.5, 0.0, 0.0, 0.0};
    scene.sampler = {};
    return scene;
  }

  const TestFile& file_;
  const TestOptions& options_;
  const Print& print_;
  double level_;
  reference::Pcg32 random_{1, 1};
  TestOutcome outcome_;
};

}  // namespace

TestOutcome runTests(const TestFile& file, const TestOptions& options,
                     const std::function<void(const std::string&)>& print) {
  return Run(file, options, print).run();
}

}  // namespace laver
