#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace laver::xml {

/// Edit distance (Levenshtein) in which swapping two neighbouring letters counts as one edit. Only
/// the first 64 bytes of each name are compared.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The candidate with the smallest edit distance, the first of equals; empty if there is none.
std::string_view nearest(std::string_view name, const std::vector<std::string_view>& candidates);

/// Whether two names are as similar as a misspelling: at most a third of the longer one differs.
bool looksLikeTypo(std::string_view name, std::string_view known);

/// "a", "b" or "c". With several candidates, also the nearest one to `name` unless that is empty.
std::string expectedNames(std::string_view name, const std::vector<std::string_view>& candidates);

}  // namespace laver::xml
