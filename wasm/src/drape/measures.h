#pragma once
#include <array>
#include <string_view>

namespace seamwise {

/// Measurements of an upright body on the floor y = 0 that faces +z, all in cm.
struct Measures {
  // Girths, measured level; girths of limbs around their axis.
  double bust, waist, hip, neck, head, upper_arm, wrist, thigh, knee, ankle;
  double shoulder_width;  ///< distance between the shoulder points, across the back
  double bust_span;       ///< distance between the bust points
  double back_length;     ///< length from the nape down to the waist
  double hip_depth;       ///< depth of the fullest part of the hip below the waist
  double body_rise;       ///< depth of the crotch below the waist
  double arm_length;      ///< length from the shoulder point down to the wrist
  double waist_height;    ///< height of the waist over the floor
  double knee_depth;      ///< depth of the knee below the waist
};

/// Measurement with its names in files and in messages.
struct MeasureName {
  std::string_view name, spoken;
  double Measures::*value;
};

inline constexpr std::array<MeasureName, 18> kMeasureNames = {
    {{"bust", "bust", &Measures::bust},
     {"waist", "waist", &Measures::waist},
     {"hip", "hip", &Measures::hip},
     {"neck", "neck", &Measures::neck},
     {"head", "head", &Measures::head},
     {"upperArm", "upper arm", &Measures::upper_arm},
     {"wrist", "wrist", &Measures::wrist},
     {"thigh", "thigh", &Measures::thigh},
     {"knee", "knee", &Measures::knee},
     {"ankle", "ankle", &Measures::ankle},
     {"shoulderWidth", "shoulder width", &Measures::shoulder_width},
     {"bustSpan", "bust span", &Measures::bust_span},
     {"backLength", "back length", &Measures::back_length},
     {"hipDepth", "hip depth", &Measures::hip_depth},
     {"bodyRise", "body rise", &Measures::body_rise},
     {"armLength", "arm length", &Measures::arm_length},
     {"waistHeight", "waist height", &Measures::waist_height},
     {"kneeDepth", "knee depth", &Measures::knee_depth}}};

struct Size {
  std::string_view name;
  Measures measures;
};

/// Sizes of the sample patterns; web/samples/drafting/body.ts gives their source.
inline constexpr std::array<Size, 5> kSizes = {{
    {"xs",
     {80, 64, 88, 29.4, 53.8, 23.4, 15.4, 53.5, 34.7, 21.2, 37.9, 14.9, 36, 22.8, 24.6, 56.6, 99.3,
      54.7}},
    {"s",
     {88, 72, 96, 32.3, 55.5, 25.7, 16.1, 55.8, 36.8, 23.3, 40.2, 15.6, 38.3, 24.2, 26.1, 58.1, 103,
      58.1}},
    {"m",
     {96, 80, 104, 35.3, 57.2, 28, 16.8, 58, 38.9, 25.4, 42.5, 16.3, 40.5, 25.6, 27.7, 59.7, 106.6,
      61.5}},
    {"l",
     {104, 88, 112, 38.2, 59, 30.4, 17.5, 60.2, 41.1, 27.5, 44.9, 17, 42.7, 27, 29.2, 61.2, 110.2,
      64.8}},
    {"xl",
     {116, 101, 122, 42.6, 61.5, 33.9, 18.6, 63.5, 44.3, 30.7, 48.4, 18, 46, 29.1, 31.5, 63.5,
      115.7, 69.9}},
}};

/// Returns the measurements of size "xs", "s", "m", "l" or "xl" in either case, or null.
inline const Measures* measuresOf(std::string_view size) {
  const auto same = [&](std::string_view name) {
    if (name.size() != size.size()) return false;
    for (std::size_t i = 0; i < name.size(); ++i)
      if ((size[i] | 0x20) != name[i]) return false;
    return true;
  };
  for (const Size& known : kSizes)
    if (same(known.name)) return &known.measures;
  return nullptr;
}

}  // namespace seamwise
