#pragma once
#include <string>

namespace laver::chart {

/// The processor's name and number of threads.
std::string machine();

/// Name and version of the compiler that built this program.
std::string compiler();

/// The date in UTC, for example 2026-01-31.
std::string today();

}  // namespace laver::chart
