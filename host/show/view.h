#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>

namespace laver {

/// How a picture lies in a window: window = zoom * picture + offset, both in pixels from the top
/// left corner. Zooms are powers of the root of 2, so that those of 2 are exact.
class Placement {
 public:
  double zoom() const;
  glm::dvec2 offset() const { return offset_; }
  glm::dvec2 toPicture(glm::dvec2 window) const { return (window - offset_) / zoom(); }

  /// Moves the picture by `pixels` of the window.
  void pan(glm::dvec2 pixels) { offset_ += pixels; }
  /// `steps` times the root of 2; what lies under `window` stays there.
  void zoomAt(glm::dvec2 window, int steps);
  /// The picture in the middle, pixel on pixel or, with `fit`, as large as it goes in whole.
  void centre(glm::ivec2 picture, glm::ivec2 window, bool fit);

  bool operator==(const Placement&) const = default;

 private:
  int steps_ = 0;
  glm::dvec2 offset_{0.0};
};

/// What a window shows of one or two pictures.
struct View {
  enum class Mode { A, B, Difference };

  Placement placement;
  bool placed = false;  ///< once the window's size is known
  int halfStops = 0;    ///< exposure: values are shown times 2^(halfStops / 2)
  bool spread = false;  ///< the layer's own range is spread over black to white
  std::size_t layer = 0;
  Mode mode = Mode::A;

  bool operator==(const View&) const = default;
};

/// What a view is of and where the cursor is.
struct ViewContext {
  glm::ivec2 picture{1}, window{1};
  glm::dvec2 cursor{0.0};
  std::size_t layers = 1;
  bool two = false;  ///< there is a picture B
};

/// The pixel of the picture under the cursor, if there is one.
std::optional<glm::ivec2> pixelUnderCursor(const View& view, const ViewContext& context);

/// Does what a typed character stands for (README.md has the table); others do nothing.
void type(View& view, char32_t character, const ViewContext& context);

/// A line a key, for --help.
const char* viewKeys();

}  // namespace laver
