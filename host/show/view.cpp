#include "show/view.h"

#include <algorithm>
#include <cmath>

namespace laver {
namespace {

constexpr int kMinSteps = -16, kMaxSteps = 16;  // 1/256 to 256
constexpr int kMaxHalfStops = 64;

}  // namespace

const char* viewKeys() {
  return "Keys:\n"
         "  drag               pan\n"
         "  wheel, + -         zoom about the cursor\n"
         "  1, f               actual pixels, fit the window\n"
         "  e E                exposure up and down by half a stop\n"
         "  n                  stretch the layer's range to black to white, and back\n"
         "  r                  reset the tone: exposure 0, not stretched\n"
         "  l L                next and previous layer\n"
         "  a b, space         picture A or B, flip\n"
         "  d                  difference in the false colours of laver compare\n"
         "  q, Escape          close; a render ends as by Ctrl-C";
}

double Placement::zoom() const { return std::exp2(0.5 * steps_); }

void Placement::zoomAt(glm::dvec2 window, int steps) {
  const glm::dvec2 fixed = toPicture(window);
  steps_ = std::clamp(steps_ + steps, kMinSteps, kMaxSteps);
  offset_ = window - zoom() * fixed;
}

void Placement::centre(glm::ivec2 picture, glm::ivec2 window, bool fit) {
  steps_ = 0;
  if (fit) {
    const glm::dvec2 ratio = glm::dvec2(window) / glm::dvec2(picture);
    const double steps = std::floor(2.0 * std::log2(std::min(ratio.x, ratio.y)) + 1e-9);
    steps_ = static_cast<int>(std::clamp(steps, double{kMinSteps}, double{kMaxSteps}));
  }
  // Whole pixels, so that at zoom 1 each image pixel covers one window pixel.
  offset_ = glm::floor(0.5 * (glm::dvec2(window) - zoom() * glm::dvec2(picture)));
}

std::optional<glm::ivec2> pixelUnderCursor(const View& view, const ViewContext& context) {
  const glm::dvec2 p = glm::floor(view.placement.toPicture(context.cursor));
  if (!glm::all(glm::greaterThanEqual(p, glm::dvec2(0.0))) ||
      !glm::all(glm::lessThan(p, glm::dvec2(context.picture))))
    return std::nullopt;
  return glm::ivec2(p);
}

void type(View& view, char32_t character, const ViewContext& context) {
  using Mode = View::Mode;
  const auto expose = [&](int halfStops) {
    view.halfStops = std::clamp(view.halfStops + halfStops, -kMaxHalfStops, kMaxHalfStops);
  };
  switch (character) {
    case U'e':
      return expose(1);
    case U'E':
      return expose(-1);
    case U'n':
      view.spread = !view.spread;
      return;
    case U'r':
      view.halfStops = 0;
      view.spread = false;
      return;
    case U'+':
    case U'=':
      return view.placement.zoomAt(context.cursor, 1);
    case U'-':
      return view.placement.zoomAt(context.cursor, -1);
    case U'1':
      return view.placement.centre(context.picture, context.window, false);
    case U'f':
      return view.placement.centre(context.picture, context.window, true);
    case U'l':
      view.layer = (view.layer + 1) % context.layers;
      return;
    case U'L':
      view.layer = (view.layer + context.layers - 1) % context.layers;
      return;
    default:
      break;
  }
  if (!context.two) return;
  if (character == U'a') view.mode = Mode::A;
  if (character == U'b') view.mode = Mode::B;
  if (character == U'd') view.mode = Mode::Difference;
  if (character == U' ') view.mode = view.mode == Mode::A ? Mode::B : Mode::A;
}

}  // namespace laver
