// XXH3 as laver uses it.
#include "core/hash.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/scene_files.h"

namespace laver::test {
namespace {

std::string hashOfParts(const std::vector<std::string>& parts) {
  Hash hash;
  for (const std::string& part : parts) hash.add(part);
  return hash.text();
}

TEST(Hash, DependsOnEveryByteAndOnTheirDivision) {
  EXPECT_EQ(hashOfParts({"ab", "c"}), hashOfParts({"ab", "c"}));
  EXPECT_NE(hashOfParts({"ab", "c"}), hashOfParts({"a", "bc"}));
  EXPECT_NE(hashOfParts({"ab", "c"}), hashOfParts({"ab", "d"}));
  EXPECT_NE(hashOfParts({"ab"}), hashOfParts({"ab", ""}));
}

TEST(Hash, OfAFileIsXxh3OfItsBytes) {
  const SceneFiles files;
  EXPECT_EQ(hashOfFile(files.write("empty", "")), "2d06800538d394c2");  // from the specification
  const std::string text(200000, 'x');
  EXPECT_EQ(hashOfFile(files.write("long", text)),
            fmt::format("{:016x}", hashOf(std::as_bytes(std::span(text)))));
  EXPECT_FALSE(hashOfFile(files.path("none")));
}

}  // namespace
}  // namespace laver::test
