#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace laver::xml {

/// Edit distance (Levenshtein) in which swapping two neighbouring letters counts as one edit. Only
/// the first 64 bytes of each name are compared.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The candidate that the name may be a slip of: one or two letters away, but no more than a third
/// of the longer one, whatever their case. Of several the one with the least edit distance, the
/// first of equals; empty if there is none.
std::string_view nearest(std::string_view name, const std::vector<std::string_view>& candidates);

/// "a", "b" or "c"; with more than one candidate also which is nearest to `name`, if one is.
std::string expectedNames(std::string_view name, const std::vector<std::string_view>& candidates);

}  // namespace laver::xml
