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

/// The inputs that determine a picture's bits: name and value, in the order in which differences
/// are reported.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// Those that do not depend on the device.
Settings settingsOf(const Scene& scene, const Crop& core, bool noriTable);

/// The settings of a render of a packed scene. They include the sample count if the sampler's
/// samples depend on it.
Settings settingsOf(const Scene& scene, const Packed& packed, const Choices& choices,
                    const DeviceInfo& device);

/// The sums of a film, from which a render can continue. Rows count from the top of the picture; no
/// row has more samples than the rows above it.
class FilmState {
 public:
  enum class Keep {
    Nothing,
    WhenEnded,  ///< only if a render is stopped early
    Always      ///< the sums of every row, 32 bytes per pixel, also of a finished render
  };

  explicit FilmState(Keep keep = Keep::Nothing) : keep_(keep) {}

  Keep keep() const { return keep_; }
  bool empty() const { return sums.pixels.empty(); }

  /// Prepares the state for a render with these settings and size. Throws Error(Usage) with one
  /// line if its sums cannot be continued to `wanted` samples per pixel.
  void begin(const Settings& now, int width, int height, std::uint32_t wanted);
  /// Number of rows from `row` on, up to `limit`, that have equal sample counts.
  int equalRows(int row, int limit) const;
  /// The sums of some rows, one shared::FilmPixel per pixel.
  std::span<const std::byte> bytes(int row, int rows) const;
  void take(int row, int rows, std::span<const std::byte> film, std::uint32_t count);
  /// Stores the finished pixels of the first rows, whose sums were not kept.
  void takeFinished(const Image& image, int rows, std::uint32_t count);

  std::string file;  ///< name of the file it was read from
  Image sums;        ///< channels sum.R .G .B .A, A the weight, and sum.rest.*; or empty
  std::vector<std::uint32_t> samples;  ///< per pixel, by row
  int finishedRows = 0;       ///< number of rows at the top that hold pixels instead of sums
  std::uint64_t dropped = 0;  ///< samples left out
  Settings settings;

 private:
  void allocate(int width);
  [[noreturn]] void refuse(const std::string& reason) const;

  Keep keep_;
};

}  // namespace laver
