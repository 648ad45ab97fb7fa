#pragma once
#include <string_view>

namespace laver {

/// Whether a text is what Git LFS leaves in the place of a file that it has not fetched (its first
/// key is the version, of the program's first name in old repositories).
inline bool isLfsPointer(std::string_view text) {
  return text.starts_with("version https://git-lfs.github.com/spec/") ||
         text.starts_with("version https://hawser.github.com/spec/");
}

inline constexpr const char* kLfsPointer =
    "is a pointer of Git LFS, not the file itself: \"git lfs pull\" fetches it";

}  // namespace laver
