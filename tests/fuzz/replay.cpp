// Feeds files, or all files of folders, to a fuzz target that is built without libFuzzer.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "fuzz/fuzz.h"

namespace {

namespace fs = std::filesystem;

void feed(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  std::printf("%s, %zu bytes\n", file.c_str(), bytes.size());
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

int replay(int count, char** names) {
  int fed = 0;
  for (int i = 0; i < count; ++i) {
    if (names[i][0] == '-') continue;  // libFuzzer's options
    if (!fs::is_directory(names[i])) {
      feed(names[i]);
      ++fed;
      continue;
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(names[i])) {
      feed(entry.path());
      ++fed;
    }
  }
  std::printf("%d files\n", fed);
  return fed > 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return replay(argc - 1, argv + 1);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "%s\n", fault.what());
    return 1;
  }
}
