#include "lab/hypothesis/bsdf_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/parallel.h"
#include "reference/bsdf.h"

namespace laver {
namespace {

/// Questions that are asked together: 24 MiB with their answers.
constexpr std::size_t kTogether = std::size_t{1} << 18;

/// What the reference says, rounded to float.
BsdfAnswer answerOf(const Bsdf& bsdf, const BsdfQuestion& q) {
  const reference::BsdfPoint point(bsdf, q.uv, {0.0, 0.0, 1.0});
  const glm::dvec3 wi = glm::normalize(glm::dvec3(q.wi));
  reference::BsdfSample sample{glm::dvec3(q.wo), glm::dvec3(0.0)};
  if (q.wo == glm::vec3(0.0F)) sample = bsdf.row->sample(point, wi, {q.first, q.second});
  return {.wo = glm::vec3(sample.wo),
          .pdf = static_cast<float>(bsdf.row->pdf(point, wi, sample.wo)),
          .weight = glm::vec3(sample.weight),
          .unused0 = 0.0F,
          .value = glm::vec3(bsdf.row->eval(point, wi, sample.wo)),
          .unused1 = 0.0F};
}

}  // namespace

struct BsdfSource::OnDevice {
  OnDevice(const std::vector<Bsdf>& bsdfs, const VulkanOptions& options)
      : instance(options.validate),
        device(choosePhysicalDevice(instance, options.device)),
        sampler(device, bsdfs) {}

  Instance instance;
  Device device;
  BsdfSampler sampler;
};

BsdfSource::BsdfSource(const std::vector<Bsdf>& bsdfs, const TestOptions& options)
    : bsdfs_(bsdfs), threads_(options.threads) {
  if (!options.reference) device_ = std::make_unique<OnDevice>(bsdfs, options.vulkan);
  for (const Bsdf& bsdf : bsdfs)
    if (options.reference && bsdf.row->sample == nullptr)
      throw Error(ExitCode::Scene, fmt::format("the BSDF \"{}\" is a user's own, which the "
                                               "reference cannot evaluate",
                                               bsdf.row->name));
}

BsdfSource::~BsdfSource() = default;

std::vector<BsdfAnswer> BsdfSource::answers(std::size_t which,
                                            std::span<const BsdfQuestion> questions) const {
  std::vector<BsdfAnswer> all(questions.size());
  if (!device_) {
    parallelFor(questions.size(), 4096, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) all[i] = answerOf(bsdfs_[which], questions[i]);
    });
    return all;
  }
  for (std::size_t begin = 0; begin < questions.size(); begin += kTogether) {
    const auto part = questions.subspan(begin, std::min(kTogether, questions.size() - begin));
    const auto answered = device_->sampler.answers(which, part);
    std::copy(answered.begin(), answered.end(), all.begin() + static_cast<std::ptrdiff_t>(begin));
  }
  return all;
}

}  // namespace laver
