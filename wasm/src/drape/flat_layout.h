#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "drape/upright_joins.h"

namespace seamwise {

/// Range of numbers.
struct Breadth {
  double low = 1e9, high = -1e9;
  void add(double x) { low = std::min(low, x), high = std::max(high, x); }
  double width() const { return high - low; }
  double middle() const { return (low + high) / 2; }
};

/// Pieces of a garment arranged flat and side by side in sewing order, upright along their grain.
/// The torso has one layout and each arm has another.
class FlatLayout {
 public:
  FlatLayout(const Garment& garment, const Pattern& pattern);

  int count() const { return count_; }
  /// Returns a piece that no seam or match joins to the others, or -1.
  int unjoined() const;
  const UprightPieces& upright() const { return upright_; }
  /// Per piece: representative piece of its arm, or -1.
  const std::vector<int>& arm() const { return arm_; }
  /// Returns whether a piece belongs to a collar, a hood or a neck strap.
  bool isNeck(int i) const { return neck_[i]; }
  bool isTorso(int i) const { return arm_[i] < 0 && !neck_[i]; }
  /// Returns whether the garment hangs from the neck, because it has sleeves or shoulder seams.
  bool hasShoulders() const;
  const std::string& name(int i) const { return pattern_.pieces[i].name; }
  const std::vector<int>& outline(int i) const { return pattern_.pieces[i].outline; }

  /// Layout positions of an upright piece's origin, of a vertex, and of the outline's middle. [cm]
  const Vec2& at(int i) const { return at_[i]; }
  Vec2 laid(int i, int v) const { return at_[i] + upright_(i, pattern_.pieces[i].rest[v]); }
  Vec2 middle(int i) const { return at_[i] + upright_(i, middleOf(i)); }
  double topOf(int i) const;
  /// Middle of the outline in piece coordinates. [cm]
  Vec2 middleOf(int i) const;

  /// Ring of the pieces for which belongs(i) holds: extent across the layout, and girth given by
  /// the seams that close the ring. [cm]
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
    // Seams that close a ring join pieces at least half the layout's width apart.
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
      laid_;  ///< pairs of a piece and its earlier neighbour, in order of placement
  std::vector<char> neck_, shoulder_;
};

}  // namespace seamwise
