#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/outcome.h"
#include "nesting/complete_search.h"
#include "nesting/layout_search.h"
#include "nesting/nesting_problem.h"

namespace seamwise {

/// Lays pieces on printed cloth, step by step: first somehow, then shorter and shorter, then it
/// tries to prove that no layout is shorter, then without the print, then on cloth of other widths.
/// Work is counted in table reads, so that the same problem has the same answer everywhere.
class Marker {
 public:
  enum class Stage : std::uint8_t { kTables, kLay, kProve, kFree, kWidths, kDone };

  /// Errors: kOptions, a sentence that names the piece that finds no place, and what would help.
  static Outcome<std::unique_ptr<Marker>> make(NestingProblem problem);

  /// Goes on until about so many million table reads are spent; false when nothing is left to do.
  bool advance(double work);
  /// Why there is no layout; after that `advance` does nothing.
  const std::optional<Error>& error() const { return error_; }

  Stage stage() const { return stage_; }
  double fraction() const;  ///< 0 to 1
  /// Of the layouts that were the best so far.
  int count() const { return count_; }

  /// Of the best layout, once there is one. [cm]
  double length() const { return roundedUp(best_->length()); }
  const Vec2& origin() const { return origin_; }  ///< of the print, from left edge and cut
  /// Per piece its coordinates -> cloth.
  const std::vector<RigidMotion>& places() const { return places_; }
  /// Where a piece may lie with all others where they are, beside where it is.
  std::vector<RigidMotion> freePlaces(int piece) const;

  /// No layout with the print starting where it does is shorter. [cm]
  double bound() const { return roundedUp(bound_); }
  bool isProven() const { return is_proven_; }
  double freeLength() const { return free_length_; }  ///< 0 where nobody asked. [cm]
  /// Per phase and per width of the problem; not a number where a piece finds no place. [cm]
  std::vector<double> phaseLengths() const;
  const std::vector<double>& widthLengths() const { return width_lengths_; }

 private:
  /// A way that the print and the nap may lie, among which the best is chosen.
  struct Variant {
    std::size_t phase = 0;
    std::unique_ptr<LayoutSearch> search;
    bool is_done = false;
  };

  explicit Marker(NestingProblem problem);
  LayCloth clothOf(double width, double phase) const;
  std::vector<std::vector<int>> naps() const;
  void makeTables();
  void makeVariants();
  void lay();
  /// One step of a search that may read so many entries. False when there is nothing left to do.
  bool goOn(LayoutSearch& search, double most);
  void keepBest();
  void beginProof();
  LayCloth clothOfProof() const;
  bool beginNextProof();
  void take(const LaidPieces& found);
  void prove();
  void layFree();
  void layWidths();
  void fail();
  double budget() const;
  double roundedUp(double length) const;
  double spent() const;

  NestingProblem problem_;
  PiecesOnBoard pieces_;
  Stage stage_ = Stage::kTables;
  std::optional<Error> error_;
  std::vector<Variant> variants_;
  std::size_t turn_ = 0;  ///< whose variant it is
  int count_ = 0;
  bool is_searched_ = false;  ///< nothing shorter than the best is left to be tried
  const LayoutSearch* best_search_ = nullptr;
  std::optional<LaidPieces> best_;
  Vec2 origin_ = Vec2::Zero();
  std::vector<RigidMotion> places_;

  std::unique_ptr<CompleteSearch> proof_;
  int proofs_ = 0;           ///< begun
  double proof_target_ = 0;  ///< that no layout is as short as. [cm]
  double proof_work_ = 0;    ///< it may take. [rows]
  bool is_of_best_ = false;  ///< that nothing is shorter than the best
  double tried_length_ = 0;  ///< of the last of these. [cm]
  double bound_ = 0;
  bool is_proven_ = false;

  std::unique_ptr<PiecesOnBoard> free_pieces_;
  std::unique_ptr<LayoutSearch> free_search_;
  double free_length_ = 0;
  std::size_t width_ = 0;
  std::unique_ptr<LayoutSearch> width_search_, narrower_;  ///< the latter of the width before
  std::vector<double> width_lengths_;
  double reads_ = 0;  ///< of this call of advance
};

}  // namespace seamwise
