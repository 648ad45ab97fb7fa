#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/form.h"
#include "scene/rows.h"

namespace laver {

/// A type of camera. Its GLSL is shaders/camera/NAME.glsl.
struct CameraRow {
  const char* name;
  const char* object = "";  ///< Nori's class, in the dump
  std::vector<Form> forms{};
  bool lens = false;  ///< rays start at points of a lens
};

namespace cameras {
extern const CameraRow perspective, thinlens;
}  // namespace cameras

const Rows<CameraRow>& cameraRows();

/// A pinhole or a thin lens. Camera space: +x left, +y up, +z forward.
struct Camera {
  glm::dmat4 toWorld{1.0};  ///< camera to world, column vectors
  int width = 1280;         ///< pixels
  int height = 720;         ///< pixels
  int subpixels = 1;        ///< pixels, across, that need not be told apart
  double fov = 30.0;        ///< horizontal, degrees
  double nearClip = 1e-4;   ///< plane z = nearClip of camera space
  double farClip = 1e4;
  double lensRadius = 0.0;     ///< camera units
  double focalDistance = 1.0;  ///< z of the plane in focus, camera units
  const CameraRow* row = &cameras::perspective;
};

}  // namespace laver
