#pragma once
#include <string>
#include <vector>

#include "image/compare.h"

namespace laver {

/// An aligned table, one line a channel under one line of headings, each ended by a newline.
/// `tolerance` is the one that compare() was given; the share beyond it is printed in percent.
std::string describe(const std::vector<ChannelDifference>& differences, double tolerance);

}  // namespace laver
