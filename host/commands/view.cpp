#include "commands/commands.h"
#include "image/image.h"
#include "image/io.h"
#include "show/view_layers.h"
#include "show/window.h"

namespace laver {
namespace {

Image pictureOf(const std::string& file) {
  Image image = readExr(file);
  if (const std::string defect = imageDefect(image); !defect.empty())
    throw Error(ExitCode::Usage, file + " is broken: " + defect);
  return onFilm(withoutPrefix(std::move(image)));
}

}  // namespace

ExitCode run(const ViewCommand& command) {
  Image a = pictureOf(command.a);
  ViewedPictures pictures;
  if (command.b.empty()) {
    pictures.add(command.a, std::move(a));
  } else {
    Image b = pictureOf(command.b);
    keepShared(a, b);
    pictures.add(command.a, std::move(a));
    pictures.add(command.b, std::move(b));
  }
  const std::string title = command.a + (command.b.empty() ? "" : " and " + command.b);
  runWindow(title + " - laver", pictures, [] { return false; });
  return ExitCode::Ok;
}

}  // namespace laver
