#pragma once
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace laver::test {

/// Seconds after which a run of laver is ended, so that no test waits without a bound. This ends
/// what hangs and measures nothing: the longest run takes seconds, or some minutes under
/// sanitizers.
inline constexpr unsigned kLongestRun = 600;

/// A running `laver ARGUMENTS` in a folder. It is killed if it still runs when the object is
/// destroyed or the test's process ends.
class Child {
 public:
  /// `out` and `err` become its stdout and stderr; by default both go to files in the folder.
  /// `interrupt` is its action for SIGINT: SIG_DFL or SIG_IGN.
  Child(const std::filesystem::path& folder, std::vector<std::string> arguments,
        std::optional<int> out = {}, std::optional<int> err = {},
        void (*interrupt)(int) = SIG_DFL) {
    arguments.insert(arguments.begin(), LAVER_BINARY);
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const std::string place = folder.string();
    process_ = ::fork();
    if (process_ != 0) return;
    const auto file = [](const char* name) {
      return ::open(name, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    };
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::alarm(kLongestRun);  // exec keeps it
    bool ready = ::chdir(place.c_str()) == 0;
    ready = ready && ::dup2(out ? *out : file("out.txt"), STDOUT_FILENO) >= 0;
    ready = ready && ::dup2(err ? *err : file("err.txt"), STDERR_FILENO) >= 0;
    ::signal(SIGINT, interrupt);
    ::signal(SIGTERM, SIG_DFL);
    if (ready) ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  ~Child() {
    if (!ended()) send(SIGKILL);
    wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  pid_t process() const { return process_; }
  void send(int signal) const { ::kill(process_, signal); }
  bool ended() {
    if (!over_) over_ = ::waitpid(process_, &status_, WNOHANG) == process_;
    return over_;
  }
  /// Waits until it ends. Returns its exit code, or minus the number of the signal that ended it.
  int wait() {
    if (!over_) ::waitpid(process_, &status_, 0);
    over_ = true;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
  }

 private:
  pid_t process_ = -1;
  int status_ = 0;
  bool over_ = false;
};

/// A descriptor that is closed with the object.
class Descriptor {
 public:
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int get() const { return descriptor_; }
  void close() {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
  }

 private:
  int descriptor_;
};

}  // namespace laver::test
