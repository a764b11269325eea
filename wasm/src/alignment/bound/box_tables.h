#pragma once
#include <utility>
#include <vector>

#include "alignment/bound/boxes.h"
#include "alignment/bound/elimination.h"
#include "alignment/bound/seam_terms.h"
#include "alignment/model/component.h"
#include "alignment/model/sampled_seams.h"

namespace seamwise {

/// Boxes that cover what each leader of a component may do, and what the seams cost at least in the
/// pairs of them that are left.
class BoxTables {
 public:
  BoxTables(const MatchProblem& problem, const Component& component);

  int leaders() const { return static_cast<int>(covers_.size()); }
  const Boxes& boxes(int v) const { return covers_[v].boxes; }
  const std::vector<Box>& all(int v) const { return covers_[v].all; }
  double weight(int v) const { return covers_[v].weight; }  ///< of the seams. [cm]
  /// What boxes and pairs cost at least, since the last sweep.
  const Elimination& sums() const { return elimination_; }
  /// Memory of the tables, about, once boxes of `v` that may cost less than `below` are halved.
  /// [bytes]
  double bytesWith(int v, float below) const;

  /// Replaces the boxes of a leader that may cost less than `below` by halves, which cost no less.
  void halve(int v, float below, double& spent);
  /// Begins to evaluate the pairs of one table whose boxes were halved, and then to sweep. False
  /// when there are none.
  bool evaluate();
  /// Begins to find the sums anew.
  void sweep();
  /// Goes on with either of these until `spent` has grown by `work`. False at the end.
  bool step(double work, double& spent);
  /// Drops what costs `cost` or more.
  void drop(float cost);
  /// Makes slopes cancel at the best partners of each box, where that is for the better.
  void tilt();

 private:
  /// The boxes of a leader, and linear functions that are added to what its seams cost in a box:
  /// together they are nothing, and so slopes cancel where an answer is in balance.
  struct Cover {
    Boxes boxes;
    int slot, slots;    ///< of Term::slope that this leader has
    double weight = 0;  ///< of its seams. [cm]
    SeamTerms own;
    std::vector<int> tables;  ///< of its seams with others
    std::vector<Box> all;
    std::vector<float> terms;  ///< of own: known, middle, slopes
    std::vector<float> tilts;  ///< for each box, of each table and of own
    int stride() const { return 2 + slots; }
    int tilted() const { return slots * (static_cast<int>(tables.size()) + 1); }
  };
  /// The seams of a table.
  struct Joint {
    SeamTerms seams;
    int row_tilt = 0, column_tilt = 0;  ///< where the tilts of its leaders begin
    int stride = 0;
    std::vector<float> terms;  ///< of each entry: known, middle, slopes of row and column
    std::vector<char> stale;   ///< whether what is known was said of larger boxes
  };

  static float tilted(const float* term, const float* row, int rows, const float* column,
                      int columns);
  std::vector<std::vector<float>> balance() const;
  void addSeams(const Component& component, const std::vector<int>& index);
  void inherit(int table, int v, const std::vector<HalfBox>& halves, const std::vector<int>& first);
  void evaluateEntry(Joint& joint, int row, int entry, double& spent);

  const MatchProblem& problem_;
  std::vector<SeamBound> bounds_;
  std::vector<Box> pinned_;
  std::vector<Cover> covers_;
  std::vector<Joint> joints_;
  Elimination elimination_;

  int table_ = -1, row_ = 0;  ///< evaluated at present
};

}  // namespace seamwise
