#include "drape/fitting_form.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "drape/hung_garment.h"

namespace seamwise {
namespace {

// Ease of girths, because cloth is at a small distance from the form. [cm]
constexpr double kEaseCm = 2, kEaseOfHeld = 1, kEaseOfLimbs = 1.5, kEaseAtCrotch = 8;
// Height of the waist over the floor in files that place pieces on a body: GarmentCode's and, after
// the lift onto the floor, Garment-Pattern-Generator's. [cm]
constexpr double kWaistOfFiles = 108.8;
// Minimum girths as a share of size M. [1]
constexpr double kThinnest = 0.6;
// Height of waist edges over the waist, and depth of crotch seams below the body's crotch. [cm]
constexpr double kOverWaist = 2, kUnderCrotch = 3;
// Cloth from the shoulders to the crotch is this much longer than the difference in height. [cm]
constexpr double kAroundTorso = 5;

// The girth around both legs at the crotch is kAroundLegs times the thigh girth plus kApart. It
// counts below the share kOfLegs of the hip depth. form_shape.cpp defines the distance between the
// legs. [1, cm, 1]
constexpr double kAroundLegs = 1.61, kApart = 3.2, kOfLegs = 0.6;
constexpr double kLeastRise = 18;    ///< cm, minimum body rise
constexpr double kBesideNeck = 4;    ///< cm, distance of a neckline from the neck
constexpr double kTightEnough = 12;  ///< cm, missing girth over all levels that ends the search
constexpr double kOfRise = 6;        ///< weight of 1 cm of missing body rise in that sum
constexpr int kSteps = 4;            ///< steps between neighbouring sizes
constexpr int kRounds = 8;

/// Interpolates between two sizes, or extrapolates by the same steps. 0 is XS, 4 is XL.
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

/// Finds the size with a given measurement by bisection, from two sizes below XS to XL.
double sizeWith(double Measures::*measure, double cm) {
  double low = -2, high = 4;
  for (int step = 0; step < 20; ++step) {
    const double middle = (low + high) / 2;
    (measuresAt(middle).*measure < cm ? low : high) = middle;
  }
  return low;
}

/// Returns the height of the form's shoulders at a distance `side` from its middle plane. [cm]
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

/// Search for a body that fits a garment.
class Fitting {
 public:
  explicit Fitting(const HungGarment& garment) : garment_(garment) {}

  FittingForm run() const {
    FittingForm best{measuresAt(2), 0};
    double least = 1e9;
    for (int step = 2 * kSteps; step >= -2 * kSteps && least >= kTightEnough; --step)
      if (const std::optional<Candidate> found = fitted(static_cast<double>(step) / kSteps);
          found && found->tightness < least)
        least = found->tightness, best = found->body;
    return best;
  }

 private:
  struct Candidate {
    FittingForm body;
    double tightness;  ///< cm, girth that rings lacked before the body's girths were reduced
  };

  /// Returns the mean depth of the garment's shoulders below those of the form; empty if the
  /// garment has none. [cm]
  std::optional<double> missingAtShoulders(const Form& form) const {
    if (!garment_.hasShoulders()) return std::nullopt;
    const double neck = form.measures().neck / (2 * kPi) + 2, tip = form.shoulderPoint().x() - 3;
    constexpr int kPlaces = 7;
    double sum = 0;
    int count = 0;
    for (int k = 0; k < kPlaces; ++k) {
      const double side = neck + (tip - neck) * k / (kPlaces - 1);
      for (const double x : {side, -side}) {
        const std::optional<double> top = garment_.topOver(x, false);
        if (!top) continue;
        const double missing = shoulderHeight(form, side) - *top;
        if (std::abs(missing) > 0.5 * form.measures().back_length) continue;
        sum += missing, ++count;
      }
    }
    if (count < 2) return std::nullopt;
    return sum / count;
  }

  /// Returns the width of the body's shoulders. It follows the garment, but a garment with flatter
  /// shoulders than a body's gets wider and flatter ones. Otherwise it would hang on the sides of
  /// the neck. [cm]
  double shoulderWidth(const Measures& m) const {
    constexpr double kRise = 0.125;  // rise from tip to neck, share of the back length
    constexpr double kWider = 9;     // cm
    constexpr double kUsualSlope = 0.33;
    const double own = std::min(2 * garment_.shoulder() + 1, m.shoulder_width);
    // A sleeveless garment would slip off wider shoulders.
    if (!garment_.hasSleeves() || garment_.hasCollar() || garment_.shoulder() < garment_.neck() + 3)
      return own;
    const double fall = garment_.topOver(garment_.neck(), true).value_or(0) -
                        garment_.topOver(garment_.shoulder(), true).value_or(0);
    const double slope = std::max(0.1, fall / (garment_.shoulder() - garment_.neck()));
    if (slope > kUsualSlope) return own;
    const double tip = m.neck / (2 * kPi) + 1 + kRise * m.back_length / slope;
    return std::clamp(2 * tip, own, own + kWider);
  }

  /// Returns the widest ring above the waist of a garment without shoulders, or the bust of `m`.
  /// [cm]
  double girthAtBust(double lift, const Measures& m) const {
    double most = 0;
    for (const WornGirth& ring : garment_.girths(BodyPart::kTorso))
      if (ring.height + lift > m.waist_height + 0.25 * m.back_length)
        most = std::max(most, ring.girth);
    return most > 0 ? most : m.bust;
  }

  /// Reduces the body of a size until the garment has ease on it; returns nothing if the
  /// measurements no longer make a body.
  std::optional<Candidate> fitted(double size) const {
    Measures m = measuresAt(size);
    const Outcome<Form> usual = Form::make(m);
    if (!usual.ok()) return std::nullopt;
    const std::optional<double> missing = missingAtShoulders(usual.value());
    double lift = missing.value_or(m.waist_height - kWaistOfFiles);
    if (const double top = garment_.top() + lift - m.waist_height;
        !missing && (top < -15 || top > 90))
      lift = m.waist_height + kOverWaist - garment_.top();
    const bool at_bust = !missing && garment_.top() + lift - m.waist_height > 0.3 * m.back_length;
    if (!missing) {
      double girths = 2;
      if (at_bust)
        girths = sizeWith(&Measures::bust, girthAtBust(lift, m));
      else if (garment_.topGirth() > 40 && garment_.topGirth() < 150)
        girths = sizeWith(&Measures::waist, garment_.topGirth() - kEaseOfHeld);
      const Measures wide = measuresAt(girths);
      for (double Measures::*girth :
           {&Measures::bust, &Measures::waist, &Measures::hip, &Measures::upper_arm,
            &Measures::wrist, &Measures::thigh, &Measures::knee, &Measures::ankle})
        m.*girth = wide.*girth;
    } else if (garment_.girths(BodyPart::kTorso).empty()) {
      // No ring closes around the torso, so the shoulder width limits the size.
      m = measuresAt(
          std::min(size, sizeWith(&Measures::shoulder_width, 2 * garment_.shoulder() + 1)));
    }
    double tightness = 0;
    if (missing) {
      m.shoulder_width =
          std::clamp(shoulderWidth(m), 0.75 * m.shoulder_width, 1.15 * m.shoulder_width);
      // A neckline runs around the neck's base or straight over it from shoulder to shoulder. Only
      // a collar closes around the neck.
      if (!garment_.hasCollar())
        m.neck = std::clamp(2 * kPi * (garment_.neck() - kBesideNeck), 0.7 * m.neck, m.neck);
      m.neck = std::min(m.neck, kPi * (m.shoulder_width - 7));
    }
    if (missing) {
      tightness = tightnessOn(m, lift);
      if (garment_.hasLegs())
        tightness += kOfRise * std::max(0.0, garment_.crotch() + lift + m.body_rise + kUnderCrotch -
                                                 m.waist_height);
    } else if (garment_.hasLegs()) {
      // Low-rise trousers hang up to 8 cm lower; the remaining excess height shortens the body
      // rise.
      const double low = m.waist_height - m.body_rise - kUnderCrotch - garment_.crotch();
      if (lift > low) lift = std::max(low, lift - 8);
    }
    if (garment_.hasLegs()) {
      const double under = kUnderCrotch + (missing ? kAroundTorso : 0);
      m.body_rise =
          std::clamp(m.waist_height - garment_.crotch() - lift - under, kLeastRise, m.body_rise);
      m.hip_depth = std::min(m.hip_depth, m.body_rise - 1.5);
    }
    for (int round = 0; round < kRounds; ++round)
      if (!lessen(&m, lift, round < kRounds / 2)) return std::nullopt;
    if (!Form::make(m).ok()) return std::nullopt;
    return Candidate{{m, lift}, tightness};
  }

  // Reduces girths at rings that are too narrow. The girth of a level is about linear in the girths
  // of its tube's sections. The first rounds leave the waist unchanged, because its neighbours come
  // first.
  bool lessen(Measures* m, double lift, bool before_waist) const {
    const Outcome<Form> made = Form::make(*m);
    if (!made.ok()) return false;
    const Form& form = made.value();
    const Measures usual = measuresAt(2);
    Measures less = *m;
    const auto take = [&](double Measures::*girth, double share, double missing) {
      if (missing <= 0) return;
      const double least = kThinnest * usual.*girth;
      less.*girth = std::min(less.*girth, std::max(least, m->*girth - missing / share));
    };
    const auto each = [&](BodyPart part, double ease, auto&& use) {
      forRings(form, part, lift, ease, use);
    };
    const bool trousers = garment_.hasLegs();
    // Only a close fit holds a garment without shoulders.
    each(BodyPart::kTorso, garment_.hasShoulders() ? kEaseCm : kEaseOfHeld,
         [&](double level, double missing) {
           const double up = level / m->back_length, down = -level / m->hip_depth;
           if (trousers && down > kOfLegs) {
             const double around = kAroundLegs * m->thigh + kApart;
             take(&Measures::thigh, kAroundLegs,
                  missing + around - form.tube(BodyPart::kTorso).section(level).girth());
           }
           if (up > 0.34)
             take(&Measures::bust, 1, missing);
           else if (down > 0.4)
             take(&Measures::hip, std::min(1.0, 0.5 + 0.5 * down),
                  missing + (trousers ? kEaseAtCrotch : 0));
           else if (!before_waist)
             take(&Measures::waist, 0.7, missing);
         });
    for (const BodyPart arm : {BodyPart::kLeftArm, BodyPart::kRightArm})
      each(arm, kEaseOfLimbs, [&](double level, double missing) {
        const double down = -level / m->arm_length;
        if (down < 0.8) take(&Measures::upper_arm, 1, missing);
        if (down > 0.4) take(&Measures::wrist, 1, missing);
      });
    const double knee = m->body_rise - m->knee_depth;
    for (const BodyPart leg : {BodyPart::kLeftLeg, BodyPart::kRightLeg})
      each(leg, kEaseOfLimbs, [&](double level, double missing) {
        if (level > 0.4 * knee)
          take(&Measures::thigh, 0.84, missing);
        else
          take(level > 1.4 * knee ? &Measures::knee : &Measures::ankle, 1, missing);
      });
    *m = less;
    return true;
  }

  /// Returns the girth that rings of the torso lack on a body, summed over levels 1 cm apart. [cm]
  double tightnessOn(const Measures& m, double lift) const {
    const Outcome<Form> form = Form::make(m);
    double sum = 0;
    if (form.ok())
      forRings(form.value(), BodyPart::kTorso, lift, kEaseCm / 2,
               [&](double, double missing) { sum += std::max(0.0, missing); });
    return sum;
  }

  // Calls use(level, missing girth) for each ring around a part of the form.
  template <class Use>
  void forRings(const Form& form, BodyPart part, double lift, double ease, const Use& use) const {
    const bool arm = only(part) & kArms, torso = part == BodyPart::kTorso;
    const Tube& tube = torso ? form.torso(garment_.hasLegs()) : form.tube(part);
    for (const WornGirth& ring : garment_.girths(part)) {
      const double level = arm ? ring.height : ring.height + lift - tube.axis().origin.y();
      if (level < tube.bottom() || level > tube.top()) continue;
      // The top edge of a garment without shoulders covers several heights.
      if (torso && !garment_.hasShoulders() && ring.height > garment_.topLow() - 1) continue;
      use(level, tube.section(level).girth() + ease - ring.girth);
    }
  }

  const HungGarment& garment_;
};

}  // namespace

Outcome<FittingForm> fittingForm(const Garment& garment, const Pattern& pattern) {
  const Outcome<Form> usual = Form::make(measuresAt(2));
  if (!usual.ok()) return usual.error();
  const Outcome<Hanging> hanging = hang(garment, pattern, usual.value());
  if (!hanging.ok()) return hanging.error();
  const HungGarment hung(garment, pattern, usual.value(), hanging.value());
  FittingForm fitting = Fitting(hung).run();
  if (!hanging.value().by_seams) return fitting;
  // Seams hang a garment by heights of the given form, so the lift depends on the form.
  const Outcome<Form> own = Form::make(fitting.measures);
  if (!own.ok()) return own.error();
  const Outcome<Hanging> on_own = hang(garment, pattern, own.value());
  if (!on_own.ok()) return on_own.error();
  fitting.lift += hanging.value().held - on_own.value().held;
  return fitting;
}

}  // namespace seamwise
