#pragma once
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "drape/cloth_point.h"
#include "drape/fabric.h"
#include "drape/sewn_mesh.h"
#include "drape/untangling.h"

namespace seamwise {

/// Two points of a cloth held together by a button or by stitches through layers: `b` is at
/// distance `gap` from `a` on the face side of the cloth.
struct ClothTie {
  ClothPoint a, b;
  double gap = 0;  ///< m
};

/// Piece `upper` covers the face of piece `lower`.
struct Overlap {
  int upper, lower;
  bool operator<(const Overlap& o) const {
    return std::pair(upper, lower) < std::pair(o.upper, o.lower);
  }
};
void sortOverlaps(std::vector<Overlap>& overlaps);

/// Separates layers of cloth and holds tied points together.
/// Every vertex stays on its side of each triangle nearby. The energies are linear springs along
/// directions that are fixed within a step. Their Hessian is therefore a sum of products of
/// vectors, for products only, never for factorisation. Constant forces can separate layers that
/// have crossed. The object keeps a pointer to the mesh.
class ClothContacts {
 public:
  /// @param overlaps   pairs in which the first piece covers the face of the second; all other
  ///                   pieces keep the side of each other on which they were first detected
  /// @param laps       per vertex 1 in the upper layer of a buttoned overlap, -1 in the lower one,
  ///                   else 0; or empty
  /// @param laid       initial positions of the cloth, m; layers that overlap there keep their
  ///                   order; or empty
  /// @param gap        distance between layers, m
  ClothContacts(const SewnMesh& mesh, std::vector<Overlap> overlaps, std::vector<ClothTie> ties,
                std::vector<signed char> laps, const Positions& laid, double gap);

  /// Updates all contact directions; repeats the proximity search once in kSearchEach calls.
  void look(const Positions& x);
  /// Switches contacts of the cloth with itself on or off and discards the current ones; ties are
  /// always active.
  void setTouching(bool on);
  bool touching() const { return touching_; }
  /// Returns whether any part of the cloth was placed on another one.
  bool hasLayers() const { return !overlaps_.empty() || !laid_.empty(); }
  /// Makes later calls of look() separate crossed cloth while contacts are on. Crossed cloth has no
  /// contact side until it is separated.
  void untangle() { untangling_.emplace(*mesh_); }

  double energy(const Positions& x, Positions* gradient) const;
  /// Computes y += H(x) p for the Hessian H.
  void addProduct(const Positions& x, const Positions& p, Positions& y) const;
  /// Estimated multiplications of one product.
  double cost() const { return 36.0 * static_cast<double>(touches_.size() + tied_.size()); }
  /// Estimated multiplications of the last search.
  double searchCost() const { return search_cost_; }

 private:
  static constexpr int kSearchEach = 3;
  struct Pair {
    int vertex, triangle;
    double side;            ///< 1: the vertex belongs on the face of the triangle, -1: behind it
    bool seen = false;      ///< the side comes from positions, not from layers
    bool in_pleat = false;  ///< the side comes from the layers of a pleat
    bool operator<(const Pair& o) const {
      return std::pair(vertex, triangle) < std::pair(o.vertex, o.triangle);
    }
  };
  /// Spring that pushes while normal . (x of vertex - point) < gap.
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

  /// Strips of a vertex's triangles in pleated pieces: one, two of which the second is larger, or
  /// more.
  struct Strips {
    int low = 0, high = 0;
    int layers = 0;  ///< twice the mean layer of both
    bool more = false;
    void add(const SewnMesh::Triangle& t);
  };

  template <class Meet>
  void forNear(const Positions& x, double near, const Meet& meet) const;
  void lay(const Positions& x);
  void findNormals(const Positions& x);
  void search(const Positions& x);
  void findCrossed(const Positions& x);
  bool isOf(int piece, int vertex) const;
  bool isCrossed(const Pair& pair) const;
  double sideByLaps(int vertex, int triangle) const;
  double sideByOverlaps(int vertex, int triangle) const;
  static double sideAmong(const std::vector<Pair>& pairs, const SewnMesh& mesh, int vertex,
                          int triangle);
  bool holdsInPleat(const Pair& pair, const Vec3& normal, const Vec3& off) const;
  double sideInPleats(int vertex, int triangle) const;
  double sideAsLaid(int vertex, int triangle) const;
  double sideByLayers(int vertex, int triangle) const;
  double sideBySight(int vertex, int triangle, const Positions& x) const;
  bool neighbours(int vertex, const std::array<int, 3>& triangle) const;
  double excess(const Touch& touch, const Positions& x) const;

  const SewnMesh* mesh_;
  std::vector<Overlap> overlaps_;         ///< sorted
  std::vector<std::vector<int>> pieces_;  ///< per vertex: pieces that contain it, sorted
  std::vector<ClothTie> ties_;
  std::vector<signed char> laps_;
  double gap_;
  std::vector<std::vector<int>> ring_;  ///< per vertex: neighbours along edges, sorted
  std::vector<Strips> strips_;          ///< per vertex
  bool pleated_ = false;
  std::vector<Vec3> normals_;          ///< per vertex of a pleated cloth, in the last look()
  const Positions* looked_ = nullptr;  ///< positions during look()
  bool touching_ = false;
  int looks_ = 0;
  double search_cost_ = 0;
  std::vector<Pair> laid_;   ///< layers in the initial positions, sorted
  std::vector<Pair> pairs_;  ///< sorted
  std::vector<Touch> touches_;
  std::vector<Tied> tied_;  ///< parallel to ties_
  std::optional<Untangling> untangling_;
  std::vector<CrossingPull> pulls_;
  std::vector<char> crossed_;  ///< per vertex: part of a crossing or next to one; empty: none
};

}  // namespace seamwise
