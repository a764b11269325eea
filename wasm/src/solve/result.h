#pragma once
#include <optional>
#include <string>
#include <vector>

#include "methods/metrics.h"
#include "pattern/garment.h"
#include "pattern/note.h"
#include "pattern/pattern.h"
#include "problem/options.h"
#include "seam/join.h"
#include "solve/seam_reasons.h"

namespace seamwise {

/// Mean mismatch along a seam. [cm]
struct SeamFigures {
  /// Point by point, modulo the print's group: of the drafted layout, of placing alone, of the
  /// result.
  double drafted = 0, placed = 0, final = 0;
  double whole = 0;     ///< of the result, through the one join of the whole seam
  bool shaped = false;  ///< its line has left the drafted one by more than 1 mm
  SeamReason reason = SeamReason::kNone;
};

/// The same over all seams that count, by length. [cm]
struct LocalMeans {
  double drafted = 0, placed = 0, final = 0;
  double worst = 0;  ///< greatest mean of a seam in the result
  double p90 = 0;    ///< what nine tenths of the result's seams, by length, do not miss by
  double off = 0;    ///< cm of seam that miss by more than 5 mm
};

/// Pieces on a print: what there is to draw, of a result or of a garment that is not solved yet,
/// which has the first two of the totals only.
struct PrintedPattern : MismatchTotals {
  Pattern pattern;  ///< rest, meshed, with the imposed mirrors
  Shapes shapes;    ///< the pieces as they are now, cm
  Garment garment;  ///< as read: how the pieces are worn
  std::vector<Alignment> alignment;
  std::vector<Join> joins;  ///< per seam
  std::vector<std::vector<double>>
      mismatch;  ///< per seam and edge, through its join, cm; none before a solve
  std::string group;
  Vec2 w1, w2;
  /// Where mirrored seams are forbidden: the totals without mirrors and glides. The other ones
  /// count whatever the print has, as for every result.
  std::optional<MismatchTotals> continuous;
  std::vector<Note> notes;
};

/// Where all pieces may lie instead, with about as good a fit.
struct OtherAlignment {
  std::vector<Alignment> pieces;
  double placed = 0;    ///< mean mismatch of the pieces as drafted. [cm]
  double expected = 0;  ///< the same once they are shaped, as a guess. [cm]
};

/// What a solve found; written as seamwise-result/1.
struct Result : PrintedPattern {
  std::vector<Alignment> drafted;    ///< how a cutter lays the pieces as drafted
  std::vector<SeamFigures> figures;  ///< per seam
  LocalMeans local;
  std::vector<Alignment> search;  ///< where the alignment search ended, before anything deformed
  double search_bound = 0;        ///< no alignment at rest costs less than this share of `search`
  double search_cost = 0;  ///< of the pieces as drafted at `search`, by the seams' weights. [cm2]
  std::optional<std::vector<OtherAlignment>> others;  ///< where they were asked for
  double max_moved_cm = 0;
  int iterations = 0;      ///< of the deformation
  int factorisations = 0;  ///< sparse LDLT factorisations
  Method method = Method::kBest;
  std::uint32_t seed = 1;
};

}  // namespace seamwise
