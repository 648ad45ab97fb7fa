#include "show/tev_client.h"

#include <algorithm>
#include <future>
#include <limits>

#include "core/error.h"
#include "unit/viewer.h"

namespace laver::test {
namespace {

/// An image that differs in each pixel, with special values of floats.
Image noise(int width, int height, unsigned seed) {
  Image image = rgbImage(width, height);
  std::uint32_t state = seed;
  for (float& value : image.pixels) {
    state = state * 1664525U + 1013904223U;
    std::memcpy(&value, &state, sizeof value);
  }
  image.pixels[0] = std::numeric_limits<float>::quiet_NaN();
  image.pixels[1] = -std::numeric_limits<float>::infinity();
  return image;
}

std::future<Viewer> viewerOf(const Listener& listener) {
  return std::async(std::launch::async, [&] { return Viewer(listener.accept()); });
}

int lines(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

void expectShown(const Listener& listener, const std::string& host) {
  const Image picture = noise(300, 500, 7);
  auto viewer = viewerOf(listener);
  {
    TevClient client({host, listener.port()}, "folder/picture.exr");
    const Image before = noise(300, 500, 8);
    client.rowsChanged(before, 0, 500);
    client.rowsChanged(picture, 100, 101);
    client.rowsChanged(picture, 101, 500);
    client.rowsChanged(picture, 0, 100);
  }
  const Viewer seen = viewer.get();
  EXPECT_EQ(seen.name, "folder/picture.exr");
  EXPECT_EQ(seen.created, 1);
  EXPECT_EQ(seen.picture.channels, picture.channels);
  EXPECT_EQ(seen.picture.width, 300);
  EXPECT_EQ(bitsOf(seen.picture), bitsOf(picture));
}

TEST(TevClient, ShowsThePictureBitForBit) { expectShown(Listener(), "127.0.0.1"); }

TEST(TevClient, FindsAViewerByNameWhicheverOfItsAddressesListens) {
  expectShown(Listener(), "localhost");
}

TEST(TevClient, SpeaksIpv6) {
  const Listener listener(AF_INET6);
  if (!listener.listens()) GTEST_SKIP() << "no IPv6 here";
  expectShown(listener, "::1");
}

TEST(TevClient, ShowsRowsWiderThanAPacket) {
  const Listener listener;
  const Image picture = noise(100000, 3, 1);
  auto viewer = viewerOf(listener);
  TevClient({"127.0.0.1", listener.port()}, "wide").rowsChanged(picture, 0, 3);
  EXPECT_EQ(bitsOf(viewer.get().picture), bitsOf(picture));
}

TEST(TevClient, SendsASlowViewerTheNewestRowsOnly) {
  const Listener listener;
  const Image picture = noise(500, 500, 2);  // 3 MB
  const Image before = noise(500, 500, 3);
  std::future<Viewer> viewer;
  {
    TevClient client({"127.0.0.1", listener.port()}, "picture");
    const int connection = listener.accept();
    for (int i = 0; i < 100; ++i) client.rowsChanged(before, 0, 500);
    client.rowsChanged(picture, 0, 500);
    viewer = std::async(std::launch::async, [=] { return Viewer(connection); });
  }
  const Viewer seen = viewer.get();
  EXPECT_EQ(bitsOf(seen.picture), bitsOf(picture));
  // 303 MB were handed over; Linux buffers 4 MB at a sender and 6 MB at a receiver by default.
  EXPECT_LT(seen.received, std::size_t{60000000});
}

TEST(TevClient, WarnsInOneLineIfNobodyListens) {
  const std::string port = Listener().port();
  testing::internal::CaptureStderr();
  {
    TevClient client({"127.0.0.1", port}, "picture");
    client.rowsChanged(noise(10, 10, 1), 0, 10);
  }
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(lines(said), 1) << said;
  EXPECT_NE(said.find("127.0.0.1 port " + port + ": Connection refused"), std::string::npos)
      << said;
}

TEST(TevClient, OutlivesAViewerThatClosesMidway) {
  const Listener listener;
  const Image picture = noise(1000, 1000, 4);  // 12 MB, more than the system keeps
  testing::internal::CaptureStderr();
  {
    TevClient client({"127.0.0.1", listener.port()}, "picture");
    const int connection = listener.accept();
    client.rowsChanged(picture, 0, 1000);
    char some[1000];
    EXPECT_GT(::read(connection, some, sizeof some), 0);
    ::close(connection);
    for (int i = 0; i < 10; ++i) client.rowsChanged(picture, 0, 1000);
  }
  EXPECT_EQ(lines(testing::internal::GetCapturedStderr()), 1);
}

TEST(TevClient, AbandonsAViewerThatNeverReads) {
  const Listener listener(AF_INET, 4096);
  const Image picture = noise(2000, 2000, 5);
  testing::internal::CaptureStderr();
  {
    TevClient client({"127.0.0.1", listener.port()}, "picture");
    for (int i = 0; i < 3; ++i) client.rowsChanged(picture, 0, 2000);
  }
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_EQ(lines(said), 1) << said;
  EXPECT_NE(said.find("timed out"), std::string::npos) << said;
}

TEST(TevClient, EndsWithoutAWarningIfThereAreNoRows) {
  const Listener listener;
  auto viewer = viewerOf(listener);
  { const TevClient client({"127.0.0.1", listener.port()}, "picture"); }
  EXPECT_EQ(viewer.get().received, 0U);
}

TEST(ViewerAddress, IsHostAndPort) {
  const auto of = [](const char* text) {
    const ViewerAddress address = viewerAddress(text);
    return address.host + " " + address.port;
  };
  EXPECT_EQ(of("localhost:14158"), "localhost 14158");
  EXPECT_EQ(of("viewer.example.org"), "viewer.example.org 14158");
  EXPECT_EQ(of("10.0.0.1:1"), "10.0.0.1 1");
  EXPECT_EQ(of("[::1]:65535"), "::1 65535");
  EXPECT_EQ(of("[fe80::1]"), "fe80::1 14158");
  for (const char* text : {"", ":1", "a:", "a:0", "a:65536", "a:123456", "a:x", "a:-1", "::1",
                           "[]:1", "[::1", "[", "[::1]x:1", "a:1:2"})
    EXPECT_THROW(viewerAddress(text), Error) << text;
}

}  // namespace
}  // namespace laver::test
