#include "drape/terms.h"

#include <algorithm>
#include <cmath>

namespace seamwise {
namespace {

constexpr double kMiddleOffset = 0.5;  ///< share of the offset, where a triangle cuts a curve short

/// Share of the stiffness that remains under compression of gathers, whose folds no triangle has.
constexpr double kGatheredStiffness = 0.002;

/// Value, slope and curvature of k/2 e^2, stiffer beyond Fabric::stiff_from.
struct Spring {
  double value, slope, curvature;
};
Spring spring(const Fabric& fabric, double k, double e, bool gathered) {
  if (gathered && e < 0) k *= kGatheredStiffness;
  Spring s{k * e * e / 2, k * e, k};
  if (const double more = e - fabric.stiff_from; more > 0) {
    const double extra = (fabric.stiffening - 1) * k;
    s.value += extra * more * more / 2, s.slope += extra * more, s.curvature += extra;
  }
  return s;
}

/// Image of a direction given by its derivatives of the hat functions.
struct Thread {
  Vec3 image;
  double stretch;  ///< length of the image
  Vec3 along;      ///< unit
};
Thread threadOf(const SewnMesh::Triangle& t, const std::array<double, 3>& hats,
                const Positions& x) {
  Thread thread{Vec3::Zero(), 0, Vec3::Zero()};
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) thread.image[c] += hats[k] * x[t.vertices[k]][c];
  thread.stretch = length(thread.image);
  if (thread.stretch > 0) thread.along = thread.image / thread.stretch;
  return thread;
}

/// Second derivative of a spring in the thread's image, without negative parts.
Mat3 stiffnessOf(const Thread& thread, const Spring& s) {
  const double across = thread.stretch > 0 ? std::max(0.0, s.slope / thread.stretch) : 0;
  return scalar(across) + outer(s.curvature - across, thread.along, thread.along);
}

double bendingOf(const SewnMesh::Hinge& h, const Fabric& fabric) {
  return kHinge * (h.warp * fabric.bending_warp + (1 - h.warp) * fabric.bending_weft) / h.area;
}

}  // namespace

double membraneEnergy(const SewnMesh& mesh, const Fabric& fabric, const Positions& x,
                      Positions* gradient, BlockMatrix* hessian) {
  double energy = 0;
  for (const SewnMesh::Triangle& t : mesh.triangles) {
    const Thread weft = threadOf(t, t.weft, x), warp = threadOf(t, t.warp, x);
    const double eu = weft.stretch - 1, ev = warp.stretch - 1;
    const Spring su = spring(fabric, fabric.weft, eu, t.gathered_weft),
                 sv = spring(fabric, fabric.warp, ev, t.gathered_warp);
    const double skew = dot(weft.image, warp.image);
    const double coupling = t.gathered_weft || t.gathered_warp ? 0 : fabric.coupling;
    energy += t.area * (su.value + sv.value + coupling * eu * ev + fabric.shear * skew * skew / 2);
    if (gradient) {
      const double fu = t.area * (su.slope + coupling * ev);
      const double fv = t.area * (sv.slope + coupling * eu);
      const double fs = t.area * fabric.shear * skew;
      for (int c = 0; c < 3; ++c) {
        const double by_weft = fu * weft.along[c] + fs * warp.image[c];
        const double by_warp = fv * warp.along[c] + fs * weft.image[c];
        for (int k = 0; k < 3; ++k)
          (*gradient)[t.vertices[k]][c] += by_weft * t.weft[k] + by_warp * t.warp[k];
      }
    }
    if (!hessian) continue;
    const Mat3 ku = stiffnessOf(weft, su), kv = stiffnessOf(warp, sv);
    std::array<Vec3, 3> skewed;
    for (int k = 0; k < 3; ++k) skewed[k] = t.weft[k] * warp.image + t.warp[k] * weft.image;
    for (int k = 0; k < 3; ++k)
      for (int l = k; l < 3; ++l) {
        Mat3 block = outer(t.area * fabric.shear, skewed[k], skewed[l]);
        block += (t.area * t.weft[k] * t.weft[l]) * ku;
        block += (t.area * t.warp[k] * t.warp[l]) * kv;
        hessian->add(t.vertices[k], t.vertices[l], block);
      }
  }
  return energy;
}

double bendingEnergy(const SewnMesh& mesh, const Fabric& fabric, const Positions& x,
                     Positions* gradient, BlockMatrix* hessian) {
  double energy = 0;
  for (const SewnMesh::Hinge& h : mesh.hinges) {
    Vec3 bend = Vec3::Zero();
    for (int k = 0; k < 4; ++k)
      for (int c = h.across_plane ? 1 : 0; c < 3; ++c)
        bend[c] += h.weights[k] * x[h.vertices[k]][c];
    const double stiffness = bendingOf(h, fabric), far = h.folded > 0 ? length(bend) : 0;
    // Share of the force that remains beside a fold's rest; a flat fold has no direction to close.
    const double share = far > 0 ? 1 - h.folded / far : h.folded > 0 ? 0 : 1;
    energy +=
        stiffness * (h.folded > 0 ? (far - h.folded) * (far - h.folded) : dot(bend, bend)) / 2;
    if (gradient)
      for (int k = 0; k < 4; ++k)
        for (int c = 0; c < 3; ++c)
          (*gradient)[h.vertices[k]][c] += share * stiffness * h.weights[k] * bend[c];
    if (!hessian) continue;
    Mat3 directions = scalar(std::max(0.0, share) * stiffness);
    if (far > 0)
      directions += outer((1 - std::max(0.0, share)) * stiffness / (far * far), bend, bend);
    if (h.across_plane && h.folded == 0) directions(0, 0) = 0;
    for (int k = 0; k < 4; ++k)
      for (int l = k; l < 4; ++l)
        hessian->add(h.vertices[k], h.vertices[l], (h.weights[k] * h.weights[l]) * directions);
  }
  return energy;
}

double gravityEnergy(const SewnMesh& mesh, const Fabric& fabric, const Positions& x,
                     Positions* gradient) {
  double energy = 0;
  for (int i = 0; i < mesh.size; ++i) {
    const double weight = fabric.density * mesh.area[i] * kGravity;
    energy += weight * x[i].y();
    if (gradient) (*gradient)[i].y() += weight;
  }
  return energy;
}

double contactEnergy(const SewnMesh& mesh, const BodyContact& contact, const Positions& x,
                     Positions* gradient, BlockMatrix* hessian) {
  double energy = 0;
  const bool derived = gradient || hessian;
  std::vector<double> distances(mesh.size);
  for (int i = 0; i < mesh.size; ++i) {
    if (!contact.near.empty() && !contact.near[i]) {
      distances[i] = 2 * kNearBody;
      continue;
    }
    Vec3 outwards = Vec3::Zero();
    distances[i] = contact.body->distance(x[i], derived ? &outwards : nullptr);
    const double depth = contact.offset - distances[i];
    if (depth <= 0) continue;
    const double k = contact.stiffness * mesh.area[i];
    energy += k * depth * depth / 2;
    if (gradient)
      for (int c = 0; c < 3; ++c) (*gradient)[i][c] -= k * depth * outwards[c];
    if (hessian) hessian->add(i, i, outer(k, outwards, outwards));
  }
  for (const SewnMesh::Triangle& t : mesh.triangles) {
    const auto& [p, q, r] = t.vertices;
    if (distances[p] > kNearBody && distances[q] > kNearBody && distances[r] > kNearBody) continue;
    Vec3 middle = Vec3::Zero(), outwards = Vec3::Zero();
    for (int c = 0; c < 3; ++c) middle[c] = (x[p][c] + x[q][c] + x[r][c]) / 3;
    const double depth = kMiddleOffset * contact.offset -
                         contact.body->distance(middle, derived ? &outwards : nullptr);
    if (depth <= 0) continue;
    const double k = contact.stiffness * t.area;
    energy += k * depth * depth / 2;
    if (gradient)
      for (const int i : t.vertices)
        for (int c = 0; c < 3; ++c) (*gradient)[i][c] -= k * depth * outwards[c] / 3;
    if (!hessian) continue;
    const Mat3 block = outer(k / 9, outwards, outwards);
    for (int m = 0; m < 3; ++m)
      for (int n = m; n < 3; ++n) hessian->add(t.vertices[m], t.vertices[n], block);
  }
  return energy;
}

double frictionEnergy(const std::vector<Friction>& contacts, double threshold, const Positions& x,
                      Positions* gradient, BlockMatrix* hessian) {
  double energy = 0;
  for (const Friction& f : contacts) {
    const Vec3 moved = x[f.vertex] - f.anchor;
    const Vec3 slip = moved - dot(moved, f.normal) * f.normal;
    const double s = length(slip), t = std::min(s / threshold, 1.0);
    energy += f.limit * (s > threshold ? s : threshold * (t * t * (1 - t / 3) + 1.0 / 3));
    // Both eigenvalues of the Hessian: slope over slip, and curvature.
    const double across = f.limit * (s > threshold ? 1 / s : (2 - t) / threshold);
    const double along = f.limit * (s > threshold ? 0 : 2 * (1 - t) / threshold);
    if (gradient)
      for (int c = 0; c < 3; ++c) (*gradient)[f.vertex][c] += across * slip[c];
    if (!hessian) continue;
    Mat3 block = scalar(across) + outer(-across, f.normal, f.normal);
    if (s > 0) block += outer((along - across) / (s * s), slip, slip);
    hessian->add(f.vertex, f.vertex, block);
  }
  return energy;
}

double proximalEnergy(const SewnMesh& mesh, const Fabric& fabric, double h, const Positions& from,
                      const Positions& x, Positions* gradient, BlockMatrix* hessian) {
  double energy = 0;
  for (int i = 0; i < mesh.size; ++i) {
    const double k = fabric.density * mesh.area[i] / (h * h);
    const Vec3 moved = x[i] - from[i];
    energy += k * dot(moved, moved) / 2;
    if (gradient)
      for (int c = 0; c < 3; ++c) (*gradient)[i][c] += k * moved[c];
    if (hessian) hessian->add(i, i, scalar(k));
  }
  return energy;
}

void addConstantHessian(const SewnMesh& mesh, const Fabric& fabric, SparseHessian& matrix) {
  for (const SewnMesh::Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      for (int l = k; l < 3; ++l)
        matrix.add(t.vertices[k], t.vertices[l],
                   t.area * ((fabric.weft + fabric.shear / 2) * t.weft[k] * t.weft[l] +
                             (fabric.warp + fabric.shear / 2) * t.warp[k] * t.warp[l]));
}

}  // namespace seamwise
