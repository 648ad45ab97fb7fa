// Each allocation of laver's own that fails ends a render with one line and an exit code, or does
// not matter to it. Allocations of the driver and other libraries do not fail here
// (failing_new.cpp).
#include <gtest/gtest.h>

#include "pictures/command_line.h"

namespace laver::test {
namespace {

class Allocations : public CommandLine {
 protected:
  /// Renders a small picture in which allocation `number` fails, from 1; 0: none. `count` is a file
  /// for the number of all, or empty.
  Outcome renderWith(std::uint64_t number, const std::string& count = "") {
    return laver("'" LAVER_SOURCE_DIR
                 "/scenes/cornell-two-lights.xml' --size 24x16 --spp 1 --device \"$device\" "
                 "-o p.exr -q",
                 "LAVER_FAILING_ALLOCATION=" + std::to_string(number) +
                     " LAVER_COUNTED_ALLOCATIONS=" + count + " LD_PRELOAD='" LAVER_FAILING_NEW "'");
  }

  void expectClean(std::uint64_t number) {
    SCOPED_TRACE(testing::Message() << "allocation " << number);
    const Outcome outcome = renderWith(number);
    const std::set<std::string> found = files();
    if (outcome.code != 0) {
      EXPECT_LT(outcome.code, 10) << "not an exit code of laver";
      EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
    }
    // The last few allocations come after the picture is in its place.
    if (outcome.code == 0 || !found.empty()) {
      EXPECT_EQ(found, (std::set<std::string>{"p.exr", "p.png"}));
      EXPECT_EQ(contents(folder_ / "p.png"), whole_) << "another picture";
    }
    for (const std::string& name : found) fs::remove(folder_ / name);
  }

  /// Of a render without failures, whose PNG is kept.
  std::uint64_t countAll() {
    const Outcome outcome = renderWith(0, "count");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    whole_ = contents(folder_ / "p.png");
    const std::uint64_t count = std::stoull(contents(folder_ / "count"));
    for (const std::string& name : files()) fs::remove(folder_ / name);
    return count;
  }

 private:
  std::string whole_;
};

TEST_F(Allocations, ThatFailEndARenderInOneLine) {
  constexpr std::uint64_t kRuns = 100;
  const std::uint64_t count = countAll();
  EXPECT_GT(count, 1000U) << "allocations are not counted";
  for (std::uint64_t i = 0; i < kRuns; ++i) expectClean(1 + i * count / kRuns);
}

using FullAllocations = Allocations;

TEST_F(FullAllocations, ThatFailEndARenderInOneLine) {
  const std::uint64_t count = countAll();
  for (std::uint64_t i = 1; i <= count; ++i) expectClean(i);
}

}  // namespace
}  // namespace laver::test
