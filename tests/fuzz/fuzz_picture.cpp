// Arbitrary bytes as a PNG or JPEG cause an error of one line, or an image of the size in the file.
#include <stdexcept>

#include "fuzz/fuzz.h"
#include "image/picture.h"

namespace laver::fuzz {
namespace {

void check(const Picture& picture) {
  const auto count =
      static_cast<std::size_t>(widthOf(picture)) * static_cast<std::size_t>(heightOf(picture));
  require(count > 0, "a picture has pixels");
  if (const auto* bitmap = std::get_if<Bitmap>(&picture))
    require(bitmap->pixels.size() == count, "a picture has its pixels");
  else
    require(std::get<Image>(picture).pixels.size() == 3 * count, "a picture has its floats");
}

template <class Decode>
void tryTo(const Decode& decode) {
  try {
    check(decode());
  } catch (const std::runtime_error& error) {
    const std::string reason = error.what();
    require(!reason.empty() && reason.find('\n') == std::string::npos, "a reason is one line");
  }
}

}  // namespace
}  // namespace laver::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  laver::fuzz::tryTo([&] { return laver::decodePng(bytes, false); });
  laver::fuzz::tryTo([&] { return laver::Picture(laver::decodeJpeg(bytes)); });
  return 0;
}
