#include "scene/bsdfs.h"

#include <filesystem>

#include "scene/user_text.h"

namespace laver {

// host/reference/bsdf/NAME.cpp
namespace reference {
glm::dvec3 diffuseEval(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo);
double diffusePdf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo);
BsdfSample diffuseSample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2 numbers);
glm::dvec3 mirrorEval(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo);
double mirrorPdf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo);
BsdfSample mirrorSample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2 numbers);
glm::dvec3 dielectricEval(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo);
double dielectricPdf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo);
BsdfSample dielectricSample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2 numbers);
}  // namespace reference

namespace bsdfs {

const BsdfRow diffuse{.name = "diffuse",
                      .object = "Diffuse",
                      .properties = {{.name = "albedo",
                                      .type = PropertyType::Color,
                                      .start = glm::dvec3(0.5),
                                      .meaning = "share of the light that is reflected"}},
                      .eval = reference::diffuseEval,
                      .pdf = reference::diffusePdf,
                      .sample = reference::diffuseSample};

static const BsdfRow mirror{.name = "mirror",
                            .object = "Mirror",
                            .delta = true,
                            .eval = reference::mirrorEval,
                            .pdf = reference::mirrorPdf,
                            .sample = reference::mirrorSample};

static const BsdfRow dielectric{.name = "dielectric",
                                .object = "Dielectric",
                                .properties = {{.name = "intIOR",
                                                .type = PropertyType::Float,
                                                .start = 1.5046,
                                                .range = moreThan(0.0),
                                                .meaning = "index of refraction inside"},
                                               {.name = "extIOR",
                                                .type = PropertyType::Float,
                                                .start = 1.000277,
                                                .range = moreThan(0.0),
                                                .meaning = "index of refraction outside"}},
                                .delta = true,
                                .eval = reference::dielectricEval,
                                .pdf = reference::dielectricPdf,
                                .sample = reference::dielectricSample};

}  // namespace bsdfs

const Rows<BsdfRow>& bsdfRows() {
  static const Rows<BsdfRow> rows = {&bsdfs::diffuse, &bsdfs::mirror, &bsdfs::dielectric};
  return rows;
}

std::shared_ptr<UserBsdf> userBsdf(const std::string& file) {
  std::optional<std::string> text = userText(file);
  if (!text) return nullptr;
  auto user = std::make_shared<UserBsdf>();
  user->name = std::filesystem::path(file).stem().string();
  user->file = file;
  user->text = std::move(*text);
  user->row.name = user->row.object = user->name.c_str();
  return user;
}

std::vector<double> numbersOf(const Bsdf& bsdf) {
  std::vector<double> numbers;
  for (const PropertyRow& property : bsdf.row->properties)
    if (property.type == PropertyType::Float) numbers.push_back(bsdf.real(property.name));
  return numbers;
}

}  // namespace laver
