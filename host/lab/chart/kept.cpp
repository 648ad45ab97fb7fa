#include "lab/chart/kept.h"

#include <cstring>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "image/atomic_file.h"
#include "lab/chart/fingerprint.h"

namespace laver::chart {
namespace {

namespace fs = std::filesystem;

/// What a file begins with; the key and the value follow as one CBOR array. Files do not travel
/// between machines: numbers are in native order.
struct Preface {
  char magic[8] = {'l', 'a', 'v', 'e', 'r', 'c', 'h', '1'};
  std::uint64_t checksum = 0;
};
static_assert(sizeof(Preface) == 16);

std::uint64_t checksum(std::span<const std::byte> data) {
  Fingerprint print;
  print.add(data);
  return print.value();
}

}  // namespace

Kept::Kept(fs::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error)
    throw Error(ExitCode::Output,
                "cannot make the folder \"" + folder_.string() + "\": " + error.message());
}

fs::path Kept::fileOf(const std::string& key) const {
  Fingerprint print;
  print.add(key);
  return folder_ / (print.text() + ".kept");
}

std::optional<nlohmann::json> Kept::read(const std::string& key) const {
  std::ifstream in(fileOf(key), std::ios::binary);
  const std::vector<char> data((std::istreambuf_iterator<char>(in)), {});
  const Preface wanted;
  Preface preface;
  if (data.size() < sizeof preface) return {};
  std::memcpy(&preface, data.data(), sizeof preface);
  const std::span body = std::span(data).subspan(sizeof preface);
  if (std::memcmp(preface.magic, wanted.magic, sizeof wanted.magic) != 0 ||
      preface.checksum != checksum(std::as_bytes(body)))
    return {};
  auto pair = nlohmann::json::from_cbor(body.begin(), body.end(), true, false);
  if (!pair.is_array() || pair.size() != 2 || pair[0] != key) return {};
  return std::move(pair[1]);
}

void Kept::write(const std::string& key, const nlohmann::json& value) const {
  const auto body = nlohmann::json::to_cbor(nlohmann::json::array({key, value}));
  Preface preface;
  preface.checksum = checksum(std::as_bytes(std::span(body)));
  AtomicFile file(fileOf(key).string());
  file.write(std::as_bytes(std::span(&preface, 1)));
  file.write(std::as_bytes(std::span(body)));
  file.commit();
}

}  // namespace laver::chart
