#pragma once

namespace seamwise {

/// Constants by which a picture is read that repeats edge to edge. Colours are in [0, 255].
struct TileReadingTuning {
  /// Share of the time that the comparison of edges takes, of 2048 x 2048 pixels.
  static constexpr double kEdgesShare = 0.2;
  /// Pixels that are compared in one step of some milliseconds.
  static constexpr int kPixelsAtOnce = 200000;

  // --- one line of pixels cut away

  /// Gaussians along a line that lines are softened by, and that windows have in which what a line
  /// shows is followed to the next. [px]
  static constexpr double kLineSoftening = 1, kStepWindow = 2;
  /// Mean square change along a line without which nothing can be followed.
  static constexpr double kLeastSlope = 1.3;
  /// Steps aside up to which they can be followed; error of one. [px]
  static constexpr double kMostStep = 3, kStepSpread = 0.05;
  /// Greatest square error of one place, in units of its spread.
  static constexpr double kMostMissed = 9;
  /// How much less the sum of such squares has to be for a cut: by what, seven places' worth; by
  /// how many times the root of both sums; and how many times more than at so many lines within. Of
  /// 1,871 borders of the sample prints, shifted by chance, none is called a cut; of 1,480 that a
  /// line was cut from, those of plaids and stripes left out, 1,286 are: the others lie on mirrors,
  /// where the print goes on, or where nothing crosses them.
  static constexpr double kCutEvidence = 60, kCutSurely = 3.5, kCutBeyond = 1.2;
  /// What is added to both sums where they are compared by their ratio.
  static constexpr double kUsualErrors = 20;
  static constexpr int kLinesWithin = 16;

  // --- more than that

  /// What nobody sees, of all of a line and beyond.
  static constexpr double kLeastLine = 12, kLeastBeyond = 3;
  /// The greatest step at a border, as a share of the greatest within; of what changes beyond, and
  /// of that where its greatest is so many times the usual one: something straight, as of squares,
  /// which may end at a border.
  static constexpr double kGreatestLine = 1.1, kGreatestBeyond = 0.95, kGreatestStraight = 1.1,
                          kStraight = 5;
  /// A share of it that is enough where the step exceeds those beside it by so many times more than
  /// any within. Of the sample prints' 47,000 borders 2 do; of 1,520 where 37 % of a print are left
  /// out, those of bands aside, 1,130 change more than anything within, and 294 are found by this.
  static constexpr double kGreatBeyond = 0.6, kAbrupt = 1.6;

  /// Places along an edge that are marked or not, and a change of colour that everybody sees.
  static constexpr int kPlaces = 48;
  static constexpr double kLeastMark = 14;

  // --- the cell

  /// Places of a picture that are looked at in one step of some milliseconds.
  static constexpr int kPlacesAtOnce = 200000;
  static constexpr int kLeastPixels = 8;
  /// Samples along a cell's side.
  static constexpr int kLeastSamples = 64, kMostSamples = 128;
  /// Cells that a picture may show, and shifts that are tried for one step to a smaller cell.
  static constexpr int kMostCopies = 1000, kMostShifts = 24;
  /// Repeats that a picture of stripes may show.
  static constexpr int kMostStripes = 64;
  /// Share of energy by which the symmetries of a tile miss that a line was cut from, at least, and
  /// what one more line of pixels leaves of it. Of 70 sample prints cut in that way the shares were
  /// 6e-4 and more; of whole ones, sampled anew, up to 2e-4 but for hexagons of whole pixels.
  static constexpr double kLeastMissed = 3e-4, kMended = 0.4;
  /// The same where that line mends them to rounding, as in bands of flat colours. Such pictures
  /// cut by a line miss by 6e-5 to 9e-5, then by less than 1e-13.
  static constexpr double kLeastExact = 2e-5, kExactly = 1e-4;
  /// By how many pixels sides may miss a lattice; and by what share at least.
  static constexpr double kRounding = 0.75, kTolerance = 0.002;
};

}  // namespace seamwise
