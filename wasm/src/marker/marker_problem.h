#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/rigid_motion.h"
#include "geometry/vec2.h"
#include "wallpaper/group.h"

namespace seamwise {

/// The rotations of a piece on the print that its grain allows, besides the identity.
enum class LayTurns : std::uint8_t { kHalf, kQuarter, kAny };

/// The pieces that must point the same way along the warp: none, those of one garment, all (up).
enum class Nap : std::uint8_t { kNone, kGarment, kOneWay };

/// A piece to place on printed fabric, face up. [cm, radians]
struct MarkerPiece {
  std::string name;
  int garment = 0;
  Polyline outline;       ///< cut line, counter-clockwise, in the coordinates of the piece's shape
  RigidMotion alignment;  ///< print point w is under piece point alignment(w)
  LayTurns turns = LayTurns::kHalf;
  Vec2 up = {0, 1};                ///< its grain line, foot to head
  std::vector<Vec2> shifts;        ///< equally good shifts of the print under it, besides zero
  std::optional<RigidMotion> pin;  ///< required position on the fabric: p -> R p + shift
};

/// Pieces and fabric of a layout: x is across from the left edge, y along the warp from the cut.
/// Lengths are in cm.
struct MarkerProblem {
  WallpaperGroup group;
  std::vector<MarkerPiece> pieces = {};
  double width = 0;             ///< width between the edges
  double selvedge = 0;          ///< width of the unusable strip along each edge
  double gap = 0;               ///< distance between cut lines
  double repeat_tolerance = 0;  ///< the bolt's repeat may be longer or shorter by this share
  Nap nap = Nap::kNone;
  bool whole_repeats = false;  ///< lengths are rounded up to multiples of the repeat along the warp
  bool ignores_print = false;  ///< any position is allowed, in steps of a fine board
  std::vector<double> phases = {
      0};  ///< distances of a print origin from the left edge; the best is chosen
  std::optional<double> start = {};  ///< distance of a print origin from the cut; needed with flaws
                                     ///< and pins
  std::vector<Polyline> flaws = {};  ///< polygons that pieces must not cover
  std::vector<double> widths = {};   ///< other fabric widths for quick additional layouts
  bool also_free = false;            ///< adds a layout without the print
  double effort = 1;                 ///< multiplies all budgets
  std::uint64_t seed = 1;
};

inline constexpr std::size_t kMostMarkerPieces = 500;

}  // namespace seamwise
