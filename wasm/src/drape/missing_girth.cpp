#include "drape/missing_girth.h"

#include "base/decimal.h"
#include "drape/wrap.h"

namespace seamwise {
namespace {

/// Girth below which a difference is hardly felt. [cm]
constexpr double kLeast = 0.5;

const MeasureName* named(double Measures::*value) {
  for (const MeasureName& measure : kMeasureNames)
    if (measure.value == value) return &measure;
  return nullptr;
}

/// Returns the measurement closest to a level of a part of the body.
const MeasureName* measureAt(BodyPart part, double level, const Measures& m) {
  if (part == BodyPart::kTorso) {
    if (level > 0.3 * m.back_length) return named(&Measures::bust);
    return named(level < -0.4 * m.hip_depth ? &Measures::hip : &Measures::waist);
  }
  if (only(part) & kArms)
    return named(level > -0.6 * m.arm_length ? &Measures::upper_arm : &Measures::wrist);
  const double knee = m.body_rise - m.knee_depth;  // level over the crotch
  if (level > 0.5 * knee) return named(&Measures::thigh);
  return named(level > 1.5 * knee ? &Measures::knee : &Measures::ankle);
}

struct Narrowest {
  const MeasureName* measure = nullptr;
  double missing = kLeast;
};

Narrowest narrowestOn(const Garment& garment, const Pattern& pattern, const Form& form) {
  Narrowest most;
  for (const BodyPart part : {BodyPart::kTorso, BodyPart::kLeftArm, BodyPart::kRightArm,
                              BodyPart::kLeftLeg, BodyPart::kRightLeg}) {
    const Tube& tube = form.tube(part);
    for (const WornGirth& ring : wornGirths(garment, pattern, form, part)) {
      const double level = only(part) & kArms ? ring.height : ring.height - tube.axis().origin.y();
      if (level < tube.bottom() || level > tube.top()) continue;
      const double missing = tube.section(level).girth() - ring.girth;
      if (missing > most.missing) most = {measureAt(part, level, form.measures()), missing};
    }
  }
  return most;
}

}  // namespace

std::optional<MissingGirth> missingGirth(const Garment& garment, const Pattern& pattern,
                                         const Form& form) {
  const Narrowest most = narrowestOn(garment, pattern, form);
  if (!most.measure) return std::nullopt;
  MissingGirth girth{most.measure, most.missing, nullptr};
  for (const Size& size : kSizes) {
    const Outcome<Form> other = Form::make(size.measures);
    if (other.ok() && !narrowestOn(garment, pattern, other.value()).measure) girth.fits = &size;
  }
  return girth;
}

std::string spoken(const MissingGirth& girth) {
  std::string text =
      " by " + fixed(girth.missing, 1) + " cm at the " + std::string(girth.measure->spoken);
  if (!girth.fits) return text;
  std::string size;
  for (const char letter : girth.fits->name) size += static_cast<char>(letter & ~0x20);
  return text + " (it fits size " + size + ")";
}

}  // namespace seamwise
