#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace laver::xml {

/// Letters to insert, remove or replace to turn one name into the other (Levenshtein), where two
/// neighbours swapped count as one. Only the first 64 bytes of each are looked at.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The candidate with the least edit distance, the first of equals; empty if there is none.
std::string_view nearest(std::string_view name, const std::vector<std::string_view>& candidates);

/// Whether two names differ by no more than a slip of the hand: a third of the longer one.
bool looksLikeTypo(std::string_view name, std::string_view known);

/// "a", "b" or "c"; with more than one candidate also which is nearest to `name`, unless that is
/// empty.
std::string expectedNames(std::string_view name, const std::vector<std::string_view>& candidates);

}  // namespace laver::xml
