// The rows of all BSDFs.
#include "scene/bsdfs.h"

namespace laver {

// host/reference/bsdf/NAME.cpp
#define LAVER_BSDF_TWIN(name)                                                  \
  glm::dvec3 name##Eval(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo); \
  double name##Pdf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo);      \
  BsdfSample name##Sample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2 numbers)
namespace reference {
LAVER_BSDF_TWIN(diffuse);
LAVER_BSDF_TWIN(mirror);
LAVER_BSDF_TWIN(dielectric);
LAVER_BSDF_TWIN(microfacet);
LAVER_BSDF_TWIN(roughconductor);
LAVER_BSDF_TWIN(roughsubstrate);
LAVER_BSDF_TWIN(conductor);
LAVER_BSDF_TWIN(microfacetConductor);
LAVER_BSDF_TWIN(microfacetDielectric);
LAVER_BSDF_TWIN(phong);
LAVER_BSDF_TWIN(disney);
LAVER_BSDF_TWIN(null);
}  // namespace reference
#undef LAVER_BSDF_TWIN

namespace bsdfs {
namespace {

PropertyRow color(const char* name, glm::dvec3 start, const char* meaning, Range range = {}) {
  return {.name = name,
          .type = PropertyType::Color,
          .start = start,
          .range = range,
          .meaning = meaning};
}

PropertyRow real(const char* name, double start, const char* meaning, Range range = {}) {
  return {.name = name,
          .type = PropertyType::Float,
          .start = start,
          .range = range,
          .meaning = meaning};
}

PropertyRow share(const char* name, double start, const char* meaning) {
  return real(name, start, meaning, fromTo(0.0, 1.0));
}

PropertyRow interior() {
  return real("intIOR", 1.5046, "index of refraction inside", moreThan(0.0));
}
PropertyRow exterior() {
  return real("extIOR", 1.000277, "index of refraction outside", moreThan(0.0));
}

PropertyRow alpha() {
  return real("alpha", 0.1, "roughness of Beckmann's distribution; below 0.001 it is 0.001",
              moreThan(0.0));
}

PropertyRow diffuseShare() {
  return color("kd", glm::dvec3(0.5), "share of diffuse reflection", fromTo(0.0, 1.0));
}

PropertyRow material(const char* meaning) {
  return {
      .name = "material", .type = PropertyType::String, .start = std::string(), .meaning = meaning};
}
/// The parts of a conductor's complex index of refraction.
PropertyRow realIndex(const char* name, glm::dvec3 start) {
  return color(name, start, "index of refraction", moreThan(0.0));
}
PropertyRow imaginaryIndex(const char* name, glm::dvec3 start) {
  return color(name, start, "its imaginary part", atLeast(0.0));
}

PropertyRow baseColor() {
  PropertyRow row =
      color("baseColor", glm::dvec3(0.5), "linear; also called albedo", fromTo(0.0, 1.0));
  row.spelling = "albedo";
  return row;
}

const glm::dvec3 kGoldEta(0.143, 0.375, 1.442), kGoldK(3.983, 2.386, 1.603);
const glm::dvec3 kCopperEta(0.200, 0.924, 1.102), kCopperK(3.913, 2.452, 2.142);
const glm::dvec3 kChromeEta(4.370, 2.917, 1.655), kChromeK(5.206, 4.231, 3.755);

/// Metals by their symbols, of a row that names its index of refraction so.
std::vector<NamedMaterial> metals(const char* eta, const char* k) {
  return {{"Au", {{eta, kGoldEta}, {k, kGoldK}}},
          {"Cu", {{eta, kCopperEta}, {k, kCopperK}}},
          {"Cr", {{eta, kChromeEta}, {k, kChromeK}}}};
}

const BsdfRow mirror{.name = "mirror",
                     .object = "Mirror",
                     .delta = true,
                     .eval = reference::mirrorEval,
                     .pdf = reference::mirrorPdf,
                     .sample = reference::mirrorSample};

const BsdfRow dielectric{.name = "dielectric",
                         .object = "Dielectric",
                         .properties = {interior(), exterior()},
                         .delta = true,
                         .transmissive = true,
                         .eval = reference::dielectricEval,
                         .pdf = reference::dielectricPdf,
                         .sample = reference::dielectricSample};

const BsdfRow microfacet{.name = "microfacet",
                         .object = "Microfacet",
                         .properties = {alpha(), interior(), exterior(), diffuseShare()},
                         .eval = reference::microfacetEval,
                         .pdf = reference::microfacetPdf,
                         .sample = reference::microfacetSample};

const BsdfRow roughsubstrate{.name = "roughsubstrate",
                             .object = "RoughSubstrate",
                             .properties = {alpha(), interior(), exterior(), diffuseShare()},
                             .eval = reference::roughsubstrateEval,
                             .pdf = reference::roughsubstratePdf,
                             .sample = reference::roughsubstrateSample};

const BsdfRow conductor{
    .name = "conductor",
    .object = "Conductor",
    .properties = {material("Au, Cu or Cr, for eta and k"), realIndex("eta", kGoldEta),
                   imaginaryIndex("k", kGoldK),
                   color("specularReflectance", glm::dvec3(1.0), "factor", atLeast(0.0))},
    .materials = metals("eta", "k"),
    .delta = true,
    .eval = reference::conductorEval,
    .pdf = reference::conductorPdf,
    .sample = reference::conductorSample};

const BsdfRow microfacetConductor{
    .name = "microfacet_conductor",
    .object = "MicrofacetConductor",
    .properties = {alpha(), material("Au, Cu or Cr, for intIOR and intK"),
                   realIndex("intIOR", kCopperEta), imaginaryIndex("intK", kCopperK)},
    .materials = metals("intIOR", "intK"),
    .eval = reference::microfacetConductorEval,
    .pdf = reference::microfacetConductorPdf,
    .sample = reference::microfacetConductorSample};

const BsdfRow roughconductor{
    .name = "roughconductor",
    .object = "RoughConductor",
    .properties = {alpha(),
                   color("R0", glm::dvec3(0.5), "reflectance at normal incidence",
                         fromTo(0.0, 1.0)),
                   material("Au, Cu or Cr: a microfacet_conductor of it")},
    .ofMaterial = &microfacetConductor,
    .eval = reference::roughconductorEval,
    .pdf = reference::roughconductorPdf,
    .sample = reference::roughconductorSample};

const BsdfRow microfacetDielectric{.name = "microfacet_dielectric",
                                   .spellings = {"roughdielectric"},
                                   .object = "MicrofacetDielectric",
                                   .properties = {alpha(), interior(), exterior()},
                                   .transmissive = true,
                                   .eval = reference::microfacetDielectricEval,
                                   .pdf = reference::microfacetDielectricPdf,
                                   .sample = reference::microfacetDielectricSample};

const BsdfRow phong{
    .name = "phong",
    .object = "Phong",
    .properties = {color("diffuseReflectance", glm::dvec3(1.0), "share of diffuse reflection"),
                   color("specularReflectance", glm::dvec3(1.0), "share of the lobe"),
                   real("shininess", 1.0, "exponent of the lobe", atLeast(0.0))},
    .eval = reference::phongEval,
    .pdf = reference::phongPdf,
    .sample = reference::phongSample};

const BsdfRow disney{
    .name = "disney",
    .spellings = {"disneyBSDF"},
    .object = "Disney",
    .properties = {baseColor(), share("metallic", 0.0, "0: a dielectric, 1: a conductor"),
                   share("subsurface", 0.0,
                         "diffuse reflection as of light that was scattered below"),
                   real("specular", 0.5, "of a dielectric: reflectance at normal incidence / 0.08",
                        atLeast(0.0)),
                   share("specularTint", 0.0, "share of the base colour's hue in it"),
                   share("roughness", 0.5, "square root of the distribution's alpha"),
                   share("anisotropic", 0.0, "how much longer highlights are along the tangent"),
                   real("sheen", 0.0, "diffuse reflection added at grazing angles", atLeast(0.0)),
                   share("sheenTint", 0.0, "share of the base colour's hue in it"),
                   real("clearcoat", 0.0, "strength of a clear coat", atLeast(0.0)),
                   share("clearcoatGloss", 0.0, "0: satin, 1: glossy")},
    .anisotropy = "anisotropic",
    .eval = reference::disneyEval,
    .pdf = reference::disneyPdf,
    .sample = reference::disneySample};

const BsdfRow null{.name = "null",
                   .object = "Null",
                   .delta = true,
                   .transmissive = true,
                   .eval = reference::nullEval,
                   .pdf = reference::nullPdf,
                   .sample = reference::nullSample};

}  // namespace

const BsdfRow diffuse{
    .name = "diffuse",
    .object = "Diffuse",
    .properties = {color("albedo", glm::dvec3(0.5), "share of the light that is reflected")},
    .eval = reference::diffuseEval,
    .pdf = reference::diffusePdf,
    .sample = reference::diffuseSample};

}  // namespace bsdfs

const Rows<BsdfRow>& bsdfRows() {
  using namespace bsdfs;
  static const Rows<BsdfRow> rows = {&diffuse,        &mirror,
                                     &dielectric,     &microfacet,
                                     &disney,         &microfacetConductor,
                                     &roughconductor, &conductor,
                                     &null,           &microfacetDielectric,
                                     &phong,          &roughsubstrate};
  return rows;
}

}  // namespace laver
