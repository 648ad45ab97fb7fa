#pragma once
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "image/image.h"

namespace laver::test {

/// Only a bound: a connection over the loopback interface takes milliseconds.
inline constexpr int kViewerSeconds = 60;

/// A socket that listens on a free port of the loopback interface, by IPv4 or IPv6.
class Listener {
 public:
  explicit Listener(int family = AF_INET, int receiveBytes = 0) {
    socket_ = ::socket(family, SOCK_STREAM, 0);
    if (receiveBytes != 0)
      ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receiveBytes, sizeof receiveBytes);
    sockaddr_in6 v6{};
    v6.sin6_family = AF_INET6;
    v6.sin6_addr = in6addr_loopback;
    sockaddr_in v4{};
    v4.sin_family = AF_INET;
    v4.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    sockaddr* const address =
        family == AF_INET ? reinterpret_cast<sockaddr*>(&v4) : reinterpret_cast<sockaddr*>(&v6);
    socklen_t size = family == AF_INET ? sizeof v4 : sizeof v6;
    listens_ = ::bind(socket_, address, size) == 0 && ::listen(socket_, 1) == 0;
    ::getsockname(socket_, address, &size);
    port_ = ntohs(family == AF_INET ? v4.sin_port : v6.sin6_port);
  }
  ~Listener() { ::close(socket_); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  bool listens() const { return listens_; }
  std::string port() const { return std::to_string(port_); }
  /// Accepts a connection. Its reads fail after kViewerSeconds without bytes; -1 if nobody connects
  /// for as long.
  int accept() const {
    pollfd wanted{socket_, POLLIN, 0};
    if (::poll(&wanted, 1, kViewerSeconds * 1000) <= 0) {
      ADD_FAILURE() << "nobody connected within " << kViewerSeconds << " s";
      return -1;
    }
    const int connection = ::accept(socket_, nullptr, nullptr);
    const timeval bound{kViewerSeconds, 0};
    ::setsockopt(connection, SOL_SOCKET, SO_RCVTIMEO, &bound, sizeof bound);
    return connection;
  }

 private:
  int socket_;
  bool listens_ = false;
  int port_ = 0;
};

/// Plays the viewer: reads packets to the end of the connection and keeps the picture that they
/// make. Written from the protocol, independently of laver's code.
class Viewer {
 public:
  explicit Viewer(int connection) {
    std::vector<char> buffer(1 << 16);
    ssize_t got = 0;
    while ((got = ::read(connection, buffer.data(), buffer.size())) > 0) {
      bytes_.insert(bytes_.end(), buffer.begin(), buffer.begin() + got);
      received += static_cast<std::size_t>(got);
      while (packet()) {
      }
    }
    if (connection >= 0) {
      EXPECT_EQ(got, 0) << "no byte for " << kViewerSeconds << " s";
      ::close(connection);
    }
    EXPECT_EQ(bytes_.size(), 0U) << "half a packet";
  }

  std::string name;
  Image picture;
  std::size_t received = 0;
  int created = 0, updates = 0;

 private:
  template <class T>
  T take() {
    T value{};
    if (at_ + sizeof value <= bytes_.size()) std::memcpy(&value, &bytes_[at_], sizeof value);
    at_ += sizeof value;
    return value;
  }
  std::string text() {
    std::string result;
    while (at_ < bytes_.size() && bytes_[at_] != '\0') result += bytes_[at_++];
    ++at_;
    return result;
  }

  bool packet() {
    std::uint32_t length = 0;
    if (bytes_.size() < sizeof length) return false;
    std::memcpy(&length, bytes_.data(), sizeof length);
    if (bytes_.size() < length) return false;
    at_ = 4;
    const int operation = take<std::uint8_t>();
    take<std::uint8_t>();  // focus
    const std::string who = text();
    if (operation == 4)
      create(who);
    else if (operation == 6)
      update(who);
    else
      ADD_FAILURE() << "operation " << operation;
    EXPECT_EQ(at_, length);
    bytes_.erase(bytes_.begin(), bytes_.begin() + length);
    return true;
  }

  void create(const std::string& who) {
    ++created;
    name = who;
    const auto width = take<std::int32_t>(), height = take<std::int32_t>();
    std::vector<std::string> channels(static_cast<std::size_t>(take<std::int32_t>()));
    for (std::string& channel : channels) channel = text();
    picture = blackImage(width, height, channels);
  }

  void update(const std::string& who) {
    ++updates;
    EXPECT_EQ(created, 1);
    EXPECT_EQ(who, name);
    const auto count = static_cast<std::size_t>(take<std::int32_t>());
    std::vector<std::string> channels(count);
    for (std::string& channel : channels) channel = text();
    EXPECT_EQ(channels, picture.channels);
    const auto x = take<std::int32_t>(), y = take<std::int32_t>();
    const auto width = take<std::int32_t>(), height = take<std::int32_t>();
    std::vector<std::int64_t> offsets(count), strides(count);
    for (auto& offset : offsets) offset = take<std::int64_t>();
    for (auto& stride : strides) stride = take<std::int64_t>();
    ASSERT_TRUE(x >= 0 && y >= 0 && x + width <= picture.width && y + height <= picture.height);
    const std::size_t first = at_;
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u)
        for (std::size_t c = 0; c < count; ++c) {
          at_ = first + 4 * static_cast<std::size_t>(offsets[c] + (v * width + u) * strides[c]);
          picture.at(x + u, y + v, c) = take<float>();
        }
  }

  std::vector<char> bytes_;
  std::size_t at_ = 0;
};

/// The bits of the picture, including NaN patterns.
inline std::vector<std::uint32_t> bitsOf(const Image& image) {
  std::vector<std::uint32_t> bits(image.pixels.size());
  std::memcpy(bits.data(), image.pixels.data(), bits.size() * 4);
  return bits;
}

}  // namespace laver::test
