#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "image/image.h"
#include "render/packed.h"

namespace laver {

struct DeviceInfo;

/// What a picture's bits depend on: name and value, in the order in which differences are told.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// Of a render of what is packed. The sample count is there where the sampler's samples
/// depend on it.
Settings settingsOf(const Scene& scene, const Packed& packed, const Choices& choices,
                    const DeviceInfo& device);

/// The sums of a film, with which a render goes on. Rows count from the top of the picture, and
/// none holds more samples than those above it.
class FilmState {
 public:
  enum class Keep {
    Nothing,
    WhenEnded,  ///< what there is when a render is ended early
    Always      ///< the sums of every row, 32 bytes a pixel: a finished render goes on, too
  };

  explicit FilmState(Keep keep = Keep::Nothing) : keep_(keep) {}

  Keep keep() const { return keep_; }
  bool empty() const { return sums.pixels.empty(); }

  /// Makes it one of `now` and of a picture of that size. Throws Error(Usage) with one line where
  /// it holds sums that cannot become `wanted` samples a pixel of that.
  void begin(const Settings& now, int width, int height, std::uint32_t wanted);
  /// Rows from `row` on, `most` or fewer, that hold equally many samples.
  int alike(int row, int most) const;
  /// The sums of some rows: a shared::FilmPixel each.
  std::span<const std::byte> bytes(int row, int rows) const;
  void take(int row, int rows, std::span<const std::byte> film, std::uint32_t count);
  /// Takes the finished pixels of the first rows, whose sums were not kept.
  void takeFinished(const Image& image, int rows, std::uint32_t count);

  std::string file;                    ///< it was read from, for messages
  Image sums;                          ///< sum.R .G .B .A, A the weight, and sum.rest.*, or empty
  std::vector<std::uint32_t> samples;  ///< a pixel, by row
  int finishedRows = 0;                ///< from the top: they hold pixels in place of sums
  std::uint64_t dropped = 0;           ///< samples left out
  Settings settings;

 private:
  void allocate(int width);
  [[noreturn]] void refuse(const std::string& reason) const;

  Keep keep_;
};

}  // namespace laver
