#pragma once
#include <string>
#include <vector>

namespace seamwise {

/// What was dropped or assumed: one sentence for people, and the same as a code with its values,
/// from which a page makes the sentence of another language. The codes are listed in
/// docs/formats.md.
struct Note {
  const char* code;  ///< part of the result file: never renamed
  std::string text;
  std::vector<int> pieces = {};      ///< that it is about; indices in the garment
  std::vector<int> seams = {};       ///< stitch numbers in the garment file
  std::vector<double> numbers = {};  ///< lengths in cm, ratios as they are
};

}  // namespace seamwise
