#include "lab/chart/fingerprint.h"

#include <array>
#include <fstream>
#include <pugixml.hpp>

#include "core/error.h"
#include "scene/mesh_files.h"

namespace laver::chart {

std::string fingerprintOfFile(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  Fingerprint print;
  std::array<char, 1 << 16> part;
  do {
    in.read(part.data(), part.size());
    print.add(std::as_bytes(std::span(part.data(), static_cast<std::size_t>(in.gcount()))));
  } while (in);
  if (!in.eof()) throw Error(ExitCode::Output, "cannot read \"" + file + "\"");
  return print.text();
}

std::string fingerprintOfScene(const std::string& file) {
  Fingerprint print;
  print.add(fingerprintOfFile(file));
  pugi::xml_document document;
  document.load_file(file.c_str());
  for (const auto& found : document.select_nodes("//string[@name='filename']")) {
    const std::string named = xml::findFile(file, found.node().attribute("value").value());
    if (!named.empty()) print.add(fingerprintOfFile(named));
  }
  return print.text();
}

}  // namespace laver::chart
