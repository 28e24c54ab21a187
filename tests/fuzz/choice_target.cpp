#include "engine/study/economy/economy_json.h"
#include "tests/engine/study/sweep/tiny_sweep.h"
#include "tests/fuzz/target.h"

namespace plumb::fuzz {
namespace {

constexpr const char* key = "0123456789abcdef";

bool feed(std::string_view input) {
  // Nothing is refused: a choice that is no good is made anew.
  const std::optional<Economy> read = decode_choice(std::string(input), key);
  if (!read) return false;
  const CaseSource made = tiny_sweep_case().source;
  const std::string written = encode_choice(*read, key, made);
  const auto again = decode_choice(written, key), of_made = decode_choice_made(written, made);
  promise(again && of_made && encode_choice(*again, key, made) == written,
          "a choice that is written and read again is another");
  promise(read->choice() != nullptr, "a choice of nothing");
  return true;
}

std::vector<std::string> seeds() {
  const LoadedCase loaded = tiny_sweep_case();
  Economy economy;
  economy.tolerance = 0.5;
  TriedCandidate candidate;
  candidate.candidate.cable = loaded.spec.cable;
  candidate.candidate.method = loaded.spec.method;
  candidate.outcome = Outcome::completed;
  candidate.estimate = 0.25;
  economy.tried = {candidate, candidate};
  economy.tried.front().estimate = std::numeric_limits<double>::infinity();
  economy.chosen = 1;
  economy.holds = true;
  return {encode_choice(economy, key, loaded.source)};
}

}  // namespace

const Target choice_target{"choice", feed, seeds};

}  // namespace plumb::fuzz
