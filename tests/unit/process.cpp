#include "commands/process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace laver::test {
namespace {

/// Runs a process without the standard descriptors in `closed`. Returns 0 if no file opened after
/// prepareProcess() gets one of their numbers, and writing to them fails.
int withoutDescriptors(std::initializer_list<int> closed) {
  const pid_t process = fork();
  if (process == 0) {
    for (const int descriptor : closed) close(descriptor);
    prepareProcess();
    if (open("/dev/null", O_WRONLY) <= STDERR_FILENO) _exit(1);
    for (const int descriptor : closed)
      if (write(descriptor, "x", 1) != -1 || errno != EBADF) _exit(2);
    _exit(0);
  }
  int status = 0;
  waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(StandardDescriptors, AreOccupiedIfTheyAreClosed) {
  EXPECT_EQ(withoutDescriptors({}), 0);
  EXPECT_EQ(withoutDescriptors({1}), 0);
  EXPECT_EQ(withoutDescriptors({0, 2}), 0);
  EXPECT_EQ(withoutDescriptors({0, 1, 2}), 0);
}

}  // namespace
}  // namespace laver::test
