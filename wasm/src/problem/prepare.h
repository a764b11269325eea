#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/outcome.h"
#include "deform/fitting_plan.h"
#include "mesh/mesh.h"
#include "pattern/pattern.h"
#include "problem/problem.h"

namespace seamwise {

/// What the pattern of a mesh, and the same with fewer mirrors, was deformed by last; null until
/// then.
struct MeshPlans {
  std::shared_ptr<FittingPlans> plans, freed;
};

/// The mesh that was made last, for whoever solves the same garment again and again: where weights,
/// pins, grain or the print change, it stays. With it or without, results are the same.
struct MeshMemo {
  /// All that meshing depends on.
  struct Inputs {
    Garment garment;
    std::vector<BodySymmetry> imposed, known;
    bool symmetries_optional;
    double edge_length_cm, max_change_cm;
    bool operator==(const Inputs&) const = default;
  };
  struct Mesh {
    Inputs from;
    Pattern pattern;
    std::vector<BodySymmetry> imposed, known;  ///< that were left
    std::vector<Note> notes;                   ///< that were added
    std::shared_ptr<MeshPlans> plans;
  };
  std::optional<Mesh> last;
};

/// Samples and meshes the garment of a problem, in steps. Symmetries whose demands on edge lengths
/// contradict each other (mirrored edges sewn to edges that do not mirror) cannot all hold: of
/// detected ones the fewest are dropped, with a note; of asked-for ones this is an error. The
/// sampling follows the same symmetries whether they are imposed or not, so that figures compare.
/// May shorten problem.imposed and problem.known.
class Preparation {
 public:
  /// @param problem   outlives it
  /// @param memo      may be null
  explicit Preparation(Problem& problem, MeshMemo* memo = nullptr);

  /// Some milliseconds of work. False when there is none left.
  bool advance();
  double fraction() const { return fraction_; }  ///< 0..1, monotone
  /// Once it has ended. Errors: kMesh, kSymmetryConflict.
  Outcome<Pattern> take() { return *std::move(pattern_); }
  /// Of the pattern, to be kept for as long as it: another mesh may be the last by then.
  std::shared_ptr<MeshPlans> plans() const { return plans_; }

 private:
  bool begin();
  bool sample();
  bool judge(Outcome<Pattern> ready);
  bool end(Outcome<Pattern> pattern);

  Problem& problem_;
  MeshMemo* memo_;
  std::optional<MeshMemo::Inputs> from_;  ///< what to remember the mesh by
  std::size_t notes_ = 0;                 ///< before
  double edge_length_;                    ///< cm, the present
  std::optional<Pattern> sampled_;        ///< by the symmetries, at the edge length
  std::optional<Meshing> meshing_;
  std::optional<Outcome<Pattern>> pattern_;
  std::shared_ptr<MeshPlans> plans_ = std::make_shared<MeshPlans>();
  bool begun_ = false;
  double fraction_ = 0;
};

/// All steps of a preparation.
Outcome<Pattern> preparedPattern(Problem& problem, MeshMemo* memo = nullptr);

}  // namespace seamwise
