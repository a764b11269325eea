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

/// A garment sampled and meshed, with what became of its symmetries.
struct Prepared {
  Pattern pattern;
  GarmentSymmetries symmetries;  ///< those that hold
  std::vector<Note> notes;       ///< which ones were dropped, and why
  /// Of the pattern, to be kept for as long as it.
  std::shared_ptr<MeshPlans> plans;
};

/// The mesh that was made last, for whoever solves the same garment again and again: where weights,
/// pins, grain or the print change, it stays. With it or without, results are the same.
struct MeshMemo {
  /// All that meshing depends on.
  struct Inputs {
    Garment garment;
    GarmentSymmetries symmetries;
    double edge_length_cm, max_change_cm;
    bool operator==(const Inputs&) const = default;
  };
  struct Mesh {
    Inputs from;
    Prepared made;
  };
  std::optional<Mesh> last;
};

/// Samples and meshes the garment of a problem, in steps. Symmetries whose demands on edge lengths
/// contradict each other (mirrored edges sewn to edges that do not mirror) cannot all hold: of
/// detected ones the fewest are dropped, with a note; of asked-for ones this is an error. The
/// sampling follows the same symmetries whether they are imposed or not, so that figures compare.
class Preparation {
 public:
  /// @param problem      outlives it
  /// @param symmetries   instead of the problem's
  /// @param memo         may be null
  Preparation(const Problem& problem, GarmentSymmetries symmetries, MeshMemo* memo = nullptr);

  /// Some milliseconds of work. False when there is none left.
  bool advance();
  double fraction() const { return fraction_; }  ///< 0..1, monotone
  /// Once it has ended. Errors: kMesh, kSymmetryConflict.
  Outcome<Prepared> take();

 private:
  bool begin();
  bool sample();
  bool judge(Outcome<Pattern> ready);
  bool end(Outcome<Pattern> pattern);
  std::optional<Error> enforceRules();

  const Problem& problem_;
  MeshMemo* memo_;
  std::optional<MeshMemo::Inputs> from_;  ///< what to remember the mesh by
  Prepared made_;                         ///< what meshing makes, and so depends on `from_` alone
  std::vector<Note> rule_notes_;          ///< symmetries that pins or grain contradict
  double edge_length_;                    ///< cm, the present
  std::optional<Pattern> sampled_;        ///< by the symmetries, at the edge length
  std::optional<Meshing> meshing_;
  std::optional<Error> error_;
  bool begun_ = false, ended_ = false;
  double fraction_ = 0;
};

/// All steps of a preparation with the problem's symmetries.
Outcome<Prepared> prepared(const Problem& problem, MeshMemo* memo = nullptr);

}  // namespace seamwise
