#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "drape/drape_check.h"
#include "drape/level_cloth.h"
#include "drape/sewn_mesh.h"

namespace seamwise {

/// A garment to be draped.
struct DrapeProblem {
  SewnLevels levels;       ///< of `pattern`
  Pattern pattern;         ///< meshed, as a solve has it
  Shapes shapes;           ///< its pieces as cut, cm
  std::vector<Vec2> warp;  ///< per piece the direction of its grain line, unit
  Fabric fabric = kPoplin;
  const DistanceField* body = nullptr;  ///< outlives the drape
  Positions start;                      ///< of the coarse level's vertices, m: wrapped on the body
  Positions settled;  ///< of the fine level's, m: where an earlier drape of other shapes left them;
                      ///< where given, they are settled anew, from there and nothing else
  std::vector<MatchLine> matches;  ///< lines that hold pieces together, as drafted
  std::vector<Overlap> overlaps;   ///< which pieces lie on which
  bool by_band = false;   ///< hangs from the waist, where friction holds it from the beginning
  std::vector<int> legs;  ///< per piece: 1 on the left leg, -1 on the right one, or 0
  double crotch = -1e9;   ///< m; below it legs keep to their sides of x = 0
  ClothOptions options;
  double effort = 1;    ///< how much closer to rest it goes, and how many more steps it may take
  double budget = 100;  ///< of work, in factorisations of a 90 x 90 grid (ClothSolver::work)
};

/// Drapes a garment: sews it on the coarse mesh, lets it hang there with friction, settles it on
/// the fine mesh, and looks at what came out. What it does depends on work only, never on time.
class Drape {
 public:
  enum class Stage : std::uint8_t { kSew, kHang, kSettle, kDone };
  struct StageReport {
    Stage stage;
    int vertices, steps;
    double work;                   ///< spent in it
    std::vector<double> energies;  ///< J, after every step
  };

  explicit Drape(DrapeProblem problem);
  Drape(const Drape&) = delete;
  Drape& operator=(const Drape&) = delete;

  /// Goes on until about so much work is spent. False once it is done.
  bool advance(double work);
  Stage stage() const { return stage_; }
  /// Of the budget or of the usual course, whichever is further, 0 to 1.
  double fraction() const;
  /// Of the vertices of the level that it works on, m.
  const Positions& positions() const { return cloth_->positions(); }
  const SewnLevel& level() const;
  double work() const { return spent_ + cloth_->work(); }

  const std::vector<StageReport>& stages() const { return stages_; }
  /// Whether the pattern's mirrors are kept: of a garment that they do not cover none are.
  bool isSymmetric() const { return cloth_->isHalf(); }
  const Fabric& fabric() const { return problem_.fabric; }
  double moved() const { return farthest_; }  ///< m that a vertex moved in the last step, at most
  /// Once it is done.
  const DrapeCheck& check() const { return check_; }
  /// What people should know, a sentence each; in "still moving by 3 mm" how far the last step
  /// went.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  /// @param from   where sewing or settling begins
  void begin(Stage stage, const Positions& from = {});
  void put(const SewnLevel& level, const SewnMesh& mesh, const Positions& from);
  void step();
  std::vector<double> besideEachOther(const SewnLevel& level, const SewnMesh& mesh,
                                      const HeldLayers& held, const Positions& x) const;
  int mostSteps(Stage stage) const;
  void watch(double fall);
  bool mend();
  void finish();

  /// The last few steps.
  struct Since {
    int steps = 0;
    Positions from;   ///< where they began
    double fall = 0;  ///< of the energy, J
  };

  DrapeProblem problem_;
  SewnMesh coarse_, fine_;
  std::unique_ptr<LevelCloth> cloth_;
  Stage stage_ = Stage::kSew;
  int mended_ = 0;     ///< times that crossings were sent back
  int last_step_ = 0;  ///< of the stage, at most
  Since since_;
  bool at_rest_ = false;
  double farthest_ = 0;  ///< m, in the last step
  double spent_ = 0;     ///< by solvers of earlier levels
  double began_ = 0;     ///< work at the start of the stage
  std::vector<StageReport> stages_;
  DrapeCheck check_;
  std::vector<std::string> notes_;
};

}  // namespace seamwise
