#pragma once
#include <string>
#include <vector>

#include "render/choices.h"

namespace laver {

/// "1 node", "2 nodes".
std::string countOf(std::uint64_t n, const char* one, const char* more = nullptr);

/// The decisions as text. `traversal` is the reason for the traversal.
std::vector<Reason> reasonsOf(const Scene& scene, const RenderOptions& options,
                              const Choices& choices, const std::string& traversal);

}  // namespace laver
