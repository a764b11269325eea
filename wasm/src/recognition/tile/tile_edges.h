#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "recognition/base/picture.h"

namespace seamwise {

/// Whether two opposite edges of a picture go on into each other when it is repeated.
struct TileEdge {
  bool meets = true;
  /// Where they differ most, as a share of the right or lower edge from its upper or left end.
  double differs_at = 0;
  /// Stretches of that edge at which they differ, as such shares; none where they meet.
  std::vector<std::array<double, 2>> open;
};

/// Which edges are compared.
enum class TileSides : std::uint8_t { kLeftAndRight, kTopAndBottom };

/// How the copy beyond an edge lies: beside the picture, or half a side further along.
enum class NextCopy : std::uint8_t { kBeside, kHalfAside };

/// Compares two opposite edges, some lines of pixels at a time. Lines of motifs run across a border
/// as steeply as they do on either side of it: where a row of pixels was cut away, they step aside
/// by twice as much, and where more was, colours do not go on at all. Bands that are straight along
/// the border or across it go on wherever a picture begins and ends, so that nothing can be said of
/// them.
class EdgeComparison {
 public:
  /// `tile`'s pixels have to outlive it.
  EdgeComparison(const PixelView& tile, TileSides sides, NextCopy next = NextCopy::kBeside)
      : tile_(tile), sides_(sides), next_(next) {}
  /// One step of some milliseconds; false when nothing is left to do.
  bool advance();
  double fraction() const;
  /// Once done.
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
  int line_ = 0;  ///< the next one within, of all or of those that a cut is told from
  std::vector<double> one_, two_;  ///< what changes within, over one line and over two. [0, 255]
  double greatest_whole_ = 0;      ///< of all of a line, over two
  double border_ratio_ = 0;        ///< of errors without a cut to those with one, at the border
  TileEdge edge_;
};

}  // namespace seamwise
