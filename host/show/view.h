#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>

namespace laver {

/// Position and zoom of an image in a window: window = zoom * image + offset, both in pixels from
/// the top left corner. Zooms are powers of sqrt(2), so that powers of 2 are exact.
class Placement {
 public:
  double zoom() const;
  glm::dvec2 offset() const { return offset_; }
  glm::dvec2 toPicture(glm::dvec2 window) const { return (window - offset_) / zoom(); }

  /// Moves the image by `pixels` of the window.
  void pan(glm::dvec2 pixels) { offset_ += pixels; }
  /// Zooms by sqrt(2)^steps and keeps the point under `window` fixed.
  void zoomAt(glm::dvec2 window, int steps);
  /// Centres the image at zoom 1, or with `fit` at the largest zoom that shows all of it.
  void centre(glm::ivec2 picture, glm::ivec2 window, bool fit);

  bool operator==(const Placement&) const = default;

 private:
  int steps_ = 0;
  glm::dvec2 offset_{0.0};
};

/// The state of a window that shows one or two images.
struct View {
  enum class Mode { A, B, Difference };

  Placement placement;
  bool placed = false;  ///< `placement` has been set
  int halfStops = 0;    ///< exposure: values are scaled by 2^(halfStops / 2)
  bool spread = false;  ///< the layer's range is stretched to black to white
  std::size_t layer = 0;
  Mode mode = Mode::A;

  bool operator==(const View&) const = default;
};

/// Sizes and cursor that interpret an input event.
struct ViewContext {
  glm::ivec2 picture{1}, window{1};
  glm::dvec2 cursor{0.0};
  std::size_t layers = 1;
  bool two = false;  ///< there is a picture B
};

/// The image pixel under the cursor, if there is one.
std::optional<glm::ivec2> pixelUnderCursor(const View& view, const ViewContext& context);

/// Executes the command of a typed character (viewKeys() lists them); other characters do nothing.
void type(View& view, char32_t character, const ViewContext& context);

/// One line per key, for --help.
const char* viewKeys();

}  // namespace laver
