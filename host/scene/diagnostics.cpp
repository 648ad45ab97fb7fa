#include "scene/diagnostics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.h"

namespace laver::xml {

void Diagnostics::error(std::size_t offset, const std::string& message) {
  errorLine(offset, fmt::format("{}: error: {}", source_.where(offset), message));
}

void Diagnostics::warning(std::size_t offset, const std::string& message) {
  warningLine(offset, fmt::format("{}: warning: {}", source_.where(offset), message));
}

void Diagnostics::errorLine(std::size_t offset, std::string line) {
  errors_.push_back({offset, std::move(line)});
}

void Diagnostics::warningLine(std::size_t offset, std::string line) {
  warnings_.push_back({offset, std::move(line)});
}

std::vector<std::string> Diagnostics::inOrder(std::vector<Entry> entries) {
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.offset < b.offset; });
  std::vector<std::string> lines;
  lines.reserve(entries.size());
  for (Entry& entry : entries) lines.push_back(std::move(entry.line));
  return lines;
}

void Diagnostics::throwErrors() const {
  if (errors_.empty()) return;
  throw Error(ExitCode::Scene, fmt::format("{}", fmt::join(inOrder(errors_), "\n")));
}

std::vector<std::string> Diagnostics::warnings() const { return inOrder(warnings_); }

}  // namespace laver::xml
