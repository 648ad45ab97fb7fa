#pragma once
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace laver::chart {

/// FNV-1a with 64 bits (Fowler, Noll, Vo): tells files and keys apart, guards against damage, not
/// against malice.
class Fingerprint {
 public:
  void add(std::span<const std::byte> bytes) {
    for (const std::byte b : bytes)
      hash_ = (hash_ ^ static_cast<std::uint64_t>(b)) * 0x100000001b3ULL;
  }
  void add(const std::string& text) { add(std::as_bytes(std::span(text))); }
  std::uint64_t value() const { return hash_; }
  std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

/// Of a file's bytes. Throws Error(Output) where it cannot be read.
std::string fingerprintOfFile(const std::string& file);

/// Of a scene file, and of every file that it names.
std::string fingerprintOfScene(const std::string& file);

}  // namespace laver::chart
