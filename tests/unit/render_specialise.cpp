#include <gtest/gtest.h>

#include "render/specialise.h"

namespace laver::test {
namespace {

TEST(Specialise, AStackIsOnlyEverMadeDeeperAndBySteps) {
  Scene scene;
  scene.meshes.resize(1);
  scene.meshes[0].triangles.resize(1000);
  SpecConstants constants = specialise(scene, {});
  const SpecConstants guess = constants;
  EXPECT_FALSE(requireStack(constants, 1));
  EXPECT_FALSE(requireStack(constants, guess[shared::SPEC_STACK]));
  EXPECT_EQ(constants, guess);
  EXPECT_TRUE(requireStack(constants, guess[shared::SPEC_STACK] + 1));
  EXPECT_EQ(constants[shared::SPEC_STACK], guess[shared::SPEC_STACK] + 16);
}

TEST(Specialise, FewTrianglesNeedAShallowStack) {
  Scene scene;
  const auto stack = [&] { return specialise(scene, {})[shared::SPEC_STACK]; };
  EXPECT_EQ(stack(), 8U);
  scene.meshes.resize(2);
  scene.meshes[0].triangles.resize(8);
  EXPECT_EQ(stack(), 8U);
  scene.meshes[1].triangles.resize(1);
  EXPECT_EQ(stack(), 16U);
  scene.meshes[1].triangles.resize(1000);
  EXPECT_EQ(stack(), 64U);
}

TEST(Specialise, IndicesAreAsSmallAsTheirLargestNumber) {
  Scene scene;
  scene.integrator = Integrator::Normals;
  scene.meshes.resize(2);
  const auto bytes = [&] { return specialise(scene, {})[shared::SPEC_INDEX_BYTES]; };
  EXPECT_EQ(bytes(), 1U);
  // Number 0 is NO_NORMAL's.
  scene.meshes[0].normals.resize(200);
  scene.meshes[1].normals.resize(55);
  EXPECT_EQ(bytes(), 1U);
  scene.meshes[1].normals.resize(56);
  EXPECT_EQ(bytes(), 2U);
  scene.meshes[0].normals.resize(65535 - 56);
  EXPECT_EQ(bytes(), 2U);
  scene.meshes[0].normals.resize(65536 - 56);
  EXPECT_EQ(bytes(), 4U);
  scene.integrator = Integrator::Depth;
  EXPECT_EQ(bytes(), 1U);
}

TEST(Specialise, WithoutALightNothingIsTraced) {
  Scene scene;
  scene.meshes.resize(1);
  const auto hits = [&](Integrator integrator) {
    scene.integrator = integrator;
    return specialise(scene, {})[shared::SPEC_HITS];
  };
  EXPECT_EQ(hits(Integrator::Normals), 1U);
  EXPECT_EQ(hits(Integrator::Depth), 1U);
  EXPECT_EQ(hits(Integrator::AverageVisibility), 1U);
  EXPECT_EQ(hits(Integrator::AmbientOcclusion), 1U);
  EXPECT_EQ(hits(Integrator::ShadingNormal), 1U);
  EXPECT_EQ(hits(Integrator::Albedo), 1U);
  EXPECT_EQ(hits(Integrator::DirectWhitted), 0U);
  scene.environment = Environment();
  EXPECT_EQ(hits(Integrator::DirectWhitted), 1U);
  scene.environment.reset();
  scene.lights.resize(1);
  EXPECT_EQ(hits(Integrator::DirectWhitted), 1U);
}

TEST(Specialise, SpheresAreTestedWhereThereAreAnyAndRaysAreTraced) {
  Scene scene;
  scene.meshes.resize(9);
  const auto spheres = [&] { return specialise(scene, {})[shared::SPEC_SPHERES]; };
  EXPECT_EQ(spheres(), 0U);
  for (Mesh& mesh : scene.meshes) mesh.sphere = Sphere();
  EXPECT_EQ(spheres(), 1U);
  EXPECT_EQ(specialise(scene, {})[shared::SPEC_STACK], 16U);
  scene.integrator = Integrator::DirectWhitted;  // without a light
  EXPECT_EQ(spheres(), 0U);
}

TEST(Specialise, OnlyTheConstantsNamedAreMadeGeneric) {
  const SpecConstants needed = specialise(Scene{}, {});
  for (std::uint32_t c = 0; c < shared::SPEC_CONSTANTS; ++c) {
    const SpecConstants one = generalise(needed, 1U << c);
    for (std::uint32_t d = 0; d < shared::SPEC_CONSTANTS; ++d)
      EXPECT_EQ(one[d], c == d ? generalise(needed, kAllConstants)[d] : needed[d]);
  }
}

TEST(Specialise, WhatASceneDoesNotNeedIsLeftOut) {
  Scene scene;
  scene.meshes.resize(2);
  scene.meshes[0].normals.resize(3);
  scene.meshes[1].bsdf.albedo = glm::dvec3(0.1);
  scene.lights.resize(1);
  const auto of = [&](std::uint32_t constant) { return specialise(scene, {})[constant]; };
  const auto albedosAndLights = [&] {
    return std::pair(of(shared::SPEC_ALBEDOS), of(shared::SPEC_LIGHTS));
  };
  scene.integrator = Integrator::Depth;
  EXPECT_EQ(of(shared::SPEC_NORMALS), 0U);
  EXPECT_EQ(albedosAndLights(), std::pair(0U, 0U));
  scene.integrator = Integrator::Normals;
  EXPECT_EQ(of(shared::SPEC_NORMALS), 1U);
  EXPECT_EQ(albedosAndLights(), std::pair(0U, 0U));
  scene.integrator = Integrator::DirectWhitted;
  EXPECT_EQ(albedosAndLights(), std::pair(1U, 1U));
  scene.meshes[1].bsdf.albedo = scene.meshes[0].bsdf.albedo;
  scene.meshes[0].normals.clear();
  scene.lights.clear();
  EXPECT_EQ(of(shared::SPEC_NORMALS), 0U);
  EXPECT_EQ(albedosAndLights(), std::pair(0U, 0U));
}

}  // namespace
}  // namespace laver::test
