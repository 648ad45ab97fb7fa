// OBJ text to triangles in the file's space.
#include <gtest/gtest.h>

#include <filesystem>

#include "scene/obj.h"

namespace laver::test {
namespace {
using Triangles = std::vector<glm::uvec3>;

obj::ObjData parsed(const std::string& text) {
  auto result = obj::read(text);
  EXPECT_TRUE(result.errors.empty()) << result.errors[0].message;
  return std::move(result.data);
}

const std::string kPoints = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv -1 .5 0\n";

TEST(ObjLoad, TriangleQuadAndFan) {
  EXPECT_EQ(parsed(kPoints + "f 1 2 3\n").triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(parsed(kPoints + "f 1 2 3 4\n").triangles, (Triangles{{0, 1, 2}, {3, 0, 2}}));
  EXPECT_EQ(parsed(kPoints + "f 1 2 3 4 5\n").triangles,
            (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(ObjLoad, DiscOfManyCorners) {
  std::string text, face = "f";
  for (int i = 1; i <= 600; ++i) {
    text += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\n";
    face += " " + std::to_string(i);
  }
  const auto data = parsed(text + face + "\n");
  ASSERT_EQ(data.triangles.size(), 598u);
  EXPECT_EQ(data.triangles.back(), glm::uvec3(0, 598, 599));
}

TEST(ObjLoad, VerticesAreJoinedInTheOrderOfUse) {
  const auto data =
      parsed(kPoints + "vt 0 0\nvt 1 1\nf 3/1 2/1 1/1\nf 3/1 1/1 4/1\nf 3/2 1/1 5/2\n");
  EXPECT_EQ(data.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {4, 2, 5}}));
  ASSERT_EQ(data.positions.size(), 6u);
  EXPECT_EQ(data.positions[0], glm::dvec3(1, 1, 0));
  EXPECT_EQ(data.positions[4], data.positions[0]);
  EXPECT_EQ(data.uvs[0], glm::dvec2(0, 0));
  EXPECT_EQ(data.uvs[4], glm::dvec2(1, 1));
  EXPECT_TRUE(data.normals.empty());
}

TEST(ObjLoad, VerticesWithDifferentNormalsAreNotJoined) {
  const auto data = parsed(kPoints + "vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 2//1 4//1\n");
  EXPECT_EQ(data.triangles, (Triangles{{0, 1, 2}, {3, 1, 4}}));
  EXPECT_EQ(data.normals.at(3), glm::dvec3(0, 1, 0));
}

TEST(ObjLoad, AllFormsOfCorners) {
  const std::string rest = "vt .25 .5\nvn 0 0 2\n";
  const auto plain = parsed(kPoints + rest + "f 1 2 3\n");
  EXPECT_TRUE(plain.uvs.empty());
  EXPECT_TRUE(plain.normals.empty());
  const auto full = parsed(kPoints + rest + "f 1/1/1 2/1/1 3/1/1\n");
  EXPECT_EQ(full.uvs.at(2), glm::dvec2(.25, .5));
  EXPECT_EQ(full.normals.at(2), glm::dvec3(0, 0, 2));
  const auto noUv = parsed(kPoints + rest + "f 1//1 2//1 3//1\n");
  EXPECT_TRUE(noUv.uvs.empty());
  EXPECT_EQ(noUv.normals.at(1), glm::dvec3(0, 0, 2));
  const auto noNormal = parsed(kPoints + rest + "f 1/1 2/1 3/1\n");
  EXPECT_EQ(noNormal.uvs.at(1), glm::dvec2(.25, .5));
  EXPECT_TRUE(noNormal.normals.empty());
}

TEST(ObjLoad, MissingAttributesOfSomeCornersAreZero) {
  const auto data = parsed(kPoints + "vt 1 1\nvn 0 0 1\nf 1//1 2/1 3\n");
  ASSERT_EQ(data.normals.size(), 3u);
  EXPECT_EQ(data.normals[0], glm::dvec3(0, 0, 1));
  EXPECT_EQ(data.normals[1], glm::dvec3(0));
  ASSERT_EQ(data.uvs.size(), 3u);
  EXPECT_EQ(data.uvs[0], glm::dvec2(0));
  EXPECT_EQ(data.uvs[1], glm::dvec2(1));
}

TEST(ObjLoad, EmptyPartsAndPart0AreAbsent) {
  const std::string rest = "vt .25 .5\nvn 0 0 2\n";
  const auto bare = parsed(kPoints + rest + "f 1/ 2// 3/0\nf 1//0 2/0/0 3\n");
  EXPECT_EQ(bare.triangles, (Triangles{{0, 1, 2}, {0, 1, 2}}));
  EXPECT_TRUE(bare.uvs.empty());
  EXPECT_TRUE(bare.normals.empty());
  const auto some = parsed(kPoints + rest + "f 1/1/ 2/1/0 3/1\nf 1/0/1 2//1 3//-1\n");
  EXPECT_EQ(some.triangles, (Triangles{{0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(some.uvs.at(0), glm::dvec2(.25, .5));
  EXPECT_EQ(some.uvs.at(3), glm::dvec2(0));
  EXPECT_EQ(some.normals.at(0), glm::dvec3(0));
  EXPECT_EQ(some.normals.at(3), glm::dvec3(0, 0, 2));
}

TEST(ObjLoad, ConcavePolygonsAreCutInTheirPlane) {
  // An L in the plane y = 2. Only fans from its corners 1 and 4 stay inside; the face starts at 3.
  const std::string points = "v 0 2 0\nv 0 2 2\nv 1 2 2\nv 1 2 1\nv 2 2 1\nv 2 2 0\n";
  const auto before = parsed(points + "f 3 4 5 6 1 2\n");
  const auto after = parsed("f 3 4 5 6 1 2\n" + points);
  EXPECT_EQ(before.triangles, after.triangles);
  ASSERT_EQ(before.triangles.size(), 4u);
  double area = 0.0;
  for (const glm::uvec3& t : before.triangles) {
    const auto& p = before.positions;
    const double y = glm::cross(p[t.y] - p[t.x], p[t.z] - p[t.x]).y;
    EXPECT_GE(y, 0.0) << "winds as the face does";
    area += y / 2.0;
  }
  EXPECT_DOUBLE_EQ(area, 3.0);
}

TEST(ObjLoad, ConcaveQuadsStayAsNoriSplitsThem) {
  EXPECT_EQ(parsed("v 0 0 0\nv 2 0 0\nv .5 .5 0\nv 0 2 0\nf 2 3 4 1\n").triangles,
            (Triangles{{0, 1, 2}, {3, 0, 2}}));
}

TEST(ObjLoad, NegativeIndicesCountBackFromTheirLine) {
  const auto data = parsed("v 0 0 0\nv 1 0 0\nv 2 1 0\nf -3 -2 -1\nv 3 3 3\nf -1 -4 2\n");
  EXPECT_EQ(data.triangles, (Triangles{{0, 1, 2}, {3, 0, 1}}));
  EXPECT_EQ(data.positions.at(3), glm::dvec3(3, 3, 3));
}

TEST(ObjLoad, FacesMayComeBeforeTheirVertices) {
  EXPECT_EQ(parsed("f 1 2 3\n" + kPoints).positions.at(1), glm::dvec3(1, 0, 0));
}

TEST(ObjLoad, LayoutOfTheText) {
  const std::string crLf = "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n";
  EXPECT_EQ(parsed(crLf).triangles.size(), 1u);
  EXPECT_EQ(parsed("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r").triangles.size(), 1u);
  EXPECT_EQ(parsed("\xEF\xBB\xBFv 7 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3").positions.at(0).x, 7.0);
  EXPECT_EQ(parsed(" \tv  0 0\t0 \nv 1 0 0\nv 0 1 0 1.0\n  f\t1  2 3 \n").triangles.size(), 1u);
  const auto comments = parsed(
      "v 0 0 0 # a\nv 1 0 0\t#b\n"
      "v 0 1 0\n#v 9 9 9\nf 1 2 3 # c \\\nf 3 2 1\n");
  EXPECT_EQ(comments.triangles.size(), 2u);
  const auto joined = parsed("v 0 \\\n0 0\nv 1 0 \\\r\n0\nv 0 1 0\nf 1 \\\n 2 3\nf 3 2 1\n");
  EXPECT_EQ(joined.triangles.size(), 2u);
}

TEST(ObjLoad, OtherStatementsAreSkipped) {
  const auto data = parsed("mtllib none.mtl\no a\ng b c\ns off\nusemtl red\n" + kPoints +
                           "l 1 2\np 1\nf 1 2 3\ng\ns 1\nusemtl blue\nf 2 3 4\n");
  EXPECT_EQ(data.triangles.size(), 2u);
}

TEST(ObjLoad, ColoursAndWeightsOfVerticesAreSkipped) {
  EXPECT_EQ(parsed("v 1 2 3 .1 .2 .3\nv 4 5 6 1\nv 7 8 1 .1 .2 .3 .4\nf 1 2 3\n").positions.at(1),
            glm::dvec3(4, 5, 6));
}

TEST(ObjLoad, NumbersThatTinyobjloaderWouldLose) {
  const std::string zeros(400, '0');
  const auto data = parsed("v 0e999 1e-2147483648 -0.0e2147483647\nv 0." + zeros + "25e401 1" +
                           zeros + "e-400 -1e-9999999999\nv 1 " +
                           "0.10000000000000000000000000000001 3.0000000000000000000\nf 1 2 3\n");
  EXPECT_EQ(data.positions.at(0), glm::dvec3(0, 0, 0));
  EXPECT_EQ(data.positions.at(1), glm::dvec3(2.5, 1, 0));
  EXPECT_EQ(data.positions.at(2), glm::dvec3(1, .1, 3));
}

struct Text {
  const char* name;
  std::string text;
};
void PrintTo(const Text& text, std::ostream* out) { *out << text.name; }
const auto kName = [](const auto& info) { return std::string(info.param.name); };

class ObjPlain : public testing::TestWithParam<Text> {};

TEST_P(ObjPlain, IsParsedOnceAndNotChecked) {
  const auto result = obj::read(GetParam().text);
  EXPECT_FALSE(result.checked);
  EXPECT_EQ(result.data.triangles.size(), 1u);
}

const std::vector<Text> kPlain = {
    {"numbers",
     "v -1 +2. .5\nv 1e5 1E-05 -1.5e+005\nv 0 -0.000000 0.1234567890123456789012\n"
     "f 1 2 3\n"},
    {"corners", kPoints + "vt 0\nvt 0 0 0\nvn 0 0 1\nf 1/1/1 -2//-1 3/2\n"},
    {"lines", "# a \\\r\n\r\n \tv  0\t0 0 \r\nv 1 0 0\rv 0 1 0 .1 .2 .3\n  f\t1 2 3 "},
    {"statements", "mtllib C:\\a.mtl # b\no a\ng\ns off\nusemtl c\n" + kPoints + "l 1 2\nf 1 2 3"},
    {"face_first", "f 1 2 3\n" + kPoints},
};
INSTANTIATE_TEST_SUITE_P(Texts, ObjPlain, testing::ValuesIn(kPlain), kName);

// Valid texts that tinyobjloader would misread, or that need a warning.
class ObjMisread : public testing::TestWithParam<Text> {};

TEST_P(ObjMisread, IsCheckedFirst) {
  const auto result = obj::read(GetParam().text);
  EXPECT_TRUE(result.checked);
  EXPECT_TRUE(result.errors.empty());
  EXPECT_EQ(result.data.triangles.size(), 1u);
}

const std::vector<Text> kMisread = {
    {"comment_behind_a_face", kPoints + "f 1 2 3 # 4\n"},
    {"comment_behind_a_vertex", "v 0 0 0 #0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
    {"byte_order_mark", "\xEF\xBB\xBF" + kPoints + "f 1 2 3\n"},
    {"continued_face", kPoints + "f 1 2 \\\n3\n"},
    {"continued_ignored_line", kPoints + "vp 1 \\\nv 1 2 3\nf 1 2 3\n"},
    {"exponent_that_makes_nan", "v 0e999 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
    {"exponent_that_overflows", "v 1e-2147483648 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
    {"long_number", "v 1.00000000000000000000000 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n"},
    {"empty_parts", kPoints + "vt 0 0\nf 1/1/ 2// 3/\n"},
    {"part_0", kPoints + "vt 0 0\nf 1/1/0 2/0 3/0/0\n"},
    {"list_not_there", kPoints + "f 1//1 2//2 3//3\n"},
    {"face_of_two_corners", kPoints + "f 1 2\nf 1 2 3\n"},
    {"unknown_statement", "hello\n" + kPoints + "f 1 2 3\n"},
};
INSTANTIATE_TEST_SUITE_P(Texts, ObjMisread, testing::ValuesIn(kMisread), kName);

TEST(ObjLoad, ReadyMeshesAreParsedOnceAndNotChecked) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(LAVER_SOURCE_DIR "/scenes/meshes")) {
    if (entry.path().extension() != ".obj") continue;
    const auto loaded = obj::load(entry.path().string());
    EXPECT_FALSE(loaded.checked) << entry.path();
    EXPECT_TRUE(loaded.problem.empty() && loaded.errors.empty() && loaded.warnings.empty());
    if (entry.path().filename() == "bunny.obj") {
      EXPECT_EQ(loaded.data.triangles.size(), 69666u);
    }
    ++count;
  }
  EXPECT_GE(count, 2) << "no meshes: build the target laver_meshes";
}

}  // namespace
}  // namespace laver::test
