#include "io/garment_document.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "io/garment_json.h"
#include "io/json_ends.h"
#include "io/json_writer.h"

namespace seamwise {
namespace {

/// Maps points of the file to the frame of the document.
struct Frame {
  double cm = 1;          ///< centimetres per unit
  bool mirrored = false;  ///< the file shows the back, so x is negated

  Vec2 operator()(const JsonValue& point) const {
    const double x = cm * point[0].number();
    return {mirrored ? 0 - x : x, cm * point[1].number()};
  }
};

void putLine(JsonWriter& out, const JsonValue& line, const Frame& frame) {
  out.openList();
  for (const JsonValue& point : line.items()) out.put(frame(point));
  out.close();
}

/// True if a space-separated list contains a name.
bool isOneOf(std::string_view list, std::string_view name) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(' '), list.size());
    if (list.substr(0, end) == name) return true;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return false;
}

/// Selects the listed members to copy. kTexts skips other values: a label of the wrong type is no
/// reason to reject a file.
enum class Copied : std::uint8_t { kAll, kTexts };

/// Copies the listed members of `object`.
void copyMembers(JsonWriter& out, const JsonValue& object, std::string_view listed,
                 Copied copied = Copied::kAll) {
  for (const auto& [name, value] : object.members())
    if (isOneOf(listed, name) && !value.isNull() && (copied == Copied::kAll || value.isText()))
      out.field(name, value);
}

/// Copies all other members, if any, into an object called `as`.
void copyOthers(JsonWriter& out, const JsonValue& object, std::string_view listed,
                std::string_view as = "more") {
  bool any = false;
  for (const auto& [name, value] : object.members()) {
    if (isOneOf(listed, name)) continue;
    if (!std::exchange(any, true)) {
      out.key(as);
      out.openObject();
    }
    out.field(name, value);
  }
  if (any) out.close();
}

/// @param cm   centimetres per unit of the file
void writeAllowance(JsonWriter& out, const JsonValue& allowance, double cm) {
  if (!allowance) return;
  out.key("allowance");
  out.openObject();
  out.field("width", cm * (allowance.isNumber() ? allowance : allowance.find("width")).number());
  copyMembers(out, allowance, "corner");
  out.close();
}

/// @param edges      the loop in the file
/// @param reversed   the file lists its edges in the opposite order
void writeLoop(JsonWriter& out, const std::vector<Curve>& loop, const JsonValue& edges,
               bool reversed, double cm) {
  out.openList();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Curve& curve = loop[k];
    const JsonValue edge = edges[reversed ? loop.size() - 1 - k : k];
    out.openObject();
    out.field("points", curve.points());
    if (curve.circular()) {
      out.field("radius", curve.radius());
      out.field("sweep", curve.sweep());
    }
    copyMembers(out, edge, "label", Copied::kTexts);
    writeAllowance(out, edge.find("allowance"), cm);
    if (edge.find("open").isTrue()) out.field("open", true);
    copyOthers(out, edge, "endpoints curvature label allowance open");
    out.close();
  }
  out.close();
}

/// Writes the members of an object with its line, if any, in the frame of the face-up piece.
void writeLined(JsonWriter& out, const JsonValue& object, std::string_view listed,
                const Frame& frame) {
  out.openObject();
  if (const JsonValue line = object.find("line")) {
    out.key("line");
    putLine(out, line, frame);
  }
  copyMembers(out, object, listed);
}

void writeGrain(JsonWriter& out, const JsonValue& json, const Frame& frame) {
  if (const JsonValue grain = json.find("grain")) {
    out.key("grain");
    writeLined(out, grain, "lock toleranceDeg", frame);
    out.close();
  }
  if (const JsonValue grains = json.find("grains")) {
    out.key("grains");
    out.openList();
    for (const JsonValue& grain : grains.items()) {
      writeLined(out, grain, "name angleDeg", frame);
      copyOthers(out, grain, "line name angleDeg");
      out.close();
    }
    out.close();
  }
}

void writeFolds(JsonWriter& out, const JsonValue& json, const std::vector<Fold>& folds) {
  if (folds.empty()) return;
  const auto line = [&](const char* name, const Fold::Line& ends) {
    out.key(name);
    out.openList();
    for (const Vec2& end : ends) out.put(end);
    out.close();
  };
  out.key("folds");
  out.openList();
  for (std::size_t k = 0; k < folds.size(); ++k) {
    out.openObject();
    line("line", folds[k].line);
    if (json[k].find("to")) line("to", folds[k].to);
    copyMembers(out, json[k], "kind");
    copyOthers(out, json[k], "line to kind");
    out.close();
  }
  out.close();
}

/// Rotation of a panel after its x axis is negated, in degrees: R(rotation) = R(returned value) F
/// on the panel's plane.
Vec3 turnedOver(const Vec3& rotation) {
  return {0 - rotation.x(), rotation.y() + 180, rotation.z()};
}

void writePlacement(JsonWriter& out, const JsonValue& panel, const Frame& frame) {
  const JsonValue translation = panel.find("translation"), rotation = panel.find("rotation");
  if (!translation && !rotation) return;
  const auto triple = [](const JsonValue& of) {
    return Vec3(of[0].number(), of[1].number(), of[2].number());
  };
  const auto put = [&](const char* name, const Vec3& v) { out.field(name, v); };
  out.key("placement");
  out.openObject();
  put("translation", translation ? Vec3(frame.cm * triple(translation)) : Vec3(Vec3::Zero()));
  if (rotation || frame.mirrored)
    put("rotation", frame.mirrored ? turnedOver(triple(rotation)) : triple(rotation));
  out.close();
}

void writePiece(JsonWriter& out, const JsonValue& json, const Panel& panel, double cm) {
  const Frame frame{cm, panel.mirrored_from_input};
  out.openObject();
  out.field("name", panel.name);
  out.field("mirroredFromInput", panel.mirrored_from_input);
  out.key("outline");
  writeLoop(out, panel.edges, json.find("edges"), false, cm);
  out.key("holes");
  out.openList();
  const JsonValue holes = json.find("holes");
  for (std::size_t h = 0; h < panel.holes.size(); ++h)
    writeLoop(out, panel.holes[h], holes[h], panel.hole_reversed[h], cm);
  out.close();
  out.key("internalLines");
  out.openList();
  for (const JsonValue& line : json.find("internalLines").items()) putLine(out, line, frame);
  out.close();
  for (const char* name : {"cutLine", "sewLine", "drillHoles"})
    if (const JsonValue line = json.find(name)) {
      out.key(name);
      putLine(out, line, frame);
    }
  writeFolds(out, json.find("folds"), panel.folds);
  writeGrain(out, json, frame);
  writePlacement(out, json, frame);
  copyMembers(out, json, "notches quantity size material");
  copyMembers(out, json, "label", Copied::kTexts);
  copyOthers(out, json,
             "vertices edges holes internalLines cutLine sewLine drillHoles folds grain grains "
             "translation rotation notches label quantity size material");
  out.close();
}

void writeSeam(JsonWriter& out, const Stitch& stitch, const JsonValue& described) {
  const auto side = [&](const char* name, const EdgeRef& of) {
    out.key(name);
    out.openObject();
    out.field("piece", of.piece);
    out.field("edge", of.edge);
    out.close();
  };
  out.openObject();
  side("a", stitch.a);
  side("b", stitch.b);
  out.field("sameDirection", stitch.same_direction);
  out.field("weight", stitch.weight);
  out.field("matched", stitch.matched);
  copyMembers(out, described, "name lengthRatio");
  if (described.find("suggested").isTrue()) out.field("suggested", true);
  copyOthers(out, described, "stitch weight matched direction name lengthRatio suggested");
  out.close();
}

class DocumentWriter {
 public:
  DocumentWriter(const JsonValue& json, const GarmentFile& file) : json_(json), file_(file) {}

  std::string write() {
    out_.openObject();
    writePieces();
    writeSeams();
    out_.key("matches");
    out_.openList();
    for (const JsonValue& match : json_.find("matches").items()) writeMatch(match);
    out_.close();
    out_.key("symmetries");
    out_.openList();
    for (const JsonValue& symmetry : json_.find("symmetries").items()) writeSymmetry(symmetry);
    out_.close();
    copyMembers(out_, json_, "title size", Copied::kTexts);
    copyMembers(out_, json_, "names");
    copyOthers(out_, json_, "format pattern properties seams matches symmetries title size names");
    copyOthers(out_, json_.find("pattern"), "panels stitches", "morePattern");
    copyOthers(out_, json_.find("properties"), "units_in_meter curvature_coords", "moreProperties");
    writeQuestions();
    out_.close();
    return textOf(out_.take());
  }

 private:
  void writePieces() {
    out_.key("pieces");
    out_.openList();
    std::size_t p = 0;
    for (const auto& [name, panel] : json_.find("pattern").find("panels").members())
      writePiece(out_, panel, file_.garment.panels[p++], file_.unit_cm);
    out_.close();
  }

  void writeSeams() {
    const std::vector<Stitch>& stitches = file_.garment.stitches;
    std::vector<JsonValue> described(stitches.size());
    for (const JsonValue& seam : json_.find("seams").items())
      described[static_cast<std::size_t>(seam.find("stitch").number())] = seam;
    out_.key("seams");
    out_.openList();
    for (std::size_t s = 0; s < stitches.size(); ++s) writeSeam(out_, stitches[s], described[s]);
    out_.close();
  }

  /// Frame for points that are in centimetres regardless of the file's unit.
  Frame frameOf(const std::string& piece) const {
    const int found = file_.garment.find(piece);
    return {1, found >= 0 && file_.garment.panels[found].mirrored_from_input};
  }

  void writeMatch(const JsonValue& match) {
    out_.openObject();
    for (const char* side : {"a", "b"}) {
      const JsonValue of = match.find(side);
      out_.key(side);
      out_.openObject();
      copyMembers(out_, of, "piece");
      out_.key("line");
      putLine(out_, of.find("line"), frameOf(of.find("piece").text()));
      out_.close();
    }
    copyMembers(out_, match, "weight name");
    copyOthers(out_, match, "a b weight name");
    out_.close();
  }

  void writeSymmetry(const JsonValue& symmetry) {
    out_.openObject();
    copyMembers(out_, symmetry, "kind piece pieces seams");
    if (const JsonValue axis = symmetry.find("axis")) {
      out_.key("axis");
      putLine(out_, axis, frameOf(symmetry.find("piece").text()));
    }
    out_.close();
  }

  /// Adds a question about the unit of length if it gives the garment an unwearable size.
  void writeQuestions() {
    out_.key("questions");
    out_.openList();
    double tallest = 0;
    for (const Panel& panel : file_.garment.panels) {
      double low = HUGE_VAL, high = -HUGE_VAL;
      for (const Curve& edge : panel.edges)
        for (const Vec2& p : edge.flattened(0.1))
          low = std::min(low, p.y()), high = std::max(high, p.y());
      tallest = std::max(tallest, high - low);
    }
    if (!isWearable(tallest)) {
      out_.openObject();
      out_.field("about", "units");
      out_.field("tallestCm", tallest);
      out_.list("likely", likelyUnits(tallest, 100 / file_.unit_cm),
                [&](const LengthUnit& unit) { out_.put(unit.name); });
      out_.close();
    }
    out_.close();
  }

  JsonValue json_;
  const GarmentFile& file_;
  JsonWriter out_;
};

}  // namespace

Outcome<std::string> garmentDocument(std::string_view text, const std::string& file) {
  return readDocument<std::string>(
      text, garmentPlace(file), [](const JsonValue& json, const Place& place) {
        const GarmentFile read = readGarmentFile(json, place);
        return place.failed() ? std::string() : DocumentWriter(json, read).write();
      });
}

}  // namespace seamwise
