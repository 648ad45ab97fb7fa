#include "kernels/cache.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <span>

#include "core/atomic_file.h"
#include "core/cache_folder.h"
#include "core/error.h"

namespace laver {
namespace {

namespace fs = std::filesystem;

/// Start of a file, followed by the words. Numbers are in native byte order.
struct Header {
  char magic[8] = {'l', 'a', 'v', 'e', 'r', 's', 'p', '1'};
  std::uint64_t bytes = 0;
  std::uint64_t checksum = 0;  ///< XXH3 of the words
};

constexpr std::uint64_t kMaxBytes = std::uint64_t{16} << 20;

}  // namespace

std::string hashOfKernel(const std::string& text) {
  const std::string all = compilerVersion() + '\n' + text;
  const XXH128_hash_t hash = XXH3_128bits(all.data(), all.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

KernelCache KernelCache::ofUser() {
  const std::string folder = cacheFolder();
  return KernelCache(folder.empty() ? fs::path() : fs::path(folder) / "kernels");
}

std::optional<Spirv> KernelCache::read(const std::string& hash) const {
  std::error_code error;
  if (folder_.empty() || !fs::is_regular_file(fileOf(hash), error)) return {};
  std::ifstream file(fileOf(hash), std::ios::binary);
  const Header wanted;
  Header header;
  if (!file.read(reinterpret_cast<char*>(&header), sizeof header) ||
      std::memcmp(header.magic, wanted.magic, sizeof wanted.magic) != 0 ||
      header.bytes > kMaxBytes || header.bytes % 4 != 0)
    return {};
  Spirv module(header.bytes / 4);
  if (!file.read(reinterpret_cast<char*>(module.data()),
                 static_cast<std::streamsize>(header.bytes)) ||
      file.peek() != std::ifstream::traits_type::eof() ||
      XXH3_64bits(module.data(), header.bytes) != header.checksum)
    return {};
  return module;
}

void KernelCache::write(const std::string& hash, const Spirv& module) const {
  Header header;
  header.bytes = module.size() * sizeof(std::uint32_t);
  header.checksum = XXH3_64bits(module.data(), header.bytes);
  if (folder_.empty() || header.bytes > kMaxBytes) return;
  std::error_code error;
  fs::create_directories(folder_, error);
  try {
    AtomicFile file(fileOf(hash).string());
    file.write(std::as_bytes(std::span(&header, 1)));
    file.write(std::as_bytes(std::span(module)));
    file.commit();
    prune();
  } catch (const std::exception&) {
    // A kernel that cannot be written is not cached.
  }
}

void KernelCache::prune() const {
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    std::error_code error;
    const auto time = entry.last_write_time(error);
    if (!error && entry.path().extension() == ".spv") files.emplace_back(time, entry.path());
  }
  if (files.size() <= kFiles) return;
  std::sort(files.begin(), files.end());
  for (std::size_t i = 0; i + kFiles < files.size(); ++i) {
    std::error_code error;
    fs::remove(files[i].second, error);
  }
}

}  // namespace laver
