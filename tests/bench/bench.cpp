// Reads tasks, one JSON object a line, from the given file or from standard input, and writes one
// JSON object a line.
#include "bench.h"

#include <fstream>
#include <iostream>
#include <map>

namespace seamwise::bench {
namespace {

Json answered(const std::string& line) {
  static const std::map<std::string, Json (*)(const Json&)> kTasks = {
      {"solve", solveTask},   {"mesh", meshTask},     {"factorise", factoriseTask},
      {"starts", startsTask}, {"search", searchTask}, {"edit", editTask},
      {"drape", drapeTask},   {"nest", markerTask}};
  try {
    const Json task = Json::parse(line);
    return kTasks.at(task.at("task").get<std::string>())(task);
  } catch (const std::exception& broken) {
    return {{"failure", broken.what()}};
  }
}

void answer(std::istream& tasks) {
  for (std::string line; std::getline(tasks, line);)
    if (!line.empty()) std::cout << answered(line) << std::endl;
}

}  // namespace
}  // namespace seamwise::bench

int main(int count, char** arguments) {
  if (count < 2) {
    seamwise::bench::answer(std::cin);
    return 0;
  }
  std::ifstream file(arguments[1]);
  if (!file) {
    std::cerr << "There is no file '" << arguments[1] << "'.\n";
    return 2;
  }
  seamwise::bench::answer(file);
}
