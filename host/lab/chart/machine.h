#pragma once
#include <string>

namespace laver::chart {

/// The processor's name and how many threads it runs.
std::string machine();

/// Name and version of the compiler that built this program.
std::string compiler();

/// In UTC, as 2026-01-31.
std::string today();

}  // namespace laver::chart
