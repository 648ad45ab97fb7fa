#pragma once
#include <future>

namespace laver {

/// The policy of std::async for work beside the caller: on a thread of its own, or, where the
/// system allows no more of them, when its result is wanted.
inline constexpr std::launch kBeside = std::launch::async | std::launch::deferred;

}  // namespace laver
