#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/outcome.h"
#include "marker/complete_search.h"
#include "marker/layout_search.h"
#include "marker/marker_problem.h"

namespace seamwise {

/// Places pieces on printed fabric, step by step. It makes a first layout and shortens it, tries to
/// prove that no layout is shorter, and then computes layouts without the print and on fabrics of
/// other widths. Work is counted in table reads, so that the result does not depend on the machine.
class Marker {
 public:
  enum class Stage : std::uint8_t { kTables, kLay, kProve, kFree, kWidths, kDone };

  /// Errors: kOptions, a sentence that names the piece that does not fit, and a remedy.
  static Outcome<std::unique_ptr<Marker>> make(MarkerProblem problem);

  /// Works for about `work` million table reads. Returns false when finished.
  bool advance(double work);
  /// The reason why there is no layout; `advance` does nothing after an error.
  const std::optional<Error>& error() const { return error_; }

  Stage stage() const { return stage_; }
  double fraction() const;  ///< 0 to 1
  /// Number of successive best layouts so far.
  int count() const { return count_; }

  /// Length of the best layout; requires count() > 0. [cm]
  double length() const { return roundedUp(best_->length()); }
  const Vec2& origin() const { return origin_; }  ///< origin of the print, from left edge and cut
  /// Per piece, the map from its coordinates to the fabric.
  const std::vector<RigidMotion>& places() const { return places_; }
  /// Free positions of a piece while all others keep theirs, including its current one.
  std::vector<RigidMotion> freePlaces(int piece) const;

  /// Lower bound on the length of layouts with the same start of the print. [cm]
  double bound() const { return roundedUp(bound_); }
  bool isProven() const { return is_proven_; }
  /// Length of the layout without the print; 0 if not requested. [cm]
  double freeLength() const { return free_length_; }
  /// Lengths per phase, and per width of the problem; NaN if a piece does not fit. [cm]
  std::vector<double> phaseLengths() const;
  const std::vector<double>& widthLengths() const { return width_lengths_; }

 private:
  /// A combination of a phase of the print and directions of garments; the best is chosen.
  struct Variant {
    std::size_t phase = 0;
    std::unique_ptr<LayoutSearch> search;
    bool is_done = false;
  };

  explicit Marker(MarkerProblem problem);
  LayFabric fabricOf(double width, double phase) const;
  std::vector<std::vector<int>> naps() const;
  void makeTables();
  void makeVariants();
  void lay();
  /// Makes one step of a search with a budget of `most` reads. Returns false when it is finished.
  bool goOn(LayoutSearch& search, double most);
  void keepBest();
  void beginProof();
  LayFabric fabricOfProof() const;
  bool beginNextProof();
  void take(const LaidPieces& found);
  void prove();
  void layFree();
  void layWidths();
  void fail();
  double budget() const;
  double roundedUp(double length) const;
  double spent() const;

  MarkerProblem problem_;
  PiecesOnBoard pieces_;
  Stage stage_ = Stage::kTables;
  std::optional<Error> error_;
  std::vector<Variant> variants_;
  std::size_t turn_ = 0;  ///< counter that selects the next variant
  int count_ = 0;
  bool is_searched_ = false;  ///< no variant can find a layout shorter than the best
  const LayoutSearch* best_search_ = nullptr;
  std::optional<LaidPieces> best_;
  Vec2 origin_ = Vec2::Zero();
  std::vector<RigidMotion> places_;

  std::unique_ptr<CompleteSearch> proof_;
  int proofs_ = 0;           ///< number of started proofs
  double proof_target_ = 0;  ///< length that the proof excludes. [cm]
  double proof_work_ = 0;    ///< budget of the proof. [rows]
  bool is_of_best_ = false;  ///< the proof excludes any layout shorter than the best
  double tried_length_ = 0;  ///< best length at the last such proof. [cm]
  double bound_ = 0;
  bool is_proven_ = false;

  std::unique_ptr<PiecesOnBoard> free_pieces_;
  std::unique_ptr<LayoutSearch> free_search_;
  double free_length_ = 0;
  std::size_t width_ = 0;
  std::unique_ptr<LayoutSearch> width_search_, narrower_;  ///< searches of this width and of the
                                                           ///< previous one
  std::vector<double> width_lengths_;
  double reads_ = 0;  ///< reads during the current call of advance
};

}  // namespace seamwise
