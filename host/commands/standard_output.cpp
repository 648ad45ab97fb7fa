#include "commands/standard_output.h"

#include <fcntl.h>
#include <unistd.h>

#include <iostream>

#include "core/error.h"

namespace laver {

void flushStandardOutput() {
  if (!std::cout.flush()) throw Error(ExitCode::Output, "standard output cannot be written");
}

void occupyStandardDescriptors() {
  int descriptor = 0;
  do {
    descriptor = ::open("/dev/null", O_RDONLY);  // the lowest that is free
  } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  if (descriptor >= 0) ::close(descriptor);
}

}  // namespace laver
