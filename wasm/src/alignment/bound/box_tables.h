#pragma once
#include <utility>
#include <vector>

#include "alignment/bound/boxes.h"
#include "alignment/bound/elimination.h"
#include "alignment/bound/seam_terms.h"
#include "alignment/model/component.h"
#include "alignment/model/sampled_seams.h"

namespace seamwise {

/// Boxes that cover the alignments of each leader of a component, and lower bounds of the seams'
/// costs in the remaining pairs of boxes.
class BoxTables {
 public:
  BoxTables(const MatchProblem& problem, const Component& component);

  int leaders() const { return static_cast<int>(covers_.size()); }
  const Boxes& boxes(int v) const { return covers_[v].boxes; }
  const std::vector<Box>& all(int v) const { return covers_[v].all; }
  double weight(int v) const { return covers_[v].weight; }  ///< total weight of its seams. [cm]
  /// Lower bounds of boxes and pairs, from the last sweep.
  const Elimination& sums() const { return elimination_; }
  /// Approximate memory of the tables after a halving of the boxes of `v` that may cost less than
  /// `below`. [bytes]
  double bytesWith(int v, float below) const;

  /// Replaces the boxes of a leader that may cost less than `below` by halves, whose costs are no
  /// less.
  void halve(int v, float below, double& spent);
  /// Starts to evaluate one table's pairs of halved boxes, followed by a sweep. Returns false when
  /// there are none.
  bool evaluate();
  /// Starts to compute the sums again.
  void sweep();
  /// Continues either of these until `spent` has grown by `work`. Returns false at the end.
  bool step(double work, double& spent);
  /// Drops boxes and pairs that cost `cost` or more.
  void drop(float cost);
  /// Makes slopes cancel at the best partners of each box, where that raises the bound.
  void tilt();

 private:
  /// The boxes of a leader, and its tilts: linear functions added to the costs of its seams in a
  /// box. The tilts of a box add up to zero, and make slopes cancel where an answer is in balance.
  struct Cover {
    Boxes boxes;
    int slot, slots;    ///< this leader's part of Term::slope
    double weight = 0;  ///< total weight of its seams. [cm]
    SeamTerms own;
    std::vector<int> tables;  ///< tables of its seams with other leaders
    std::vector<Box> all;
    std::vector<float> terms;  ///< terms of `own`: known, middle, slopes
    std::vector<float> tilts;  ///< per box: the tilts of each table and of `own`
    int stride() const { return 2 + slots; }
    int tilted() const { return slots * (static_cast<int>(tables.size()) + 1); }
  };
  /// The seams of a table.
  struct Joint {
    SeamTerms seams;
    int row_tilt = 0, column_tilt = 0;  ///< first index of its leaders' tilts
    int stride = 0;
    std::vector<float> terms;  ///< per entry: known, middle, slopes of row and column
    std::vector<char> stale;   ///< per entry: 1 if the terms are those of larger boxes
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

  int table_ = -1, row_ = 0;  ///< table and row of the current evaluation
};

}  // namespace seamwise
