#pragma once

namespace seamwise {

/// Constants for reading an image that repeats edge to edge. Colours are in [0, 255].
struct TileReadingTuning {
  /// Share of the time for the comparison of edges, at 2048 x 2048 pixels.
  static constexpr double kEdgesShare = 0.2;
  /// Pixels compared in one step of some milliseconds.
  static constexpr int kPixelsAtOnce = 200000;

  // --- one missing line of pixels at a border

  /// Widths of Gaussians along a line: for softening lines, and for the window in which the shift
  /// of a line's content to the next line is measured. [px]
  static constexpr double kLineSoftening = 1, kStepWindow = 2;
  /// Least mean square change along a line at which a shift is measurable.
  static constexpr double kLeastSlope = 1.3;
  /// Greatest measurable shift between two lines, and its error. [px]
  static constexpr double kMostStep = 3, kStepSpread = 0.05;
  /// Greatest square error of one position, in units of its spread.
  static constexpr double kMostMissed = 9;
  /// Least advantage of a cut over an uncut border in the sum of these squares: absolute, seven
  /// positions' worth; in roots of both sums; and as a multiple of the ratio at kLinesWithin inner
  /// lines. None of 1,871 borders of randomly shifted sample prints is classified as a cut. Of
  /// 1,480 borders with a cut line, apart from plaids and stripes, 1,286 are: at the others there
  /// is a mirror, the print continues, or nothing crosses the border.
  static constexpr double kCutEvidence = 60, kCutSurely = 3.5, kCutBeyond = 1.2;
  /// Offset of both sums in their ratio.
  static constexpr double kUsualErrors = 20;
  static constexpr int kLinesWithin = 16;

  // --- several missing lines

  /// Greatest invisible change of a line: of its mean, and of pixels apart from the mean.
  static constexpr double kLeastLine = 12, kLeastBeyond = 3;
  /// Greatest change at an intact border, as a share of the greatest inner change: of a line's
  /// mean; of pixels apart from the mean; and of the latter if the greatest inner change is more
  /// than kStraight times the usual one. In this case the print has straight edges, such as
  /// squares, which may end at a border.
  static constexpr double kGreatestLine = 1.1, kGreatestBeyond = 0.95, kGreatestStraight = 1.1,
                          kStraight = 5;
  /// Smaller share that suffices if the change exceeds those beside it by more than kAbrupt times
  /// the greatest such excess inside. It applies to 2 of the sample prints' 47,000 borders. Of
  /// 1,520 borders at which 37 % of a print are missing, apart from bands, 1,130 change more than
  /// any inner line, and this criterion finds 294.
  static constexpr double kGreatBeyond = 0.6, kAbrupt = 1.6;

  /// Number of positions along an edge that may be marked, and a clearly visible change of colour.
  static constexpr int kPlaces = 48;
  static constexpr double kLeastMark = 14;

  // --- the cell

  /// Positions of an image visited in one step of some milliseconds.
  static constexpr int kPlacesAtOnce = 200000;
  static constexpr int kLeastPixels = 8;
  /// Samples along a cell's side.
  static constexpr int kLeastSamples = 64, kMostSamples = 128;
  /// Greatest number of cells in an image, and of shifts tried for one step to a smaller cell.
  static constexpr int kMostCopies = 1000, kMostShifts = 24;
  /// Greatest number of repeats in an image of stripes.
  static constexpr int kMostStripes = 64;
  /// Least share of energy by which the symmetries of a tile with a cut line fail, and the factor
  /// of this share after one more line of pixels. Of 70 sample prints cut in this way the shares
  /// were 6e-4 and more; of resampled whole ones up to 2e-4, except for hexagons of whole pixels.
  static constexpr double kLeastMissed = 3e-4, kMended = 0.4;
  /// The same if that line restores the symmetries up to rounding, as in bands of flat colours. The
  /// shares of such images are 6e-5 to 9e-5 with a cut line, then less than 1e-13.
  static constexpr double kLeastExact = 2e-5, kExactly = 1e-4;
  /// Greatest deviation of sides from a lattice in pixels, and least tolerance as a share.
  static constexpr double kRounding = 0.75, kTolerance = 0.002;
};

}  // namespace seamwise
