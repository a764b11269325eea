#include "symmetry/placement.h"

namespace seamwise {
namespace {

// Rotation about the fixed axes x, then y, then z (Maya's "XYZ") of the input panel. A panel that
// was mirrored on import is first mirrored back.
Eigen::Matrix3d placementTurn(const Panel& panel) {
  const Vec3 c = panel.placement_turn.array().cos(), s = panel.placement_turn.array().sin();
  Eigen::Matrix3d x, y, z;
  x << 1, 0, 0, 0, c.x(), -s.x(), 0, s.x(), c.x();
  y << c.y(), 0, s.y(), 0, 1, 0, -s.y(), 0, c.y();
  z << c.z(), -s.z(), 0, s.z(), c.z(), 0, 0, 0, 1;
  Eigen::Matrix3d turn = z * y * x;
  if (panel.mirrored_from_input) turn.col(0) = -turn.col(0);
  return turn;
}

}  // namespace

Placement::Placement(const Garment& garment) : garment_(garment) {
  for (const Panel& panel : garment.panels) {
    const Panel& first = garment.panels.front();
    known_ = known_ || panel.placement_shift != first.placement_shift ||
             panel.placement_turn != first.placement_turn;
    turns_.push_back(placementTurn(panel));
  }
}

Vec3 Placement::placed(int piece, const Vec2& p) const {
  return turns_[piece] * Vec3(p.x(), p.y(), 0) + garment_.panels[piece].placement_shift;
}

double Placement::disagreement(int from, int to, const RigidMotion& map,
                               const Outline& outline) const {
  if (!known_) return 0;
  double sum = 0;
  for (const Vec2& p : outline.even()) {
    Vec3 mirrored = placed(from, p);
    mirrored.x() = -mirrored.x();
    sum += (placed(to, map(p)) - mirrored).squaredNorm();
  }
  return std::sqrt(sum / Outline::kEven);
}

}  // namespace seamwise
