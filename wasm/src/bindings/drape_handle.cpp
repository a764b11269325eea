#include "bindings/drape_handle.h"

#include <array>

#include "io/json_input.h"

namespace seamwise {
namespace {

constexpr double kFormSpacing = 1.5;  ///< cm; smaller spacing shows no more of a form

constexpr std::array<const char*, kBodyParts> kPartNames = {
    "torso", "neck", "left arm", "right arm", "left leg", "right leg", "head"};

constexpr std::array<const char*, 4> kStageNames = {"sew", "hang", "settle", "done"};

template <class Number, class Point>
void append(std::vector<Number>* flat, const Point& point) {
  for (int c = 0; c < point.size(); ++c) flat->push_back(static_cast<Number>(point[c]));
}

template <class Number, class Points>
val flatValue(const Points& points, double scale = 1) {
  std::vector<Number> flat;
  for (const auto& point : points) append(&flat, (point * scale).eval());
  return copied(flat.size(), flat.data());
}

val indicesValue(const std::vector<int>& indices) {
  const std::vector<std::uint32_t> flat(indices.begin(), indices.end());
  return copied(flat.size(), flat.data());
}

val indicesValue(const std::vector<std::array<int, 3>>& triples) {
  std::vector<std::uint32_t> flat;
  for (const auto& triple : triples) flat.insert(flat.end(), triple.begin(), triple.end());
  return copied(flat.size(), flat.data());
}

template <class List, class Value>
val listValue(const List& list, Value value) {
  val result = val::array();
  for (const auto& item : list) result.call<void>("push", value(item));
  return result;
}

val tripleValue(const Vec3& v) {
  val triple = val::array();
  for (int c = 0; c < 3; ++c) triple.call<void>("push", v[c]);
  return triple;
}

val spreadValue(const DrapeCheck::Spread& spread) {
  val value = val::object();
  value.set("median", spread.median);
  value.set("p99", spread.p99);
  value.set("max", spread.most);
  return value;
}

val fabricValue(const Fabric& fabric) {
  val value = val::object();
  value.set("name", std::string(fabric.name));
  value.set("density", fabric.density);
  value.set("warp", fabric.warp);
  value.set("weft", fabric.weft);
  value.set("coupling", fabric.coupling);
  value.set("shear", fabric.shear);
  value.set("stiffFrom", fabric.stiff_from);
  value.set("stiffening", fabric.stiffening);
  value.set("bendingWarp", fabric.bending_warp);
  value.set("bendingWeft", fabric.bending_weft);
  value.set("friction", fabric.friction);
  value.set("offset", fabric.offset);
  return value;
}

val tubeValue(const Tube& tube, int part) {
  val value = val::object();
  value.set("name", std::string(kPartNames[part]));
  value.set("origin", tripleValue(tube.axis().origin));
  value.set("up", tripleValue(tube.axis().up));
  val sections = val::array();
  constexpr double kApart = 2;  // cm
  const int count = 1 + static_cast<int>((tube.top() - tube.bottom()) / kApart);
  for (int k = 0; k <= count; ++k) {
    const double level = tube.bottom() + (tube.top() - tube.bottom()) * k / count;
    const Section section = tube.section(level);
    val one = val::object();
    one.set("level", level);
    one.set("width", section.width);
    one.set("depth", section.depth);
    one.set("middle", section.middle);
    one.set("square", section.square);
    sections.call<void>("push", one);
  }
  value.set("sections", sections);
  return value;
}

}  // namespace

DrapeHandle::DrapeHandle(const val& request) {
  const auto text = [&](const char* field) { return request[field].as<std::string>(); };
  request_ = {text("result"),
              text("resultName"),
              text("body"),
              text("bodyName"),
              text("fabric"),
              text("size"),
              request["effort"].as<double>(),
              emscripten::convertJSArrayToNumberVector<double>(request["settled"])};
}

void DrapeHandle::hang() {
  const Request request = std::exchange(request_, {});
  name_ = request.result_name;
  Outcome<SolvedGarment> solved = readSolved(request.result, request.result_name);
  WearSettings settings;
  settings.effort = request.effort;
  settings.settled = request.settled;
  for (const Fabric& fabric : kFabrics)
    if (request.fabric == fabric.name) settings.fabric = fabric;
  if (solved.ok() && !request.size.empty()) {
    solved.value().garment.size = request.size;
    solved.value().garment.body.clear();
  }
  if (solved.ok() && !request.body.empty()) {
    auto body = readBody(request.body, request.body_name);
    if (!body.ok())
      error_ = body.error();
    else
      solved.value().garment.body = std::move(body).value();
  }
  if (!solved.ok()) error_ = solved.error();
  if (error_) return;
  stitches_ = static_cast<std::ptrdiff_t>(solved.value().pattern.seams.size());
  auto worn = WornGarment::make(std::move(solved).value(), settings);
  if (!worn.ok()) {
    error_ = inFile(worn.error(), request.result_name);
    return;
  }
  worn_ = std::move(worn).value();
  place_.resize(worn_->order().size());
  for (std::size_t k = 0; k < place_.size(); ++k) place_[worn_->order()[k]] = static_cast<int>(k);
}

bool DrapeHandle::advance(double work) {
  if (error_) return false;
  if (worn_) {
    const bool more = worn_->drape().advance(work);
    if (const auto refusal = worn_->refusal()) error_ = inFile(*refusal, name_);
    return more && !error_;
  }
  hang();
  return !error_;
}

std::string DrapeHandle::stage() const {
  return worn_ ? kStageNames[static_cast<std::size_t>(worn_->drape().stage())] : "";
}

val DrapeHandle::form() const {
  const Form& form = worn_->form();
  val value = val::object(), body = val::object(), parts = val::array();
  for (const MeasureName& measure : kMeasureNames)
    body.set(std::string(measure.name), form.measures().*measure.value);
  const BodyParts covered = worn_->hanging().covered();
  for (int p = 0; p < kBodyParts; ++p)
    if (covered & only(static_cast<BodyPart>(p)))
      parts.call<void>("push", tubeValue(form.tube(static_cast<BodyPart>(p)), p));
  const Surface surface = surfaceOf(form, covered, kFormSpacing);
  val shown = val::object();
  shown.set("vertices", flatValue<float>(surface.vertices));
  shown.set("triangles", indicesValue(surface.triangles));
  value.set("body", body);
  value.set("parts", parts);
  value.set("surface", shown);
  return value;
}

val DrapeHandle::piece(int index) const {
  const SewnLevel& level = this->level();
  const Piece& piece = level.pattern.pieces[index];
  const SolvedGarment& garment = worn_->garment();
  const Shapes shapes = shapesOf(level, garment.pattern, garment.shapes);
  val value = val::object();
  value.set("name", piece.name);
  value.set("rest", flatValue<double>(piece.rest));
  value.set("shape", flatValue<double>(shapes[index]));
  value.set("triangles", indicesValue(piece.triangles));
  value.set("sewn", indicesValue(level.sewn[index]));
  value.set("outline", indicesValue(piece.outline));
  value.set("resultVertices", indicesValue(level.from[index]));
  value.set("grainAngle", garment.garment.panels[index].grain_angle);
  value.set("layer", 0);
  value.set("part", std::string(kPartNames[static_cast<int>(worn_->hanging().parts[index])]));
  return value;
}

val DrapeHandle::mesh() const {
  const SewnLevel& level = this->level();
  const std::vector<int>& order = worn_->order();
  const auto side = [&](const SeamSide& of) {
    val value = val::object();
    value.set("piece", order[of.piece]);
    value.set("vertices", indicesValue(of.vertices));
    return value;
  };
  val value = val::object();
  value.set("pieces", listValue(place_, [&](int index) { return piece(index); }));
  const auto first = level.pattern.seams.begin();
  const std::vector<Seam> of_file(first, first + stitches_);
  value.set("seams", listValue(of_file, [&](const Seam& seam) {
              val sides = val::object();
              sides.set("a", side(seam.a));
              sides.set("b", side(seam.b));
              return sides;
            }));
  const std::vector<Mirror> none;
  const bool symmetric = worn_->drape().isSymmetric();
  value.set("mirrors",
            listValue(symmetric ? level.pattern.mirrors : none, [&](const Mirror& mirror) {
              val one = val::object(), pieces = val::array();
              for (int p : mirror.pieces) pieces.call<void>("push", order[p]);
              one.set("pieces", pieces);
              one.set("image", indicesValue(mirror.image));
              return one;
            }));
  value.set("size", level.size);
  return value;
}

val DrapeHandle::shown() const { return flatValue<float>(worn_->drape().positions(), 100); }
val DrapeHandle::positions() const { return flatValue<double>(worn_->drape().positions(), 100); }

val DrapeHandle::report() const {
  const Drape& drape = worn_->drape();
  val value = val::object(), check = val::object();
  const DrapeCheck& measured = drape.check();
  check.set("gap", 0);
  check.set("depth", measured.depth / kCentimetre);
  check.set("tension", spreadValue(measured.tension));
  check.set("compression", spreadValue(measured.compression));
  check.set("crossings", measured.crossings);
  check.set("moved", drape.moved() / kCentimetre);
  check.set("fromRest", drape.fromRest() / kCentimetre);
  check.set("atRest", drape.isAtRest());
  value.set("check", check);
  value.set("fabric", fabricValue(drape.fabric()));
  value.set("stages", listValue(drape.stages(), [](const Drape::StageReport& stage) {
              val one = val::object();
              one.set("name", std::string(kStageNames[static_cast<std::size_t>(stage.stage)]));
              one.set("vertices", stage.vertices);
              one.set("steps", stage.steps);
              one.set("work", stage.work);
              one.set("energy", listValue(stage.energies, [](double e) { return val(e); }));
              return one;
            }));
  std::vector<Note> notes = drape.notes();
  if (worn_->hanging().by_seams)
    notes.push_back({"drapeBySeams",
                     "The garment's file does not say where its pieces hang; they hang as their "
                     "seams and names have it."});
  value.set("notes", listValue(notes, [](const Note& note) { return val(note.text); }));
  value.set("noteDetails", listValue(notes, [](const Note& note) {
              val one = val::object();
              one.set("code", std::string(note.code));
              one.set("number", note.numbers.empty() ? 0 : note.numbers.front());
              return one;
            }));
  return value;
}

}  // namespace seamwise
