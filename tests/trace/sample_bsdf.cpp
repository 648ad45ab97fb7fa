// What BSDFs draw on the device, against their twins in double precision.
#include <gtest/gtest.h>

#include <random>

#include "reference/bsdf.h"
#include "support/bsdf_cases.h"
#include "support/test_device.h"
#include "lab/hypothesis/bsdf_sampler.h"
#include "vulkan/device.h"

namespace laver::test {
namespace {

/// Directions from the upper and the lower side.
std::vector<BsdfQuestion> questions() {
  std::mt19937 engine(5);
  std::uniform_real_distribution<float> number(0.0F, 1.0F);
  std::vector<BsdfQuestion> all(4096);
  for (BsdfQuestion& q : all) {
    glm::vec3 d;
    do d = glm::vec3(number(engine), number(engine), number(engine)) * 2.0F - 1.0F;
    while (glm::dot(d, d) > 1.0F || std::abs(d.z) < 0.05F);
    q.wi = glm::normalize(d);
    q.first = number(engine);
    q.second = number(engine);
    q.uv = {number(engine), number(engine)};
  }
  return all;
}

/// How far the answers are from the twin's.
struct Distance {
  std::size_t otherDirections = 0;
  double weight = 0.0, pdf = 0.0, value = 0.0;  ///< relative to max(1, the twin's)
};

double apart(glm::dvec3 a, glm::dvec3 b) {
  const double size = std::max({1.0, std::abs(b.x), std::abs(b.y), std::abs(b.z)});
  return glm::length(a - b) / size;
}

/// Densities, values and weights are those of the direction that the device drew.
Distance distanceOf(const Bsdf& bsdf, std::span<const BsdfQuestion> asked,
                    std::span<const BsdfAnswer> answered) {
  Distance distance;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const BsdfQuestion& q = asked[i];
    const BsdfAnswer& a = answered[i];
    const reference::BsdfPoint point(bsdf, q.uv, {0.0, 0.0, 1.0});
    const glm::dvec3 wi = glm::normalize(glm::dvec3(q.wi)), wo(a.wo);
    const reference::BsdfSample truth = bsdf.row->sample(point, wi, {q.first, q.second});
    if (!(glm::length(wo - truth.wo) < 1e-5)) {
      ++distance.otherDirections;
      continue;
    }
    const glm::dvec3 unit = glm::normalize(wo);
    const double pdf = bsdf.row->pdf(point, wi, unit);
    const glm::dvec3 value = bsdf.row->eval(point, wi, unit);
    const bool none = truth.weight == glm::dvec3(0.0) || bsdf.row->delta;
    const glm::dvec3 weight = none ? truth.weight : value * (std::abs(unit.z) / pdf);
    distance.weight = std::max(distance.weight, apart(glm::dvec3(a.weight), weight));
    distance.pdf = std::max(distance.pdf, apart(glm::dvec3(a.pdf), glm::dvec3(pdf)));
    // The cosine goes with it: the value alone grows beyond bounds at grazing angles.
    distance.value = std::max(
        distance.value, apart(std::abs(unit.z) * glm::dvec3(a.value), std::abs(unit.z) * value));
  }
  return distance;
}

void expectTwins(const Bsdf& bsdf, std::span<const BsdfAnswer> answers,
                 std::span<const BsdfQuestion> asked) {
  const Distance distance = distanceOf(bsdf, asked, answers);
  // A choice may fall the other way where a number equals a probability, or a texture's coordinate
  // the edge of a field, to rounding.
  EXPECT_LE(distance.otherDirections, 4U);
  // A half vector is off by 4 e, e = 2^-24; by four times that where light is refracted or the
  // directions are nearly opposite. A lobe of width a changes by 2 t / a of itself per radian at t
  // widths from its middle, t < 8. The rest is some tens of roundings of numbers of about 1. At the
  // critical angle Fresnel's term falls by 4 times the cosine beyond, whose square is off by e.
  const bool critical = bsdf.row->transmissive && !bsdf.row->delta;
  const double bound =
      1e-5 + 256.0 * 0x1p-24 / narrowestLobe(bsdf) + (critical ? 4.0 * 0x1p-12 : 0.0);
  EXPECT_LT(distance.weight, bound);
  EXPECT_LT(distance.pdf, bound);
  EXPECT_LT(distance.value, bound);
  for (const BsdfAnswer& answer : answers) EXPECT_TRUE(!bsdf.row->delta || answer.pdf == 0.0F);
}

class SampleBsdf : public testing::Test {
 protected:
  SampleBsdf() : instance_(false), device_(choosePhysicalDevice(instance_, testDevice())) {}
  Instance instance_;
  Device device_;
};

TEST_F(SampleBsdf, OfTheDeviceIsItsTwins) {
  const auto asked = questions();
  for (const BsdfCase& one : bsdfCases()) {
    SCOPED_TRACE(one.name);
    const BsdfSampler sampler(device_, {one.bsdf});
    expectTwins(one.bsdf, sampler.answers(0, asked), asked);
  }
}

// Records have room for the largest, and each BSDF is chosen by its number.
TEST_F(SampleBsdf, OfAKernelWithAllOfThemIsItsTwins) {
  const auto asked = questions();
  const auto cases = bsdfCases();
  std::vector<Bsdf> bsdfs;
  for (const BsdfCase& one : cases) bsdfs.push_back(one.bsdf);
  const BsdfSampler sampler(device_, bsdfs);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(cases[i].name);
    expectTwins(bsdfs[i], sampler.answers(i, asked), asked);
  }
}

TEST_F(SampleBsdf, DensitiesAreThoseOfTheSamples) {
  std::mt19937 engine(17);
  std::uniform_real_distribution<float> number(0.0F, 1.0F);
  const glm::dvec2 uv(0.2, 0.5);
  const glm::dvec3 wi = directionAt(0.7, 0.3);
  std::vector<BsdfQuestion> asked(65536);
  for (BsdfQuestion& q : asked)
    q = {.wi = glm::vec3(wi), .first = number(engine), .second = number(engine), .uv = uv};
  for (const BsdfCase& one : bsdfCases()) {
    if (one.bsdf.row->delta) continue;
    std::vector<glm::dvec3> samples;
    for (const BsdfAnswer& answer : BsdfSampler(device_, {one.bsdf}).answers(0, asked))
      samples.emplace_back(answer.weight == glm::vec3(0.0F) ? glm::vec3(0.0F) : answer.wo);
    EXPECT_LT(deviateOf(one.bsdf, uv, wi, samples), 4.0) << one.name;
  }
}

}  // namespace
}  // namespace laver::test
