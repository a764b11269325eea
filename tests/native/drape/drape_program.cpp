// Drapes a result in poplin and writes the positions of all vertices, x, y, z in cm as 8 bytes
// each. The module for pages and Node must return the same bytes.
#include <cstdio>
#include <fstream>
#include <sstream>

#include "io/solved_json.h"

int main(int count, char** words) {
  using namespace seamwise;
  if (count != 2) return 2;
  std::stringstream text;
  text << std::ifstream(words[1]).rdbuf();
  Outcome<SolvedGarment> solved = readSolved(text.str(), words[1]);
  if (!solved.ok()) return 2;
  const auto worn = WornGarment::make(std::move(solved).value(), {});
  if (!worn.ok()) return 2;
  Drape& drape = worn.value()->drape();
  while (drape.advance(1)) {
  }
  for (const Vec3& at : drape.positions()) {
    const Vec3 cm = at * 100;
    if (std::fwrite(cm.data(), sizeof(double), 3, stdout) != 3) return 1;
  }
  return 0;
}
