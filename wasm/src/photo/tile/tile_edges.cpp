#include "photo/tile/tile_edges.h"

#include <algorithm>
#include <cmath>

#include "base/sort_by.h"
#include "tuning/tile_reading.h"

namespace seamwise {
namespace {

using EdgeTuning = TileReadingTuning;

/// Columns or rows of pixels: red, green and blue in turn on white. [0, 255]
class PixelLines {
 public:
  PixelLines(const PixelView& view, TileSides sides, NextCopy next)
      : view_(view), columns_(sides == TileSides::kLeftAndRight) {
    if (next == NextCopy::kHalfAside) aside_ = (length() + 1) / 2;
  }
  int count() const { return columns_ ? view_.width : view_.height; }
  int length() const { return columns_ ? view_.height : view_.width; }
  /// Returns a line of the image, or of the copy before or after it.
  std::vector<float> at(int line) const {
    std::vector<float> values(3 * static_cast<std::size_t>(length()));
    const int within = (line + count()) % count();
    const int aside = line >= count() ? aside_ : line < 0 ? length() - aside_ : 0;
    for (int k = 0; k < length(); ++k) {
      const int place = (k + aside) % length();
      const std::size_t pixel = columns_ ? static_cast<std::size_t>(place) * view_.width + within
                                         : static_cast<std::size_t>(within) * view_.width + place;
      const std::uint8_t* const from = view_.rgba.data() + 4 * pixel;
      const float opaque = from[3] / 255.0f;
      for (int c = 0; c < 3; ++c) values[3 * k + c] = opaque * from[c] + 255 * (1 - opaque);
    }
    return values;
  }
  /// Returns only the luma of JPEG (Rec. 601), because files with half the resolution for colours
  /// displace colours at the image's border.
  std::vector<float> lumaAt(int line) const {
    const std::vector<float> colours = at(line);
    std::vector<float> luma(length());
    for (int k = 0; k < length(); ++k) {
      luma[k] = 0.299f * colours[3 * k] + 0.587f * colours[3 * k + 1] + 0.114f * colours[3 * k + 2];
    }
    return luma;
  }

 private:
  const PixelView& view_;
  bool columns_;
  int aside_ = 0;  ///< start of the next copy, along a line
};

/// Returns the values along a closed line, softened by a Gaussian.
std::vector<float> softenedLine(const std::vector<float>& values, double width) {
  const int n = static_cast<int>(values.size());
  const int reach = static_cast<int>(std::ceil(3 * width));
  std::vector<float> kernel(2 * reach + 1), out(values.size(), 0.0f);
  float sum = 0;
  for (int k = -reach; k <= reach; ++k) {
    sum += kernel[k + reach] = std::exp(static_cast<float>(-k * k / (2 * width * width)));
  }
  for (int i = 0; i < n; ++i) {
    for (int k = -reach; k <= reach; ++k) {
      out[i] += kernel[k + reach] / sum * values[(((i + k) % n) + n) % n];
    }
  }
  return out;
}

/// Displacement aside of a line's content on the next line, in pixels at each of its pixels, and
/// its certainty: the sum of squares of the change along the line [255^2].
struct StepAside {
  std::vector<float> by, weight;
};

StepAside stepAside(const std::vector<float>& from, const std::vector<float>& to) {
  const int n = static_cast<int>(from.size());
  std::vector<float> product(n), square(n);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n, last = (i + n - 1) % n;
    const float slope = (from[next] - from[last] + to[next] - to[last]) / 4;
    product[i] = (to[i] - from[i]) * slope;
    square[i] = slope * slope;
  }
  StepAside step{softenedLine(product, EdgeTuning::kStepWindow),
                 softenedLine(square, EdgeTuning::kStepWindow)};
  for (int i = 0; i < n; ++i) step.by[i] = -step.by[i] / (step.weight[i] + 1);
  return step;
}

/// Errors of the displacement between two lines, relative to that on both sides of the two: square
/// errors for the same displacement, and for twice that, as left by a line cut away between the
/// two.
struct StepErrors {
  double whole = 0, cut = 0;
  double most_at = 0;  ///< greatest excess of the first over the second, as a share of the line

  double ratio() const {
    return (whole + EdgeTuning::kUsualErrors) / (cut + EdgeTuning::kUsualErrors);
  }
  bool speakForCut() const {
    const double evidence = whole - cut;
    return evidence > EdgeTuning::kCutEvidence &&
           evidence > EdgeTuning::kCutSurely * std::sqrt(whole + cut);
  }
};

/// Returns the errors between line `at` and the next one, across the border if necessary.
StepErrors stepErrors(const PixelLines& lines, int at) {
  const int n = lines.length();
  const auto line = [&](int k) {
    return softenedLine(lines.lumaAt(k), EdgeTuning::kLineSoftening);
  };
  const std::vector<float> before = line(at - 1), last = line(at), first = line(at + 1),
                           after = line(at + 2);
  const StepAside in = stepAside(before, last), across = stepAside(last, first),
                  out = stepAside(first, after);
  StepErrors errors;
  double most = 0;
  for (int i = 0; i < n; ++i) {
    if (std::min({in.weight[i], across.weight[i], out.weight[i]}) < EdgeTuning::kLeastSlope)
      continue;
    const double step = (in.by[i] + out.by[i]) / 2;
    if (std::abs(step) > EdgeTuning::kMostStep) continue;
    const double spread = EdgeTuning::kStepSpread + std::abs(in.by[i] - out.by[i]);
    const auto missed = [&](double by) {
      const double ratio = (across.by[i] - by) / spread;
      return std::min(EdgeTuning::kMostMissed, ratio * ratio);
    };
    const double one = missed(step), other = missed(2 * step);
    errors.whole += one;
    errors.cut += other;
    if (one - other > most) {
      most = one - other;
      errors.most_at = (i + 0.5) / n;
    }
  }
  return errors;
}

/// Change from one line to another: of the whole line, as at the side of a stripe, and the mean
/// change of single pixels beyond that. [0, 255]
struct LineStep {
  double whole = 0, beyond = 0;
  int most_at = 0;
};

LineStep lineStep(const std::vector<float>& from, const std::vector<float>& to) {
  const int n = static_cast<int>(from.size()) / 3;
  std::array<double, 3> mean{};
  for (int k = 0; k < 3 * n; ++k) mean[k % 3] += (to[k] - from[k]) / n;
  LineStep step;
  double most = -1;
  for (int i = 0; i < n; ++i) {
    double square = 0;
    for (int c = 0; c < 3; ++c) {
      const double d = to[3 * i + c] - from[3 * i + c] - mean[c];
      square += d * d;
    }
    step.beyond += std::sqrt(square / 3) / n;
    if (square > most) {
      most = square;
      step.most_at = i;
    }
  }
  step.whole = std::sqrt((mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2]) / 3);
  return step;
}

/// Changes from line to line beyond those of whole lines. [0, 255]
struct InnerSteps {
  double usual = 0, greatest = 0;  ///< over two lines, because a sharp edge may be between two
  double greatest_whole = 0;       ///< change of a whole line, over two lines
  /// Greatest excess of one step over both its neighbours.
  double greatest_excess = 0;
};

/// @param one, two   changes beyond those of whole lines, over one line and over two, in order
InnerSteps innerSteps(const std::vector<double>& one, std::vector<double>& two,
                      double greatest_whole) {
  InnerSteps steps;
  steps.greatest_whole = greatest_whole;
  for (std::size_t k = 1; k + 1 < one.size(); ++k) {
    steps.greatest_excess =
        std::max(steps.greatest_excess, one[k] - std::max(one[k - 1], one[k + 1]));
  }
  sortNumbers(two);
  steps.usual = two[two.size() / 2];
  steps.greatest = two.back();
  return steps;
}

/// Returns whether colours change more across the border than anywhere inside, or almost as much
/// and more abruptly.
bool breaksOff(const PixelLines& lines, const InnerSteps& inner, TileEdge& edge) {
  const int count = lines.count();
  const std::vector<float> last = lines.at(count - 1), first = lines.at(count);
  const LineStep border = lineStep(last, first);
  edge.differs_at = (border.most_at + 0.5) / lines.length();
  if (border.whole > EdgeTuning::kLeastLine + EdgeTuning::kGreatestLine * inner.greatest_whole)
    return true;
  const bool straight = inner.greatest > EdgeTuning::kStraight * inner.usual;
  const double share = straight ? EdgeTuning::kGreatestStraight : EdgeTuning::kGreatestBeyond;
  if (border.beyond > EdgeTuning::kLeastBeyond + share * inner.greatest) return true;
  const double beside = std::max(lineStep(lines.at(count - 2), last).beyond,
                                 lineStep(first, lines.at(count + 1)).beyond);
  return border.beyond > EdgeTuning::kLeastBeyond + EdgeTuning::kGreatBeyond * inner.greatest &&
         border.beyond - beside >
             EdgeTuning::kLeastBeyond + EdgeTuning::kAbrupt * inner.greatest_excess;
}

/// Returns the places of the last line at which colours change most across the border; neighbouring
/// places are merged.
std::vector<std::array<double, 2>> openStretches(const PixelLines& lines) {
  const int n = lines.length(), places = std::min(EdgeTuning::kPlaces, n);
  const std::vector<float> last = lines.at(lines.count() - 1), first = lines.at(lines.count());
  std::vector<double> changes(places, 0.0);
  for (int i = 0; i < n; ++i) {
    double square = 0;
    for (int c = 0; c < 3; ++c) {
      const double d = first[3 * i + c] - last[3 * i + c];
      square += d * d / 3;
    }
    double& change = changes[static_cast<std::int64_t>(i) * places / n];
    change = std::max(change, std::sqrt(square));
  }
  const double most = *std::max_element(changes.begin(), changes.end());
  const double least = std::min(EdgeTuning::kLeastMark, most / 2);
  std::vector<std::array<double, 2>> stretches;
  bool is_open = false;
  for (int k = 0; k < places; ++k) {
    const bool was_open = is_open;
    is_open = changes[k] > least;
    if (!is_open) continue;
    if (!was_open) stretches.push_back({static_cast<double>(k) / places, 0});
    stretches.back()[1] = (k + 1.0) / places;
  }
  return stretches;
}

}  // namespace

bool EdgeComparison::advance() {
  switch (stage_) {
    case Stage::kWithin:
      lookWithin();
      break;
    case Stage::kBorder:
      lookAtBorder();
      break;
    case Stage::kCut:
      compareCut();
      break;
    case Stage::kDone:
      break;
  }
  return stage_ != Stage::kDone;
}

double EdgeComparison::fraction() const {
  const int count = PixelLines(tile_, sides_, next_).count();
  return stage_ == Stage::kWithin ? static_cast<double>(line_) / count : 1;
}

void EdgeComparison::lookWithin() {
  const PixelLines lines(tile_, sides_, next_);
  const int count = lines.count();
  if (count < 4) {
    stage_ = Stage::kDone;
    return;
  }
  const int end = std::min(count - 1, line_ + 1 + EdgeTuning::kPixelsAtOnce / lines.length());
  std::vector<float> from = lines.at(line_), to = lines.at(line_ + 1);
  for (; line_ < end; ++line_) {
    one_.push_back(lineStep(from, to).beyond);
    if (line_ + 2 == count) continue;
    std::vector<float> after = lines.at(line_ + 2);
    const LineStep step = lineStep(from, after);
    two_.push_back(step.beyond);
    greatest_whole_ = std::max(greatest_whole_, step.whole);
    from = std::move(to);
    to = std::move(after);
  }
  if (end == count - 1) stage_ = Stage::kBorder;
}

void EdgeComparison::lookAtBorder() {
  const PixelLines lines(tile_, sides_, next_);
  if (breaksOff(lines, innerSteps(one_, two_, greatest_whole_), edge_)) return foundOpen();
  const StepErrors border = stepErrors(lines, lines.count() - 1);
  edge_.differs_at = border.most_at;
  border_ratio_ = border.ratio();
  line_ = 0;
  stage_ = border.speakForCut() ? Stage::kCut : Stage::kDone;
}

/// Compares one more inner line. Nothing is cut away at the border if motifs step aside at that
/// line as they do there.
void EdgeComparison::compareCut() {
  const PixelLines lines(tile_, sides_, next_);
  const int parts = EdgeTuning::kLinesWithin + 1;
  const StepErrors within = stepErrors(lines, ++line_ * lines.count() / parts);
  if (border_ratio_ < EdgeTuning::kCutBeyond * within.ratio()) {
    stage_ = Stage::kDone;
  } else if (line_ == EdgeTuning::kLinesWithin) {
    foundOpen();
  }
}

void EdgeComparison::foundOpen() {
  edge_.meets = false;
  edge_.open = openStretches(PixelLines(tile_, sides_, next_));
  stage_ = Stage::kDone;
}

}  // namespace seamwise
