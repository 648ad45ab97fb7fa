#pragma once
#include <cstddef>
#include <vector>

#include "render/options.h"

namespace laver {

/// The pixels of a film whose rays may hit geometry: one span of columns per row.
class Coverage {
 public:
  /// An empty coverage of a film of that size.
  Coverage(int width, int height);
  static Coverage whole(int width, int height);
  int width() const { return width_; }
  int height() const { return static_cast<int>(rows_.size()); }

  /// Adds pixels, clipped to the film.
  void add(const Crop& pixels);
  bool contains(const Crop& pixels) const;
  /// Whether any of these pixels is covered.
  bool intersects(const Crop& pixels) const;
  /// All pixels of the film within `reach` columns and rows of covered ones.
  Coverage grown(int reach) const;
  /// Share of an area that is covered, 0 to 1.
  double share(const Crop& area) const;

  /// Costs of rectangles in addition to their area, in pixels: per rectangle, and per column of
  /// each.
  struct Costs {
    double each = 0, column = 0;
  };
  /// The cheapest set of rectangles that contain all covered pixels of an area, from the top down;
  /// no two share a row. They begin at multiples of SLOT_COLUMNS from the area's left.
  std::vector<Crop> parts(const Crop& area, const Costs& costs) const;

 private:
  struct Span {
    int x0, x1;
    bool empty() const { return x0 >= x1; }
    void widen(const Span& s);
  };
  Span ofRows(int y0, int y1) const;

  int width_;
  std::vector<Span> rows_;
};

}  // namespace laver
