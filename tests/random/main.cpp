// laver_scenes: renders random scenes by the device and by the reference, prints the seeds of those
// that fail, and makes one that fails smaller.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "random/shrink.h"
#include "random/verdict.h"

namespace {

using namespace laver::test;

constexpr const char* kUsage =
    "laver_scenes --seeds A..B [--all]  render the scenes of seeds A to B - 1; print those that\n"
    "                                   fail or are refused, or with --all each\n"
    "laver_scenes --shrink SEED [DIR]   leave out what does not matter to its fault, and write\n"
    "                                   DIR/scene.xml (default: scene-SEED)\n";

const char* nameOf(Verdict::Result result) {
  constexpr const char* kNames[] = {"passed",     "refused",    "threw",    "dropped",
                                    "not finite", "other bits", "different"};
  return kNames[static_cast<std::size_t>(result)];
}

void print(std::uint64_t seed, const RandomScene& random, const Verdict& verdict) {
  fmt::print("{} {}: {} [{}]\n", seed, nameOf(verdict.result), verdict.why, random.traits);
  std::fflush(stdout);
}

int renderSeeds(std::uint64_t from, std::uint64_t to, bool all) {
  Court court;
  std::uint64_t failures = 0, refused = 0;
  for (const std::uint64_t seed : seedsByKind(from, to)) {
    const RandomScene random = randomScene(seed);
    const Verdict verdict = court.judge(random);
    failures += verdict.failed() ? 1 : 0;
    refused += verdict.result == Verdict::Result::Refused ? 1 : 0;
    if (all || verdict.result != Verdict::Result::Passed) print(seed, random, verdict);
  }
  fmt::print("{} scenes, {} failed, {} refused\n", to - from, failures, refused);
  return failures == 0 ? 0 : 1;
}

int shrink(std::uint64_t seed, const std::string& folder) {
  Court court;
  const RandomScene random = randomScene(seed);
  const Verdict verdict = court.judge(random);
  print(seed, random, verdict);
  if (!verdict.failed()) return 0;
  const RandomScene small =
      shrunk(random, [&](const RandomScene& r) { return court.judge(r).result == verdict.result; });
  fmt::print("{}: {}\n", folder, court.judge(small).why);
  std::filesystem::create_directories(folder);
  writeScene(small.scene, folder);
  return 1;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const std::string command = arguments.empty() ? "" : arguments[0];
  const std::string value = arguments.size() > 1 ? arguments[1] : "";
  if (command == "--seeds") {
    const std::size_t dots = value.find("..");
    const std::uint64_t from = std::stoull(value);
    const std::uint64_t to =
        dots == std::string::npos ? from + 1 : std::stoull(value.substr(dots + 2));
    return renderSeeds(from, to, arguments.size() > 2 && arguments[2] == "--all");
  }
  if (command == "--shrink")
    return shrink(std::stoull(value), arguments.size() > 2 ? arguments[2] : "scene-" + value);
  fmt::print("{}", kUsage);
  return 2;
} catch (const std::exception& fault) {
  fmt::print(stderr, "{}\n{}", fault.what(), kUsage);
  return 2;
}
