#include "bindings/photo_handle.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "photo/fabric/coin.h"
#include "photo/steps/photo.h"
#include "photo/steps/photo_tile.h"

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

Error noPicture() {
  return {Failure::kPicture, "The picture's pixels do not fill its width and height."};
}

std::optional<double> known(double number) {
  return std::isfinite(number) ? std::optional<double>(number) : std::nullopt;
}

/// Reads ten numbers: the homography row by row, and the lens.
LatticeMap mapOf(const std::vector<double>& numbers, const PixelView& view) {
  LatticeMap map;
  for (int k = 0; k < 9; ++k) map.homography(k / 3, k % 3) = numbers[k];
  map.lens = numbers[9];
  map.middle = Vec2(view.width, view.height) / 2;
  map.radius = std::max(view.width, view.height) / 2.0;
  return map;
}

void addNumbers(const LatticeMap& map, std::vector<double>& numbers) {
  for (int k = 0; k < 9; ++k) numbers.push_back(map.homography(k / 3, k % 3));
  numbers.push_back(map.lens);
}

val mapValue(const LatticeMap& map) {
  std::vector<double> numbers;
  addNumbers(map, numbers);
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

/// Flat list of the stretches at which an edge does not meet its copy.
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

/// Inner products of w1 and w2, in the square of their unit.
Mat2 gramOf(const std::vector<double>& w) {
  const Mat2 vectors = (Mat2() << w[0], w[2], w[1], w[3]).finished();
  return vectors.transpose() * vectors;
}

class PhotoWork : public PictureWork {
 public:
  explicit PhotoWork(const val& request) : PictureWork(request) {
    if (check()) photo_ = std::make_unique<Photo>(view(), settingsOf(request, view()));
  }
  bool advance() override {
    if (failed()) return false;
    const bool more = photo_->advance();
    fail(photo_->error());
    return more;
  }
  val stage() const override {
    return nameOf(kPhotoStages, photo_ ? photo_->stage() : PhotoStage::kRepeat);
  }
  double fraction() const override { return photo_ ? photo_->fraction() : 0; }
  val answer() const override;

 private:
  std::unique_ptr<Photo> photo_;
};

val PhotoWork::answer() const {
  const Photo& photo = *photo_;
  const GroupReading& groups = photo.groups();
  const LatticeReading& lattice = photo.lattice();
  val value = val::object();
  value.set("group", val(groups.groups[groups.best].group->name.data()));
  value.set("groups", listOf(groups.groups, [&](const GroupVerdict& verdict) {
              val group = val::object();
              group.set("name", val(verdict.group->name.data()));
              group.set("rho", verdict.rho);
              group.set("worst", verdict.worst);
              group.set("verdict", nameOf(kVerdicts, verdict.verdict));
              group.set("map", mapValue(photo.mapOf(verdict)));
              return group;
            }));
  value.set("vectors", vectorsValue(photo.vectors()));
  value.set("isScaled", photo.isScaled());
  value.set("seenAspect", photo.seenAspect());
  value.set("seenError", photo.seenError());
  value.set("confidence", nameOf(kConfidences, photo.confidence()));
  value.set("uncertainty", lattice.uncertainty);
  value.set("oneWay", groups.one_way);
  value.set("stripes", groups.stripes);
  value.set("copies", lattice.copies);
  value.set("explained", lattice.explained);
  std::vector<double> others, differing;
  for (const LatticeReading& other : photo.others()) addNumbers(other.map, others);
  for (const DifferingRegion& region : photo.differing()) {
    const Vec2 low = region.low, high = region.high;
    differing.insert(differing.end(), {low.x(), low.y(), high.x(), high.y()});
  }
  value.set("others", copied(others));
  value.set("differing", copied(differing));
  value.set("notes",
            listOf(photo.notes(), [](PhotoNote note) { return nameOf(kPhotoNotes, note); }));
  value.set("seams", seamsValue(photo.seams()));
  return value;
}

/// Returns whether the sizes are those of a cell: ten numbers of its map, and four of w1 and w2.
bool isCell(const std::vector<double>& map, const std::vector<double>& w) {
  return map.size() == 10 && w.size() == 4;
}

class PhotoTileWork : public PictureWork {
 public:
  explicit PhotoTileWork(const val& request) : PictureWork(request) {
    const std::vector<double> map = photoNumbers(request, "map");
    const std::vector<double> w = photoNumbers(request, "vectors");
    if (!check(isCell(map, w))) return;
    PhotoTileSettings settings;
    settings.map = mapOf(map, view());
    settings.gram = gramOf(w);
    settings.is_tile = request["isTile"].as<bool>();
    settings.flatten = photoNumber(request, "flatten");
    settings.group = findGroup(request["group"].as<std::string>());
    tile_ = std::make_unique<PhotoTile>(view(), settings);
  }
  bool advance() override { return tile_ && tile_->advance(); }
  val stage() const override { return val("tile"); }
  double fraction() const override { return tile_ ? tile_->fraction() : 0; }
  val answer() const override {
    const std::vector<std::uint8_t> image = tile_->image();
    val value = val::object();
    value.set("width", tile_->columns());
    value.set("height", tile_->rows());
    value.set("pixels", copied(image.size(), image.data()));
    return value;
  }

 private:
  std::unique_ptr<PhotoTile> tile_;
};

class PhotoObjectWork : public PictureWork {
 public:
  explicit PhotoObjectWork(const val& request) : PictureWork(request) {
    const std::vector<double> map = photoNumbers(request, "map");
    const std::vector<double> w = photoNumbers(request, "vectors");
    const std::vector<double> at = photoNumbers(request, "at");
    const auto name = request["object"].as<std::string>();
    for (const KnownObject& known : knownObjects())
      if (known.name == name) object_ = known;
    if (!check(isCell(map, w) && at.size() == 2 && object_.width > 0)) return;
    search_ = std::make_unique<ObjectSearch>(view(), mapOf(map, view()), gramOf(w), object_,
                                             Vec2(at[0], at[1]));
  }
  bool advance() override {
    if (failed()) return false;
    const bool more = search_->advance();
    fail(search_->error());
    return more;
  }
  val stage() const override { return val("object"); }
  double fraction() const override { return search_ ? search_->fraction() : 0; }
  val answer() const override {
    const std::vector<Vec2>& outline = search_->found().outline;
    std::vector<double> numbers;
    for (const Vec2& p : outline) numbers.insert(numbers.end(), {p.x(), p.y()});
    const Vec2 from = outline[0], to = outline[object_.round ? outline.size() / 2 : 1];
    val value = val::object();
    value.set("outline", copied(numbers));
    value.set("between",
              copied(std::vector<double>{from.x(), from.y(), to.x(), to.y(), object_.width}));
    value.set("error", search_->found().error);
    return value;
  }

 private:
  KnownObject object_;
  std::unique_ptr<ObjectSearch> search_;
};

}  // namespace

PictureWork::PictureWork(const val& request)
    : bytes_(bytesOf(request["pixels"])),
      view_{request["width"].as<int>(), request["height"].as<int>(), bytes_} {}

bool PictureWork::check(bool others_hold) {
  constexpr int kMost = 1 << 14;
  const auto [width, height, bytes] = view_;
  const bool is_sized = width > 0 && height > 0 && width <= kMost && height <= kMost &&
                        bytes.size() == 4 * static_cast<std::size_t>(width) * height;
  if (!is_sized || !others_hold) error_ = noPicture();
  return !error_;
}

PictureWork* photoWork(const val& request) { return new PhotoWork(request); }
PictureWork* photoTileWork(const val& request) { return new PhotoTileWork(request); }
PictureWork* photoObjectWork(const val& request) { return new PhotoObjectWork(request); }

}  // namespace seamwise
