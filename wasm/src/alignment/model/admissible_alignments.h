#pragma once
#include <vector>

#include "alignment/model/alignment.h"
#include "wallpaper/group.h"

namespace seamwise {

/// Admissible alignments of a piece: all, a pinned one, those with its own axis on a mirror line of
/// the print, those within a tolerance of given angles (grain), or both of the last two.
class AdmissibleAlignments {
 public:
  bool operator==(const AdmissibleAlignments&) const = default;
  static AdmissibleAlignments anywhere() { return {}; }
  static AdmissibleAlignments pinned(const Alignment& at);
  /// @param map   the piece's own reflection; the group must carry single pieces
  static AdmissibleAlignments mirrored(const RigidMotion& map, const WallpaperGroup& group);

  /// Keeps only angles within `tolerance` of one of `angles` (rad). Returns false, and changes
  /// nothing, if a mirrored piece has no such alignment on this print.
  bool restrictAngles(const std::vector<double>& angles, double tolerance);

  bool isPinned() const { return pinned_; }
  bool isMirrored() const { return !places_.empty(); }
  bool mayRotate() const {
    return !pinned_ && places_.empty() && (angles_.empty() || tolerance_ > 0);
  }

  /// Alignments of a mirrored piece: its axis at `angle` on a line, with any slide along it.
  struct Place {
    double angle;    ///< angle of the alignment, rad
    Vec2 on_line;    ///< a print point of the mirror line
    Vec2 along;      ///< unit vector of the line in print space
    double period;   ///< the print repeats after this shift along the line. [cm]
    double spacing;  ///< distance of equal parallel lines. [cm]
    bool operator==(const Place&) const = default;
  };
  /// Places that put different prints on the piece (others are turns of the print onto itself).
  const std::vector<Place>& places() const { return distinct_; }
  const std::vector<double>& angles() const { return angles_; }
  /// Greatest turn away from angles(). [rad]
  double tolerance() const { return tolerance_; }

  /// The alignment on `place` whose axis point nearest `centre` is `slide` cm along the line.
  Alignment onPlace(const Place& place, const Vec2& centre, double slide) const;

  /// The admissible alignment nearest to `wanted`, turning about the piece point `centre`.
  Alignment nearest(const Alignment& wanted, const Vec2& centre) const;

  /// Columns of the admissible infinitesimal motions (turn about the centre, shift in print space):
  /// 3 x dof, dof in 0..3.
  using Basis = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
  Basis basis(const Alignment& at) const;

  /// Passes all fields to `each`.
  template <class Each>
  void fields(Each&& each) {
    each(pinned_, pin_, axis_point_, axis_direction_, places_, distinct_, angles_, tolerance_);
  }

 private:
  bool pinned_ = false;
  Alignment pin_;
  Vec2 axis_point_ = Vec2::Zero(), axis_direction_ = Vec2::UnitX();  ///< piece coordinates
  std::vector<Place> places_, distinct_;
  std::vector<double> angles_;
  double tolerance_ = 0;
};

/// `alignment` after a turn by `turn` about the piece point `centre` and a shift in print space.
Alignment moved(const Alignment& alignment, const Vec2& centre, double turn, const Vec2& shift);

}  // namespace seamwise
