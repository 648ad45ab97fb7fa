#pragma once
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "image/image.h"

namespace laver {

/// What a window shows: a picture A, perhaps a B alike in size and channels, and how far the
/// rendering of A is. A rendering thread may change it while a window reads.
class ViewedPictures {
 public:
  struct Rendering {
    std::string device;
    double share = 0.0;  ///< that is done
    double seconds = 0.0;
    double samplesPerSecond = 0.0;
    bool over = false;
  };
  /// Valid while a reader has it.
  struct Contents {
    std::vector<std::string> names;
    std::vector<Image> images;
    Rendering rendering;
    bool rendered = false;      ///< `rendering` means something
    std::uint64_t changes = 0;  ///< how often the pictures have changed
  };

  void add(std::string name, Image image);

  /// Takes rows [firstRow, endRow) of picture A.
  void rowsChanged(const Image& picture, int firstRow, int endRow);
  /// Picture A, other channels too.
  void replace(const Image& picture);
  void report(const Rendering& rendering);

  /// Calls use(contents); the rendering thread waits meanwhile if it has news.
  template <class Use>
  auto read(const Use& use) const {
    const std::lock_guard lock(mutex_);
    return use(contents_);
  }

 private:
  mutable std::mutex mutex_;
  Contents contents_;
};

}  // namespace laver
