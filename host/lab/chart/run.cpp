#include "lab/chart/run.h"

#include <fstream>

#include "image/io.h"
#include "lab/chart/errors.h"
#include "lab/process.h"

namespace laver::chart {
namespace {

std::string lastLine(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

}  // namespace

Runner::~Runner() {
  std::error_code ignored;
  for (const char* extension : {".exr", ".png", ".json", ".partial.exr", ".partial.png"})
    std::filesystem::remove(file(extension), ignored);
}

Run Runner::run(std::vector<std::string> command) const {
  for (const std::string& more :
       {std::string("-o"), file(".exr"), "--stats=" + file(".json"), std::string("--quiet")})
    command.push_back(more);
  const ProcessRun ended = runProcess(std::move(command));
  Run run{ended.exitCode, ended.seconds, nullptr, lastLine(ended.errorOutput)};
  if (run.exitCode == 0)
    run.stats = nlohmann::json::parse(std::ifstream(file(".json")), nullptr, false);
  return run;
}

Image Runner::picture() const { return rgbOf(allChannels(), file(".exr")); }

Image Runner::allChannels() const { return readExr(file(".exr")); }

}  // namespace laver::chart
