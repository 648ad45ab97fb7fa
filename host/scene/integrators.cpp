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
glm::dvec3 simple(const CameraSample& sample);
glm::dvec3 whitted(const CameraSample& sample);
glm::dvec3 direct(const CameraSample& sample);
glm::dvec3 directEms(const CameraSample& sample);
glm::dvec3 directMats(const CameraSample& sample);
glm::dvec3 directMis(const CameraSample& sample);
glm::dvec3 pathEms(const CameraSample& sample);
glm::dvec3 pathMats(const CameraSample& sample);
glm::dvec3 pathMis(const CameraSample& sample);
glm::dvec3 photonMapper(const CameraSample& sample);
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
                    .meaning = "maximum distance of an occluder"}},
    .needs = {.normals = true, .numbers = true},
    .radiance = reference::averageVisibility};

const IntegratorRow ambientOcclusion{
    .name = "ao",
    .object = "AmbientOcclusionIntegrator",
    .properties = {{.name = "length",
                    .type = PropertyType::Float,
                    .start = 4.0,
                    .range = moreThan(0.0),
                    .unit = kDiagonals,
                    .meaning = "maximum distance of an occluder, endless from 1 on; 0.1 in the "
                               "dialect nori1"}},
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

static const IntegratorRow simple{
    .name = "simple",
    .object = "SimpleIntegrator",
    .properties = {{.name = "position",
                    .type = PropertyType::Point,
                    .start = glm::dvec3(0.0, 100.0, 0.0),
                    .required = true,
                    .unit = kSceneUnits,
                    .meaning = "of its only light; those of the scene are not used"},
                   {.name = "energy",
                    .type = PropertyType::Color,
                    .start = glm::dvec3(3.76e4),
                    .required = true,
                    .unit = kPowers,
                    .meaning = "of that light; every surface reflects energy / (4 pi^2) * cos / "
                               "distance^2"}},
    .needs = {.normals = true},
    .miss = Miss::Black,
    .looksOn = true,
    .radiance = reference::simple};

const PropertyRow kMaxDepth{.name = "max_depth",
                            .type = PropertyType::Integer,
                            .start = std::int64_t{0},
                            .range = fromTo(0, std::numeric_limits<std::int32_t>::max()),
                            .unit = "surfaces",
                            .meaning = "that scatter, at most; 0: no maximum"};

/// An integrator that follows paths, with light of all kinds.
IntegratorRow pathRow(const char* name, const char* object, std::vector<const char*> spellings,
                      glm::dvec3 (*radiance)(const reference::CameraSample&)) {
  return {.name = name,
          .spellings = std::move(spellings),
          .object = object,
          .needs = {.normals = true,
                    .materials = true,
                    .lights = true,
                    .emitters = true,
                    .background = true,
                    .numbers = true},
          .miss = Miss::Background,
          .bounces = true,
          .radiance = radiance};
}

IntegratorRow endless(IntegratorRow row) {
  row.properties = {kMaxDepth};
  return row;
}

// All that follow paths to their end have one expectation; their names say how they sample.
static const IntegratorRow whitted =
    pathRow("whitted", "WhittedIntegrator", {}, reference::whitted);
static const IntegratorRow direct = pathRow("direct", "DirectIntegrator", {}, reference::direct);
static const IntegratorRow directEms =
    pathRow("direct_ems", "DirectEmsIntegrator", {}, reference::directEms);
static const IntegratorRow directMats =
    pathRow("direct_mats", "DirectMatsIntegrator", {}, reference::directMats);
static const IntegratorRow directMis =
    pathRow("direct_mis", "DirectMisIntegrator", {}, reference::directMis);
static const IntegratorRow pathEms = endless(
    pathRow("path_ems", "PathEmsIntegrator", {"path_simple", "path_nee"}, reference::pathEms));
static const IntegratorRow pathMats =
    endless(pathRow("path_mats", "PathMatsIntegrator", {}, reference::pathMats));
static const IntegratorRow pathMis = endless(pathRow(
    "path_mis", "PathMisIntegrator", {"path", "mipath", "path_tracer"}, reference::pathMis));
static const IntegratorRow photonMapper = [] {
  IntegratorRow row = pathRow("photonmapper", "PhotonMapper", {}, reference::photonMapper);
  row.properties = {{.name = "photonCount",
                     .type = PropertyType::Integer,
                     .start = std::int64_t{1000000},
                     .meaning = "not used: no photons are stored"},
                    {.name = "photonRadius",
                     .type = PropertyType::Float,
                     .start = 0.0,
                     .unit = kSceneUnits,
                     .meaning = "not used: nothing is blurred"}};
  row.note =
      "rendered by paths as path_mis: a photon map has the same expectation, but blurs by "
      "its photonRadius";
  return row;
}();

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
  user->row.needs.emitters = user->text.find("emitter/sources.glsl") != std::string::npos;
  IntegratorUse use{&user->row};
  use.user = std::move(user);
  return use;
}

const Rows<IntegratorRow>& integratorRows() {
  using namespace integrators;
  static const Rows<IntegratorRow> rows = {
      &normals,          &directWhitted,    &depth,        &averageVisibility,
      &ambientOcclusion, &geometricNormals, &whitted,      &direct,
      &directEms,        &directMats,       &directMis,    &pathEms,
      &pathMats,         &pathMis,          &photonMapper, &simple};
  return rows;
}

}  // namespace laver
