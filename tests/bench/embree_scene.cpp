#include "bench/embree_scene.h"

#include <fmt/format.h>

#include <chrono>
#include <iostream>
#include <sstream>

#include "core/error.h"
#include "render/packed.h"

namespace laver::bench {
namespace {

void check(RTCDevice device, const char* what) {
  const RTCError error = rtcGetDeviceError(device);
  if (error != RTC_ERROR_NONE)
    throw Error(ExitCode::Device,
                fmt::format("Embree: {}: error {}", what, static_cast<int>(error)));
}

}  // namespace

EmbreeDevice::EmbreeDevice(const std::string& config) {
  // No property has the instruction set, so it is taken from the device's verbose output.
  std::ostringstream said;
  std::streambuf* const before = std::cout.rdbuf(said.rdbuf());
  device_ = rtcNewDevice((config + ",verbose=1").c_str());
  std::cout.rdbuf(before);
  check(nullptr, "rtcNewDevice");
  const std::string text = said.str();
  const auto version = rtcGetDeviceProperty(device_, RTC_DEVICE_PROPERTY_VERSION);
  description_ = fmt::format("{}.{}.{}", version / 10000, version / 100 % 100, version % 100);
  // The last word of "Targets : SSE4.2 AVX AVX2  (supported)".
  if (const auto supported = text.find(" (supported"); supported != std::string::npos) {
    const auto end = text.find_last_not_of(' ', supported);
    const auto begin = text.find_last_of(' ', end);
    description_ += ", " + text.substr(begin + 1, end - begin);
  }
  description_ += ", native packets of";
  for (const auto& [property, width] :
       {std::pair(RTC_DEVICE_PROPERTY_NATIVE_RAY4_SUPPORTED, " 4"),
        std::pair(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED, " 8"),
        std::pair(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED, " 16")})
    if (rtcGetDeviceProperty(device_, property) != 0) description_ += width;
}

EmbreeDevice::~EmbreeDevice() { rtcReleaseDevice(device_); }

EmbreeMesh::EmbreeMesh(const Scene& scene) {
  if (hasSpheres(scene))
    throw Error(ExitCode::Scene, scene.file + ": Embree's side has no spheres");
  const Normalisation space = normalisationOf(scene);
  for (const Mesh& mesh : scene.meshes) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const glm::dvec3& p : mesh.positions) positions.emplace_back(space.apply(p));
    for (const glm::uvec3& t : mesh.triangles) triangles.push_back(t + first);
  }
  positions.emplace_back(0.0F);  // Embree reads 16 bytes of the last one
}

EmbreeScene::EmbreeScene(const EmbreeDevice& device, const EmbreeMesh& mesh, RTCSceneFlags flags,
                         RTCBuildQuality quality)
    : scene_(rtcNewScene(device.get())) {
  RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             mesh.positions.data(), 0, sizeof(glm::vec3),
                             mesh.positions.size() - 1);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.triangles.data(), 0, sizeof(glm::uvec3), mesh.triangles.size());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneFlags(scene_, flags);
  rtcSetSceneBuildQuality(scene_, quality);
  const auto start = std::chrono::steady_clock::now();
  rtcCommitScene(scene_);
  commitSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  check(device.get(), "rtcCommitScene");
}

EmbreeScene::~EmbreeScene() { rtcReleaseScene(scene_); }

}  // namespace laver::bench
