#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "deform/fitting_plan.h"
#include "geometry/outcome.h"
#include "pattern/pattern.h"
#include "solve/problem.h"

namespace seamwise {

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
    /// For the pattern, and for it with fewer mirrors; null until it was deformed.
    std::shared_ptr<FittingPlans> plans, freed_plans;
  };
  std::optional<Mesh> last;
};

/// Samples and meshes the garment of a problem. Symmetries whose demands on edge lengths contradict
/// each other (mirrored edges sewn to edges that do not mirror) cannot all hold: of detected ones
/// the fewest are dropped, with a note; of asked-for ones this is an error. The sampling follows
/// the same symmetries whether they are imposed or not, so that figures compare. May shorten
/// problem.imposed and problem.known. Errors: kMesh, kSymmetryConflict.
/// @param memo   may be null
Outcome<Pattern> preparedPattern(Problem& problem, MeshMemo* memo = nullptr);

}  // namespace seamwise
