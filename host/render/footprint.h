#pragma once
#include <cstddef>
#include <vector>

#include "render/options.h"

namespace laver {

/// Where a film can see something: in each row one span of columns, and nothing beside it.
class Footprint {
 public:
  /// Nothing of a film of that size.
  Footprint(int width, int height);
  static Footprint whole(int width, int height);
  int width() const { return width_; }
  int height() const { return static_cast<int>(rows_.size()); }

  /// Sees these pixels too, as far as the film has them.
  void add(const Crop& pixels);
  bool holds(const Crop& pixels) const;
  /// Some of these pixels see something.
  bool meets(const Crop& pixels) const;
  /// All pixels of the film within `reach` columns and rows of those seen.
  Footprint grown(int reach) const;
  /// How much of an area is seen, from 0 to 1.
  double share(const Crop& area) const;

  /// What rectangles cost, in pixels: each for itself, and for each of its columns.
  struct Costs {
    double each = 0, column = 0;
  };
  /// The cheapest rectangles that hold all that is seen of an area, from the top down; no two have
  /// a row in common. They begin at multiples of SLOT_COLUMNS from the area's left.
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
