#pragma once
#include <cstddef>
#include <string>

#include "vulkan/device_info.h"

namespace laver {

/// Aligned lines about a device: what it is, the limits laver depends on, and why it cannot be
/// used, if it cannot. `isDefault` says whether laver takes it unasked.
std::string describe(const DeviceInfo& device, std::size_t index, bool isDefault);

}  // namespace laver
