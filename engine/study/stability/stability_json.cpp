#include "engine/study/stability/stability_json.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <type_traits>

#include "engine/base/message.h"
#include "engine/base/parse_json.h"
#include "engine/run/method_json.h"
#include "engine/run/stored_parts.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

// Each part of a study names its members once, in members(); Writer and Reader are the two ways to go through
// them.

template <class Archive>
void members(Archive& a, StabilityPoint& p) {
  a("outcome", p.outcome);
  a("message", p.message);
  a("end_time", p.end_time);
  a("error", p.error);
  a("judged_until", p.judged_until);
  a("energy_change", p.energy_change);
  a("steps", p.steps);
  a("seconds", p.seconds);
}

template <class Archive>
void members(Archive& a, PredictedLimit& p) {
  a("at_start", p.at_start);
  a("at_worst", p.at_worst);
}

template <class Archive>
void members(Archive& a, OutcomeMap& m) {
  a("label", m.label);
  a("method", m.method);
  a("by_step", m.by_step);
  a("axis", m.axis);
  a("settings", m.settings);
  a("values", m.values);
  a("limit_kind", m.limit_kind);
  a("limits", m.limits);
  a("in_words", m.in_words);
  a("points", m.points);
}

template <class Archive>
void members(Archive& a, CriticalStep& c) {
  a("label", c.label);
  a("method", c.method);
  a("parameter", c.parameter);
  a("elements", c.elements);
  a("stable", c.stable);
  a("unstable", c.unstable);
  a("beyond", c.beyond);
  a("limit_kind", c.limit_kind);
  a("predicted", c.predicted);
}

template <class Archive>
void members(Archive& a, EnergyHistory& e) {
  a("label", e.label);
  a("parameter", e.parameter);
  a("step", e.step);
  a("outcome", e.outcome);
  a("message", e.message);
  a("times", e.times);
  a("change", e.change);
}

template <class Archive>
void members(Archive& a, ModeAmplification& m) {
  a("label", m.label);
  a("steps_a_period", m.steps_a_period);
  a("measured", m.measured);
  a("predicted", m.predicted);
}

template <class Archive>
void members(Archive& a, Separation& s) {
  a("parameter", s.parameter);
  a("elements", s.elements);
  a("times", s.times);
  a("distances", s.distances);
  a("exponent", s.exponent);
  a("horizon", s.horizon);
  a("beyond_end", s.beyond_end);
  a("in_words", s.in_words);
}

template <class Archive>
void members(Archive& a, MotionStatistics& s) {
  a("label", s.label);
  a("parameter", s.parameter);
  a("step", s.step);
  a("outcome", s.outcome);
  a("message", s.message);
  a("duration", s.duration);
  a("taken", s.taken);
  a("mean_height", s.mean_height);
  a("height_deviation", s.height_deviation);
  a("rms_speed", s.rms_speed);
  a("energy_change", s.energy_change);
}

template <class Archive>
void members(Archive& a, StabilityReference& r) {
  a("parameter", r.parameter);
  a("elements", r.elements);
  a("duration", r.duration);
  a("first", r.first);
  a("second", r.second);
  a("agreement", r.agreement);
  a("trusted_until", r.trusted_until);
  a("frequency_at_start", r.frequency_at_start);
  a("frequency_at_worst", r.frequency_at_worst);
}

template <class Archive>
void members(Archive& a, std::pair<std::string, std::string>& item) {
  a("name", item.first);
  a("value", item.second);
}

template <class Archive>
void members(Archive& a, Stability& s) {
  a("title", s.title);
  a("parameter", s.parameter);
  a("parameter_value", s.parameter_value);
  a("elements", s.elements);
  a("end", s.end);
  a("duration", s.duration);
  a("tolerance", s.tolerance);
  a("maps", s.maps);
  a("critical_steps", s.critical_steps);
  a("energies", s.energies);
  a("amplifications", s.amplifications);
  a("separations", s.separations);
  a("statistics", s.statistics);
  a("references", s.references);
  a("provenance", s.provenance);
}

class Writer {
 public:
  explicit Writer(Json& json) : json_(json) {}

  template <class T>
  void operator()(const char* name, const T& value) {
    json_[name] = of(value);
  }

 private:
  static Json of(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  }
  static Json of(const MethodSpec& method) { return method_to_json(method); }
  template <class T>
  static Json of(const std::vector<T>& values) {
    Json list = Json::array();
    for (const T& value : values) list.push_back(of(value));
    return list;
  }
  template <class T>
  static Json of(const T& value) {
    if constexpr (std::is_enum_v<T>) {
      return word(value);
    } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
      return value;
    } else {
      Json object = Json::object();
      Writer writer(object);
      members(writer, const_cast<T&>(value));
      return object;
    }
  }

  Json& json_;
};

class Reader {
 public:
  explicit Reader(const Json& json) : json_(json) {}

  template <class T>
  void operator()(const char* name, T& value) {
    read(json_.at(name), value);
  }

 private:
  static void read(const Json& json, double& value) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!json.is_string()) {
      if (!json.is_number()) throw std::runtime_error("a number is missing");
      value = json.get<double>();
    } else if (json == "nan") {
      value = std::numeric_limits<double>::quiet_NaN();
    } else if (json == "inf" || json == "-inf") {
      value = json == "inf" ? infinity : -infinity;
    } else {
      throw std::runtime_error(one_line(fmt::format("'{}' is no number", json.get<std::string>())));
    }
  }
  static void read(const Json& json, int& value) {
    if (!json.is_number_integer()) throw std::runtime_error("a whole number is missing");
    value = json.get<int>();
  }
  static void read(const Json& json, long& value) {
    if (!json.is_number_integer()) throw std::runtime_error("a whole number is missing");
    value = json.get<long>();
  }
  static void read(const Json& json, bool& value) { value = json.get<bool>(); }
  static void read(const Json& json, std::string& value) { value = one_line(json.get<std::string>()); }
  static void read(const Json& json, Outcome& value) { value = stored_outcome(json.get<std::string>()); }
  static void read(const Json& json, MapAxis& value) {
    value = choice(json, {MapAxis::parameter, MapAxis::elements, MapAxis::duration});
  }
  static void read(const Json& json, LimitKind& value) {
    value = choice(json, {LimitKind::none, LimitKind::vibration, LimitKind::contraction, LimitKind::always});
  }
  static void read(const Json& json, MethodSpec& value) { value = method_from_json(json); }
  template <class T>
  static void read(const Json& json, std::vector<T>& values) {
    if (!json.is_array()) throw std::runtime_error("a list is missing");
    for (const Json& item : json) read(item, values.emplace_back());
  }
  template <class T>
  static void read(const Json& json, T& value) {
    Reader reader(json);
    members(reader, value);
  }
  template <class T>
  static T choice(const Json& json, std::initializer_list<T> all) {
    const auto name = json.get<std::string>();
    for (const T any : all)
      if (word(any) == name) return any;
    throw std::runtime_error(one_line(fmt::format("'{}' is no word of a study", name)));
  }

  const Json& json_;
};

bool rising(const std::vector<double>& values) {
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!std::isfinite(values[k]) || (k > 0 && !(values[k] > values[k - 1]))) return false;
  return !values.empty();
}

void check(const Stability& study) {
  for (const OutcomeMap& map : study.maps) {
    const bool whole = rising(map.settings) && rising(map.values) && map.settings.front() > 0 &&
                       map.points.size() == map.settings.size() * map.values.size() &&
                       (map.limits.empty() || map.limits.size() == map.values.size());
    if (!whole) throw std::runtime_error(fmt::format("the map of {} is not whole", map.label));
  }
  for (const EnergyHistory& energy : study.energies)
    if (energy.times.size() != energy.change.size())
      throw std::runtime_error(fmt::format("the energies of {} are not whole", energy.label));
  for (const Separation& separation : study.separations)
    if (separation.times.size() != separation.distances.size())
      throw std::runtime_error("the distances of neighbours are not whole");
}

}  // namespace

Json stability_to_json(const Stability& study) {
  Json json = Json::object();
  Writer writer(json);
  members(writer, const_cast<Stability&>(study));
  return json;
}

Stability stability_from_json(const Json& json) {
  Stability study;
  try {
    Reader reader(json);
    members(reader, study);
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(json_fault(error));
  }
  check(study);
  return study;
}

}  // namespace plumb
