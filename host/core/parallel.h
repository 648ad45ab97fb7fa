#pragma once
#include <cstddef>
#include <functional>

namespace laver {

/// Number of threads to use: `requested`, or if that is 0, as many as processors that this process
/// may run on.
unsigned threadCount(unsigned requested);

/// Calls body(begin, end) for consecutive chunks of at most `grain` items that together cover [0,
/// count), on `threads` threads (0: all). Rethrows the first exception of a chunk.
void parallelFor(std::size_t count, std::size_t grain, unsigned threads,
                 const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace laver
