#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace laver {

/// The address at which a viewer listens.
struct ViewerAddress {
  std::string host, port;
};

/// Parses HOST:PORT, [IPV6]:PORT or HOST, with tev's default port 14158. Throws Error(Usage).
ViewerAddress viewerAddress(const std::string& text);

/// A TCP connection whose waits can be abandoned.
class Connection {
 public:
  /// Called ten times per second during a wait; the wait is abandoned if it returns false.
  using Patience = std::function<bool()>;

  /// Tries every address of the host, each for at most 5 s. Looking up a name cannot be abandoned.
  /// Throws std::runtime_error with the reason.
  Connection(const ViewerAddress& address, const Patience& patience);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Sends all bytes, and calls `progress` after each part. Throws std::runtime_error with the
  /// reason.
  void send(std::span<const std::byte> bytes, const Patience& patience,
            const std::function<void()>& progress) const;

 private:
  int socket_ = -1;
};

}  // namespace laver
