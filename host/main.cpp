#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <system_error>

#include "commands/cli.h"
#include "commands/process.h"

namespace {

using namespace laver;

int fail(ExitCode code, const std::string& message) {
  std::fprintf(stderr, "laver: %s\n", message.c_str());
  return static_cast<int>(code);
}

/// Comes before the other static objects, tables of texts among them, which take memory.
struct BeforeOthers {
  BeforeOthers() { reportLackOfMemory(); }
};
[[gnu::init_priority(101)]] const BeforeOthers beforeOthers;

}  // namespace

int main(int argc, char** argv) {
  prepareProcess();
  try {
    const Job job = parse(argc, argv);
    return static_cast<int>(std::visit([](const auto& command) { return run(command); }, job));
  } catch (const Error& error) {
    // Scene errors are lines that begin with the file's name.
    if (error.code() != ExitCode::Scene) return fail(error.code(), error.what());
    std::fprintf(stderr, "%s\n", error.what());
    return static_cast<int>(error.code());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::Output, "out of memory");
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again)
      return fail(ExitCode::Output,
                  "no thread can be started: the system allows no more (ulimit -u)");
    return fail(ExitCode::Output, std::string("internal error: ") + error.what());
  } catch (const std::exception& error) {
    return fail(ExitCode::Output, std::string("internal error: ") + error.what());
  }
}
