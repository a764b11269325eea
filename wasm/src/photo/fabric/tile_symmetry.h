#pragma once
#include <array>
#include <vector>

#include "wallpaper/group.h"

namespace seamwise {

/// Makes an image of a cell exactly symmetric: every pixel becomes the mean of its images under the
/// group, some rows at a time. Elements that map pixels to pixels need no interpolation. Others
/// (rotations by 60 degrees) use cubics through the pixels.
class TileSymmetry {
 public:
  /// @param planes   sample (i, j) at ((i + 1/2) / columns, (j + 1/2) / rows), in the group's own
  ///                 basis and origin; `columns` equals `rows` if the group's matrices mix both
  ///                 directions
  TileSymmetry(std::array<std::vector<float>, 3> planes, int columns, int rows,
               const GroupData& group);
  /// Continues for about `samples` samples; returns false when done.
  bool advance(int samples);
  double fraction() const { return static_cast<double>(row_) / rows_; }
  /// Valid once done.
  const std::array<std::vector<float>, 3>& planes() const { return symmetric_; }

 private:
  void add(const LatticeElement& element, int row);

  std::array<std::vector<float>, 3> planes_, symmetric_;
  int columns_, rows_;
  std::vector<LatticeElement> elements_;
  int row_ = 0;
};

}  // namespace seamwise
