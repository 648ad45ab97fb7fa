#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"
#include "core/numeric.h"
#include "image/io.h"
#include "lab/chart/chart.h"
#include "lab/chart/films.h"
#include "lab/chart/machine.h"
#include "lab/chart/measure.h"
#include "lab/chart/pictures.h"

namespace laver::chart {
namespace {

/// Beyond so many samples a pixel the double-precision twin would take longer than all the rest.
constexpr std::uint32_t kMostJudged = 64;

class Maker {
 public:
  explicit Maker(const Options& options)
      : options_(options),
        kept_(std::filesystem::path(options.folder) / "kept"),
        measurer_(options, kept_),
        scene_(sceneWith(samplers::independent.name, 1)) {}

  Chart make() {
    probe();
    const auto choices = choicesFor(scene_, options_.programs, otherTraversals_, options_.samples);
    plan(choices);
    makeTruths();
    addPoints(choices);
    addPeers();
    judge(choices);
    addFloor();
    addMethods();
    return std::move(chart_);
  }

 private:
  Scene sceneWith(const std::string& sampler, std::uint32_t samples) const {
    SceneOverrides overrides;
    overrides.sampler = rowCalled(samplerRows(), sampler);
    overrides.size = options_.size;
    overrides.sampleCount = samples;
    return loadScene(options_.scene, overrides).scene;
  }

  /// What the device is and how it traces unasked.
  void probe() {
    auto arguments = measurer_.commonArguments();
    arguments.insert(arguments.end(), {"--spp", "1"});
    const Run run = measurer_.runOnce("laver", arguments);
    chart_.device = run.stats.value("device", "");
    chart_.driver = run.stats.value("driver", "");
    otherTraversals_ = traversalsBeside(run.stats.value("traversal", ""));
    chart_.scene = options_.scene;
    chart_.machine = machine();
    chart_.date = today();
    chart_.width = options_.size.x;
    chart_.height = options_.size.y;
    chart_.filters = filtersFor(scene_);
    chart_.truthSamples = squareFrom(options_.truthSamples);
  }

  /// Shares of the progress, by what things took on a machine of 2 threads.
  double pixels() const { return static_cast<double>(options_.size.x) * options_.size.y; }
  double truthCost() const { return 2.0 * options_.truthSamples * pixels() * 1.1e-6; }
  double costOf(const Choice& choice) const {
    return static_cast<double>(options_.runs + 1) *
           (0.3 + std::max(choice.samples, 1U) * pixels() * 9e-8);
  }
  double judgeCost(const Choice& choice) const {
    return isJudged(choice) ? choice.samples * pixels() * 4e-7 : 0.0;
  }
  void plan(const std::vector<Choice>& choices) {
    total_ = truthCost();
    for (const Choice& choice : choices) total_ += costOf(choice) + judgeCost(choice);
  }
  void report(double more) const {
    if (options_.progress) options_.progress(std::min(1.0, (done_ + more) / total_));
  }
  void finish(double cost) {
    done_ += cost;
    report(0.0);
  }

  void makeTruths() {
    TruthOptions truth;
    truth.samples = options_.truthSamples;
    truth.threads = options_.threads;
    truth.stop = options_.stop;
    truth.progress = [&](double share) { report(share * truthCost()); };
    const std::string key = fmt::format("laver {} {}", LAVER_VERSION, measurer_.sceneKey());
    chart_.truths = truthOf(scene_, chart_.filters, truth, kept_, key);
    if (chart_.truths.empty()) throw Stopped{};
    finish(truthCost());
  }

  std::size_t placeOf(const FilterRow* filter) const {
    std::size_t i = 0;
    while (chart_.filters[i].row != filter) ++i;
    return i;
  }

  void addPoints(const std::vector<Choice>& choices) {
    chart_.points.resize(choices.size());
    images_.resize(choices.size());
    for (const auto& group : sameButForProgram(choices)) {
      std::vector<Choice> members;
      members.reserve(group.size());
      for (const std::size_t i : group) members.push_back(choices[i]);
      measurer_.measureInTurns(members);
      for (const std::size_t i : group) setPoint(choices[i], chart_.points[i], images_[i]);
    }
  }

  void setPoint(const Choice& choice, Point& point, Image& image) {
    const Measured measured = measurer_.measured(choice);
    point.series = nameOf(choice.series);
    point.filter = choice.series.filter;
    point.program = choice.series.program;
    point.sampler = choice.series.sampler;
    point.adaptive = choice.series.adaptive;
    point.traversal = choice.series.traversal;
    point.samples = measured.samples;
    point.command =
        fmt::format("{} {} {}", choice.series.program, fmt::join(measurer_.commonArguments(), " "),
                    fmt::join(choice.arguments(), " "));
    point.passSeconds = measured.passSeconds;
    point.processSeconds = measured.processSeconds;
    image = measured.image;
    addErrors(image, point);
    if (options_.say)
      options_.say(fmt::format("{}, {:g} samples: {:.1f} ms, RMSE {:.3g}", point.series,
                               point.samples, quantile(point.passSeconds, 0.5) * 1e3,
                               point.errors.rmse));
    finish(costOf(choice));
  }

  void addErrors(const Image& image, Point& point) const {
    const Image& truth = chart_.truths[placeOf(point.filter)].image;
    point.errors = errorsOf(image, truth);
    point.thumbnail = thumbnailOf(image);
    point.errorMap = errorMapOf(image, truth);
  }

  void addPeers() {
    for (const Peer& peer : options_.peers) {
      const Image image = rgbOf(readExr(peer.file), peer.file);
      Point point;
      point.series = point.program = peer.name;
      point.filter = scene_.filter.row;
      point.passSeconds = point.processSeconds = {peer.seconds};
      addErrors(image, point);
      chart_.points.push_back(std::move(point));
    }
  }

  static bool isJudged(const Choice& choice) {
    return choice.samples != 0 && choice.samples <= kMostJudged;
  }

  /// Holds pictures against the double-precision pictures of the same samples, traced once for all
  /// filters.
  void judge(const std::vector<Choice>& choices) {
    std::map<std::pair<std::string, std::uint32_t>, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < choices.size(); ++i)
      if (isJudged(choices[i]))
        groups[{choices[i].series.sampler, choices[i].samples}].push_back(i);
    for (const auto& [group, members] : groups)
      judgeGroup(group.first, group.second, members, choices);
  }

  void judgeGroup(const std::string& sampler, std::uint32_t samples,
                  const std::vector<std::size_t>& members, const std::vector<Choice>& choices) {
    const auto keyOfMember = [&](std::size_t i) {
      return fmt::format("laver {} mismatches of {}", LAVER_VERSION, measurer_.keyOf(choices[i]));
    };
    const auto complete = std::all_of(members.begin(), members.end(),
                                      [&](std::size_t i) { return kept_.read(keyOfMember(i)); });
    if (!complete) {
      Scene scene = sceneWith(sampler, samples);
      const Reference reference(scene, options_.threads);
      Films films(chart_.width, chart_.height, chart_.filters, options_.threads);
      for (std::uint32_t s = 0; s < samples; ++s) {
        throwIfStopped(options_);
        films.add([&](int x, int y) { return glm::dvec2(reference.samplePosition(x, y, s)); },
                  [&](glm::dvec2 film) { return reference.radiance(film); });
      }
      for (const std::size_t i : members) {
        throwIfStopped(options_);
        if (kept_.read(keyOfMember(i))) continue;
        const std::size_t f = placeOf(choices[i].series.filter);
        scene.filter = chart_.filters[f];
        const Mismatches m =
            mismatchesOf(images_[i], films.picture(f), scene, reference, options_.threads);
        kept_.write(keyOfMember(i),
                    {{"pixels", m.pixels}, {"unexplained", m.unexplained}, {"rmse", m.rmse}});
      }
    }
    for (const std::size_t i : members) {
      const auto found = kept_.read(keyOfMember(i));
      chart_.points[i].mismatches =
          Mismatches{found->at("pixels"), found->at("unexplained"), found->at("rmse")};
      finish(judgeCost(choices[i]));
    }
  }

  /// Of laver's own pictures with the fewest flips at edges: their median of the most samples
  /// judged.
  void addFloor() {
    std::vector<double> floors;
    for (const Point& point : chart_.points)
      if (point.program == "laver" && point.mismatches) floors.push_back(point.mismatches->rmse);
    chart_.floatFloor = quantile(floors, 0.5);
  }

  void addMethods() {
    const std::string key = measurer_.keyOfMethods();
    auto found = kept_.read(key);
    if (!found) {
      found = nlohmann::json::array();
      try {
        for (const MethodPoint& m :
             chartMethods(scene_, options_.device, options_.runs, options_.stop))
          found->push_back(toJson(m));
      } catch (const Error& error) {  // a sphere, or a tree too large for one buffer
        if (options_.say) options_.say(std::string("panel C is left out: ") + error.what());
        return;
      }
      throwIfStopped(options_);
      kept_.write(key, *found);
    }
    for (const auto& entry : *found) chart_.methods.push_back(methodFromJson(entry));
  }

  const Options& options_;
  Kept kept_;
  Measurer measurer_;
  Scene scene_;
  std::vector<std::string> otherTraversals_;
  Chart chart_;
  std::vector<Image> images_;  // of the choices
  double total_ = 1, done_ = 0;
};

}  // namespace

std::optional<Chart> makeChart(const Options& options) {
  try {
    return Maker(options).make();
  } catch (const Stopped&) {
    return {};
  }
}

}  // namespace laver::chart
