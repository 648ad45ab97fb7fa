#pragma once
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

namespace laver {

/// FNV-1a of 64 bits (Fowler, Noll and Vo), of words of 8 bytes where there are some: it tells
/// whether data is the same, and guards against nobody's intent.
class Fnv1a {
 public:
  void add(std::span<const std::byte> bytes) {
    for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data(), 8);
      step(word);
      hash_ ^= hash_ >> 32;  // a product alone never carries down
    }
    for (const std::byte b : bytes) step(static_cast<std::uint64_t>(b));
    step(bytes.size() + 256);
  }
  void add(const std::string& text) { add(std::as_bytes(std::span(text))); }

  std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  void step(std::uint64_t word) { hash_ = (hash_ ^ word) * 0x100000001b3ULL; }

  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

}  // namespace laver
