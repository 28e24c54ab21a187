#include "engine/study/economy/economy_json.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/base/document_sum.h"
#include "engine/base/errors.h"
#include "engine/base/parse_json.h"
#include "engine/case/case_codec.h"
#include "engine/integrate/method_info.h"
#include "engine/run/method_json.h"
#include "engine/run/provenance.h"
#include "engine/study/economy/candidates.h"

namespace plumb {

template <class Archive>
void members(Archive& a, TriedCandidate& tried) {
  Candidate& candidate = tried.candidate;
  a.said("in_words", [&] { return in_words(candidate); });
  a("cable", candidate.cable);
  a.said("method", [&] { return method_json(candidate.method); });
  if constexpr (Archive::reads) a("method", candidate.method);
  a("predicted_work", candidate.work);
  a("outcome", tried.outcome);
  a("message", tried.message);
  a("seconds", tried.seconds);
  a("estimated_picture_error", tried.estimate);
  a("true_picture_error", tried.true_error);
  a("certain_until", tried.certain_until);
  a("why", tried.why);
}

template <class Archive>
void members(Archive& a, Economy& economy) {
  a("tolerance", economy.tolerance);
  a.said("unit", [] { return std::string("pixels"); });
  a.said("safety_factor", [] { return economy_safety; });
  a("case_elements", economy.case_elements);
  a("holds", economy.holds);
  a("chosen", economy.chosen);
  a("finest", economy.finest);
  a("finest_error", economy.finest_error);
  a("observed_ratio", economy.observed_ratio);
  a("error_of_the_step", economy.time_share);
  a("uncertain", economy.uncertain);
  a("search_seconds", economy.search_seconds);
  a("search_work", economy.search_work);
  a("safe_work", economy.safe_work);
  a("reused", economy.reused);
  a("tried", economy.tried);
}

namespace {

using Json = nlohmann::ordered_json;

/// FNV-1a of 64 bits (Fowler, Noll and Vo 1991), the same with every library.
class Hash {
 public:
  void take(const std::string& text) {
    for (const char c : text + '\0') {
      value_ ^= static_cast<unsigned char>(c);
      value_ *= 1099511628211U;
    }
  }
  std::string digits() const { return fmt::format("{:016x}", value_); }

 private:
  std::uint64_t value_ = 14695981039346656037U;
};

std::optional<Economy> with_key(const std::string& text, const char* name, const std::string& key) {
  try {
    const auto json = parse_json<Json>(text, "choice.json");
    if (json.at("kind") != "choice" || json.at("version") != choice_version || json.at(name) != key)
      return {};
    return decoded<Economy>(json.at("economy"));
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace

Json to_stored(const Economy& economy) {
  return codec::encode_members(economy, NotFinite::null);
}

void from_stored(const Json& json, Economy& economy) {
  codec::decode_members(json, economy, NotFinite::null);
  if (economy.chosen < -1 || economy.chosen >= std::ssize(economy.tried))
    throw std::runtime_error("the chosen candidate is none of those tried");
  // What is not finite of these is infinite.
  const auto mend = [](double& number) {
    if (std::isnan(number)) number = std::numeric_limits<double>::infinity();
  };
  for (TriedCandidate& tried : economy.tried) {
    if (find_method(tried.candidate.method.name) == nullptr) throw std::runtime_error("no such method");
    mend(tried.estimate);
    mend(tried.true_error);
  }
  mend(economy.finest_error);
  mend(economy.observed_ratio);
  mend(economy.time_share);
}

std::string choice_key(const CaseSource& source) {
  Hash hash;
  hash.take(source.file.text);
  for (const std::string& text : source.overrides) hash.take(text);
  for (const auto& [name, value] : provenance_now())
    if (name == "program" || name == "revision") hash.take(value);
  return hash.digits();
}

std::string encode_choice(const Economy& economy, const std::string& key, const CaseSource& made) {
  Json json{{"kind", "choice"},
            {"version", choice_version},
            {"key", key},
            {"key_of_the_run", choice_key(made)},
            {"overrides", made.overrides}};
  json["economy"] = encode(economy);
  return to_summed_text(std::move(json), 1);
}

std::optional<Economy> decode_choice(const std::string& text, const std::string& key) {
  return with_key(text, "key", key);
}

std::optional<Economy> decode_choice_made(const std::string& text, const CaseSource& made) {
  return with_key(text, "key_of_the_run", choice_key(made));
}

}  // namespace plumb
