// The tables of scene objects: each row is complete, and omitted parts have safe defaults.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "reference/filter.h"
#include "scene/layers.h"
#include "scene/schema.h"
#include "scene/suggest.h"
#include "support/scene_files.h"

namespace laver::test {
namespace {

bool hasShader(const std::string& name) {
  const std::filesystem::path shaders = std::filesystem::path(LAVER_SOURCE_DIR) / "shaders";
  return std::filesystem::exists(shaders / "integrators" / (name + ".glsl"));
}

TEST(SceneRows, AnIntegratorHasAKernelATwinAndAnObjectOfItsOwn) {
  std::set<std::string> objects;
  for (const IntegratorRow* row : integratorRows()) {
    SCOPED_TRACE(row->name);
    EXPECT_TRUE(hasShader(row->name));
    EXPECT_NE(row->radiance, nullptr);
    ASSERT_NE(row->object, nullptr);
    EXPECT_TRUE(objects.insert(row->object).second);
    EXPECT_EQ(rowCalled(integratorRows(), row->name), row);
  }
}

TEST(SceneRows, ALayerIsNoIntegratorOfAScene) {
  for (const IntegratorRow* row : {&integrators::shadingNormal, &integrators::albedo}) {
    EXPECT_EQ(row->object, nullptr);
    EXPECT_TRUE(hasShader(row->name));
    EXPECT_NE(row->radiance, nullptr);
    EXPECT_EQ(rowCalled(integratorRows(), row->name), nullptr);
  }
}

TEST(SceneRows, AFilterKeepsEachOfItsProperties) {
  std::set<std::string> objects;
  for (const FilterRow* row : filterRows()) {
    SCOPED_TRACE(row->name);
    EXPECT_TRUE(objects.insert(row->object).second);
    ASSERT_EQ(row->members.size(), row->properties.size());
    const Filter filter = filterOf(*row);
    for (std::size_t i = 0; i < row->members.size(); ++i)
      EXPECT_EQ(Value(filter.*row->members[i]), row->properties[i].start);
    // Two implementations of one formula: a few roundings of numbers up to 8.
    for (const double x : {0.0, 0.3, 0.5, 0.7})
      EXPECT_NEAR(row->evaluate(filter, x * filter.radius),
                  row->twin->exact(filter, x * filter.radius), 1e-14);
    EXPECT_GT(row->evaluate(filter, 0.0), 0.0);
  }
}

TEST(SceneRows, ASamplerHasAnObjectAndATwin) {
  std::set<std::string> objects;
  for (const SamplerRow* row : samplerRows()) {
    SCOPED_TRACE(row->name);
    EXPECT_TRUE(objects.insert(row->object).second);
    EXPECT_NE(row->position, nullptr);
    EXPECT_NE(row->pair, nullptr);
  }
}

TEST(SceneRows, AnEmitterIsSampledOrSeenBehindTheScene) {
  for (const EmitterRow* row : emitterRows()) {
    EXPECT_FALSE(row->forms.empty()) << row->name;
    const bool background = row->background != nullptr;
    EXPECT_EQ(row->direction != nullptr, background) << row->name;
    EXPECT_EQ(row->density != nullptr, background) << row->name;
    // An area light is sampled as the surface of its mesh.
    if (row != &emitters::area) {
      EXPECT_NE(row->sample != nullptr, background) << row->name;
    }
  }
}

TEST(SceneRows, ATextureHasFormsAndATwin) {
  for (const TextureRow* row : textureRows()) {
    EXPECT_FALSE(row->forms.empty()) << row->name;
    EXPECT_NE(row->color, nullptr) << row->name;
    EXPECT_NE(row->describe, nullptr) << row->name;
  }
}

TEST(SceneRows, ALayerShowsAnIntegratorOrThePixelsCentre) {
  std::set<std::string> channels;
  for (const LayerRow* row : layerRows()) {
    SCOPED_TRACE(row->name);
    EXPECT_FALSE(row->integrator != nullptr && row->write != nullptr);
    EXPECT_FALSE(row->channels.empty());
    for (const std::string& channel : row->channels) EXPECT_TRUE(channels.insert(channel).second);
  }
}

TEST(SceneRows, EachPropertyHasAMeaningAndADefaultOfItsType) {
  for (const xml::ObjectRule& rule : xml::objectRules())
    for (const PropertyRow& row : rule.properties) {
      SCOPED_TRACE(std::string(rule.type) + " " + row.name);
      EXPECT_STRNE(row.meaning, "");
      const bool number = row.type == PropertyType::Float || row.type == PropertyType::Integer;
      if (number && !row.required) {
        EXPECT_EQ(problemOf(row, row.start), "");
      }
    }
}

TEST(SceneRows, AHintNamesAllIntegratorsOfTheTable) {
  const SceneFiles files;
  std::vector<std::string_view> names;
  for (const IntegratorRow* row : integratorRows()) names.emplace_back(row->name);
  EXPECT_NE(files.errors("<scene><integrator type=\"dept\"/></scene>")
                .find(xml::expectedNames("dept", names)),
            std::string::npos);
}

// An integrator that is rendered as a layer has the properties that the file gives it.
TEST(SceneRows, PropertiesOfTheFileApplyToALayer) {
  const SceneFiles files;
  SceneOverrides overrides;
  overrides.integrator = {&integrators::depth};
  const std::string av =
      "<scene><integrator type=\"av\"><float name=\"length\" value=\"3\"/></integrator></scene>";
  const Scene scene = files.load(av, overrides).scene;
  EXPECT_TRUE(scene.integrator.is(integrators::depth));
  EXPECT_EQ(useOf(scene, {&integrators::averageVisibility}).real("length"), 3.0);
  EXPECT_EQ(files.load(av).scene.integrator.real("length"), 3.0);
  overrides.integrator = {&integrators::averageVisibility};
  EXPECT_EQ(files.load(av, overrides).scene.integrator.real("length"), 3.0);
  EXPECT_EQ(IntegratorUse{&integrators::averageVisibility}.real("length"),
            std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace laver::test
