#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

struct XXH3_state_s;

namespace laver {

/// 64-bit XXH3 of a sequence of byte strings, each preceded by its length, so that "ab", "c"
/// differs from "a", "bc". It detects differences and damage; it is not secure against intent.
class Hash {
 public:
  Hash();
  void add(std::span<const std::byte> bytes);
  void add(const std::string& text) { add(std::as_bytes(std::span(text))); }
  /// 16 hexadecimal digits.
  std::string text() const;

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Free> state_;
};

/// 64-bit XXH3 of the bytes alone.
std::uint64_t hashOf(std::span<const std::byte> bytes);

/// 64-bit XXH3 of a file in 16 hexadecimal digits, as `xxhsum -H3` prints it. Nothing if the file
/// cannot be read.
std::optional<std::string> hashOfFile(const std::string& file);

}  // namespace laver
