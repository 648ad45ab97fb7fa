#include <gtest/gtest.h>

#include "render/specialise.h"

namespace laver {
namespace {

TEST(Specialise, AStackIsOnlyEverMadeDeeperAndBySteps) {
  SpecConstants constants = specialise(Scene{}, {});
  const SpecConstants guess = constants;
  EXPECT_FALSE(requireStack(constants, 1));
  EXPECT_FALSE(requireStack(constants, guess[shared::SPEC_STACK]));
  EXPECT_EQ(constants, guess);
  EXPECT_TRUE(requireStack(constants, guess[shared::SPEC_STACK] + 1));
  EXPECT_EQ(constants[shared::SPEC_STACK], guess[shared::SPEC_STACK] + 16);
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
}  // namespace laver
