// laver_scenes: renders random scenes by the device and by the reference and prints the seeds of
// those that differ.
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <string>

#include "random/verdict.h"

using namespace laver::test;

int main(int argc, char** argv) {
  std::uint64_t from = 0, to = 100;
  bool verbose = false;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--seeds") == 0 && i + 1 < argc) {
      const std::string range = argv[++i];
      from = std::stoull(range);
      const auto dots = range.find("..");
      to = dots == std::string::npos ? from + 1 : std::stoull(range.substr(dots + 2));
    } else if (std::strcmp(argv[i], "-v") == 0) {
      verbose = true;
    }
  }
  Court court;
  int failures = 0, refused = 0;
  for (std::uint64_t seed = from; seed < to; ++seed) {
    const RandomScene random = randomScene(seed);
    const Verdict verdict = court.judge(random);
    failures += verdict.result == Verdict::Result::Failed;
    refused += verdict.result == Verdict::Result::Refused;
    if (verbose || verdict.result != Verdict::Result::Passed)
      fmt::print("{} {} {:.3f} {:.3f} {}\n    {}\n", seed,
                 verdict.result == Verdict::Result::Failed    ? "FAILED"
                 : verdict.result == Verdict::Result::Refused ? "refused"
                                                              : "passed",
                 verdict.differing, verdict.unexplained, verdict.why, random.traits);
    std::fflush(stdout);
  }
  fmt::print("{} scenes, {} failed, {} refused\n", to - from, failures, refused);
  return failures == 0 ? 0 : 1;
}
