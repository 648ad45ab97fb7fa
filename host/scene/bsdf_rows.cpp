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
  static const Rows<BsdfRow> rows = {&diffuse, &mirror, &dielectric, &microfacet};
  return rows;
}

}  // namespace laver
