#include "commands/process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>

namespace laver {
namespace {

std::atomic<int> firstSignal{0};
static_assert(std::atomic<int>::is_always_lock_free);  // safe in a signal handler

void note(int signal) {
  int none = 0;
  firstSignal.compare_exchange_strong(none, signal);
}

void handle(int signal) {
  struct sigaction old {};
  sigaction(signal, nullptr, &old);
  if (old.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = note;
  // A second signal has its default effect. Interrupted reads and writes are restarted after the
  // first.
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(signal, &action, nullptr);
}

/// Under a limit of the address space, drivers crash where they get no memory.
void reportCrash(int /*signal*/) {
  constexpr char text[] =
      "laver: crashed, probably in the driver for lack of memory: the address space is limited "
      "(ulimit -v)\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, sizeof text - 1);
  ::_exit(static_cast<int>(ExitCode::Device));
}

bool addressSpaceIsLimited() {
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

void release(int signal) {
  struct sigaction now {};
  sigaction(signal, nullptr, &now);
  if (now.sa_handler == note) ::signal(signal, SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
  firstSignal = 0;
  handle(SIGINT);
  handle(SIGTERM);
}

Interruption::~Interruption() {
  release(SIGINT);
  release(SIGTERM);
}

bool Interruption::noted() { return firstSignal != 0; }

void Interruption::waiting() {
  if (!noted()) return;
  std::fputs("laver: interrupted before the first pass; nothing is written\n", stderr);
  std::_Exit(static_cast<int>(code()));
}

void Interruption::request() { note(SIGINT); }

ExitCode Interruption::code() {
  return firstSignal == SIGTERM ? ExitCode::Terminated : ExitCode::Interrupted;
}

void reportLackOfMemory() {
  std::set_terminate([] {
    if (const std::exception_ptr thrown = std::current_exception()) {
      try {
        std::rethrow_exception(thrown);
      } catch (const std::bad_alloc&) {
        constexpr char text[] = "laver: out of memory\n";
        [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, sizeof text - 1);
        ::_exit(static_cast<int>(ExitCode::Output));
      } catch (...) {
      }
    }
    std::abort();
  });
}

void prepareProcess() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  if (addressSpaceIsLimited())
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT}) std::signal(signal, reportCrash);
  int descriptor = 0;
  do {
    descriptor = ::open("/dev/null", O_RDONLY);  // the lowest that is free
  } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  if (descriptor >= 0) ::close(descriptor);
}

void flushStandardOutput() {
  if (!std::cout.flush()) throw Error(ExitCode::Output, "standard output cannot be written");
}

std::uint64_t peakBytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace laver
