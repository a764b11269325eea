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

/// A garment as a solve leaves it.
struct SolvedGarment {
  Garment garment;  ///< how its pieces are worn; panels without edges
  Pattern pattern;  ///< as drafted and meshed; mirrors have images of outline vertices
  Shapes shapes;    ///< as cut, cm
};

/// What a garment is worn on, and of what cloth it is.
struct WearSettings {
  Fabric fabric = kPoplin;
  std::optional<Measures> measures;  ///< of the form; else the garment's own, or those of its size
  double effort = 1;                 ///< DrapeProblem::effort
  double edge = kFineCloth;          ///< cm, of the fine mesh's triangles; half of the coarse one's
  /// Where an earlier drape of the garment left its cloth, x, y, z after each other, cm; empty:
  /// none
  std::vector<double> settled;
};

/// A garment on its form. Its pieces are draped in the order in which they hang, so that the order
/// and names of the file make no difference; everything here has that order.
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
  /// Which piece of the file a piece is.
  const std::vector<int>& order() const { return order_; }
  Drape& drape() { return *drape_; }
  const Drape& drape() const { return *drape_; }
  /// Why what came out so far is not worn by anybody: kNotAGarment when the garment slides off the
  /// form or, once it is done, is torn on it or lies in a tangle.
  std::optional<Error> refusal() const;

 private:
  /// The form's distance in metres.
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

  SolvedGarment garment_;
  Form form_;
  Hanging hanging_;
  SewnLevels levels_;
  std::vector<int> order_;
  Body body_;
  std::unique_ptr<Drape> drape_;
  double top_ = 0;  ///< where the start's highest vertex is, m
};

}  // namespace seamwise
