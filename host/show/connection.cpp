#include "show/connection.h"

#include <fmt/format.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "core/error.h"

namespace laver {
namespace {

constexpr int kTickMilliseconds = 100;
constexpr int kConnectTicks = 50;  // 5 s

std::string reasonOf(int error) { return std::generic_category().message(error); }

/// Waits until `socket` can be written to. Returns 0, or an errno: ETIMEDOUT after `ticks` of
/// kTickMilliseconds (negative: no limit) or when `patience` returns false.
int waitToWrite(int socket, const Connection::Patience& patience, int ticks) {
  for (; ticks != 0 && patience(); --ticks) {
    pollfd wanted{socket, POLLOUT, 0};
    const int ready = ::poll(&wanted, 1, kTickMilliseconds);
    if (ready > 0) return 0;
    if (ready < 0 && errno != EINTR) return errno;
  }
  return ETIMEDOUT;
}

/// Connects a new socket to `address`. Returns 0, or an errno.
int connectTo(const addrinfo& address, const Connection::Patience& patience, int& socket) {
  socket = ::socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC,
                    address.ai_protocol);
  if (socket < 0) return errno;
  if (::connect(socket, address.ai_addr, address.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  if (const int error = waitToWrite(socket, patience, kConnectTicks)) return error;
  int error = 0;
  socklen_t size = sizeof error;
  return ::getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

}  // namespace

ViewerAddress viewerAddress(const std::string& text) {
  ViewerAddress address{text, "14158"};
  const std::size_t colon = text.rfind(':');
  const bool bracketed = text.rfind('[', 0) == 0;
  if (colon != std::string::npos && (!bracketed || text[colon - 1] == ']')) {
    address.host = text.substr(0, colon);
    address.port = text.substr(colon + 1);
  }
  std::string& host = address.host;
  bool good = true;
  if (bracketed) {
    good = host.size() > 2 && host.back() == ']';
    host = host.substr(1, host.size() - 2);
  } else {
    good = !host.empty() && host.find(':') == std::string::npos;
  }
  const std::string& port = address.port;
  const bool digits = !port.empty() && port.size() <= 5 &&
                      port.find_first_not_of("0123456789") == std::string::npos;
  if (!good || !digits || std::stoi(port) < 1 || std::stoi(port) > 65535)
    throw Error(ExitCode::Usage,
                fmt::format("--display-server {}: expected HOST:PORT or [IPV6]:PORT", text));
  return address;
}

Connection::Connection(const ViewerAddress& address, const Patience& patience) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  // A null host means the loopback addresses, which are what "localhost" must name (RFC 6761,
  // section 6.3) even if the system resolves no names.
  const char* host = address.host == "localhost" ? nullptr : address.host.c_str();
  const int failed = ::getaddrinfo(host, address.port.c_str(), &hints, &found);
  if (failed != 0)
    throw std::runtime_error(failed == EAI_SYSTEM ? reasonOf(errno) : ::gai_strerror(failed));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> all(found, ::freeaddrinfo);
  int error = ECONNREFUSED;
  for (const addrinfo* one = found; one != nullptr && patience(); one = one->ai_next) {
    error = connectTo(*one, patience, socket_);
    if (error == 0) return;
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
  }
  throw std::runtime_error(reasonOf(error));
}

Connection::~Connection() {
  if (socket_ >= 0) ::close(socket_);
}

void Connection::send(std::span<const std::byte> bytes, const Patience& patience,
                      const std::function<void()>& progress) const {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(sent));
      progress();
      continue;
    }
    int error = errno;
    if (error == EINTR) continue;
    if (error == EAGAIN || error == EWOULDBLOCK) error = waitToWrite(socket_, patience, -1);
    if (error != 0) throw std::runtime_error(reasonOf(error));
  }
}

}  // namespace laver
