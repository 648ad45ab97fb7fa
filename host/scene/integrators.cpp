#include "scene/integrators.h"

#include <filesystem>
#include <limits>

#include "scene/user_text.h"

namespace laver {

// host/reference/integrators/NAME.cpp
namespace reference {
glm::dvec3 normals(const CameraSample& sample);
glm::dvec3 directWhitted(const CameraSample& sample);
glm::dvec3 depth(const CameraSample& sample);
glm::dvec3 averageVisibility(const CameraSample& sample);
glm::dvec3 ambientOcclusion(const CameraSample& sample);
glm::dvec3 shadingNormal(const CameraSample& sample);
glm::dvec3 albedo(const CameraSample& sample);
glm::dvec3 geometricNormals(const CameraSample& sample);
}  // namespace reference

namespace integrators {

const IntegratorRow normals{.name = "normals",
                            .object = "NormalIntegrator",
                            .needs = {.normals = true},
                            .miss = Miss::Black,
                            .radiance = reference::normals};

const IntegratorRow directWhitted{
    .name = "direct_whitted",
    .object = "DirectWhittedIntegrator",
    .needs = {.normals = true, .materials = true, .lights = true, .background = true},
    .miss = Miss::Background,
    .litOnly = true,
    .radiance = reference::directWhitted};

const IntegratorRow depth{.name = "depth",
                          .object = "DepthIntegrator",
                          .miss = Miss::Black,
                          .radiance = reference::depth};

const IntegratorRow averageVisibility{
    .name = "av",
    .object = "AverageVisibilityIntegrator",
    .properties = {{.name = "length",
                    .type = PropertyType::Float,
                    .start = std::numeric_limits<double>::infinity(),
                    .required = true,
                    .range = moreThan(0.0),
                    .unit = kSceneUnits,
                    .meaning = "how far it looks"}},
    .needs = {.normals = true, .numbers = true},
    .radiance = reference::averageVisibility};

const IntegratorRow ambientOcclusion{.name = "ao",
                                     .object = "AmbientOcclusionIntegrator",
                                     .needs = {.normals = true, .numbers = true},
                                     .miss = Miss::Black,
                                     .radiance = reference::ambientOcclusion};

const IntegratorRow shadingNormal{.name = "shading_normal",
                                  .needs = {.normals = true, .negative = true},
                                  .miss = Miss::Black,
                                  .radiance = reference::shadingNormal};

const IntegratorRow albedo{.name = "albedo",
                           .needs = {.materials = true},
                           .miss = Miss::Black,
                           .radiance = reference::albedo};

static const IntegratorRow geometricNormals{.name = "geometric_normals",
                                            .object = "GeometricNormalIntegrator",
                                            .miss = Miss::Black,
                                            .radiance = reference::geometricNormals};

}  // namespace integrators

bool IntegratorUse::operator==(const IntegratorUse& other) const {
  if (row == other.row) return true;
  std::error_code error;
  return user && other.user && std::filesystem::equivalent(user->file, other.user->file, error);
}

std::optional<IntegratorUse> userIntegrator(const std::string& file) {
  std::optional<std::string> text = userText(file);
  if (!text) return {};
  auto user = std::make_shared<UserIntegrator>();
  user->name = std::filesystem::path(file).stem().string();
  user->file = file;
  user->text = std::move(*text);
  user->row.name = user->row.object = user->name.c_str();
  user->row.needs = {
      .normals = true, .materials = true, .lights = true, .background = true, .numbers = true};
  IntegratorUse use{&user->row};
  use.user = std::move(user);
  return use;
}

const Rows<IntegratorRow>& integratorRows() {
  using namespace integrators;
  static const Rows<IntegratorRow> rows = {
      &normals, &directWhitted, &depth, &averageVisibility, &ambientOcclusion, &geometricNormals};
  return rows;
}

}  // namespace laver
