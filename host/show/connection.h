#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace laver {

/// Where a viewer listens.
struct ViewerAddress {
  std::string host, port;
};

/// Reads HOST:PORT, [IPV6]:PORT or HOST, whose port is tev's own, 14158. Throws Error(Usage).
ViewerAddress viewerAddress(const std::string& text);

/// A TCP connection that is never waited for longer than its user likes.
class Connection {
 public:
  /// Asked ten times a second while something is waited for: false gives up.
  using Patience = std::function<bool()>;

  /// Tries every address that the host's name has, each for 5 s at most. Looking up a name cannot
  /// be given up. Throws std::runtime_error with the reason.
  Connection(const ViewerAddress& address, const Patience& patience);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Sends all, and calls `progress` whenever some went. Throws std::runtime_error with the reason.
  void send(std::span<const std::byte> bytes, const Patience& patience,
            const std::function<void()>& progress) const;

 private:
  int socket_ = -1;
};

}  // namespace laver
