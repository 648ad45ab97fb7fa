#pragma once
#include <cstddef>
#include <functional>

namespace laver {

/// Threads to use: `requested`, or all that the process may run on when it is 0.
unsigned threadCount(unsigned requested);

/// Calls body(begin, end) for consecutive chunks of at most `grain` items that together cover
/// [0, count), on `threads` threads (0: all). An exception of a chunk is thrown again here.
void parallelFor(std::size_t count, std::size_t grain, unsigned threads,
                 const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace laver
