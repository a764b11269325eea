#pragma once
#include "geometry/vec2.h"

namespace seamwise {

/// Constants of pleats whose width becomes a whole repeat of the print (problem/pleats.h). Chosen.
struct PleatTuning {
  /// Greatest change of a pleat's width, as a share of it. Outline edges may change by 15 %.
  static constexpr double kMostGrowth = 0.145;
  /// Greatest angle off the grain of a pleated piece whose grain is free. [rad]
  static constexpr double kMostTurn = 20 * kPi / 180;
  /// Lines that deviate by less from parallel, along their length, are parallel. [cm]
  static constexpr double kParallelCm = 0.02;
  /// Changes of width below this are none. [cm]
  static constexpr double kWholeCm = 1e-6;
  /// Angles closer than this are equal. [rad]
  static constexpr double kSameAngle = 1e-6;
};

}  // namespace seamwise
