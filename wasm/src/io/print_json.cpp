#include "io/print_json.h"

#include "io/json_input.h"

namespace seamwise {
namespace {

void checkPresentation(const JsonValue& document, const Place& place) {
  if (const JsonValue image = document.find("image")) text(image, place, "'image'");
  if (const JsonValue cell = document.find("cell")) {
    const std::string word = text(cell, place, "'cell'");
    if (word != "primitive" && word != "rectangular" && word != "centred")
      place.fail(place.shape, "has the unknown cell " + inQuotes(word) +
                                  "; write primitive, rectangular or centred");
  }
  if (const JsonValue fabric = document.find("fabric")) {
    object(fabric, place, "'fabric'");
    if (const JsonValue width = fabric.find("usableWidthCm"))
      if (!(number(width, place, "fabric.usableWidthCm", kMaxCoordinateCm) > 0))
        place.fail(place.number, "has no positive fabric.usableWidthCm; correct it");
  }
}

Outcome<Print> printOf(const JsonValue& document, const Place& place) {
  object(document, place, "content");
  checkFormat(document, place, "seamwise-print", 1);
  const std::string group_name = text(need(document, "group", place), place, "'group'");
  const Vec2 w1 = point(need(document, "w1", place), place, "'w1'");
  const Vec2 w2 = point(need(document, "w2", place), place, "'w2'");
  Outcome<WallpaperGroup> group = WallpaperGroup::make(group_name, w1, w2);
  if (!group.ok()) return inFile(group.error(), place.name);
  Print print{std::move(group).value()};
  if (const JsonValue one_way = document.find("oneWay"))
    print.one_way = boolean(one_way, place, "'oneWay'");
  checkPresentation(document, place);
  return print;
}

}  // namespace

Outcome<Print> readPrint(std::string_view text, const std::string& file) {
  const Place place{file, Failure::kNotAPrint, Failure::kNotAPrint};
  return readDocument<Print>(text, place, printOf);
}

}  // namespace seamwise
