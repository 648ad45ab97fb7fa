#include "lab/chart/run.h"

#include <fcntl.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "image/io.h"

namespace laver::chart {
namespace {

std::string lastLine(const std::string& file) {
  std::ifstream in(file);
  std::string last;
  for (std::string line; std::getline(in, line);) last = line;
  return last;
}

/// Waits for the process; returns as waitpid fills it, or what posix_spawn failed with, times 256.
int spawnAndWait(std::vector<std::string>& arguments, const std::string& errors) {
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t child = 0;
  int status = ::posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ) << 8;
  posix_spawn_file_actions_destroy(&actions);
  if (status == 0) ::waitpid(child, &status, 0);
  return status;
}

}  // namespace

Runner::~Runner() {
  std::error_code ignored;
  for (const char* extension : {".exr", ".png", ".json", ".err", ".partial.exr", ".partial.png"})
    std::filesystem::remove(file(extension), ignored);
}

std::optional<Run> Runner::run(const std::string& program, std::vector<std::string> arguments,
                               const std::function<bool()>& stop) const {
  arguments.insert(arguments.begin(), program);
  for (const std::string& more :
       {std::string("-o"), file(".exr"), "--stats=" + file(".json"), std::string("--quiet")})
    arguments.push_back(more);
  std::error_code ignored;
  std::filesystem::remove(file(".err"), ignored);
  const auto start = std::chrono::steady_clock::now();
  const int status = spawnAndWait(arguments, file(".err"));
  Run result;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (status != 0) {
    if (stop && stop()) return {};
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
    const bool known = code >= 1 && code <= 5;
    throw Error(known ? static_cast<ExitCode>(code) : ExitCode::Output,
                fmt::format("{} failed: {}", fmt::join(arguments, " "), lastLine(file(".err"))));
  }
  result.stats = nlohmann::json::parse(std::ifstream(file(".json")), nullptr, false);
  if (!result.stats.is_object() || !result.stats.contains("seconds"))
    throw Error(ExitCode::Output, program + " left no figures in " + file(".json"));
  return result;
}

Image Runner::picture() const { return readExr(file(".exr")); }

}  // namespace laver::chart
