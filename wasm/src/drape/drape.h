#pragma once
#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drape/drape_check.h"
#include "drape/level_cloth.h"
#include "drape/sewn_mesh.h"
#include "pattern/note.h"

namespace seamwise {

/// Garment to be draped.
struct DrapeProblem {
  SewnLevels levels;       ///< meshes of `pattern`
  Pattern pattern;         ///< meshed pattern of a solve
  Shapes shapes;           ///< pieces as cut, cm
  std::vector<Vec2> warp;  ///< per piece: unit vector along the grain line
  Fabric fabric = kPoplin;
  const DistanceField* body = nullptr;  ///< has to outlive the drape
  Positions start;                      ///< vertices of the coarse level wrapped on the body, m
  int other_starts = 0;  ///< number of starts with other waves; the drape keeps one of all
  std::function<Positions(int)> other_start = {};  ///< returns one of these, 0 and above
  Positions settled;  ///< vertices of the fine level from an earlier drape of other shapes, m; if
                      ///< not empty, the drape only settles, starting from these positions alone
  std::vector<MatchLine> matches;  ///< lines that hold pieces together, as drafted
  std::vector<Overlap> overlaps;   ///< upper and lower piece of each overlap
  bool by_band = false;            ///< hangs from the waist: friction holds it from the start
  std::vector<int> legs;           ///< per piece: 1 on the left leg, -1 on the right leg, else 0
  double crotch = -1e9;            ///< m; legs keep to their sides of x = 0 below this height
  ClothOptions options;
  double effort = 1;    ///< factor on closeness to rest and on the maximum number of steps
  double budget = 100;  ///< maximum work, in factorisations of a 90 x 90 grid (ClothSolver::work)
};

/// Drapes a garment: sews it on the coarse mesh, lets it hang there with friction, settles it on
/// the fine mesh, and checks the result. If there are several starts, each hangs for a few steps,
/// and the one with the least energy continues. The result depends on work only, never on time.
class Drape {
 public:
  enum class Stage : std::uint8_t { kSew, kHang, kSettle, kDone };
  struct StageReport {
    Stage stage;
    int vertices, steps;
    double work;                   ///< spent in this stage
    std::vector<double> energies;  ///< J, after every step
  };

  explicit Drape(DrapeProblem problem);
  Drape(const Drape&) = delete;
  Drape& operator=(const Drape&) = delete;

  /// Continues for about the given work. Returns false once the drape is done.
  bool advance(double work);
  Stage stage() const { return stage_; }
  /// Progress, 0 to 1: the larger of the share of the budget and the share of the usual steps.
  double fraction() const { return fraction_; }
  /// Vertices of the current level, m.
  const Positions& positions() const { return (best_.cloth ? best_.cloth : cloth_)->positions(); }
  const SewnLevel& level() const;
  double work() const {
    return spent_ + (cloth_ ? cloth_->work() : 0) + (best_.cloth ? best_.cloth->work() : 0);
  }

  const std::vector<StageReport>& stages() const { return stages_; }
  /// Returns whether the mirrors of the pattern are kept. None are kept in a garment that they do
  /// not cover.
  bool isSymmetric() const { return cloth_->isHalf(); }
  const Fabric& fabric() const { return problem_.fabric; }
  double moved() const { return farthest_; }  ///< largest movement of a vertex in the last step, m
  /// Upper estimate of the distance of the vertices from rest, root mean square, m. It extrapolates
  /// the last steps: each kRestSteps of them lower the energy by a constant share of those before.
  double fromRest() const { return from_rest_; }
  /// Returns whether the vertices are at most kAtRest from rest.
  bool isAtRest() const { return from_rest_ <= kAtRest; }
  static constexpr double kAtRest = 0.005;  ///< m
  /// Valid once the drape is done.
  const DrapeCheck& check() const { return check_; }
  /// Notes for the user, a sentence each. "Still moving by 3 mm" gives the movement in the last
  /// step.
  const std::vector<Note>& notes() const { return notes_; }

 private:
  /// @param from   positions at the start of sewing or settling, m
  void begin(Stage stage, const Positions& from = {});
  void put(const SewnLevel& level, const SewnMesh& mesh, const Positions& from);
  void step();
  std::vector<double> besideEachOther(const SewnLevel& level, const SewnMesh& mesh,
                                      const HeldLayers& held, const Positions& x) const;
  int mostSteps(Stage stage) const;
  double progress() const;
  void watch(double fall);
  void tryNextStart();
  void forgetFall();
  void stiffen();
  bool mend();
  void finish();

  /// Movement over the last few steps.
  struct Since {
    int steps = 0;
    Positions from;   ///< positions at their start
    double fall = 0;  ///< decrease of energy, J
  };

  /// The best of the starts that have hung so far.
  struct Trial {
    std::unique_ptr<LevelCloth> cloth;
    Positions start;
    std::vector<StageReport> stages;
  };

  DrapeProblem problem_;
  Fabric yielding_;     ///< fabric until the cloth has folded
  bool yields_ = true;  ///< the cloth is of that fabric
  SewnMesh coarse_, fine_;
  std::unique_ptr<LevelCloth> cloth_;
  Stage stage_ = Stage::kSew;
  int mended_ = 0;     ///< number of rounds that separated crossings
  int last_step_ = 0;  ///< maximum step count of the stage
  int tried_ = 0;      ///< number of starts that have hung
  Trial best_;         ///< without a cloth unless there are several starts
  Since since_;
  double last_fall_ = 0;  ///< J, in the kRestSteps steps before
  bool settled_ = false;  ///< further steps would hardly lower the energy
  double from_rest_ = 1;
  double fraction_ = 0;
  double farthest_ = 0;  ///< m, in the last step
  double spent_ = 0;     ///< work of the solvers of earlier levels
  double began_ = 0;     ///< work at the start of the stage
  std::vector<StageReport> stages_;
  DrapeCheck check_;
  std::vector<Note> notes_;
};

}  // namespace seamwise
