#include "drape/seam_arms.h"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.h"
#include "drape/piece_words.h"

namespace seamwise {
namespace {

// Maximum relative difference in area between twin tubes. [1]
constexpr double kTwin = 0.02;
// Maximum width of a sleeve relative to all other pieces. [1]
constexpr double kNarrow = 0.75;

class ArmFinder {
 public:
  ArmFinder(const Pattern& pattern, const UprightPieces& upright)
      : pattern_(pattern),
        upright_(upright),
        count_(static_cast<int>(pattern.pieces.size())),
        tubes_(count_),
        is_sleeve_(count_, false) {}

  std::vector<int> run() {
    findTubes();
    for (int i = 0; i < count_; ++i)
      if (isCalled(pattern_.pieces[i].name, kSleeveWords)) is_sleeve_[i] = true;
    followSleeves();
    std::vector<int> arms(count_, -1);
    // Arms need a torso, so pieces that are not sleeves have to exist.
    if (std::all_of(is_sleeve_.begin(), is_sleeve_.end(), [](char is) { return is; })) return arms;
    DisjointSets sets(count_);
    for (const UprightJoin& join : upright_.joins())
      if (is_sleeve_[join.a.piece] && is_sleeve_[join.b.piece])
        sets.join(join.a.piece, join.b.piece);
    for (int i = 0; i < count_; ++i)
      if (is_sleeve_[i]) arms[i] = sets.find(i);
    return arms;
  }

 private:
  void findTubes() {
    const std::vector<UprightJoin>& joins = upright_.joins();
    std::vector<char> closed(count_, false);
    for (const UprightJoin& join : joins)
      for (const UprightJoin& other : joins)
        if (areOpposite(join, other)) tubes_.join(join.a.piece, join.b.piece);
    for (const UprightJoin& join : joins)
      if (join.isUpright() && tubes_.find(join.a.piece) == tubes_.find(join.b.piece) &&
          (join.a.piece != join.b.piece || isAround(join)))
        closed[tubes_.find(join.a.piece)] = true;
    std::vector<double> area(count_, 0.0), width(count_, 0.0);
    double all = 0;
    for (int i = 0; i < count_; ++i) {
      area[tubes_.find(i)] += upright_.area(i);
      width[tubes_.find(i)] += upright_.width(i);
      all += upright_.width(i);
    }
    const auto isTwin = [&](int one, int other) {
      return one != other && closed[one] && closed[other] &&
             std::abs(area[one] - area[other]) < kTwin * area[one] && !areJoined(one, other) &&
             width[one] < kNarrow * (all - width[one] - width[other]);
    };
    for (int i = 0; i < count_; ++i)
      for (int other = 0; other < count_; ++other)
        if (isTwin(tubes_.find(i), other)) is_sleeve_[i] = true;
  }

  // Returns whether two seams join the same two pieces on opposite sides.
  static bool areOpposite(const UprightJoin& join, const UprightJoin& other) {
    if (!join.isUpright() || !other.isUpright() || join.a.piece == join.b.piece) return false;
    const bool same = join.a.piece == other.a.piece && join.b.piece == other.b.piece;
    const bool crossed = join.a.piece == other.b.piece && join.b.piece == other.a.piece;
    if (!same && !crossed) return false;
    return join.a.out.x() * (same ? other.a : other.b).out.x() < -0.3;
  }

  // Returns whether a seam closes a piece to a tube; a dart's seam does not.
  bool isAround(const UprightJoin& join) const {
    return std::abs(join.a.middle.x() - join.b.middle.x()) > 0.5 * upright_.width(join.a.piece);
  }

  bool areJoined(int one, int other) {
    for (const UprightJoin& join : upright_.joins()) {
      const int a = tubes_.find(join.a.piece), b = tubes_.find(join.b.piece);
      if ((a == one && b == other) || (a == other && b == one)) return true;
    }
    return false;
  }

  // Adds cuffs, which are sewn only to sleeves.
  void followSleeves() {
    for (bool changed = true; changed;) {
      changed = false;
      std::vector<char> to_sleeve(count_, false), to_other(count_, false);
      for (const UprightJoin& join : upright_.joins())
        for (const auto& [one, other] :
             {std::pair(join.a.piece, join.b.piece), {join.b.piece, join.a.piece}})
          if (one != other) (is_sleeve_[other] ? to_sleeve : to_other)[one] = true;
      for (int i = 0; i < count_; ++i)
        if (!is_sleeve_[i] && to_sleeve[i] && !to_other[i]) is_sleeve_[i] = changed = true;
    }
  }

  const Pattern& pattern_;
  const UprightPieces& upright_;
  int count_;
  DisjointSets tubes_;
  std::vector<char> is_sleeve_;
};

}  // namespace

std::vector<int> armsBySeams(const Pattern& pattern, const UprightPieces& upright) {
  return ArmFinder(pattern, upright).run();
}

}  // namespace seamwise
