// Errors of OBJ files that a lenient parser would misread.
#include <gtest/gtest.h>

#include "scene/obj.h"

namespace laver::test {
namespace {

struct Case {
  const char* name;
  std::string text;
  std::vector<std::string> errors;  // "line: message"
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

std::vector<std::string> lines(const std::vector<obj::Issue>& issues) {
  std::vector<std::string> result;
  result.reserve(issues.size());
  for (const auto& issue : issues) {
    result.push_back(std::to_string(issue.line) + ": " + issue.message);
  }
  return result;
}

const std::string kV = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

class ObjCheck : public testing::TestWithParam<Case> {};

TEST_P(ObjCheck, FindsTheLine) {
  const auto result = obj::read(GetParam().text);
  EXPECT_EQ(lines(result.errors), GetParam().errors);
  EXPECT_TRUE(result.data.triangles.empty());
}

const std::vector<Case> kCases = {
    {"zero_index", kV + "f 0 1 2\n", {"4: vertex index 0, OBJ counts from 1"}},
    {"normal_out_of_range",
     kV + "vn 0 0 1\nf 1//-2 2//1 3//1\n",
     {"5: normal index -2 goes back too far, there are 1 so far"}},
    {"back_to_later_normals",
     kV + "f 1//-1 2//1 3//1\nvn 0 0 1\n",
     {"4: normal index -1 goes back too far, there are 0 so far"}},
    {"index_too_large", kV + "\nf 1 2 4\n", {"5: vertex index 4 is out of range, the file has 3"}},
    {"index_huge",
     kV + "f 1 2 99999999999999999999\n",
     {"4: vertex index 9223372036854775807 is out of range, the file has 3"}},
    {"index_wraps_in_32_bits",
     kV + "f 1 2 4294967297\n",
     {"4: vertex index 4294967297 is out of range, the file has 3"}},
    {"uv_out_of_range",
     kV + "vt 0 0\nf 1/1 2/2 3/1\n",
     {"5: texture coordinate index 2 is out of range, the file has 1"}},
    {"back_too_far",
     kV + "f -1 -2 -4\n",
     {"4: vertex index -4 goes back too far, there are 3 so far"}},
    {"back_to_later_lines",
     "f -1 -2 -3\n" + kV,
     {"1: vertex index -1 goes back too far, there are 0 so far",
      "1: vertex index -2 goes back too far, there are 0 so far",
      "1: vertex index -3 goes back too far, there are 0 so far"}},
    {"word_for_an_index",
     kV + "f 1 2 x\n",
     {"4: \"x\" is not a corner, expected v, v/vt, v//vn or v/vt/vn"}},
    {"index_with_a_point",
     kV + "f 1 2 3.0\n",
     {"4: \"3.0\" is not a corner, expected v, v/vt, v//vn or v/vt/vn"}},
    {"slash_first",
     kV + "f /1 2 3\n",
     {"4: \"/1\" is not a corner, expected v, v/vt, v//vn or v/vt/vn"}},
    {"four_parts",
     kV + "vt 0 0\nvn 0 0 1\nf 1/1/1/1 2 3\n",
     {"6: \"1/1/1/1\" is not a corner, expected v, v/vt, v//vn or v/vt/vn"}},
    {"four_parts_of_which_three_are_empty",
     kV + "f 1/// 2 3\n",
     {"4: \"1///\" is not a corner, expected v, v/vt, v//vn or v/vt/vn"}},
    {"nan_of_windows", kV + "vn -1.#IND 0 1\n", {"4: \"-1.#IND\" is not a finite number"}},
    {"infinity_of_windows", "v 0 1.#INF00 1\n", {"1: \"1.#INF00\" is not a finite number"}},
    {"comment_in_a_word", "v 0 0 0#a\n", {"1: \"0#a\" is not a number"}},
    {"nan", "v 0 nan 0\n", {"1: \"nan\" is not a finite number"}},
    {"infinite", "vn 0 -inf 0\n", {"1: \"-inf\" is not a finite number"}},
    {"overflow", "v 0 0 1e400\n", {"1: \"1e400\" is too large for a number"}},
    {"word", "v 0 0 abc\n", {"1: \"abc\" is not a number"}},
    {"sign_alone", "v 0 - 0\n", {"1: \"-\" is not a number"}},
    {"point_alone", "v 0 0 .\n", {"1: \".\" is not a number"}},
    {"comma", "v 0,5 0 0\n", {"1: \"0,5\" is not a number"}},
    {"garbage_behind_a_number", "vt 0 1x\n", {"1: \"1x\" is not a number"}},
    {"two_coordinates", "v 0 0\n", {"1: \"v\" takes 3 to 8 numbers, found 2"}},
    {"no_coordinates", "v\n", {"1: \"v\" takes 3 to 8 numbers, found 0"}},
    {"short_normal", "vn 0 1\n", {"1: \"vn\" takes 3 numbers, found 2"}},
    {"empty_uv", "vt\n", {"1: \"vt\" takes 1 to 3 numbers, found 0"}},
    {"nul", std::string("v 0 0 0\n\0", 9), {"2: a NUL byte, expected a text file"}},
    {"line_behind_joined_ones",
     "v 0 \\\n 0 0\r\nv 1 \\\r\n0 x\nf 0\n",
     {"4: \"x\" is not a number", "5: vertex index 0, OBJ counts from 1"}},
    {"old_line_ends", "v 0 0 0\rv 0 0 x\r", {"2: \"x\" is not a number"}},
};
const auto kName = [](const auto& info) { return std::string(info.param.name); };
INSTANTIATE_TEST_SUITE_P(Faults, ObjCheck, testing::ValuesIn(kCases), kName);

// Another renderer's file, a web page in place of one, ...
TEST(ObjCheckKinds, TextWithoutAVertexOrAFaceIsNoObjFile) {
  EXPECT_EQ(
      lines(obj::read("# a\n<html>\n<p>404</p>\n").errors),
      (std::vector<std::string>{"2: \"<html>\" is no statement of OBJ, and no line of the file "
                                "is a vertex or a face"}));
  EXPECT_TRUE(obj::read("# exported\no nothing\n").errors.empty());
}

TEST(ObjCheckKinds, FacesOfFewCornersAreSkippedAndCounted) {
  const auto result = obj::read(kV + "f 1 2\nf 1 2 3\nf 3\nf\n");
  EXPECT_EQ(lines(result.warnings),
            (std::vector<std::string>{"4: faces of fewer than 3 corners are skipped: 3 in this "
                                      "file"}));
  EXPECT_EQ(result.data.triangles, (std::vector<glm::uvec3>{{0, 1, 2}}));
}

TEST(ObjCheckKinds, ListsThatTheFileDoesNotHaveAreWarnedOf) {
  const auto result = obj::read(kV + "f 1//1 2//2 3//-1\nf 1/7/1 2/8/1 3/99999999999999999999/1\n");
  EXPECT_TRUE(result.errors.empty());
  EXPECT_EQ(
      lines(result.warnings),
      (std::vector<std::string>{
          "4: 6 corners name normals, of which the file has none: the geometric normal is used",
          "5: 3 corners name texture coordinates, of which the file has none: they get none"}));
  EXPECT_EQ(result.data.triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 1, 2}}));
  EXPECT_TRUE(result.data.normals.empty());
  EXPECT_TRUE(result.data.uvs.empty());
}

TEST(ObjCheckKinds, PolygonsThatCrossThemselvesAreWarnedOf) {
  const std::string star =
      "v 0 1 0\nv -.6 -.8 0\nv .95 .3 0\nv -.95 .3 0\nv .6 -.8 0\n"
      "f 1 2 3\n";
  const std::string message =
      "the outline of this face crosses itself, as do 1 more: it has no inside to fill, and parts "
      "may be covered twice or not at all";
  const std::string plain = star + "\nf 1 2 3 4 5\nf 5 4 3 2 1\n";
  EXPECT_EQ(lines(obj::read(plain).warnings), (std::vector<std::string>{"8: " + message}));
  const std::string joined = star + "f 1 2 \\\r\n 3\r\nf 1 2\nf 1 2 3 \\\n4 5 # a\nf 5 4 3 2 1\n";
  EXPECT_EQ(lines(obj::read(joined).warnings),
            (std::vector<std::string>{
                "9: faces of fewer than 3 corners are skipped: 1 in this file", "10: " + message}));
}

TEST(ObjCheckLimits, TenErrorsAreEnough) {
  std::string text;
  for (int i = 0; i < 50; ++i) text += "v x 0 0\n";
  const auto errors = obj::read(text).errors;
  ASSERT_EQ(errors.size(), 10u);
  EXPECT_EQ(errors.back().line, 10u);
}

TEST(ObjCheckLimits, TooManyIndices) {
  const std::string text = kV + "f 1 2 3\nf 3 2 1\n";
  EXPECT_TRUE(obj::read(text, 6).errors.empty());
  EXPECT_EQ(lines(obj::read(text, 5).errors),
            (std::vector<std::string>{
                "1: too large: 3 vertices, 6 triangle corners, at most 5 of each are possible"}));
}

TEST(ObjCheckLimits, CountsWhatIsThere) {
  const std::string text = kV + "vt 1\nvn 0 0 1\nf 1 2 3\nf 1 2 3 1\nf 1 2 3 1 2\n";
  const obj::Counts expected{3, 1, 1, 3, 18};
  EXPECT_EQ(obj::check(text).counts, expected);
  EXPECT_EQ(obj::scanPlain(text), expected);
}

TEST(ObjCheckLimits, UnknownStatementsAreWarnedOfOnce) {
  const std::string text = "hello\n" + kV + "fv 1 2 3\nV 1 1 1\n";
  EXPECT_EQ(
      lines(obj::read(text).warnings),
      (std::vector<std::string>{"1: unknown statement \"hello\" is ignored, and so are 2 more "
                                "lines of unknown kinds"}));
}

TEST(ObjCheckLimits, OtherCountsThanTheParsersGiveNoData) {
  const std::string text = kV + "f 1 2 3\n";
  EXPECT_TRUE(obj::parse(text, obj::Counts{3, 0, 0, 1, 3}));
  EXPECT_FALSE(obj::parse(text, obj::Counts{3, 0, 0, 2, 6}));
  EXPECT_FALSE(obj::parse(text, obj::Counts{4, 0, 0, 1, 3}));
}

}  // namespace
}  // namespace laver::test
