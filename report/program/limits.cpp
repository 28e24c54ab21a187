#include "report/program/limits.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>

#include "engine/base/errors.h"
#include "engine/base/file_writing.h"
#include "engine/base/nearest.h"
#include "engine/case/case_source.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr const char* limit_form = "must be as memory=2GB,disk=10GB,time=1h, each at most once";

struct Unit {
  const char* name;
  double size;
};
constexpr Unit size_units[] = {{"kB", 1e3}, {"MB", 1e6}, {"GB", 1e9}, {"TB", 1e12}};
constexpr Unit time_units[] = {{"s", 1}, {"min", 60}, {"h", 3600}, {"d", 86400}};

std::span<const Unit> units_of(Resource resource) {
  return resource == Resource::time ? std::span<const Unit>(time_units) : std::span<const Unit>(size_units);
}

[[noreturn]] void refuse_limit(const std::string& text, const std::string& why) {
  throw UsageError(fmt::format("--limit {}: {}", text, why));
}

Resource resource_of(const std::string& name, const std::string& text) {
  std::vector<std::string> known;
  for (const Resource resource : {Resource::memory, Resource::disk, Resource::time}) {
    if (word(resource) == name) return resource;
    known.emplace_back(word(resource));
  }
  refuse_limit(text, fmt::format("'{}' is no resource{}; {}", name, suggestion(name, known), limit_form));
}

double amount_of(const std::string& value, Resource resource, const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  const std::string unit(end, static_cast<const char*>(value.data() + value.size()));
  std::vector<std::string> known;
  for (const Unit& any : units_of(resource)) {
    known.emplace_back(any.name);
    if (error == std::errc() && unit == any.name && number > 0 && std::isfinite(number * any.size))
      return number * any.size;
  }
  refuse_limit(text, fmt::format("{} = {}: must be a number greater than 0 with its unit, {}", word(resource),
                                 value, fmt::join(known, ", ")));
}

/// The number that a file begins with, or the one after `key` in it.
std::optional<double> number_in(const std::string& path, const std::string& key = {}) {
  std::ifstream file(path);
  std::string found;
  while (file >> found) {
    if (!key.empty()) {
      if (found != key || !(file >> found)) continue;
    }
    double number = 0;
    const auto [end, error] = std::from_chars(found.data(), found.data() + found.size(), number);
    if (error == std::errc() && end == found.data() + found.size()) return number;
    return {};  // "max": no limit
  }
  return {};
}

constexpr double kibibyte = 1024;

void add_memory_of_machine(std::vector<Bound>& bounds) {
  if (const auto available = number_in("/proc/meminfo", "MemAvailable:")) {
    const double swap = number_in("/proc/meminfo", "SwapFree:").value_or(0);
    bounds.push_back(
        {Resource::memory, kibibyte * (*available + swap), "the memory that is available on this machine"});
  }
}

/// The limits of the control group that this process is in and of those around it, version 2 or 1.
void add_memory_of_control_groups(std::vector<Bound>& bounds) {
  constexpr const char* source = "what is left of the memory of the control group";
  std::ifstream groups("/proc/self/cgroup");
  std::string line;
  while (std::getline(groups, line)) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    if (!controllers.empty() && controllers.find("memory") == std::string::npos) continue;
    const bool unified = controllers.empty();
    const std::string root = unified ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    for (fs::path group = line.substr(second + 1);; group = group.parent_path()) {
      const std::string folder = root + group.string() + "/";
      const auto most = number_in(folder + (unified ? "memory.max" : "memory.limit_in_bytes"));
      const auto used = number_in(folder + (unified ? "memory.current" : "memory.usage_in_bytes"));
      if (most && used) {
        // Of the files in it the system keeps what nobody else needs.
        const double files =
            number_in(folder + "memory.stat", unified ? "inactive_file" : "total_inactive_file").value_or(0);
        bounds.push_back({Resource::memory, std::max(0.0, *most - *used + files), source});
      }
      if (!group.has_relative_path()) break;
    }
  }
}

void add_address_space(std::vector<Bound>& bounds) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  const double used =
      number_in("/proc/self/statm").value_or(0) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  bounds.push_back({Resource::memory, std::max(0.0, static_cast<double>(limit.rlim_cur) - used),
                    "what is left of the address space (ulimit -v)", true, true});
}

/// Counts what is mapped for writing, as memory and the stacks of threads are.
void add_data(std::vector<Bound>& bounds) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return;
  const double used = kibibyte * number_in("/proc/self/status", "VmData:").value_or(0);
  bounds.push_back({Resource::memory, std::max(0.0, static_cast<double>(limit.rlim_cur) - used),
                    "what is left of the data segment (ulimit -d)", false, true});
}

void add_disk(const std::string& folder, std::vector<Bound>& bounds) {
  std::error_code ignored;
  fs::path there = fs::absolute(folder, ignored);
  while (!fs::exists(there, ignored) && there.has_relative_path()) there = there.parent_path();
  struct statvfs system {};
  if (::statvfs(there.c_str(), &system) != 0) return;
  bounds.push_back({Resource::disk,
                    static_cast<double>(system.f_bavail) * static_cast<double>(system.f_frsize),
                    "what is free on the disk", false, false, folder});
}

std::string kept_heaviest;

std::string describe(const EstimatedPart& part) {
  return fmt::format("{} ({})", part.what, amount_in_words(part.resource, part.amount));
}

}  // namespace

std::vector<Bound> asked_bounds(const std::vector<std::string>& texts) {
  std::vector<Bound> bounds;
  for (const std::string& text : texts) {
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      const std::string part = text.substr(begin, end - begin);
      begin = end + 1;
      const std::size_t equals = part.find('=');
      if (equals == std::string::npos) refuse_limit(text, limit_form);
      const Resource resource = resource_of(part.substr(0, equals), text);
      for (const Bound& other : bounds)
        if (other.resource == resource)
          refuse_limit(text, fmt::format("{} is limited twice; {}", word(resource), limit_form));
      bounds.push_back({resource, amount_of(part.substr(equals + 1), resource, text), "--limit"});
    }
  }
  return bounds;
}

std::vector<Bound> machine_bounds(const std::string& folder) {
  std::vector<Bound> bounds;
  add_memory_of_machine(bounds);
  add_memory_of_control_groups(bounds);
  add_address_space(bounds);
  add_data(bounds);
  add_disk(folder, bounds);
  return bounds;
}

void refuse_beyond(const Estimate& estimate, const std::vector<Bound>& bounds, const std::string& name) {
  for (const Bound& bound : bounds) {
    const double wanted =
        estimate.total(bound.resource) + (bound.address_space ? estimate.drawing_address_space : 0);
    // Turned round, so that a number that is none is refused.
    if (wanted <= bound.amount) continue;
    const EstimatedPart most = estimate.parts_of(bound.resource).front();
    const std::string why =
        fmt::format("would take some {} of {}, more than {}, {}; most of it: {}{}",
                    amount_in_words(bound.resource, wanted), word(bound.resource), bound.source,
                    amount_in_words(bound.resource, bound.amount), describe(most),
                    most.keys.empty() ? "" : "; less with other " + most.keys);
    // A full disk is no fault of the case, nor is too little for what every case takes.
    if (!bound.place.empty()) throw WriteError(bound.place, name + " " + why);
    double of_any_case = bound.address_space ? estimate.drawing_address_space : 0;
    for (const EstimatedPart& part : estimate.parts_of(bound.resource))
      if (part.keys.empty()) of_any_case += part.amount;
    if (bound.of_process && of_any_case > bound.amount) throw OutputError(name + ": " + why);
    throw InputError(name + ": " + why);
  }
}

Estimate check_estimate(const Case& spec, const PlannedWork& work, const std::string& name,
                        const std::string& folder, const Options& options, Console& console) {
  Estimate made = estimate(spec, work);
  const EstimatedPart most = made.parts_of(Resource::memory).front();
  kept_heaviest = fmt::format("{}{}", describe(most), most.keys.empty() ? "" : ": " + most.keys);
  std::vector<Bound> bounds = asked_bounds(options.limits);
  for (Bound& bound : machine_bounds(folder)) bounds.push_back(std::move(bound));
  refuse_beyond(made, bounds, name);
  constexpr double long_time = 86400;
  if (const double time = made.total(Resource::time); time > long_time)
    console.remark(fmt::format("this will take some {}: {} (--limit time=1h would refuse it)",
                               amount_in_words(Resource::time, time),
                               describe(made.parts_of(Resource::time).front())));
  return made;
}

void refuse_no_room_to_draw() {
  std::vector<Bound> bounds;
  add_address_space(bounds);
  for (const Bound& bound : bounds)
    if (bound.amount < renderer_address_space)
      throw OutputError(
          fmt::format("drawing would take some {:.0f} MB of address space, more than {}, {:.0f} MB",
                      renderer_address_space / 1e6, bound.source, bound.amount / 1e6));
}

PlannedWork work_of_run(const Case& spec) {
  const bool solves = !reports_given_run(spec);
  return {.solves = solves,
          .writes_run = true,
          .assesses = solves,
          .quick_study = solves && spec.work_precision && spec.cable.model != CableModel::rigid,
          .draws = true};
}

std::vector<std::string> in_words(const Estimate& estimate) {
  constexpr std::size_t shown = 3;
  std::vector<std::string> lines;
  for (const Resource resource : {Resource::memory, Resource::disk, Resource::time}) {
    std::vector<EstimatedPart> parts = estimate.parts_of(resource);
    if (parts.empty()) continue;
    std::vector<std::string> texts;
    for (std::size_t k = 0; k < std::min(shown, parts.size()); ++k) texts.push_back(describe(parts[k]));
    lines.push_back(fmt::format("{}: some {}: {}", word(resource),
                                amount_in_words(resource, estimate.total(resource)), fmt::join(texts, "; ")));
  }
  return lines;
}

const std::string& heaviest_part() {
  return kept_heaviest;
}

}  // namespace plumb
