#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "photo/base/picture.h"

namespace seamwise {

/// Continuity of two opposite edges of a repeated image.
struct TileEdge {
  bool meets = true;
  /// Place of the greatest difference, as a share of the right or lower edge from its upper or left
  /// end.
  double differs_at = 0;
  /// Stretches of that edge with differences, as such shares; empty if the edges meet.
  std::vector<std::array<double, 2>> open;
};

/// Compared edges.
enum class TileSides : std::uint8_t { kLeftAndRight, kTopAndBottom };

/// Position of the copy beyond an edge: beside the image, or half a side further along.
enum class NextCopy : std::uint8_t { kBeside, kHalfAside };

/// Compares two opposite edges, some lines of pixels at a time.
/// Lines of motifs run across a border as steeply as they do on either side of it. They step aside
/// by twice as much if a row of pixels was cut away. Colours are discontinuous if more was cut
/// away. Straight bands along the border or across it continue wherever an image starts and ends,
/// so they give no evidence.
class EdgeComparison {
 public:
  /// The pixels of `tile` have to outlive the object.
  EdgeComparison(const PixelView& tile, TileSides sides, NextCopy next = NextCopy::kBeside)
      : tile_(tile), sides_(sides), next_(next) {}
  /// Runs one step of some milliseconds; returns false when done.
  bool advance();
  double fraction() const;
  /// Valid once done.
  const TileEdge& edge() const { return edge_; }

 private:
  enum class Stage : std::uint8_t { kWithin, kBorder, kCut, kDone };
  void lookWithin();
  void lookAtBorder();
  void compareCut();
  void foundOpen();

  PixelView tile_;
  TileSides sides_;
  NextCopy next_;
  Stage stage_ = Stage::kWithin;
  int line_ = 0;  ///< next inner line, of all lines or of those compared with a cut
  std::vector<double> one_, two_;  ///< changes inside, over one line and over two. [0, 255]
  double greatest_whole_ = 0;      ///< change of a whole line, over two lines
  double border_ratio_ = 0;  ///< errors without a cut relative to those with one, at the border
  TileEdge edge_;
};

}  // namespace seamwise
