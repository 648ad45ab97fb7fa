#include "lab/chart/measure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>

#include "core/error.h"
#include "lab/chart/fingerprint.h"

namespace laver::chart {

Measurer::Measurer(const Options& options, const Kept& kept)
    : options_(options),
      kept_(kept),
      runner_((std::filesystem::path(options.folder) / "kept").string()) {
  programs_["laver"] = {options.self, fingerprintOfFile(options.self)};
  for (const Program& program : options.programs)
    programs_[program.name] = {program.file, fingerprintOfFile(program.file)};
  sceneKey_ =
      fmt::format("{} {}x{}", fingerprintOfScene(options.scene), options.size.x, options.size.y);
}

std::string Measurer::keyOf(const Choice& choice) const {
  return fmt::format("{} {} {} {} runs {}", programs_.at(choice.series.program).fingerprint,
                     sceneKey_, fmt::join(commonArguments(), " "),
                     fmt::join(choice.arguments(), " "), options_.runs);
}

std::string Measurer::keyOfMethods() const {
  return fmt::format("{} methods {} {} runs {}", programs_.at("laver").fingerprint, sceneKey_,
                     fmt::join(commonArguments(), " "), options_.runs);
}

std::vector<std::string> Measurer::commonArguments() const {
  std::vector<std::string> list{options_.scene, "--size",
                                fmt::format("{}x{}", options_.size.x, options_.size.y)};
  if (!options_.device.empty()) list.insert(list.end(), {"--device", options_.device});
  if (options_.threads != 0)
    list.insert(list.end(), {"--threads", std::to_string(options_.threads)});
  return list;
}

Run Measurer::runOnce(const std::string& program, const std::vector<std::string>& arguments) const {
  throwIfStopped(options_);
  auto run = runner_.run(programs_.at(program).file, arguments, options_.stop);
  if (!run) throw Stopped{};
  return std::move(*run);
}

void Measurer::addRun(const Choice& choice, bool counts, nlohmann::json& record) const {
  auto arguments = commonArguments();
  for (const std::string& argument : choice.arguments()) arguments.push_back(argument);
  const Run run = runOnce(choice.series.program, arguments);
  if (!counts) return;
  record["samples"] = (run.stats.value("/samples/total"_json_pointer, 0.0) +
                       run.stats.value("/adaptive/pilotSamples"_json_pointer, 0.0)) /
                      options_.size.x / options_.size.y;
  const auto& seconds = run.stats["seconds"];
  record["pass"].push_back(seconds.value("trace", 0.0) + seconds.value("reconstruct", 0.0));
  record["process"].push_back(run.seconds);
}

nlohmann::json Measurer::pixels(const std::string& program) const {
  const Image image = rgbOf(runner_.picture(), "the picture of " + program);
  if (image.width != options_.size.x || image.height != options_.size.y)
    throw Error(ExitCode::Output, program + " left a picture of another size");
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(image.pixels.data());
  return nlohmann::json::binary(
      std::vector<std::uint8_t>(bytes, bytes + image.pixels.size() * sizeof(float)));
}

void Measurer::measureInTurns(const std::vector<Choice>& choices) const {
  if (std::all_of(choices.begin(), choices.end(),
                  [&](const Choice& choice) { return kept_.read(keyOf(choice)).has_value(); }))
    return;
  std::vector<nlohmann::json> records(choices.size());
  for (std::size_t run = 0; run <= options_.runs; ++run)
    for (std::size_t i = 0; i < choices.size(); ++i) {
      addRun(choices[i], run > 0, records[i]);  // the first warms caches up
      if (run == options_.runs) records[i]["pixels"] = pixels(choices[i].series.program);
    }
  for (std::size_t i = 0; i < choices.size(); ++i) kept_.write(keyOf(choices[i]), records[i]);
}

Measured Measurer::measured(const Choice& choice) const {
  const auto found = kept_.read(keyOf(choice));
  if (!found) throw Error(ExitCode::Output, "what was measured is not kept");
  Measured measured{found->at("pass"), found->at("process"), found->at("samples"),
                    rgbImage(options_.size.x, options_.size.y)};
  const auto& bytes = found->at("pixels").get_binary();
  if (bytes.size() != measured.image.pixels.size() * sizeof(float))
    throw Error(ExitCode::Output, "a kept picture has another size");
  std::memcpy(measured.image.pixels.data(), bytes.data(), bytes.size());
  return measured;
}

}  // namespace laver::chart
