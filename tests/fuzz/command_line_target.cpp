#include "report/program/drawing_options.h"
#include "report/program/verbs.h"
#include "tests/fuzz/small_files.h"

namespace plumb::fuzz {
namespace {

/// A line a word, the first behind the program's name.
bool feed(std::string_view input) {
  std::vector<std::string> words{"plumb"};
  for (std::size_t from = 0; from <= input.size() && words.size() < 40;) {
    const std::size_t end = std::min(input.find('\n', from), input.size());
    // The words of a command line end in a 0 byte.
    words.emplace_back(std::string(input.substr(from, end - from)).c_str());
    from = end + 1;
  }
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  return reads<UsageError, InputError>([&] {
    const Command command = parse_command(static_cast<int>(arguments.size()), arguments.data());
    promise(command.verb != nullptr || !command.said.empty(), "a command line that asks for nothing");
    if (const auto frames = asked_frames(command.options))
      promise(frames->first >= 0 && frames->last >= frames->first, "a range of frames upside down");
    static const LoadedCase loaded = load_case(small_source());
    with_asked_scene(loaded, command.options);
  });
}

std::vector<std::string> seeds() {
  return {"run\ncase.toml\n--set\nscene.theme=dark\n-o\nout\n--baseline\nold\n--numbers\n1e-6\n--quiet",
          "render\nrun.h5\n--frames\n10:20\n--size\n320x180\n--camera\ntop\n--over\nother\n--points",
          "diff\na\nb\n--channel\n3\n--density\n0.5\n--html\npage.html\n--accept\n--json",
          "study\ncase.toml\nsweep\n--set\nscene.size=[64,64]",
          "solve\ncase.toml\n--csv\n-\n--economy\n--explain",
          "report\n--from\nresults.json",
          "--help",
          "--version",
          "check\n--help"};
}

}  // namespace

const Target command_line_target{"command_line", feed, seeds};

}  // namespace plumb::fuzz
