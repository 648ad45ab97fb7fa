#pragma once
#include <string>
#include <vector>

#include "scene/text_source.h"

namespace laver::xml {

/// Collects errors and warnings of a scene and reports them all, in file order.
class Diagnostics {
 public:
  explicit Diagnostics(const TextSource& source) : source_(source) {}

  /// An error at a byte offset of the scene file; `message` follows "error: ".
  void error(std::size_t offset, const std::string& message);
  void warning(std::size_t offset, const std::string& message);

  /// A complete line about another file, sorted by the offset at which the scene names that file.
  void errorLine(std::size_t offset, std::string line);
  void warningLine(std::size_t offset, std::string line);

  std::size_t errorCount() const { return errors_.size(); }
  /// Throws Error(ExitCode::Scene) with one line per error, if there are any.
  void throwErrors() const;
  /// The warnings, one line each, in file order.
  std::vector<std::string> warnings() const;

 private:
  struct Entry {
    std::size_t offset;
    std::string line;
  };
  static std::vector<std::string> inOrder(std::vector<Entry> entries);

  const TextSource& source_;
  std::vector<Entry> errors_;
  std::vector<Entry> warnings_;
};

}  // namespace laver::xml
