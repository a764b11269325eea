#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/rigid_motion.h"
#include "geometry/vec2.h"
#include "wallpaper/group.h"

namespace seamwise {

/// By which turns of the print a piece may be laid, beside its own: what its grain allows.
enum class LayTurns : std::uint8_t { kHalf, kQuarter, kAny };

/// Which pieces have to point the same way along the warp: none, those of one garment, all (up).
enum class Nap : std::uint8_t { kNone, kGarment, kOneWay };

/// A piece to be laid on printed cloth, face up. [cm, radians]
struct NestingPiece {
  std::string name;
  int garment = 0;
  Polyline outline;  ///< the cut line's, counter-clockwise, in the coordinates of the piece's shape
  RigidMotion alignment;  ///< print point w lies under piece point alignment(w)
  LayTurns turns = LayTurns::kHalf;
  Vec2 up = {0, 1};                ///< its grain line, foot to head
  std::vector<Vec2> shifts;        ///< of the print under it that fit as well, beside none
  std::optional<RigidMotion> pin;  ///< where on the cloth it has to lie: p -> R p + shift
};

/// What is laid, and on which cloth: x across from the left edge, y along the warp from the cut.
/// Lengths in cm.
struct NestingProblem {
  WallpaperGroup group;
  std::vector<NestingPiece> pieces = {};
  double width = 0;             ///< between the edges
  double selvedge = 0;          ///< of no use along each edge
  double gap = 0;               ///< between cut lines
  double repeat_tolerance = 0;  ///< the bolt's repeat may be longer or shorter by this share
  Nap nap = Nap::kNone;
  bool whole_repeats = false;  ///< lengths are rounded up to multiples of the repeat along the warp
  bool ignores_print = false;  ///< pieces may lie anywhere, in steps of a fine board
  std::vector<double> phases = {
      0};  ///< of an origin of the print from the left edge; the best is chosen
  std::optional<double> start = {};  ///< of an origin from the cut; needed with flaws and pins
  std::vector<Polyline> flaws = {};  ///< polygons on which nothing may lie
  std::vector<double> widths = {};   ///< others to lay on as well, quickly
  bool also_free = false;            ///< whether to lay without regard to the print, too
  double effort = 1;                 ///< multiplies all budgets
  std::uint64_t seed = 1;
};

inline constexpr std::size_t kMostNestingPieces = 500;

}  // namespace seamwise
