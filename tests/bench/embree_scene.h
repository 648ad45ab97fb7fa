#pragma once
#include <embree3/rtcore.h>

#include <string>
#include <vector>

#include "scene/scene.h"

namespace laver::bench {

/// An Embree device and its description.
class EmbreeDevice {
 public:
  /// `config` is the argument of rtcNewDevice.
  explicit EmbreeDevice(const std::string& config);
  ~EmbreeDevice();
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;

  RTCDevice get() const { return device_; }
  /// "3.13.5, AVX512, native packets of 4, 8, 16"
  const std::string& description() const { return description_; }

 private:
  RTCDevice device_;
  std::string description_;
};

/// Corners of all meshes in normalised space, and triangles in file order: primID is laver's id.
struct EmbreeMesh {
  explicit EmbreeMesh(const Scene& scene);
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
};

/// A committed scene of one mesh. The mesh must outlive it.
class EmbreeScene {
 public:
  EmbreeScene(const EmbreeDevice& device, const EmbreeMesh& mesh, RTCSceneFlags flags,
              RTCBuildQuality quality);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  RTCScene get() const { return scene_; }
  double commitSeconds() const { return commitSeconds_; }

 private:
  RTCScene scene_;
  double commitSeconds_;
};

}  // namespace laver::bench
