#include "show/tev_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <mutex>
#include <span>
#include <vector>

namespace laver {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds kStalled{1}, kLongest{10};
/// Floats per packet: a quarter MiB takes some ten microseconds to copy.
constexpr std::size_t kPacketFloats = 1 << 16;

static_assert(std::endian::native == std::endian::little, "packets hold little-endian numbers");

/// A message to tev or HDRView, little-endian: u32 length of the packet including these four bytes,
/// u8 operation, payload; strings end in NUL.
class Packet {
 public:
  explicit Packet(std::uint8_t operation) {
    add(std::uint32_t{0});
    add(operation);
  }

  template <class T>
  void add(T number) {
    append(&number, sizeof number);
  }
  void add(const std::string& text) { append(text.c_str(), text.size() + 1); }
  void add(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) add(text);
  }
  void add(std::span<const float> numbers) { append(numbers.data(), numbers.size_bytes()); }

  std::vector<std::byte> finish() {
    const auto length = static_cast<std::uint32_t>(bytes_.size());
    std::memcpy(bytes_.data(), &length, sizeof length);
    return std::move(bytes_);
  }

 private:
  void append(const void* data, std::size_t size) {
    const auto* begin = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), begin, begin + size);
  }

  std::vector<std::byte> bytes_;
};

/// Operation 4: creates a black image and shows it.
std::vector<std::byte> createImagePacket(const std::string& name, int width, int height,
                                         const std::vector<std::string>& channels) {
  Packet packet(4);
  packet.add(std::uint8_t{1});  // takes the focus
  packet.add(name);
  packet.add(std::int32_t{width});
  packet.add(std::int32_t{height});
  packet.add(static_cast<std::int32_t>(channels.size()));
  packet.add(channels);
  return packet.finish();
}

/// Operation 6: replaces `rows` whole rows from row `y` on, channels interleaved.
std::vector<std::byte> updateImagePacket(const std::string& name,
                                         const std::vector<std::string>& channels, int y, int width,
                                         int rows, std::span<const float> pixels) {
  const auto count = static_cast<std::int64_t>(channels.size());
  Packet packet(6);
  packet.add(std::uint8_t{0});
  packet.add(name);
  packet.add(static_cast<std::int32_t>(count));
  packet.add(channels);
  for (const std::int32_t number : {0, y, width, rows}) packet.add(number);
  for (std::int64_t offset = 0; offset < count; ++offset) packet.add(offset);
  for (std::int64_t i = 0; i < count; ++i) packet.add(count);  // strides
  packet.add(pixels);
  return packet.finish();
}

}  // namespace

struct TevClient::State {
  ViewerAddress address;
  std::string name;

  std::mutex mutex;  // guards all below
  std::condition_variable changed;
  Image latest;
  std::vector<bool> waiting;  // rows that changed since they were last sent
  std::size_t next = 0;       // where the search for a waiting row starts
  bool connected = false;
  bool ending = false;  // no more rows come
  bool over = false;    // the thread has ended
  Clock::time_point end, progress;

  /// Whether to go on waiting for the viewer: always while rows may still arrive.
  bool patient() {
    const std::lock_guard lock(mutex);
    const auto now = Clock::now();
    return !ending || (now < end + kLongest && now < std::max(end, progress) + kStalled);
  }

  void run() {
    std::string problem;
    try {
      serve();
    } catch (const std::exception& error) {
      problem = error.what();
    }
    if (!problem.empty())
      fmt::print(
          stderr,
          "laver: warning: display server {} port {}: {}; it has only a part of the picture\n",
          address.host, address.port, problem);
    const std::lock_guard lock(mutex);
    over = true;
    changed.notify_all();
  }

  void serve() {
    const Connection::Patience patience = [this] { return patient(); };
    const auto note = [this] {
      const std::lock_guard lock(mutex);
      progress = Clock::now();
    };
    Connection connection(address, patience);
    {
      const std::lock_guard lock(mutex);
      connected = true;
    }
    bool created = false;
    int y = 0;
    for (Image rows = take(y); rows.height != 0; rows = take(y)) {
      if (!created)
        connection.send(createImagePacket(name, latest.width, latest.height, latest.channels),
                        patience, note);
      created = true;
      connection.send(
          updateImagePacket(name, rows.channels, y, rows.width, rows.height, rows.pixels), patience,
          note);
    }
  }

  /// Waits for changed rows and takes some consecutive ones, the first of which is `y`; none at the
  /// end.
  Image take(int& y) {
    std::unique_lock lock(mutex);
    std::size_t first = 0;
    changed.wait(lock, [&] {
      first = firstWaiting();
      return first < waiting.size() || ending;
    });
    Image rows;
    if (first >= waiting.size()) return rows;
    const std::size_t stride = static_cast<std::size_t>(latest.width) * latest.channels.size();
    const std::size_t limit = first + std::max<std::size_t>(kPacketFloats / stride, 1);
    for (next = first; next < std::min(limit, waiting.size()) && waiting[next]; ++next)
      waiting[next] = false;
    const auto at = [&](std::size_t row) {
      return latest.pixels.begin() + static_cast<std::ptrdiff_t>(row * stride);
    };
    rows.width = latest.width;
    rows.height = static_cast<int>(next - first);
    rows.channels = latest.channels;
    rows.pixels.assign(at(first), at(next));
    y = static_cast<int>(first);
    return rows;
  }

  /// The first waiting row, from `next` on and then from the top; waiting.size() if there is none.
  std::size_t firstWaiting() const {
    const std::size_t rows = waiting.size();
    for (std::size_t i = 0; i < rows; ++i)
      if (waiting[(next + i) % rows]) return (next + i) % rows;
    return rows;
  }
};

TevClient::TevClient(ViewerAddress address, std::string name) : state_(std::make_shared<State>()) {
  state_->address = std::move(address);
  state_->name = std::move(name);
  thread_ = std::thread([state = state_] { state->run(); });
}

TevClient::~TevClient() {
  std::unique_lock lock(state_->mutex);
  state_->ending = true;
  state_->end = Clock::now();
  state_->changed.notify_all();
  // patient() ends the thread sooner, unless it is looking up a name.
  const auto longest = (state_->connected ? kLongest : kStalled) + kStalled;
  state_->changed.wait_for(lock, longest, [&] { return state_->over; });
  const bool over = state_->over;
  lock.unlock();
  over ? thread_.join() : thread_.detach();
}

void TevClient::rowsChanged(const Image& picture, int first, int end) {
  const std::lock_guard lock(state_->mutex);
  if (state_->over) return;
  Image& latest = state_->latest;
  if (latest.height == 0) {
    latest = picture;
    state_->waiting.assign(static_cast<std::size_t>(picture.height), false);
  }
  const std::ptrdiff_t stride =
      picture.width * static_cast<std::ptrdiff_t>(picture.channels.size());
  std::copy(picture.pixels.begin() + first * stride, picture.pixels.begin() + end * stride,
            latest.pixels.begin() + first * stride);
  std::fill(state_->waiting.begin() + first, state_->waiting.begin() + end, true);
  state_->changed.notify_all();
}

}  // namespace laver
