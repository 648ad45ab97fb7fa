#include "commands/interruption.h"

#include <atomic>
#include <csignal>

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
  // The second one finds the default again; reads and writes go on after the first.
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(signal, &action, nullptr);
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

void Interruption::request() { note(SIGINT); }

ExitCode Interruption::code() {
  return firstSignal == SIGTERM ? ExitCode::Terminated : ExitCode::Interrupted;
}

}  // namespace laver
