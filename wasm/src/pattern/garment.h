#pragma once
#include <optional>
#include <string>
#include <vector>

#include "geometry/curve.h"
#include "geometry/rigid_motion.h"
#include "pattern/fold.h"

namespace seamwise {

/// Direction of the grain line on the fabric: free, along its length, across it, or at 45 degrees.
enum class GrainLock : std::uint8_t { kFree, kOn, kAcross, kBias };

/// A cut piece as drafted: its outline as exact curves, face side up (the printed side towards the
/// viewer), counter-clockwise, in cm. `edges` keep the numbering of the file; edge k ends where
/// edge k + 1 starts.
struct Panel {
  std::string name;
  std::vector<Curve> edges;
  std::vector<std::vector<Curve>> holes;  ///< cut-outs, each a closed clockwise loop; never sewn
  std::vector<char> hole_reversed;        ///< true for holes that the file lists counter-clockwise
  std::vector<Fold> folds;
  bool mirrored_from_input = false;     ///< the file shows the back, so x is negated
  double grain_angle = kPi / 2;         ///< direction of the grain line in this (face-up) frame
  bool grain_stated = false;            ///< false: the file has no grain line, so it is upwards
  std::optional<GrainLock> grain_lock;  ///< set by the file; options may override
  double grain_tolerance = 0;           ///< rad
  Vec3 placement_shift = Vec3::Zero();  ///< 3D translation of the input panel, cm
  Vec3 placement_turn = Vec3::Zero();   ///< XYZ Euler angles, rad
  bool operator==(const Panel&) const = default;
};

struct EdgeRef {
  int piece = -1;
  int edge = -1;
  bool operator==(const EdgeRef&) const = default;
};

/// Two edges sewn to each other. The start of `a` meets the end of `b`, unless `same_direction` is
/// true.
struct Stitch {
  EdgeRef a, b;
  bool same_direction = false;  ///< "right_wrong" in GarmentCode
  double weight = 1.0;
  bool matched = true;    ///< false: sewn, but the print need not match
  double visibility = 0;  ///< how much a mismatch is seen; 0: all seams count equally
  bool operator==(const Stitch&) const = default;
};

/// Two lines on pieces that overlap without being sewn along them (a button front, a patch pocket).
/// Both are polylines with the same number of points in corresponding order, in face-up piece
/// coordinates.
struct MatchLine {
  int piece_a = -1, piece_b = -1;
  Polyline a, b;
  double weight = 1.0;
  bool operator==(const MatchLine&) const = default;
};

/// A mirror symmetry of the body: maps points of pieces[0] to points of pieces[1] (the same piece
/// for a piece that is symmetric in itself). `map.mirrored` is always true.
struct BodySymmetry {
  int pieces[2] = {-1, -1};
  RigidMotion map;      ///< face-up coordinates, p' = R F p + t (Wolff et al. 2019, Eq. 3)
  double residual = 0;  ///< greatest distance between the mapped outline and its image. [cm]
  bool single() const { return pieces[0] == pieces[1]; }
  bool operator==(const BodySymmetry&) const = default;
};

/// A measurement of the body that a garment is drafted for. [cm]
struct BodyMeasure {
  std::string name;
  double cm = 0;
  bool operator==(const BodyMeasure&) const = default;
};

/// A sewing pattern as read: panels and stitches, in the order of the file.
struct Garment {
  std::vector<Panel> panels;
  std::vector<Stitch> stitches;
  std::vector<MatchLine> matches;
  std::string size;               ///< the file's name of the size ("M"), or empty
  std::vector<BodyMeasure> body;  ///< empty if the file has none
  bool operator==(const Garment&) const = default;

  int find(const std::string& name) const {
    for (std::size_t i = 0; i < panels.size(); ++i)
      if (panels[i].name == name) return static_cast<int>(i);
    return -1;
  }
};

}  // namespace seamwise
