#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "drape/cloth_ties.h"
#include "drape/contacts.h"
#include "drape/half_cloth.h"
#include "drape/newton_cg.h"

namespace seamwise {

/// Cloth of one mesh level during a drape: the whole cloth, or one half of a symmetric one.
class LevelCloth {
 public:
  struct Layers {
    std::vector<Overlap> overlaps;
    HeldLayers held;
    Positions laid;  ///< initial positions of all vertices, m
    double gap = 0;  ///< m, between layers
  };

  /// @param mesh, layers   mesh and layers of the whole cloth
  /// @param image          per vertex: mirror image in x = 0; or empty
  /// @param start          initial positions of all vertices, m
  LevelCloth(const SewnMesh& mesh, const std::vector<int>& image, const Layers& layers,
             const Fabric& fabric, const DistanceField& body, const Positions& start,
             ClothOptions options);
  LevelCloth(const LevelCloth&) = delete;
  LevelCloth& operator=(const LevelCloth&) = delete;

  /// Steps return energies of the whole cloth.
  ClothSolver::Step newtonStep() { return taken(solver_->newtonStep()); }
  ClothSolver::Step quasiNewtonStep() { return taken(solver_->quasiNewtonStep()); }
  void setFriction(bool on) { solver_->setFriction(on); }
  void setWeight(bool on) { solver_->setWeight(on); }
  void setTouching(bool on) { contacts_->setTouching(on); }
  bool hasLayers() const { return contacts_->hasLayers(); }
  void untangle() { contacts_->untangle(); }
  int crossings() const;

  /// Positions of all vertices, m.
  const Positions& positions() const { return x_; }
  double energy() const { return sides() * solver_->energy(); }
  double weight() const { return sides() * solver_->weight(); }
  double work() const { return solver_->work(); }
  bool isHalf() const { return half_.has_value(); }

 private:
  double sides() const { return half_ ? 2 : 1; }
  const SewnMesh& solved() const { return half_ ? half_->mesh : *mesh_; }
  ClothSolver::Step taken(ClothSolver::Step step);
  HeldLayers heldOfHalf(const HeldLayers& held) const;
  std::vector<double> leastX(double gap) const;

  const SewnMesh* mesh_;
  std::optional<HalfCloth> half_;
  std::unique_ptr<ClothContacts> contacts_;
  std::unique_ptr<ClothSolver> solver_;
  Positions x_;
};

}  // namespace seamwise
