#pragma once
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "image/image.h"

namespace laver {

/// The images of a window: A, optionally B of the same size and channels, and the progress of the
/// render of A. A rendering thread may change it while a window reads.
class ViewedPictures {
 public:
  struct Rendering {
    std::string device;
    double share = 0.0;  ///< of the samples, finished
    double seconds = 0.0;
    double samplesPerSecond = 0.0;
    bool over = false;
  };
  /// Valid only inside read().
  struct Contents {
    std::vector<std::string> names;
    std::vector<Image> images;
    Rendering rendering;
    bool rendered = false;      ///< `rendering` is valid
    std::uint64_t changes = 0;  ///< number of changes of the images
  };

  void add(std::string name, Image image);

  /// Copies rows [firstRow, endRow) of picture A.
  void rowsChanged(const Image& picture, int firstRow, int endRow);
  /// Replaces picture A, including its channels.
  void replace(const Image& picture);
  void report(const Rendering& rendering);

  /// Calls use(contents), during which other threads that change the contents wait.
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
