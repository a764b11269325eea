#include "photo/lattice/picture_faults.h"

#include <algorithm>

namespace seamwise {
namespace {

// Variances are those of flattened channels, in squares of the surrounding light. All limits were
// measured on 124 images of prints and 40 of other things, all drawn.
constexpr double kPlain = 0.0012;      // linen has 0.0008, the faintest print 0.022
constexpr int kContrastLongest = 330;  // longer side of the level that hides threads. [pixels]
constexpr double kBlurred = 0.04;  // share of the variance between 4 and 8 pixels; prints have 0.07
constexpr double kMoire = 0.45;    // correlation at 3 to 6 pixels; white noise has 0.1
constexpr double kLocal = 0.75;    // fabric that repeats in places; random bricks have 0.67
constexpr double kAgrees = 0.75, kDisagrees = 0.25;  // explained share of a cell's own variance
constexpr double kManyCells = 0.15;                  // share of all cells
constexpr double kExplained = 0.6;                   // below it, a print's copies differ too much
constexpr double kNeighboursDiffer = 0.15;  // share of their variance if only far copies differ

/// Returns an error of the image.
/// @param reason   one of the reasons listed in web/src/model/print/photo-reading.ts
Error fault(const char* reason, const char* sentence) {
  return {Failure::kPicture, sentence, -1, -1, reason};
}

double varianceOf(const ChannelImage& image) {
  double sum = 0;
  for (const float value : image.samples) sum += value * value;
  return sum / (static_cast<double>(image.width) * image.height);
}

/// Returns the greatest correlation of the slope of lightness with itself some pixels away, along
/// rows or columns.
double finePeriod(const ChannelImage& image) {
  constexpr int kFirst = 3, kLast = 6;
  double greatest = 0;
  for (const int stride : {1, image.width}) {
    const int end = image.width * image.height - (kLast + 1) * stride;
    const auto slope = [&](int i) {
      return image.samples[4 * (i + stride)] - image.samples[4 * i];
    };
    double power = 0;
    std::array<double, kLast + 1> products{};
    for (int i = 0; i < end; ++i) {
      const float here = slope(i);
      power += here * here;
      for (int k = kFirst; k <= kLast; ++k) products[k] += here * slope(i + k * stride);
    }
    if (power > 0)
      greatest = std::max(greatest, *std::max_element(products.begin(), products.end()) / power);
  }
  return greatest;
}

Error noRepeat() {
  return fault(
      "noRepeat",
      "no repeat was found: step back until three repeats are seen each way, and photograph the "
      "fabric flat and from above");
}

}  // namespace

Error whyNoRepeat(const std::vector<ChannelImage>& levels, double local) {
  std::size_t coarse = 0;
  while (coarse + 1 < levels.size() &&
         std::max(levels[coarse].width, levels[coarse].height) > kContrastLongest)
    ++coarse;
  const double variance = varianceOf(levels[coarse]);
  if (finePeriod(levels[0]) > kMoire) {
    return fault(
        "moire",
        "the weave makes a strong moire on the picture: photograph the fabric from a little closer "
        "or farther away");
  }
  if (variance < kPlain) {
    return fault("plain",
                 "no print was found, the fabric looks plain: photograph it in brighter light from "
                 "one side, "
                 "or choose a plain colour instead");
  }
  if (coarse + 1 < levels.size() &&
      variance - varianceOf(levels[coarse + 1]) < kBlurred * variance) {
    return fault(
        "blurred",
        "no repeat was found, the picture is blurred: hold the camera still and let it focus on "
        "the fabric");
  }
  if (local > kLocal) {
    return fault(
        "uneven",
        "the print repeats in the middle of the picture only, the fabric does not lie flat: smooth "
        "it out and photograph it again");
  }
  return noRepeat();
}

Error twoPrints() {
  return fault(
      "twoPrints",
      "a part of the picture shows another print or none: cut the picture to the part with the "
      "print that is wanted");
}

std::optional<Error> whyRefused(const Agreement& agreement, const CopyDifferences& differences,
                                double seen) {
  double agreeing = 0, disagreeing = 0, all = 0;
  for (std::size_t c = 0; c < agreement.of_cells.size(); ++c) {
    const double share = agreement.cell_share[c];
    all += share;
    if (agreement.of_cells[c] > kAgrees) agreeing += share;
    if (agreement.of_cells[c] < kDisagrees) disagreeing += share;
  }
  if (agreeing > kManyCells * all && disagreeing > kManyCells * all) {
    return twoPrints();
  }
  if (seen < kLeastRepeats) {
    if (agreement.explained < kExplained) return noRepeat();
    return fault("fewRepeats",
                 "fewer than 2.2 repeats are seen: step back until three repeats are seen");
  }
  const auto* right = differences.at(1, 0);
  const auto* below = differences.at(0, 1);
  if (agreement.explained < kExplained && right != nullptr && below != nullptr &&
      std::max(right->mean, below->mean) < kNeighboursDiffer * 2 * agreement.variance) {
    return fault(
        "changes",
        "the print changes along the fabric: photograph a part in which all repeats are alike");
  }
  return std::nullopt;
}

}  // namespace seamwise
