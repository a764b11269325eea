#pragma once
#include <array>
#include <cstdint>

#include "geometry/vec2.h"

namespace seamwise {

/// A straight line on a piece along which triangles end.
using Crease = std::array<Vec2, 2>;

/// Kinds of folds. kRoll and kPress are creases, which take up no fabric.
enum class FoldKind : std::uint8_t { kKnife, kBox, kInverted, kTuck, kRoll, kPress };

/// A fold of a panel, in face-up coordinates. A pleat or tuck is closed by laying `line` on `to`;
/// the fabric between the two lines is hidden then. Both lines run in the same direction.
struct Fold {
  using Line = Crease;
  Line line{Vec2::Zero(), Vec2::Zero()};
  Line to{Vec2::Zero(), Vec2::Zero()};  ///< equals `line` for a crease without a second line
  FoldKind kind = FoldKind::kKnife;
  bool operator==(const Fold&) const = default;

  bool takesUp() const { return kind != FoldKind::kRoll && kind != FoldKind::kPress; }
};

}  // namespace seamwise
