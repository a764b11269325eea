#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "drape/upright_joins.h"

namespace seamwise {

/// What numbers lie between.
struct Breadth {
  double low = 1e9, high = -1e9;
  void add(double x) { low = std::min(low, x), high = std::max(high, x); }
  double width() const { return high - low; }
  double middle() const { return (low + high) / 2; }
};

/// The pieces of a garment laid flat side by side as they are sewn, upright along their grain:
/// those of the torso, and by themselves those of each arm.
class FlatLayout {
 public:
  FlatLayout(const Garment& garment, const Pattern& pattern);

  int count() const { return count_; }
  /// A piece that no seam and no match joins to the others, or -1.
  int unjoined() const;
  const UprightPieces& upright() const { return upright_; }
  /// Per piece: a piece by which its arm is known, or -1.
  const std::vector<int>& arm() const { return arm_; }
  /// Whether a piece is of a collar, a hood, or a strap around the neck.
  bool isNeck(int i) const { return neck_[i]; }
  bool isTorso(int i) const { return arm_[i] < 0 && !neck_[i]; }
  /// Whether the garment hangs from the neck: it has sleeves or shoulder seams.
  bool hasShoulders() const;
  const std::string& name(int i) const { return pattern_.pieces[i].name; }
  const std::vector<int>& outline(int i) const { return pattern_.pieces[i].outline; }

  /// Where the origin of a piece, upright, lies; a vertex; the middle of the outline. [cm]
  const Vec2& at(int i) const { return at_[i]; }
  Vec2 laid(int i, int v) const { return at_[i] + upright_(i, pattern_.pieces[i].rest[v]); }
  Vec2 middle(int i) const { return at_[i] + upright_(i, middleOf(i)); }
  double topOf(int i) const;
  /// Of the outline, in the piece's own coordinates. [cm]
  Vec2 middleOf(int i) const;

  /// The pieces of which belongs(i) holds, as a ring: where they lie across the layout, and how far
  /// around it goes, by the seams that close it. [cm]
  struct Ring {
    Breadth across;
    double girth = 0;
  };
  template <class Belongs>
  Ring ring(const Belongs& belongs) const {
    Ring ring;
    for (int i = 0; i < count_; ++i)
      if (belongs(i))
        for (const int v : outline(i)) ring.across.add(laid(i, v).x());
    for (const UprightJoin& join : joins())
      if (belongs(join.a.piece) && belongs(join.b.piece) && join.isUpright() && join.isFlat())
        ring.girth = std::max(ring.girth, apart(join));
    // Those that close it lie apart by much of the layout.
    if (ring.girth < ring.across.width() / 2) ring.girth = ring.across.width();
    return ring;
  }

 private:
  double apart(const UprightJoin& join) const;
  template <class Use>
  void forSides(const Use& use) const;
  void hold(int i);
  void holdStrap(int i);
  double lengthOf(int i) const;
  void spread(int arm);
  double rank(int i) const;
  void lay(int join);
  bool layMatched(int arm);
  void findNeck();
  void centreRows();
  const std::vector<UprightJoin>& joins() const { return upright_.joins(); }

  const Garment& garment_;
  const Pattern& pattern_;
  UprightPieces upright_;
  int count_;
  std::vector<int> arm_;
  std::vector<char> reached_;
  std::vector<Vec2> at_;
  std::vector<std::pair<int, int>>
      laid_;  ///< pieces beside others, in the order in which they were
  std::vector<char> neck_, shoulder_;
};

}  // namespace seamwise
