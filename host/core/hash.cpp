#include "core/hash.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <array>
#include <fstream>
#include <new>

namespace laver {

Hash::Hash() : state_(XXH3_createState()) {
  if (!state_) throw std::bad_alloc();
  XXH3_64bits_reset(state_.get());
}

void Hash::Free::operator()(XXH3_state_s* state) const { XXH3_freeState(state); }

void Hash::add(std::span<const std::byte> bytes) {
  const std::uint64_t size = bytes.size();
  XXH3_64bits_update(state_.get(), &size, sizeof size);
  XXH3_64bits_update(state_.get(), bytes.data(), bytes.size());
}

std::string Hash::text() const { return fmt::format("{:016x}", XXH3_64bits_digest(state_.get())); }

std::uint64_t hashOf(std::span<const std::byte> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

std::optional<std::string> hashOfFile(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(),
                                                                              XXH3_freeState);
  if (!state) throw std::bad_alloc();
  XXH3_64bits_reset(state.get());
  std::array<char, 1 << 16> part;
  do {
    in.read(part.data(), part.size());
    XXH3_64bits_update(state.get(), part.data(), static_cast<std::size_t>(in.gcount()));
  } while (in);
  if (!in.eof()) return std::nullopt;
  return fmt::format("{:016x}", XXH3_64bits_digest(state.get()));
}

}  // namespace laver
