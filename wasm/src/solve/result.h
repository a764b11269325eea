#pragma once
#include <string>
#include <vector>

#include "pattern/pattern.h"
#include "seam/join.h"
#include "solve/metrics.h"
#include "solve/options.h"

namespace seamwise {

/// Pieces on a print: what there is to draw, of a result or of a garment that is not solved yet.
struct PrintedPattern {
  Pattern pattern;  ///< rest, meshed, with the imposed mirrors
  Shapes shapes;    ///< the pieces as they are now, cm
  std::vector<Alignment> alignment;
  std::vector<Join> joins;                    ///< per seam
  std::vector<std::vector<double>> mismatch;  ///< per seam and edge, through its join, cm; none before a solve
  std::string group;
  Vec2 w1, w2;
  double fit_random = 0;
  std::vector<std::string> notes;
};

/// What a solve found; written as seamwise-result/1.
struct Result : PrintedPattern {
  std::vector<Alignment> search;  ///< where the alignment search ended, before anything deformed
  double fit_search = 0, fit_aligned = 0;
  double search_bound = 0;  ///< no alignment at rest costs less than this share of `search`
  Fit fit;
  double max_moved_cm = 0;
  int iterations = 0;      ///< of the deformation
  int factorisations = 0;  ///< sparse LDLT factorisations
  Method method = Method::kBest;
  std::uint32_t seed = 1;
};

}  // namespace seamwise
