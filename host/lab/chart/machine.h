#pragma once
#include <string>

namespace laver::chart {

/// The processor's name and how many threads it runs.
std::string machine();

/// In UTC, as 2026-01-31.
std::string today();

}  // namespace laver::chart
