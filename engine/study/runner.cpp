#include "engine/study/runner.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "engine/integrate/processor_time.h"

namespace plumb {

Runner::Runner(Journal& journal, StudyProgress progress)
    : journal_(journal), progress_(std::move(progress)), workers_(&own_workers_) {}

Runner::Runner(Journal& journal, StudyProgress progress, Workers& workers, Scope scope)
    : journal_(journal), progress_(std::move(progress)), workers_(&workers), scope_(std::move(scope)) {}

void Runner::say(const std::string& part, double share) {
  if (!progress_) return;
  const std::lock_guard lock(saying_);
  progress_(part, share);
}

std::string Runner::text_of(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string Runner::timed(const std::function<std::string()>& compute) {
  const double began = processor_seconds();
  const std::string line = compute();
  return fmt::format("{:.3g} {}", processor_seconds() - began, line);
}

std::pair<double, std::string> Runner::untimed(const std::string& line) {
  const std::size_t space = line.find(' ');
  double seconds = -1;
  std::from_chars(line.data(), line.data() + space, seconds);
  return {seconds, line.substr(space + 1)};
}

/// Points are dealt out by their predicted work, the most first, so that shares are alike; groups stay
/// together.
std::vector<bool> Runner::own_of(const PlannedPart& planned) const {
  const std::size_t count = planned.points.size();
  if (planned.part.division == Division::shared) return std::vector<bool>(count, scope_.computes);
  std::vector<bool> own(count, false);
  if (!scope_.computes) return own;
  std::size_t dealt = 0;
  std::map<std::size_t, std::size_t> dealt_groups;
  for (const std::size_t k : most_work_first(planned.tasks)) {
    if (scope_.only && !scope_.only->contains(planned.points[k].key)) continue;
    const std::size_t hand =
        planned.part.company == Company::apart
            ? dealt_groups.try_emplace(planned.tasks[k].group, dealt_groups.size()).first->second
            : dealt++;
    own[k] = hand % scope_.shares == scope_.share - 1;
  }
  return own;
}

void Runner::add(PlannedPart planned) {
  const std::vector<bool> own = own_of(planned);
  if (planned.part.division == Division::shared) kept_for_others_.insert(full_key(planned.part.name, ""));
  points_ += planned.points.size();
  for (std::size_t k = 0; k < planned.points.size(); ++k) {
    PointState& point = planned.points[k];
    point.own = own[k];
    if (point.own)
      ++own_points_;
    else if (!point.known)
      missing_.push_back(point.key);
  }
  planned_.push_back(std::move(planned));
}

void Runner::compute(const std::string& what) {
  std::vector<PlannedPart> parts = std::move(planned_);
  planned_.clear();
  for (const Company company : {Company::together, Company::apart, Company::alone})
    compute_in(company, parts, what);
  bool enough = true;
  for (PlannedPart& planned : parts) {
    if (planned.part.division == Division::shared && workers_->is_job()) spread(planned);
    for (const PointState& point : planned.points) {
      if (point.known)
        processors_[planned.part.name].insert(journal_.machine_of(point.key).processor);
      else if (planned.part.division == Division::shared)
        enough = false;
    }
  }
  if (!enough) throw NotWhole();
}

void Runner::compute_in(Company company, std::vector<PlannedPart>& parts, const std::string& what) {
  struct Place {
    PlannedPart* part;
    std::size_t point;
  };
  std::vector<Task> tasks;
  std::vector<Place> places;
  std::size_t id = 0, all = 0, done = 0;
  for (PlannedPart& planned : parts) {
    if (planned.part.company != company) {
      id += planned.points.size();
      continue;
    }
    for (std::size_t k = 0; k < planned.points.size(); ++k, ++id) {
      const PointState& point = planned.points[k];
      ++all;
      if (point.known || !point.own) {
        ++done;
        continue;
      }
      planned.tasks[k].id = id;
      tasks.push_back(std::move(planned.tasks[k]));
      places.push_back({&planned, k});
    }
  }
  if (all == 0) return;
  const auto share = [&] { return static_cast<double>(done) / static_cast<double>(all); };
  say(what, share());
  workers_->compute(tasks, company, [&](std::size_t task, const TaskEnd& end) {
    const auto [planned, k] = places[task];
    const auto [seconds, line] =
        end.fault.empty() ? untimed(end.line) : std::pair(-1.0, planned->lost(k, end.fault));
    PointState& point = planned->points[k];
    journal_.add(point.key, line, seconds, end.on);
    planned->read(k, line);
    point.known = true;
    ++done;
    say(what, share());
  });
}

void Runner::spread(PlannedPart& planned) {
  std::vector<std::string> lines;
  for (const PointState& point : planned.points) lines.push_back(journal_.find(point.key).value_or(""));
  workers_->spread(lines);
  if (!workers_->serves()) return;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (lines[k].empty()) continue;
    planned.read(k, lines[k]);
    journal_.add(planned.points[k].key, lines[k]);
    planned.points[k].known = true;
  }
}

void Runner::conclude() const {
  if (!missing_.empty() || workers_->serves()) throw NotWhole();
}

bool Runner::alike(const std::vector<std::string>& parts) const {
  std::set<std::string> all;
  for (const std::string& part : parts)
    if (const auto found = processors_.find(part); found != processors_.end())
      all.merge(std::set(found->second));
  return all.size() <= 1;
}

Provenance Runner::provenance() const {
  Provenance provenance = provenance_now();
  const auto machines = journal_.machines();
  const bool all_here = std::all_of(machines.begin(), machines.end(), [](const auto& machine) {
    return machine.second == 0 || machine.first == this_machine();
  });
  for (const auto& [machine, points] : machines)
    if (points > 0 && !all_here)
      provenance.emplace_back(
          fmt::format("points computed on {}", machine.host),
          fmt::format("{}, {}, revision {}", points, machine.processor, machine.revision));
  return provenance;
}

std::string Runner::missing_text(const StudyIdentity& identity) const {
  const auto is_kept = [&](const std::string& key) {
    return std::any_of(kept_for_others_.begin(), kept_for_others_.end(),
                       [&](const std::string& begin) { return key.starts_with(begin); });
  };
  return journal_.text(identity, is_kept, missing_);
}

}  // namespace plumb
