#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "drape/cloth_point.h"
#include "drape/fabric.h"
#include "drape/sewn_mesh.h"
#include "drape/untangling.h"

namespace seamwise {

/// Two points of a cloth that are held together, as by a button or a line of stitches through
/// layers: `b` lies on the face of the cloth at `a`, so far from it.
struct ClothTie {
  ClothPoint a, b;
  double gap = 0;  ///< m
};

/// A piece that lies on the face of another one.
struct Overlap {
  int upper, lower;
  bool operator<(const Overlap& o) const {
    return std::pair(upper, lower) < std::pair(o.upper, o.lower);
  }
};
void sortOverlaps(std::vector<Overlap>& overlaps);

/// What keeps layers of cloth apart, and holds them together: a vertex stays on its side of each
/// triangle nearby, and tied points stay together. Energies of linear springs along directions that
/// a step keeps, so that their Hessian is a sum of products of vectors: in products only, never in
/// a factor. What has crossed can be drawn apart, by constant forces. Keeps a pointer to the mesh.
class ClothContacts {
 public:
  /// @param overlaps   pieces of which the first lies on the face of the second; all others stay
  ///                   on the side of each other that they were first seen on
  /// @param laps       per vertex 1: of a buttoned layer above those of -1; or empty
  /// @param laid       where the cloth was laid to begin with: layers that are one on the other
  ///                   there stay so, m; or empty
  /// @param gap        between layers, m
  ClothContacts(const SewnMesh& mesh, std::vector<Overlap> overlaps, std::vector<ClothTie> ties,
                std::vector<signed char> laps, const Positions& laid, double gap);

  /// Looks for what is near, once in kSearchEach calls, and sets all directions anew.
  void look(const Positions& x);
  /// From now on; ties are always on.
  void setTouching(bool on);
  bool touching() const { return touching_; }
  /// Whether any part of the cloth was laid on another one.
  bool hasLayers() const { return !overlaps_.empty() || !laid_.empty(); }
  /// While it touches, what crosses is drawn apart from now on, and has no side until it is.
  void untangle() { untangling_.emplace(*mesh_); }

  double energy(const Positions& x, Positions* gradient) const;
  /// y += Hessian at x times p
  void addProduct(const Positions& x, const Positions& p, Positions& y) const;
  /// Numbers that a product multiplies, about.
  double cost() const { return 36.0 * static_cast<double>(touches_.size() + tied_.size()); }
  /// What the last search took, in multiplications, about.
  double searchCost() const { return search_cost_; }

 private:
  static constexpr int kSearchEach = 3;
  struct Pair {
    int vertex, triangle;
    double side;        ///< 1: the vertex belongs on the triangle's face, -1: behind it
    bool seen = false;  ///< there, and nothing else says so
    bool operator<(const Pair& o) const {
      return std::pair(vertex, triangle) < std::pair(o.vertex, o.triangle);
    }
  };
  /// A spring that pushes while normal . (x of vertex - point) < gap.
  struct Touch {
    int vertex;
    ClothPoint point;
    Vec3 normal;
    double stiffness;
  };
  struct Tied {
    Vec3 offset;
    double stiffness;
  };

  template <class Meet>
  void forNear(const Positions& x, double near, const Meet& meet) const;
  void lay(const Positions& x);
  void search(const Positions& x);
  void findCrossed(const Positions& x);
  bool isOf(int piece, int vertex) const;
  bool isCrossed(const Pair& pair) const;
  double sideByLaps(int vertex, int triangle) const;
  double sideByOverlaps(int vertex, int triangle) const;
  static double sideAmong(const std::vector<Pair>& pairs, const SewnMesh& mesh, int vertex,
                          int triangle);
  double sideAsLaid(int vertex, int triangle) const;
  double sideByLayers(int vertex, int triangle) const;
  double sideBySight(int vertex, int triangle, const Positions& x) const;
  bool neighbours(int vertex, const std::array<int, 3>& triangle) const;
  double excess(const Touch& touch, const Positions& x) const;

  const SewnMesh* mesh_;
  std::vector<Overlap> overlaps_;         ///< sorted
  std::vector<std::vector<int>> pieces_;  ///< per vertex, those that it is of
  std::vector<ClothTie> ties_;
  std::vector<signed char> laps_;
  double gap_;
  std::vector<std::vector<int>> ring_;  ///< per vertex those that share an edge with it, sorted
  bool touching_ = false;
  int looks_ = 0;
  double search_cost_ = 0;
  std::vector<Pair> laid_;   ///< sorted: of layers, as the cloth was laid
  std::vector<Pair> pairs_;  ///< sorted
  std::vector<Touch> touches_;
  std::vector<Tied> tied_;  ///< by ties_
  std::optional<Untangling> untangling_;
  std::vector<CrossingPull> pulls_;
  std::vector<char> crossed_;  ///< per vertex: of a crossing or beside one; empty: none
};

}  // namespace seamwise
