#include "stability/subject.h"

#include <gtest/gtest.h>

#include <chrono>

#include "core/parallel.h"
#include "render/renderer.h"
#include "render/traversal.h"

namespace laver::test {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class TwinSubject : public Subject {
 public:
  TwinSubject(const Twin* theTwin, const Bvh& bvh) : bvh_(bvh) {
    twin = theTwin;
    name = twin->name;
    slow = name == "C++ -O0";
  }
  std::vector<TestHit> closest(std::span<const TestRay> rays) override {
    const auto start = Clock::now();
    std::vector<TestHit> hits(rays.size());
    parallelFor(rays.size(), 4096, 0, [&](std::size_t begin, std::size_t end) {
      twin->closest(bvh_, rays.subspan(begin, end - begin), hits.data() + begin);
    });
    seconds += since(start);
    return hits;
  }
  std::vector<std::uint32_t> visible(glm::vec3 light, std::span<const glm::vec3> points) override {
    const auto start = Clock::now();
    std::vector<std::uint32_t> seen(points.size());
    parallelFor(points.size(), 4096, 0, [&](std::size_t begin, std::size_t end) {
      twin->visible(bvh_, light, points.subspan(begin, end - begin), seen.data() + begin);
    });
    seconds += since(start);
    return seen;
  }

 private:
  const Bvh& bvh_;
};

class DeviceSubject : public Subject {
 public:
  DeviceSubject(const Device& device, const Bvh& bvh, const std::string& traversal,
                std::shared_ptr<TestKernels> kernels)
      : tracer_(device, bvh, traversal, std::move(kernels)) {
    name = traversal;
  }
  std::vector<TestHit> closest(std::span<const TestRay> rays) override {
    const auto start = Clock::now();
    auto hits = tracer_.closest(rays);
    EXPECT_EQ(tracer_.incomplete(), 0U) << name;
    seconds += since(start);
    return hits;
  }
  std::vector<std::uint32_t> visible(glm::vec3 light, std::span<const glm::vec3> points) override {
    const auto start = Clock::now();
    auto seen = tracer_.visible(light, points);
    EXPECT_EQ(tracer_.incomplete(), 0U) << name;
    seconds += since(start);
    return seen;
  }

 private:
  RayTracer tracer_;
};

}  // namespace

std::vector<std::unique_ptr<Subject>> subjects(const Bvh& bvh) {
  static const Instance instance(false);
  static const Device device(choosePhysicalDevice(instance, testDevice()));
  static const auto kernels = std::make_shared<TestKernels>();
  std::vector<std::unique_ptr<Subject>> all;
  all.push_back(std::make_unique<DeviceSubject>(device, bvh, "lane", kernels));
  if (runsPackets(device.info()))
    for (const char* packet : {"packet32", "packet64"})
      all.push_back(std::make_unique<DeviceSubject>(device, bvh, packet, kernels));
  for (const Twin* twin : twins()) all.push_back(std::make_unique<TwinSubject>(twin, bvh));
  return all;
}

}  // namespace laver::test
