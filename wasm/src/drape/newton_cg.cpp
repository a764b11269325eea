#include "drape/newton_cg.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace seamwise {
namespace {

/// Stiffness of the plane x = 0 relative to a body: cloth that passes the plane crosses its mirror
/// image.
constexpr double kPlaneStiffness = 8;
constexpr double kArmijo = 1e-4;
constexpr int kMostHalvings = 12;
constexpr std::size_t kMostPairs = 6;
constexpr double kLonger = 1.4, kShorter = 0.5;  ///< factors on h_ after full and shortened steps
constexpr double kShortest = 0.2;                ///< minimum h_, as a share of the first step
constexpr double kChangedContacts = 0.01;        ///< share that requires a new factorisation

// Multiplications, counted in the code of the terms.
constexpr double kPerTriangle = 60, kPerTriangleBlocks = 250, kPerHinge = 35, kPerDistance = 80;

}  // namespace

ClothSolver::ClothSolver(const SewnMesh& mesh, const Fabric& fabric, const DistanceField& body,
                         Positions start, ClothOptions options, ClothContacts* contacts)
    : mesh_(&mesh),
      fabric_(&fabric),
      contact_{&body, fabric.offset, options.contact_stiffness},
      options_(std::move(options)),
      contacts_(contacts),
      x_(std::move(start)),
      from_(x_),
      h_(options_.first_step),
      hessian_(mesh.size, mesh.pairs()),
      preconditioner_(mesh.size, mesh.edges()),
      anchors_(mesh.size) {
  preconditioner_.setZero();
  addConstantHessian(mesh, fabric, preconditioner_);
  constant_.assign(preconditioner_.values(), preconditioner_.values() + preconditioner_.nonZeros());
}

void ClothSolver::setFriction(bool on) {
  options_.friction = on;
  std::fill(anchors_.begin(), anchors_.end(), std::nullopt);
}

double ClothSolver::energy() const {
  return membraneEnergy(*mesh_, *fabric_, x_, nullptr, nullptr) +
         bendingEnergy(*mesh_, *fabric_, x_, nullptr, nullptr) +
         gravityEnergy(*mesh_, *fabric_, x_, nullptr) +
         contactEnergy(*mesh_, contact_, x_, nullptr, nullptr);
}

double ClothSolver::weight() const {
  const Positions metre_up(x_.size(), Vec3(0, 1, 0));
  return gravityEnergy(*mesh_, *fabric_, metre_up, nullptr);
}

/// Energy that keeps half a cloth and trouser legs on their side of the plane x = 0.
double ClothSolver::planeEnergy(const Positions& x, Positions* gradient,
                                BlockMatrix* hessian) const {
  double energy = 0;
  for (std::size_t i = 0; i < options_.least_x.size(); ++i) {
    const double least = options_.least_x[i], side = least < 0 ? -1 : 1;
    if (least == 0 || least == ClothOptions::kInPlane) continue;
    const double depth = side * (least - x[i].x()),
                 k = kPlaneStiffness * options_.contact_stiffness * mesh_->area[i];
    if (!(depth > 0)) continue;
    energy += k * depth * depth / 2;
    if (gradient) (*gradient)[i].x() -= side * k * depth;
    if (hessian)
      hessian->add(static_cast<int>(i), static_cast<int>(i), outer(k, {1, 0, 0}, {1, 0, 0}));
  }
  return energy;
}

/// Function that a step minimises: energy, friction, and proximity to the start of the step.
double ClothSolver::merit(const Positions& x, Positions* gradient, BlockMatrix* hessian) {
  operations_ += kPerTriangle * static_cast<double>(mesh_->triangles.size()) +
                 kPerHinge * static_cast<double>(mesh_->hinges.size());
  for (const char near : contact_.near) operations_ += near ? kPerDistance : 0;
  if (hessian)
    operations_ += kPerTriangleBlocks * static_cast<double>(mesh_->triangles.size()) +
                   2 * kPerHinge * static_cast<double>(mesh_->hinges.size());
  double sum = membraneEnergy(*mesh_, *fabric_, x, gradient, hessian) +
               bendingEnergy(*mesh_, *fabric_, x, gradient, hessian) +
               (weighs_ ? gravityEnergy(*mesh_, *fabric_, x, gradient) : 0) +
               contactEnergy(*mesh_, contact_, x, gradient, hessian);
  sum += planeEnergy(x, gradient, hessian);
  if (contacts_) {
    sum += contacts_->energy(x, gradient);
    operations_ += contacts_->cost();
  }
  sum += frictionEnergy(frictions_, options_.friction_threshold, x, gradient, hessian);
  return sum + proximalEnergy(*mesh_, *fabric_, h_, from_, x, gradient, hessian);
}

/// Prepares a step: finds vertices near or in contact with the body, their friction, and the
/// maximum movement of each vertex.
void ClothSolver::lookAround() {
  from_ = x_;
  if (contacts_) {
    contacts_->look(x_);
    operations_ += contacts_->searchCost();
  }
  touching_.assign(mesh_->size, 0), reach_.assign(mesh_->size, options_.farthest);
  contact_.near.assign(mesh_->size, 0);
  if (measured_.empty()) measured_ = x_, distance_.assign(mesh_->size, -1e9);
  frictions_.clear();
  for (int i = 0; i < mesh_->size; ++i) {
    // Distances are approximate: they change by at most twice the distance moved.
    const double least = distance_[i] - 2 * length(Vec3(x_[i] - measured_[i]));
    const double of_interest = std::max(options_.near, kNearBody + 2 * options_.farthest);
    if (least > of_interest) {
      anchors_[i].reset();
      continue;
    }
    contact_.near[i] = 1;
    Vec3 normal;
    const double d = contact_.body->distance(x_[i], &normal);
    measured_[i] = x_[i], distance_[i] = d;
    operations_ += kPerDistance;
    contact_.near[i] = d < of_interest;
    if (d < options_.near) reach_[i] = options_.farthest_near;
    if (d >= fabric_->offset) {
      anchors_[i].reset();
      continue;
    }
    touching_[i] = 1;
    if (!options_.friction) continue;
    if (!anchors_[i]) anchors_[i] = x_[i];
    const double force = options_.contact_stiffness * mesh_->area[i] * (fabric_->offset - d);
    frictions_.push_back({i, fabric_->friction * force, normal / length(normal), *anchors_[i]});
  }
}

/// A slipping vertex drags its anchor along.
void ClothSolver::dragAnchors() {
  for (const Friction& f : frictions_) {
    const Vec3 moved = x_[f.vertex] - f.anchor;
    const Vec3 slip = moved - dot(moved, f.normal) * f.normal;
    const double far = length(slip);
    if (far > options_.friction_threshold)
      anchors_[f.vertex] = f.anchor + (1 - options_.friction_threshold / far) * slip;
  }
}

/// Factorises the preconditioner unless an earlier factorisation is close enough. Returns false on
/// failure.
bool ClothSolver::prepare() {
  int changed = 0, all = 0;
  for (std::size_t i = 0; i < touching_.size(); ++i) {
    all += touching_[i];
    changed += factorised_touching_.empty() || touching_[i] != factorised_touching_[i];
  }
  if (h_ == factorised_h_ && changed <= kChangedContacts * all) return true;
  std::copy(constant_.begin(), constant_.end(), preconditioner_.values());
  for (int i = 0; i < mesh_->size; ++i) {
    const double contact = touching_[i] ? options_.contact_stiffness / 3 : 0;
    preconditioner_.add(i, i, mesh_->area[i] * (fabric_->density / (h_ * h_) + contact));
  }
  factorised_h_ = h_, factorised_touching_ = touching_;
  if (!preconditioner_.factorise()) return false;
  const auto entries = static_cast<double>(preconditioner_.factorNonZeros());
  operations_ += entries * entries / mesh_->size;  // assumes columns of about equal length
  return true;
}

void ClothSolver::mask(Positions& r) const {
  for (std::size_t i = 0; i < options_.held.size(); ++i)
    if (options_.held[i]) r[i] = Vec3::Zero();
  for (std::size_t i = 0; i < options_.least_x.size(); ++i)
    if (options_.least_x[i] == ClothOptions::kInPlane) r[i].x() = 0;
}

void ClothSolver::precondition(Positions& r) {
  preconditioner_.solveThree(r);
  mask(r);
  operations_ += 6 * static_cast<double>(preconditioner_.factorNonZeros()) + 3.0 * mesh_->size;
}

/// Solves H p = -gradient.
Positions ClothSolver::conjugateGradients(const Positions& gradient, int* iterations) {
  Positions p(x_.size(), Vec3::Zero()), r = p, product;
  addScaled(r, -1, gradient);
  Positions z = r;
  precondition(z);
  Positions direction = z;
  double rz = dot(r, z);
  const double enough = options_.accuracy * options_.accuracy * rz;
  for (*iterations = 0; *iterations < options_.most_iterations &&
                        (rz > enough || (*iterations < options_.least_iterations && rz > 0));
       ++*iterations) {
    hessian_.times(direction, product);
    if (contacts_) {
      contacts_->addProduct(x_, direction, product);
      operations_ += contacts_->cost();
    }
    mask(product);
    const double along = rz / dot(direction, product);
    addScaled(p, along, direction);
    addScaled(r, -along, product);
    z = r;
    precondition(z);
    const double next = dot(r, z), beta = next / rz;
    for (std::size_t i = 0; i < z.size(); ++i) direction[i] = z[i] + beta * direction[i];
    rz = next;
    operations_ += 18 * static_cast<double>(hessian_.blocks()) + 15.0 * mesh_->size;
  }
  return p;
}

/// Moves along a direction as far as vertices may move and the merit decreases.
ClothSolver::Step ClothSolver::search(double before, const Positions& gradient,
                                      const Positions& direction) {
  Step step;
  const double slope = dot(gradient, direction);
  double share = 1, longest = 0;
  for (std::size_t i = 0; i < direction.size(); ++i) {
    const double far = length(direction[i]);
    longest = std::max(longest, far);
    if (far * share > reach_[i]) share = reach_[i] / far;
  }
  bool full = share == 1;
  step.failed = !(slope < 0);
  for (int halvings = 0; !step.failed; ++halvings) {
    x_ = from_;
    addScaled(x_, share, direction);
    const double after = merit(x_, nullptr, nullptr);
    if (after <= before + kArmijo * share * slope) {
      step.fall = before - after;
      break;
    }
    step.failed = halvings == kMostHalvings;
    share /= 2, full = false;
  }
  if (step.failed) x_ = from_;
  if (!step.failed) step.farthest = share * longest;
  const double shortest = kShortest * options_.first_step;
  h_ = full ? std::min(kLonger * h_, options_.longest_step) : std::max(kShorter * h_, shortest);
  dragAnchors();
  step.energy = energy();
  return step;
}

ClothSolver::Step ClothSolver::newtonStep() {
  pairs_.clear();
  lookAround();
  if (!prepare()) return {energy(), 0, 0, 0, true};
  Positions gradient(x_.size(), Vec3::Zero());
  hessian_.setZero();
  const double before = merit(x_, &gradient, &hessian_);
  mask(gradient);
  int iterations = 0;
  const Positions direction = conjugateGradients(gradient, &iterations);
  Step step = search(before, gradient, direction);
  step.iterations = iterations;
  return step;
}

ClothSolver::Step ClothSolver::quasiNewtonStep() {
  lookAround();
  if (!prepare()) return {energy(), 0, 0, 0, true};
  Positions gradient(x_.size(), Vec3::Zero());
  const double before = merit(x_, &gradient, nullptr);
  mask(gradient);
  if (!pairs_.empty()) {
    Pair& last = pairs_.back();
    for (std::size_t i = 0; i < x_.size(); ++i) last.turned[i] = gradient[i] - last.turned[i];
    last.product = dot(last.moved, last.turned);
    if (!(last.product > 0)) pairs_.pop_back();
  }
  Positions direction(x_.size(), Vec3::Zero());
  addScaled(direction, -1, gradient);
  std::vector<double> shares(pairs_.size());
  for (std::size_t k = pairs_.size(); k-- > 0;) {
    shares[k] = dot(pairs_[k].moved, direction) / pairs_[k].product;
    addScaled(direction, -shares[k], pairs_[k].turned);
  }
  precondition(direction);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const double back = dot(pairs_[k].turned, direction) / pairs_[k].product;
    addScaled(direction, shares[k] - back, pairs_[k].moved);
  }
  operations_ += 12.0 * mesh_->size * static_cast<double>(pairs_.size());
  const double h = h_;
  Step step = search(before, gradient, direction);
  h_ = h;  // these steps share one matrix
  if (step.failed) {
    pairs_.clear();
    return step;
  }
  Pair pair{x_, gradient, 0};
  addScaled(pair.moved, -1, from_);
  if (pairs_.size() == kMostPairs) pairs_.erase(pairs_.begin());
  pairs_.push_back(std::move(pair));
  return step;
}

}  // namespace seamwise
