#include "bindings/photo_handle.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "recognition/cloth/coin.h"

namespace seamwise {
namespace {

constexpr std::array<const char*, 4> kPhotoStages = {"repeat", "light", "symmetry", "symmetry"};
constexpr std::array<const char*, 3> kConfidences = {"sure", "likely", "uncertain"};
constexpr std::array<const char*, 4> kVerdicts = {"has", "almost", "has not", "cannot"};
constexpr std::array<const char*, 4> kPhotoNotes = {"uneven", "differs", "focalLength", "unequal"};

template <class Enum, std::size_t n>
val nameOf(const std::array<const char*, n>& names, Enum value) {
  return val(names[static_cast<std::size_t>(value)]);
}

std::vector<std::uint8_t> bytesOf(const val& list) {
  return emscripten::convertJSArrayToNumberVector<std::uint8_t>(list);
}

std::vector<double> photoNumbers(const val& request, const char* field) {
  return emscripten::convertJSArrayToNumberVector<double>(request[field]);
}

double photoNumber(const val& request, const char* field) { return request[field].as<double>(); }

/// Nothing unless the picture has a size that its bytes fill.
std::optional<PixelView> viewOf(const val& request, const std::vector<std::uint8_t>& bytes) {
  const int width = request["width"].as<int>(), height = request["height"].as<int>();
  constexpr int kMost = 1 << 14;
  if (width < 1 || height < 1 || width > kMost || height > kMost) return std::nullopt;
  if (bytes.size() != 4 * static_cast<std::size_t>(width) * height) return std::nullopt;
  return PixelView{width, height, bytes};
}

Error noPicture() {
  return {Failure::kPicture, "The picture's pixels do not fill its width and height."};
}

std::optional<double> known(double number) {
  return std::isfinite(number) ? std::optional<double>(number) : std::nullopt;
}

/// Ten numbers: the homography row by row, and the lens.
LatticeMap mapOf(const std::vector<double>& numbers, const PixelView& view) {
  LatticeMap map;
  for (int k = 0; k < 9; ++k) map.homography(k / 3, k % 3) = numbers[k];
  map.lens = numbers[9];
  map.middle = Vec2(view.width, view.height) / 2;
  map.radius = std::max(view.width, view.height) / 2.0;
  return map;
}

val mapValue(const LatticeMap& map) {
  std::vector<double> numbers;
  for (int k = 0; k < 9; ++k) numbers.push_back(map.homography(k / 3, k % 3));
  numbers.push_back(map.lens);
  return copied(numbers);
}

PhotoSettings settingsOf(const val& request, const PixelView& view) {
  PhotoSettings settings;
  settings.is_tile = request["isTile"].as<bool>();
  settings.any_edges = request["anyEdges"].as<bool>();
  settings.hints.f35 = known(photoNumber(request, "f35"));
  settings.hints.lengths = {known(photoNumber(request, "w1Cm")),
                            known(photoNumber(request, "w2Cm"))};
  const std::vector<double> between = photoNumbers(request, "between");
  if (between.size() == 5)
    settings.hints.span = {{between[0], between[1]}, {between[2], between[3]}, between[4]};
  const std::vector<double> lattice = photoNumbers(request, "lattice");
  if (lattice.size() == 10) settings.lattice = mapOf(lattice, view);
  if (request["keepsLattice"].as<bool>()) settings.use = GivenLattice::kKeep;
  settings.flatten = photoNumber(request, "flatten");
  return settings;
}

val vectorsValue(const std::array<Vec2, 2>& w) {
  return copied(std::vector<double>{w[0].x(), w[0].y(), w[1].x(), w[1].y()});
}

template <class List, class Value>
val listOf(const List& list, const Value& valueOf) {
  val all = val::array();
  for (const auto& one : list) all.call<void>("push", valueOf(one));
  return all;
}

/// The stretches of an edge that does not meet its copy, flat.
val openValue(const TileEdge& edge, bool is_missing = false) {
  if (is_missing) return copied(std::vector<double>{0, 1});
  std::vector<double> numbers;
  for (const auto& stretch : edge.open)
    numbers.insert(numbers.end(), stretch.begin(), stretch.end());
  return copied(numbers);
}

val seamsValue(const TileSeams& seams) {
  val value = val::object();
  value.set("across", openValue(seams.across, seams.missing_column));
  value.set("up", openValue(seams.up, seams.missing_row));
  value.set("halfDrop", openValue(seams.half_drop));
  value.set("brick", openValue(seams.brick));
  return value;
}

/// Of w1, w2, in their unit.
Mat2 gramOf(const std::vector<double>& w) {
  const Mat2 vectors = (Mat2() << w[0], w[2], w[1], w[3]).finished();
  return vectors.transpose() * vectors;
}

}  // namespace

PhotoHandle::PhotoHandle(const val& request) : bytes_(bytesOf(request["pixels"])) {
  const auto view = viewOf(request, bytes_);
  if (view)
    photo_ = std::make_unique<Photo>(*view, settingsOf(request, *view));
  else
    error_ = noPicture();
}

bool PhotoHandle::advance() {
  if (error_) return false;
  const bool more = photo_->advance();
  error_ = photo_->error();
  return more;
}

val PhotoHandle::stage() const {
  return nameOf(kPhotoStages, photo_ ? photo_->stage() : PhotoStage::kRepeat);
}

val PhotoHandle::report() const {
  const GroupReading& groups = photo_->groups();
  const LatticeReading& lattice = photo_->lattice();
  val value = val::object();
  value.set("group", val(groups.groups[groups.best].group->name.data()));
  value.set("groups", listOf(groups.groups, [&](const GroupVerdict& verdict) {
              val group = val::object();
              group.set("name", val(verdict.group->name.data()));
              group.set("rho", verdict.rho);
              group.set("worst", verdict.worst);
              group.set("verdict", nameOf(kVerdicts, verdict.verdict));
              group.set("map", mapValue(photo_->mapOf(verdict)));
              return group;
            }));
  value.set("vectors", vectorsValue(photo_->vectors()));
  value.set("isScaled", photo_->isScaled());
  value.set("confidence", nameOf(kConfidences, photo_->confidence()));
  value.set("uncertainty", lattice.uncertainty);
  value.set("oneWay", groups.one_way);
  value.set("stripes", groups.stripes);
  value.set("copies", lattice.copies);
  value.set("explained", lattice.explained);
  value.set("others", listOf(photo_->others(),
                             [](const LatticeReading& other) { return mapValue(other.map); }));
  value.set("differing", listOf(photo_->differing(), [](const DifferingRegion& region) {
              const Vec2 low = region.low, high = region.high;
              return copied(std::vector<double>{low.x(), low.y(), high.x(), low.y(), high.x(),
                                                high.y(), low.x(), high.y()});
            }));
  value.set("notes",
            listOf(photo_->notes(), [](PhotoNote note) { return nameOf(kPhotoNotes, note); }));
  value.set("seams", seamsValue(photo_->seams()));
  return value;
}

PhotoTileHandle::PhotoTileHandle(const val& request) : bytes_(bytesOf(request["pixels"])) {
  const auto view = viewOf(request, bytes_);
  const std::vector<double> map = photoNumbers(request, "map");
  const std::vector<double> w = photoNumbers(request, "vectors");
  if (!view || map.size() != 10 || w.size() != 4) {
    error_ = noPicture();
    return;
  }
  PhotoTileSettings settings;
  settings.map = mapOf(map, *view);
  settings.gram = gramOf(w);
  settings.is_tile = request["isTile"].as<bool>();
  settings.flatten = photoNumber(request, "flatten");
  settings.group = findGroup(request["group"].as<std::string>());
  tile_ = std::make_unique<PhotoTile>(*view, settings);
}

val PhotoTileHandle::tile() const {
  const std::vector<std::uint8_t> image = tile_->image();
  val value = val::object();
  value.set("width", tile_->columns());
  value.set("height", tile_->rows());
  value.set("pixels", copied(image.size(), image.data()));
  return value;
}

val knownObjectIn(const val& request) {
  const std::vector<std::uint8_t> bytes = bytesOf(request["pixels"]);
  const auto view = viewOf(request, bytes);
  const std::vector<double> map = photoNumbers(request, "map"),
                            w = photoNumbers(request, "vectors");
  const std::vector<double> at = photoNumbers(request, "at");
  const auto name = request["object"].as<std::string>();
  const auto known = knownObjects();
  const auto object =
      std::find_if(known.begin(), known.end(), [&](const auto& one) { return one.name == name; });
  val value = val::object();
  if (!view || map.size() != 10 || w.size() != 4 || at.size() != 2 || object == known.end()) {
    value.set("failure", failureValue(noPicture()));
    return value;
  }
  const auto found = findObject(*view, mapOf(map, *view), gramOf(w), *object, {at[0], at[1]});
  if (!found.ok()) {
    value.set("failure", failureValue(found.error()));
    return value;
  }
  const std::vector<Vec2>& outline = found.value().outline;
  std::vector<double> numbers;
  for (const Vec2& p : outline) numbers.insert(numbers.end(), {p.x(), p.y()});
  const Vec2 from = outline[0], to = outline[object->round ? outline.size() / 2 : 1];
  value.set("failure", val::null());
  value.set("outline", copied(numbers));
  value.set("between",
            copied(std::vector<double>{from.x(), from.y(), to.x(), to.y(), object->width}));
  value.set("error", found.value().error);
  return value;
}

}  // namespace seamwise
