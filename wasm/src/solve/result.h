#pragma once
#include <optional>
#include <string>
#include <vector>

#include "methods/metrics.h"
#include "pattern/garment.h"
#include "pattern/note.h"
#include "pattern/pattern.h"
#include "problem/options.h"
#include "problem/seam_groups.h"
#include "seam/join.h"
#include "solve/seam_reasons.h"

namespace seamwise {

/// Mean mismatch along a seam. [cm]
struct SeamFigures {
  /// Point by point, modulo the print's group: for the drafted layout, after placing alone, and for
  /// the result.
  double drafted = 0, placed = 0, final = 0;
  double whole = 0;     ///< mismatch of the result under one join for the whole seam
  bool shaped = false;  ///< its line differs from the drafted one by more than 1 mm
  SeamReason reason = SeamReason::kNone;
};

/// State of a seam. Values are part of the result file: append only.
enum class SeamState : std::uint8_t {
  kMatches,  ///< 95 % of its length within 3 mm
  kClose,    ///< within 6 mm, or all but one short end matches
  kOff,
  kCannot,  ///< no alignment and no allowed shape matches it
  kChoice   ///< left out by the user
};

/// End of a seam that does not match while the rest does.
struct UnmatchedEnd {
  SeamEnd from = SeamEnd::kTop;
  double cm = 0;  ///< its length
};

/// State of a seam of one or several stitches.
struct GroupFigures {
  SeamState state = SeamState::kMatches;
  SeamReason reason = SeamReason::kNone;  ///< unless it matches
  std::optional<UnmatchedEnd> end;
};

/// Means over all seams that count, weighted by length. [cm]
struct LocalMeans {
  double drafted = 0, placed = 0, final = 0;
  double worst = 0;  ///< greatest mean of a seam in the result
  double p90 = 0;    ///< mismatch that 90 % of the result's seams, by length, do not exceed
  double off = 0;    ///< length of seams with a mismatch above 5 mm
};

/// Pieces on a print: the data for drawing a result or a garment that is not solved yet. The latter
/// has only the first two of the totals.
struct PrintedPattern : MismatchTotals {
  Pattern pattern;  ///< rest shapes, meshed, with the imposed mirrors
  Shapes shapes;    ///< current shapes of the pieces, cm
  Garment garment;  ///< garment as read, for the drape
  std::vector<Alignment> alignment;
  std::vector<Join> joins;  ///< per seam
  std::vector<std::vector<double>>
      mismatch;  ///< per seam and edge, under its join, cm; empty before a solve
  std::string group;
  Vec2 w1, w2;
  /// Totals without mirrors and glides; set if mirrored seams are forbidden. The inherited totals
  /// use all symmetries of the print, as for every result.
  std::optional<MismatchTotals> continuous;
  std::vector<Note> notes;
};

/// Alternative alignments of all pieces with a similar mismatch.
struct OtherAlignment {
  std::vector<Alignment> pieces;
  double placed = 0;    ///< mean mismatch of the pieces as drafted. [cm]
  double expected = 0;  ///< estimate of the same after shaping. [cm]
};

/// The result of a solve; written as seamwise-result/1.
struct Result : PrintedPattern {
  std::vector<Alignment> drafted;    ///< a cutter's layout of the pieces as drafted
  std::vector<SeamFigures> figures;  ///< per seam
  std::vector<SeamGroup> groups;     ///< seams of a sewist
  std::vector<GroupFigures> states;  ///< per group
  LocalMeans local;
  std::vector<Alignment> search;  ///< end of the alignment search, before any deformation
  double search_bound = 0;        ///< no alignment of the pieces as drafted costs less than this
                                  ///< share of the cost at `search`
  double search_cost = 0;         ///< cost of drafted pieces at `search`, by seam weights. [cm2]
  std::optional<std::vector<OtherAlignment>> others;  ///< set if requested
  /// answerCost() of the result; a lower one is a better answer to the same problem. [cm2]
  double cost = 0;
  double max_moved_cm = 0;
  int iterations = 0;      ///< number of iterations of the deformation
  int factorisations = 0;  ///< number of sparse LDLT factorisations
  Method method = Method::kBest;
  std::uint32_t seed = 1;
};

}  // namespace seamwise
