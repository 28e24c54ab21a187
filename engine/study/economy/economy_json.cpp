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
#include "engine/case/case_words.h"
#include "engine/integrate/method_info.h"
#include "engine/run/provenance.h"
#include "engine/study/economy/candidates.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

/// Infinite pixels are null, as JSON has no such number.
double pixels(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

template <class E>
E value_of(const Json& json) {
  const std::string text = json.get<std::string>();
  for (const auto& entry : words_of<E>)
    if (entry.word == text) return entry.value;
  throw std::runtime_error("no such word: " + text);
}

Json cable_json(const CableSpec& cable) {
  return {{"model", word(cable.model)},
          {"elements", cable.elements},
          {"length", cable.length},
          {"area", cable.area},
          {"density", cable.density},
          {"youngs_modulus", cable.youngs_modulus},
          {"second_moment", cable.second_moment},
          {"strain", word(cable.strain)},
          {"quadrature", word(cable.quadrature)}};
}

CableSpec cable_of(const Json& json) {
  CableSpec cable;
  cable.model = value_of<CableModel>(json.at("model"));
  cable.elements = json.at("elements").get<int>();
  cable.length = json.at("length").get<double>();
  cable.area = json.at("area").get<double>();
  cable.density = json.at("density").get<double>();
  cable.youngs_modulus = json.at("youngs_modulus").get<double>();
  cable.second_moment = json.at("second_moment").get<double>();
  cable.strain = value_of<StrainModel>(json.at("strain"));
  cable.quadrature = value_of<QuadratureRule>(json.at("quadrature"));
  return cable;
}

Json method_json(const MethodSpec& method) {
  Json json{{"name", method.name}};
  if (method.step) json["step"] = *method.step;
  if (method.rtol) json["rtol"] = *method.rtol;
  if (method.atol) json["atol"] = *method.atol;
  return json;
}

MethodSpec method_of(const Json& json) {
  const MethodInfo* info = find_method(json.at("name").get<std::string>());
  if (info == nullptr) throw std::runtime_error("no such method");
  MethodSpec method = plain_method(*info);
  const auto number = [&](const char* key) {
    return json.contains(key) ? std::optional(json.at(key).get<double>()) : std::nullopt;
  };
  method.step = number("step");
  method.rtol = number("rtol");
  method.atol = number("atol");
  return method;
}

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
    return economy_of(json.at("economy"));
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace

Json tried_candidate_json(const TriedCandidate& tried) {
  return {{"in_words", in_words(tried.candidate)},
          {"cable", cable_json(tried.candidate.cable)},
          {"method", method_json(tried.candidate.method)},
          {"predicted_work", tried.candidate.work},
          {"outcome", word(tried.outcome)},
          {"message", tried.message},
          {"seconds", tried.seconds},
          {"estimated_picture_error", tried.estimate},
          {"true_picture_error", tried.true_error},
          {"certain_until", tried.certain_until},
          {"why", tried.why}};
}

TriedCandidate tried_candidate_of(const Json& json) {
  TriedCandidate tried;
  tried.candidate.cable = cable_of(json.at("cable"));
  tried.candidate.method = method_of(json.at("method"));
  tried.candidate.work = json.at("predicted_work").get<double>();
  tried.outcome = outcome_named(json.at("outcome").get<std::string>());
  tried.message = json.at("message").get<std::string>();
  tried.seconds = json.at("seconds").get<double>();
  tried.estimate = pixels(json.at("estimated_picture_error"));
  tried.true_error = pixels(json.at("true_picture_error"));
  tried.certain_until = json.at("certain_until").get<double>();
  tried.why = json.at("why").get<std::string>();
  return tried;
}

Json economy_json(const Economy& economy) {
  Json json{{"tolerance", economy.tolerance},
            {"unit", "pixels"},
            {"safety_factor", economy_safety},
            {"case_elements", economy.case_elements},
            {"holds", economy.holds},
            {"chosen", economy.chosen},
            {"finest", economy.finest},
            {"finest_error", economy.finest_error},
            {"observed_ratio", economy.observed_ratio},
            {"error_of_the_step", economy.time_share},
            {"uncertain", economy.uncertain},
            {"search_seconds", economy.search_seconds},
            {"search_work", economy.search_work},
            {"safe_work", economy.safe_work},
            {"reused", economy.reused}};
  json["tried"] = Json::array();
  for (const TriedCandidate& tried : economy.tried) json["tried"].push_back(tried_candidate_json(tried));
  return json;
}

Economy economy_of(const Json& json) {
  Economy economy;
  economy.tolerance = json.at("tolerance").get<double>();
  economy.case_elements = json.at("case_elements").get<int>();
  economy.holds = json.at("holds").get<bool>();
  economy.chosen = json.at("chosen").get<int>();
  economy.finest = json.at("finest").get<std::string>();
  economy.finest_error = pixels(json.at("finest_error"));
  economy.observed_ratio = pixels(json.at("observed_ratio"));
  economy.time_share = pixels(json.at("error_of_the_step"));
  economy.uncertain = json.at("uncertain").get<std::string>();
  economy.search_seconds = json.at("search_seconds").get<double>();
  economy.search_work = json.at("search_work").get<double>();
  economy.safe_work = json.at("safe_work").get<double>();
  economy.reused = json.at("reused").get<bool>();
  for (const Json& tried : json.at("tried")) economy.tried.push_back(tried_candidate_of(tried));
  if (economy.chosen < -1 || economy.chosen >= std::ssize(economy.tried))
    throw std::runtime_error("the chosen candidate is none of those tried");
  return economy;
}

Json to_stored(const Economy& economy) {
  return economy_json(economy);
}

void from_stored(const Json& json, Economy& economy) {
  economy = economy_of(json);
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
  json["economy"] = economy_json(economy);
  return to_summed_text(std::move(json), 1);
}

std::optional<Economy> decode_choice(const std::string& text, const std::string& key) {
  return with_key(text, "key", key);
}

std::optional<Economy> decode_choice_made(const std::string& text, const CaseSource& made) {
  return with_key(text, "key_of_the_run", choice_key(made));
}

}  // namespace plumb
