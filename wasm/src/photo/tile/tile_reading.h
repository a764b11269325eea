#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "base/outcome.h"
#include "photo/tile/seamless_reading.h"
#include "photo/tile/tile_edges.h"

namespace seamwise {

/// Fit of an image to its copies, repeated straight, in half-drop and as bricks.
struct TileSeams {
  TileEdge across, up;  ///< left and right edges; upper and lower edges
  /// Left and right edges if the next copy is half a side down; upper and lower edges if it is half
  /// a side aside.
  TileEdge half_drop, brick;
  bool missing_column = false;  ///< only symmetries show that a line of pixels is missing
  bool missing_row = false;
};

/// Reads an image that repeats edge to edge as one cell of a print or several, step by step. It
/// compares the edges, reads the image, and reads it again with other sides or one more line.
/// Pixels are assumed to be square. The exception is a square image whose rotations by a third of a
/// turn show that its sides are those of a hexagonal cell.
class TileReader {
 public:
  /// The pixels of `tile` have to outlive the object.
  /// @param any_edges   the image repeats edge to edge even if its edges do not meet; `seams`
  ///                    contains whether they do
  TileReader(const PixelView& tile, bool any_edges) : tile_(tile), any_edges_(any_edges) {}

  /// Runs one step of some milliseconds; returns false when done or after an error.
  bool advance();
  double fraction() const;
  /// Returns whether the smallest cell is known and groups are being read.
  bool readsGroups() const;
  /// kPicture, one sentence with the edges that do not meet and the place, or about an image that
  /// is too small.
  const std::optional<Error>& error() const { return error_; }

  // Results, valid once done:

  const SeamlessReading& reading() const { return found_->reading(); }
  /// Half-drop and bricks are compared only if any edges are allowed.
  const TileSeams& seams() const { return seams_; }

 private:
  enum class Stage : std::uint8_t { kEdges, kCell, kTrials, kDone };
  /// Other tiles that the image may represent.
  enum Trial : std::uint8_t { kSharpHexagon, kBluntHexagon, kOneMoreColumn, kOneMoreRow, kTrials };
  void compareEdges();
  void tryNext();
  bool isWorthTrying(int trial) const;
  void begin(int trial);
  void judge(int trial);
  void fail(const Error& error);

  PixelView tile_;
  bool any_edges_;
  Stage stage_ = Stage::kEdges;
  std::optional<Error> error_;
  TileSeams seams_;
  int compared_ = 0;  ///< number of compared edges
  std::unique_ptr<EdgeComparison> comparison_;
  std::unique_ptr<SeamlessReader> found_, other_;
  bool square_pixels_ = true;
  int trial_ = 0;
};

}  // namespace seamwise
