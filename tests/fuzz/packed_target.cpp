#include "engine/base/packed.h"
#include "tests/fuzz/target.h"

namespace plumb::fuzz {
namespace {

/// What a process that was taken over may answer: the first byte says what was asked for.
bool feed(std::string_view input) {
  if (input.empty()) return false;
  const std::string answer(input.substr(1));
  return reads<std::runtime_error>([&] {
    Unpacked unpacked(answer);
    std::string again;
    switch (input.front()) {
      case 't': {
        const std::vector<std::string> texts = unpacked.texts();
        again = Packed().add(texts).take();
        break;
      }
      case 'd': {
        const std::vector<std::uint64_t> shape = unpacked.numbers<std::uint64_t>();
        again = Packed().add(shape).add(unpacked.numbers<std::uint64_t>()).take();
        break;
      }
      default:
        again = Packed().add(unpacked.text()).add(unpacked.number()).take();
    }
    promise(answer.starts_with(again), "what is taken apart and packed again is another");
  });
}

std::vector<std::string> seeds() {
  const std::vector<std::uint64_t> numbers{1, 2, 3};
  return {"t" + Packed().add({"tip.x", "", "t"}).take(), "d" + Packed().add(numbers).add(numbers).take(),
          "x" + Packed().add(std::string_view("m")).add(std::uint64_t{7}).take()};
}

}  // namespace

const Target packed_target{"packed", feed, seeds};

}  // namespace plumb::fuzz
