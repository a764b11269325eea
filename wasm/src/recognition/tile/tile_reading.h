#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "base/outcome.h"
#include "recognition/tile/seamless_reading.h"
#include "recognition/tile/tile_edges.h"

namespace seamwise {

/// How a picture meets its copies, repeated straight, in half-drop and as bricks.
struct TileSeams {
  TileEdge across, up;          ///< its left and right edges, and its upper and lower ones
  TileEdge half_drop, brick;    ///< left and right where the next copy lies half a side down, ...
  bool missing_column = false;  ///< only its symmetries show that a line of pixels is missing
  bool missing_row = false;
};

/// Reads a picture that repeats edge to edge as one cell or several of a print, step by step: its
/// edges are compared, it is read, and once more as it would be with other sides or one more line.
/// Pixels are taken to be square, unless the picture is a square whose thirds of a turn show that
/// its sides are those of a hexagonal cell.
class TileReader {
 public:
  /// `tile`'s pixels have to outlive it.
  /// @param any_edges   it repeats edge to edge whether these meet or not: `seams` says whether
  TileReader(const PixelView& tile, bool any_edges) : tile_(tile), any_edges_(any_edges) {}

  /// One step of some milliseconds; false when nothing is left to do, or once it has failed.
  bool advance();
  double fraction() const;
  /// The smallest cell is known, and groups are read.
  bool readsGroups() const;
  /// kPicture, one sentence that says which edges do not meet, and where, or that the picture is
  /// too small.
  const std::optional<Error>& error() const { return error_; }

  // Once done:

  const SeamlessReading& reading() const { return found_->reading(); }
  /// Those of half-drop and bricks where any edges may be.
  const TileSeams& seams() const { return seams_; }

 private:
  enum class Stage : std::uint8_t { kEdges, kCell, kTrials, kDone };
  /// Other tiles that the picture may stand for.
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
  int compared_ = 0;  ///< edges
  std::unique_ptr<EdgeComparison> comparison_;
  std::unique_ptr<SeamlessReader> found_, other_;
  bool square_pixels_ = true;
  int trial_ = 0;
};

}  // namespace seamwise
