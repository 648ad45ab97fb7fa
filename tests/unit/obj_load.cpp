// OBJ text to triangles in the file's space.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "scene/obj_data.h"
#include "support/scene_files.h"

namespace {
using namespace laver;
using Triangles = std::vector<glm::uvec3>;

obj::ObjData parsed(std::string text) {
  const auto checked = obj::check(text);
  EXPECT_TRUE(checked.errors.empty()) << (checked.errors.empty() ? "" : checked.errors[0].message);
  return obj::parse(text, checked.counts);
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

TEST(ObjLoad, VerticesWithOtherNormalsStayApart) {
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
      "v 0 0 0 # a\nv 1 0 0#b\n"
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

TEST(ObjLoad, BunnyInWellUnderAFifthOfASecond) {
  const std::string file = LAVER_SOURCE_DIR "/scenes/meshes/bunny.obj";
  double best = 1e9;
  for (int i = 0; i < 3; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const auto loaded = obj::load(file);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    best = std::min(best, took.count());
    EXPECT_EQ(loaded.data.triangles.size(), 69666u);
    EXPECT_TRUE(loaded.warnings.empty());
  }
  RecordProperty("milliseconds", static_cast<int>(best * 1e3));
  // Sanitizers and debug builds may take ten times as long.
  EXPECT_LT(best, 2.0);
}

}  // namespace
