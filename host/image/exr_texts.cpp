#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include "core/error.h"
#include "image/io.h"

namespace laver {

std::map<std::string, std::string> readExrTexts(const std::string& file) {
  try {
    const Imf::InputFile input(file.c_str());
    const Imf::Header& header = input.header();
    std::map<std::string, std::string> texts;
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
      const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute());
      if (text != nullptr) texts[attribute.name()] = text->value();
    }
    return texts;
  } catch (const std::exception&) {
    throw Error(ExitCode::Usage, fmt::format("cannot read \"{}\": it is no EXR file", file));
  }
}

}  // namespace laver
