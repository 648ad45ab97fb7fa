#pragma once
#include <string_view>

namespace laver {

/// Whether a text is a pointer file, which Git LFS leaves in place of a file that it has not
/// fetched. Its first key is the version, in old repositories with the program's earlier name.
inline bool isLfsPointer(std::string_view text) {
  return text.starts_with("version https://git-lfs.github.com/spec/") ||
         text.starts_with("version https://hawser.github.com/spec/");
}

inline constexpr const char* kLfsPointer =
    "is a pointer of Git LFS, not the file itself: \"git lfs pull\" fetches it";

}  // namespace laver
