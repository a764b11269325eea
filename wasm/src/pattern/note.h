#pragma once
#include <string>
#include <vector>

namespace seamwise {

/// A note about something dropped or assumed: an English sentence, and a code with values, from
/// which a page makes the sentence in another language. docs/formats.md lists the codes.
struct Note {
  const char* code;  ///< part of the result file: never rename it
  std::string text;
  std::vector<int> pieces = {};      ///< pieces concerned; indices in the garment
  std::vector<int> seams = {};       ///< seams concerned; stitch numbers in the garment file
  std::vector<double> numbers = {};  ///< lengths in cm; ratios without unit
};

}  // namespace seamwise
