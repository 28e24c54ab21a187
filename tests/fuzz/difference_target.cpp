#include "render/image/apng.h"
#include "render/image/png.h"
#include "report/diff/file_difference.h"
#include "tests/fuzz/mended_png.h"
#include "tests/fuzz/target.h"

namespace plumb::fuzz {
namespace {

constexpr std::string_view between = "\n<->\n";

/// Two files of one name with `between` them; the first byte says of what kind.
bool feed(std::string_view input) {
  const std::size_t middle = input.find(between);
  if (input.empty() || middle == std::string_view::npos || middle == 0) return false;
  const char kind = input.front();
  std::string a(input.substr(1, middle - 1)), b(input.substr(middle + between.size()));
  const std::string name = kind == 'p' ? "a.png" : kind == 'c' ? "a.csv" : "results.json";
  if (kind == 'p') {
    a = mended_png(a);
    b = mended_png(b);
  }
  const FileDifference found = compare_files(name, a, b, {}), turned = compare_files(name, b, a, {});
  // Documents without a verdict are not.
  promise(found.sameness != Sameness::not_compared || kind == 'r', "a file of a known kind is not compared");
  promise((found.sameness == Sameness::identical) == (turned.sameness == Sameness::identical),
          "two files are the same from one side only");
  promise((found.sameness == Sameness::unreadable) == (turned.sameness == Sameness::unreadable),
          "two files are readable from one side only");
  promise(!found.in_words.empty(), "nothing is said of two files");
  return found.sameness != Sameness::unreadable;
}

std::string pair(char kind, const std::string& a, const std::string& b) {
  return kind + a + std::string(between) + b;
}

std::vector<std::string> seeds() {
  const std::string one = encode_png(small_image(3, 2, true, 0)),
                    other = encode_png(small_image(3, 2, false, 3));
  return {pair('p', one, other), pair('p', join_apng({{one, one}}, 10), join_apng({{one, one}}, 20)),
          pair('c', "t [s],x\n0,1\n1,nan\n", "t [s],x\n0,1\n1,2\n"),
          pair('c', "name,value\na,1\nb,1e3\n", "name,value\na,1\nb,1e3\n\n"),
          pair('r', R"({"outcome":"accurate","verdicts":[{"name":"a","status":"passed"}]})",
               R"({"outcome":"accurate","verdicts":[{"name":"a","status":"failed"}]})")};
}

}  // namespace

const Target difference_target{"difference", feed, seeds};

}  // namespace plumb::fuzz
