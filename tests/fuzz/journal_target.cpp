#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <sstream>

#include "engine/study/journal.h"
#include "tests/fuzz/target.h"

namespace plumb::fuzz {
namespace {

const StudyIdentity identity{"of-the-target", "case.toml", "the program"};

std::string journal_heading() {
  const MemoryFile file("heading");
  Journal(file.hold(""), identity);
  return file.text();
}

/// Each line with the check sum that a journal asks of it.
std::string mended(std::string_view lines) {
  std::string result;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    const std::string line(lines.substr(0, end)), summed = journal_heading() + line;
    const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(summed.data()), summed.size());
    result += fmt::format("{:08x} {}\n", sum, line);
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return result;
}

/// What a journal says that has these lines behind its heading.
bool feed_lines(const std::string& lines) {
  static const MemoryFile file("journal");
  static const std::string heading = journal_heading();
  const std::string path = file.hold(heading + lines);
  std::size_t found = 0;
  {
    Journal journal(path, identity);
    found = journal.found();
    promise(found <= static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n')),
            "a journal finds more than it has lines");
    journal.add("an added point", "[1,\"inf\"]");
  }
  const Journal again(path, identity);
  promise(again.found() == found + 1, "a line that was added is lost, or one that was torn is back");
  promise(again.find("an added point") == "[1,\"inf\"]", "a point of a journal is another");
  return found > 0;
}

/// The lines of a journal without their check sums.
bool feed(std::string_view input) {
  feed_lines(std::string(input));
  return feed_lines(mended(input));
}

std::vector<std::string> seeds() {
  const MemoryFile file("seed");
  const std::string path = file.hold("");
  {
    Journal journal(path, identity);
    journal.add("timing: rk4", "[0.5,0.25]");
    journal.add("runs: rk4", R"({"method":{"name":"rk4","step":0.25},"outcome":"completed"})");
  }
  std::string seed;
  std::istringstream lines(file.text());
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line);) seed += line.substr(line.find(' ') + 1) + '\n';
  return {seed};
}

}  // namespace

const Target journal_target{"journal", feed, seeds};

}  // namespace plumb::fuzz
