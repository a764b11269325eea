#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "base/outcome.h"
#include "drape/drape.h"
#include "drape/form.h"
#include "drape/parts.h"
#include "pattern/garment.h"

namespace seamwise {

/// Garment as returned by a solve.
struct SolvedGarment {
  Garment garment;  ///< placements of its pieces; panels without edges
  Pattern pattern;  ///< drafted and meshed pieces; mirrors have images of outline vertices
  Shapes shapes;    ///< pieces as cut, cm
};

/// Form, fabric and effort of a drape.
struct WearSettings {
  Fabric fabric = kPoplin;
  std::optional<Measures> measures;  ///< default: those of the garment or its size
  double effort = 1;                 ///< DrapeProblem::effort
  double edge = kFineCloth;  ///< cm, edge of the fine mesh's triangles, half of the coarse one's
  /// Vertices from an earlier drape of the garment: x, y, z one after the other, cm; empty: none.
  std::vector<double> settled;
};

/// Garment on its form. Its pieces are draped in the order in which they hang, so the order and
/// names in the file make no difference. All members use that order.
class WornGarment {
 public:
  /// Chooses the form and hangs the pieces around it.
  /// Errors: those of Form::make() and hang(); kMesh, naming the piece.
  static Outcome<std::unique_ptr<WornGarment>> make(SolvedGarment garment,
                                                    const WearSettings& settings);
  WornGarment(const WornGarment&) = delete;
  WornGarment& operator=(const WornGarment&) = delete;

  const Form& form() const { return form_; }
  const Hanging& hanging() const { return hanging_; }
  const SolvedGarment& garment() const { return garment_; }
  const SewnLevels& levels() const { return levels_; }
  /// Per piece: its index in the file.
  const std::vector<int>& order() const { return order_; }
  Drape& drape() { return *drape_; }
  const Drape& drape() const { return *drape_; }
  /// Returns the reason why the current drape is not wearable: kNotAGarment if the garment slides
  /// off the form. Once the drape is done, this includes a garment that is too small for the form
  /// or tangled.
  std::optional<Error> refusal() const;

 private:
  /// Distance from the form in metres.
  class Body : public DistanceField {
   public:
    Body(const Form& form, BodyParts parts) : form_(&form), parts_(parts) {}
    double distance(const Vec3& p, Vec3* gradient) const override;

   private:
    const Form* form_;
    BodyParts parts_;
  };

  WornGarment(SolvedGarment garment, Form form, Hanging hanging, SewnLevels levels,
              std::vector<int> order);
  /// Returns the pattern with the shapes of its pieces as cut.
  Pattern asCut() const;
  Outcome<Positions> startWith(double fold, double* fullness = nullptr) const;

  SolvedGarment garment_;
  Form form_;
  Hanging hanging_;
  SewnLevels levels_;
  std::vector<int> order_;
  Body body_;
  std::unique_ptr<Drape> drape_;
  double top_ = 0;  ///< m, height of the highest vertex at the start
};

}  // namespace seamwise
