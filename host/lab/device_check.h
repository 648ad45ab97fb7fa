#pragma once
#include <cstddef>
#include <functional>
#include <string>

#include "vulkan/device_info.h"

namespace laver {

/// One small picture of a device, against the reference.
struct DeviceCheck {
  std::string name;  ///< scene and traversal
  bool right = false;
  std::string finding;   ///< what differs, or why there is no picture
  double seconds = 0.0;  ///< of the whole process
};

/// Renders small scenes of known answer on a device, by every traversal that it can run, and calls
/// `report` after each. `self` is the laver program: each render is a process of its own, so that a
/// driver's crash is a finding; one that takes more than `limit` seconds is ended.
void checkDevice(const std::string& self, std::size_t index, const DeviceInfo& device, double limit,
                 const std::function<void(const DeviceCheck&)>& report);

}  // namespace laver
