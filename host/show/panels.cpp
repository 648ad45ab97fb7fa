#include "show/panels.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <cmath>
#include <cstdint>

#include "show/compose.h"

namespace laver {
namespace {

using Contents = ViewedPictures::Contents;

void text(const std::string& line) { ImGui::TextUnformatted(line.c_str()); }

/// Radio buttons for the picture, if there are two, and for the layer.
void drawChoices(const Contents& contents, const std::vector<ViewLayer>& layers, View& view) {
  using Mode = View::Mode;
  const auto choice = [&](const std::string& label, bool chosen) {
    const bool pressed = ImGui::RadioButton(label.c_str(), chosen);
    ImGui::SameLine();
    return pressed;
  };
  if (contents.images.size() > 1) {
    if (choice("A " + contents.names[0], view.mode == Mode::A)) view.mode = Mode::A;
    if (choice("B " + contents.names[1], view.mode == Mode::B)) view.mode = Mode::B;
    if (choice("A - B", view.mode == Mode::Difference)) view.mode = Mode::Difference;
    text("|");
    ImGui::SameLine();
  }
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (choice(layers[i].name, view.layer == i)) view.layer = i;
  text(fmt::format("| {:.4g} % | exposure {:+.1f}{}", view.placement.zoom() * 100.0,
                   0.5 * view.halfStops, view.spread ? " | spread" : ""));
}

/// The layer's channels of a pixel in each picture, and their difference.
std::string values(const Contents& contents, const ViewLayer& layer, glm::ivec2 pixel) {
  const auto at = [&](std::size_t image, std::size_t c) {
    return static_cast<double>(contents.images[image].at(pixel.x, pixel.y, c));
  };
  const bool two = contents.images.size() > 1;
  std::string line = fmt::format("({}, {})", pixel.x, pixel.y);
  for (const std::size_t c : layer.channels) {
    line += fmt::format("  {} {:.6g}", contents.images[0].channels[c], at(0, c));
    if (two) line += fmt::format(" B {:.6g} A-B {:.3g}", at(1, c), at(0, c) - at(1, c));
  }
  return line;
}

void drawRendering(const ViewedPictures::Rendering& r) {
  const std::string share = r.over ? fmt::format("done in {:.1f} s", r.seconds)
                                   : fmt::format("{:.1f} %  {:.1f} s", r.share * 100.0, r.seconds);
  ImGui::ProgressBar(r.over ? 1.0F : static_cast<float>(r.share), {200.0F, 0.0F}, share.c_str());
  ImGui::SameLine();
  text(fmt::format("{:.2f} million samples/s | {}", r.samplesPerSecond * 1e-6, r.device));
}

}  // namespace

ImageView::ImageView() {
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

ImageView::~ImageView() { glDeleteTextures(1, &texture_); }

void ImageView::draw(const ViewedPictures::Contents& contents, const ViewLayer& layer,
                     const View& view, glm::ivec2 size) {
  const Drawn wanted{contents.changes, view, size};
  if (drawn_ != wanted) {
    const auto& images = contents.images;
    const Bitmap bitmap =
        compose(images[0], images.size() > 1 ? &images[1] : nullptr, layer, view, size.x, size.y);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, size.x, size.y, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 bitmap.pixels.data());
    drawn_ = wanted;
  }
  // NOLINTNEXTLINE(performance-no-int-to-ptr): required by ImGui's OpenGL backend
  const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture_));
  ImGui::GetBackgroundDrawList()->AddImage(
      texture, {0.0F, 0.0F}, {static_cast<float>(size.x), static_cast<float>(size.y)});
}

void drawPanel(const Contents& contents, const std::vector<ViewLayer>& layers,
               std::optional<glm::ivec2> pixel, int width, int top, View& view) {
  ImGui::SetNextWindowPos({0.0F, static_cast<float>(top)});
  ImGui::SetNextWindowSize({static_cast<float>(width), static_cast<float>(kPanelHeight)});
  ImGui::SetNextWindowBgAlpha(1.0F);
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
  drawChoices(contents, layers, view);
  text(pixel ? values(contents, layers[view.layer], *pixel) : "");
  if (contents.rendered) drawRendering(contents.rendering);
  ImGui::TextDisabled("drag, wheel, + - 1 f  place | e E n r  tone | l L  layer%s | q  close",
                      contents.images.size() > 1 ? " | a b d space  picture" : "");
  ImGui::End();
}

}  // namespace laver
