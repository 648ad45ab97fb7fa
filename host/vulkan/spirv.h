#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace laver {

/// SPIR-V of shaders/<kernel>.comp, embedded at build time. Throws std::out_of_range.
std::span<const std::uint32_t> spirvOf(const std::string& kernel);

}  // namespace laver
