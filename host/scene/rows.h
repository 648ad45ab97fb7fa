#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace laver {

/// The rows of a table of scene objects, in the order of listings.
template <class Row>
using Rows = std::vector<const Row*>;

/// Whether `name` is a name of the row.
template <class Row>
bool isCalled(const Row& row, std::string_view name) {
  return row.name == name ||
         std::find(row.spellings.begin(), row.spellings.end(), name) != row.spellings.end();
}

/// The row of that name, or nullptr.
template <class Row>
const Row* rowCalled(const Rows<Row>& rows, std::string_view name) {
  for (const Row* row : rows)
    if (isCalled(*row, name)) return row;
  return nullptr;
}

/// The names of rows, for example "normals, depth or av".
template <class Row>
std::string namesOf(const Rows<Row>& rows, const char* last = " or ") {
  std::string names;
  for (std::size_t i = 0; i < rows.size(); ++i)
    names += std::string(i == 0 ? "" : i + 1 == rows.size() ? last : ", ") + rows[i]->name;
  return names;
}

}  // namespace laver
