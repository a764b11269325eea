#include "drape/fitting_form.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "drape/wrap.h"

namespace seamwise {
namespace {

constexpr double kEaseCm = 1;  ///< of a girth, at least
constexpr double kTightEnough =
    12;                           ///< cm of girth over all levels, 1 cm apart, that may be missing
constexpr double kOverWaist = 2;  ///< cm: where the top edge of skirts and trousers lies
constexpr double kFarthestLift = 40;  ///< cm
constexpr int kSteps = 4;             ///< between neighbouring sizes

/// A body between two sizes, or smaller than the smallest by the same steps. 0 is XS, 4 XL.
Measures measuresAt(double size) {
  const int last = static_cast<int>(kSizes.size()) - 2;
  const int below = std::clamp(static_cast<int>(std::floor(size)), 0, last);
  const double share = size - below;
  const Measures &a = kSizes[below].measures, &b = kSizes[below + 1].measures;
  Measures between = a;
  for (const MeasureName& name : kMeasureNames)
    between.*name.value = (1 - share) * a.*name.value + share * b.*name.value;
  return between;
}

/// The height of the form's shoulders at so far from the middle. [cm]
double shoulderHeight(const Form& form, double side) {
  const Vec3 tip = form.shoulderPoint();
  double low = tip.y() - 20, high = form.napeHeight() + 10;
  for (int step = 0; step < 20; ++step) {
    const double middle = (low + high) / 2;
    const bool inside = form.distance({side, middle, tip.z()}, only(BodyPart::kTorso), nullptr) < 0;
    (inside ? low : high) = middle;
  }
  return low;
}

/// By how much what lies on the shoulders lies too low, in the mean; none where nothing does. [cm]
std::optional<double> missingAtShoulders(const Pattern& pattern, const Hanging& hanging,
                                         const Form& form) {
  const double neck = form.measures().neck / (2 * kPi) + 2, tip = form.shoulderPoint().x() - 3;
  constexpr int kPlaces = 5;
  double sum = 0;
  int count = 0;
  for (int k = 0; k < kPlaces; ++k) {
    const double side = neck + (tip - neck) * k / (kPlaces - 1);
    double top = -1e9;
    for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
      if (hanging.parts[p] != BodyPart::kTorso) continue;
      const std::vector<int>& outline = pattern.pieces[p].outline;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto at = [&](std::size_t corner) {
          return hanging.placed[p](pattern.pieces[p].rest[outline[corner % outline.size()]]);
        };
        const Vec3 a = at(i), b = at(i + 1);
        if ((a.x() < side) == (b.x() < side)) continue;
        top = std::max(top, a.y() + (side - a.x()) / (b.x() - a.x()) * (b.y() - a.y()));
      }
    }
    const double missing = shoulderHeight(form, side) - top;
    if (std::abs(missing) > 0.4 * form.measures().back_length) continue;
    sum += missing, ++count;
  }
  if (count < 3) return std::nullopt;
  return sum / count;
}

/// The top edge of what hangs on torso and legs. [cm]
double topOf(const Pattern& pattern, const Hanging& hanging) {
  double top = -1e9;
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
    for (int v : pattern.pieces[p].outline)
      top = std::max(top, hanging.placed[p](pattern.pieces[p].rest[v]).y());
  return top;
}

}  // namespace

Outcome<FittingForm> fittingForm(const Garment& garment, const Pattern& pattern) {
  FittingForm best{measuresAt(2), 0};
  double least = 1e9;
  for (int step = 2 * kSteps; step >= -2 * kSteps; --step) {
    const Measures measures = measuresAt(static_cast<double>(step) / kSteps);
    const Outcome<Form> form = Form::make(measures);
    if (!form.ok()) continue;
    const Outcome<Hanging> hanging = hang(garment, pattern, form.value());
    if (!hanging.ok()) return hanging.error();
    const std::optional<double> missing =
        missingAtShoulders(pattern, hanging.value(), form.value());
    const double lift =
        missing.value_or(measures.waist_height + kOverWaist - topOf(pattern, hanging.value()));
    if (std::abs(lift) > kFarthestLift) continue;
    Garment lifted = garment;
    for (Panel& panel : lifted.panels) panel.placement_shift.y() += lift;
    const double tightness = missingGirth(lifted, pattern, form.value(), kEaseCm);
    if (tightness >= least) continue;
    least = tightness, best = {measures, lift};
    if (tightness < kTightEnough) break;
  }
  return best;
}

}  // namespace seamwise
