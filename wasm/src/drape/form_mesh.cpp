#include "drape/form_mesh.h"

#include <cmath>
#include <utility>

namespace seamwise {
namespace {

// Meshes the left half x >= 0 of the surface; each cell is split into six tetrahedra around one
// diagonal.
class MarchingTetrahedra {
 public:
  MarchingTetrahedra(const Form& form, BodyParts parts, double spacing)
      : form_(form), parts_(parts), spacing_(spacing) {
    const Measures& m = form.measures();
    count_ = {static_cast<int>(std::ceil((m.shoulder_width / 2 + m.arm_length + 20) / spacing)),
              static_cast<int>(std::ceil((form.napeHeight() + 40) / spacing)),
              static_cast<int>(std::ceil(80 / spacing))};
    values_.resize(std::size_t(count_[0] + 1) * (count_[1] + 1) * (count_[2] + 1));
    last_cut_.assign(values_.size(), -1);
    for (int i = 0; i <= count_[0]; ++i)
      for (int j = 0; j <= count_[1]; ++j)
        for (int k = 0; k <= count_[2]; ++k)
          values_[index(i, j, k)] = form.distance(place(index(i, j, k)), parts, nullptr);
  }

  Surface run() {
    for (int i = 0; i < count_[0]; ++i)
      for (int j = 0; j < count_[1]; ++j)
        for (int k = 0; k < count_[2]; ++k) cutCell(i, j, k);
    return std::move(surface_);
  }

 private:
  int index(int i, int j, int k) const { return (i * (count_[1] + 1) + j) * (count_[2] + 1) + k; }
  Vec3 place(int at) const {
    const int k = at % (count_[2] + 1), j = at / (count_[2] + 1) % (count_[1] + 1);
    const int i = at / (count_[2] + 1) / (count_[1] + 1);
    return {i * spacing_, j * spacing_, k * spacing_ - 40};
  }

  void cutCell(int i, int j, int k) {
    int corner[8];
    bool inside = false, outside = false;
    for (int c = 0; c < 8; ++c) {
      corner[c] = index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
      (values_[corner[c]] < 0 ? inside : outside) = true;
    }
    if (!inside || !outside) return;
    constexpr int kPaths[6][2] = {{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}};
    for (const auto& path : kPaths)
      cutTetrahedron({corner[0], corner[path[0]], corner[path[1]], corner[7]});
  }

  void cutTetrahedron(const std::array<int, 4>& corner) {
    std::vector<int> in, out;
    for (int c : corner) (values_[c] < 0 ? in : out).push_back(c);
    if (in.empty() || out.empty()) return;
    if (in.size() == 2) {
      const int a = cut(in[0], out[0]), b = cut(in[0], out[1]);
      const int c = cut(in[1], out[1]), d = cut(in[1], out[0]);
      add(a, b, c, in, out);
      add(a, c, d, in, out);
    } else {
      const bool one_in = in.size() == 1;
      const int tip = one_in ? in[0] : out[0];
      const std::vector<int>& base = one_in ? out : in;
      add(cut(tip, base[0]), cut(tip, base[1]), cut(tip, base[2]), in, out);
    }
  }

  void add(int a, int b, int c, const std::vector<int>& in, const std::vector<int>& out) {
    const std::vector<Vec3>& x = surface_.vertices;
    const Vec3 normal = crossProduct(x[b] - x[a], x[c] - x[a]);
    // Vector from the inner corners to the outer ones.
    Vec3 outward = Vec3::Zero();
    for (int v : out) outward += place(v) * static_cast<double>(in.size());
    for (int v : in) outward -= place(v) * static_cast<double>(out.size());
    if (dot(normal, outward) < 0) std::swap(b, c);
    surface_.triangles.push_back({a, b, c});
  }

  // Returns the surface vertex on the edge between two grid points on opposite sides of the
  // surface.
  int cut(int a, int b) {
    if (a > b) std::swap(a, b);
    for (int vertex = last_cut_[a]; vertex >= 0; vertex = cuts_[vertex].before)
      if (cuts_[vertex].to == b) return vertex;
    cuts_.push_back({b, last_cut_[a]});
    last_cut_[a] = static_cast<int>(surface_.vertices.size());
    Vec3 low = place(values_[a] < 0 ? a : b), high = place(values_[a] < 0 ? b : a);
    for (int step = 0; step < 24; ++step) {
      const Vec3 middle = (low + high) / 2;
      (form_.distance(middle, parts_, nullptr) < 0 ? low : high) = middle;
    }
    surface_.vertices.push_back((low + high) / 2);
    return last_cut_[a];
  }

  const Form& form_;
  BodyParts parts_;
  double spacing_;
  std::array<int, 3> count_;
  std::vector<double> values_;
  struct Cut {
    int to;      ///< grid point at the other end of the edge
    int before;  ///< previous vertex on an edge from the same grid point, or -1
  };
  std::vector<Cut> cuts_;      ///< per vertex of the surface
  std::vector<int> last_cut_;  ///< per grid point: latest vertex on an edge from it, or -1
  Surface surface_;
};

}  // namespace

Surface surfaceOf(const Form& form, BodyParts parts, double spacing) {
  Surface surface = MarchingTetrahedra(form, parts, spacing).run();
  const int vertices = static_cast<int>(surface.vertices.size());
  const int triangles = static_cast<int>(surface.triangles.size());
  std::vector<int> image(vertices);
  for (int v = 0; v < vertices; ++v) {
    const Vec3 p = surface.vertices[v];
    image[v] = v;
    if (p.x() == 0) continue;
    image[v] = static_cast<int>(surface.vertices.size());
    surface.vertices.push_back(mirrored(p));
  }
  for (int t = 0; t < triangles; ++t) {
    const auto [a, b, c] = surface.triangles[t];
    surface.triangles.push_back({image[a], image[c], image[b]});
  }
  return surface;
}

}  // namespace seamwise
