#pragma once

namespace seamwise {

/// Constants by which a picture is read that repeats edge to edge. Colours are in [0, 255].
struct TileReadingTuning {
  // --- one line of pixels cut away

  /// Gaussians along a line that lines are softened by, and that windows have in which what a line
  /// shows is followed to the next. [px]
  static constexpr double kLineSoftening = 1, kStepWindow = 2;
  /// Mean square change along a line without which nothing can be followed.
  static constexpr double kLeastSlope = 4;
  /// Steps aside up to which they can be followed; error of one. [px]
  static constexpr double kMostStep = 3, kStepSpread = 0.05;
  /// Greatest square error of one place, in units of its spread.
  static constexpr double kMostMissed = 9;
  /// By how much the sum of such squares has to be less for a cut.
  static constexpr double kCutEvidence = 10;

  // --- more than that

  /// What nobody sees, of all of a line and beyond.
  static constexpr double kLeastLine = 12, kLeastBeyond = 3;
  /// The greatest step at a border, as a share of the greatest within. Flowers and leaves change
  /// steadily, and are cut by a border that changes half as much again; squares and bands may well
  /// begin and end at it.
  static constexpr double kSteady = 0.6, kSharp = 1.1;
  /// Beyond so many times the usual step, the greatest one is that of something straight.
  static constexpr double kStraight = 5;

  // --- the cell

  static constexpr int kLeastPixels = 8;
  /// Samples along a cell's side.
  static constexpr int kLeastSamples = 64, kMostSamples = 128;
  /// Cells that a picture may show, and shifts that are tried for one step to a smaller cell.
  static constexpr int kMostCopies = 1000, kMostShifts = 24;
  /// By how many pixels sides may miss a lattice; and by what share at least.
  static constexpr double kRounding = 0.75, kTolerance = 0.002;
};

}  // namespace seamwise
