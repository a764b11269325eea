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

/// Plans of the latest deformation of a meshed pattern, and of the same pattern with fewer mirrors
/// (`freed`); null before the first deformation.
struct MeshPlans {
  std::shared_ptr<FittingPlans> plans, freed;
};

/// A garment sampled and meshed, and its remaining symmetries.
struct Prepared {
  Pattern pattern;
  GarmentSymmetries symmetries;  ///< those that hold
  std::vector<Note> notes;       ///< dropped symmetries, with reasons
  /// Plans of the pattern; must live as long as it.
  std::shared_ptr<MeshPlans> plans;
};

/// The latest mesh, for repeated solves of the same garment. It stays valid if weights, pins, grain
/// or the print change. Reusing it does not change the result.
struct MeshMemo {
  /// All inputs of meshing.
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

/// Samples and meshes the garment of a problem, in steps. Symmetries with contradictory demands on
/// edge lengths (mirrored edges sewn to edges that do not mirror) cannot all hold. As few detected
/// ones as possible are dropped, with a note; requested ones cause an error. The sampling follows
/// the same symmetries whether they are imposed or not, so that figures are comparable.
class Preparation {
 public:
  /// @param problem      must outlive this object
  /// @param symmetries   replace the problem's
  /// @param memo         may be null
  Preparation(const Problem& problem, GarmentSymmetries symmetries, MeshMemo* memo = nullptr);

  /// Works for some milliseconds. Returns false when finished.
  bool advance();
  double fraction() const { return fraction_; }  ///< 0..1, monotone
  /// Returns the mesh; requires that advance() has returned false. Errors: kMesh,
  /// kSymmetryConflict.
  Outcome<Prepared> take();

 private:
  bool begin();
  bool sample();
  bool judge(Outcome<Pattern> ready);
  bool end(Outcome<Pattern> pattern);
  std::optional<Error> enforceRules();

  const Problem& problem_;
  MeshMemo* memo_;
  std::optional<MeshMemo::Inputs> from_;  ///< key of the mesh in the memo
  Prepared made_;                         ///< result of meshing, which depends only on `from_`
  std::vector<Note> rule_notes_;          ///< symmetries that pins or grain contradict
  double edge_length_;                    ///< current edge length, cm
  std::optional<Pattern> sampled_;        ///< garment sampled at the current edge length
  std::optional<Meshing> meshing_;
  std::optional<Error> error_;
  bool begun_ = false, ended_ = false;
  double fraction_ = 0;
};

/// Runs all steps of a preparation with the problem's symmetries.
Outcome<Prepared> prepared(const Problem& problem, MeshMemo* memo = nullptr);

}  // namespace seamwise
