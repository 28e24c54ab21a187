#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "engine/base/errors.h"
#include "engine/base/job_runs.h"
#include "engine/base/message.h"
#include "report/program/earlier_report.h"
#include "report/program/history_file.h"
#include "report/program/limits.h"
#include "report/program/many_reports.h"
#include "report/program/output_use.h"
#include "report/program/run_pipeline.h"
#include "report/program/share_option.h"

namespace plumb {

namespace fs = std::filesystem;

namespace {

constexpr const char* threads_of_renderer = "LP_NUM_THREADS";

/// One of several cases, checked.
struct Planned {
  std::string path;
  std::string name;    ///< of its folder, and what it is called
  std::string folder;  ///< for its results
  Estimate estimate;
  bool timed = false;  ///< its study times runs against one another
};

Options for_one(const Options& options, const Planned& one) {
  Options own = options;
  own.input = one.path;
  own.inputs = {one.path};
  own.output = one.folder;
  own.json = false;
  return own;
}

/// The command line of one of several cases. What it would say on standard output nobody reads.
std::vector<std::string> arguments_for(const Options& options, const Planned& one) {
  std::vector<std::string> words{"run", "--output", one.folder};
  const auto add = [&](const char* name, const std::vector<std::string>& values) {
    for (const std::string& value : values) words.insert(words.end(), {name, value});
  };
  add("--set", options.overrides);
  add("--limit", options.limits);
  if (!options.history.empty()) add("--history", {options.history});
  if (options.economy) words.emplace_back("--economy");
  if (options.quiet) words.emplace_back("--quiet");
  words.insert(words.end(), {"--", one.path});
  return words;
}

/// Throws UsageError where two cases, or a case and the index, would share a place.
std::string place_of(const std::string& path, const std::string& folder,
                     std::map<std::string, std::string>& names) {
  std::string name = folder_name_of(path);
  if (is_of_index(name))
    throw UsageError(
        fmt::format("{}: its results would be in {}/{}, and the index over several cases has a "
                    "{} there; rename it, or run it alone",
                    path, folder, name, name));
  const auto [known, first] = names.emplace(name, path);
  if (!first)
    throw UsageError(
        fmt::format("{} and {} would both be written to {}/{}", known->second, path, folder, known->first));
  return name;
}

void refuse_options_for_one_case(const Options& options) {
  if (!options.baseline.empty())
    throw UsageError("--baseline is for one case; with several, run each against its own");
  if (options.explain) throw UsageError("--explain is for one case");
}

/// What all of them take of disk and time together, one part a case.
void refuse_beyond_together(const std::vector<Planned>& cases, const std::string& folder,
                            const Options& options) {
  Estimate all;
  for (const Planned& one : cases)
    for (const Resource resource : {Resource::disk, Resource::time})
      all.parts.push_back({resource, "", one.path, "cases", one.estimate.total(resource)});
  std::vector<Bound> bounds = asked_bounds(options.limits);
  for (Bound& bound : machine_bounds(folder)) bounds.push_back(std::move(bound));
  std::erase_if(bounds, [](const Bound& bound) { return bound.resource == Resource::memory; });
  refuse_beyond(all, bounds, fmt::format("{} cases", cases.size()));
}

/// The memory that is there for all that run at once, bytes.
double memory_for_all(const std::string& folder, const Options& options) {
  double least = std::numeric_limits<double>::infinity();
  std::vector<Bound> bounds = asked_bounds(options.limits);
  for (Bound& bound : machine_bounds(folder)) bounds.push_back(std::move(bound));
  for (const Bound& bound : bounds)
    // What is a limit of a process each of them has for itself.
    if (bound.resource == Resource::memory && !bound.of_process) least = std::min(least, bound.amount);
  return least;
}

/// Reads and checks all cases. Says each fault; `worst` becomes the status of the worst.
std::vector<Planned> planned(const CaseList& cases, const std::string& folder, const Options& options,
                             Console& console, ExitStatus& worst) {
  std::vector<Planned> all;
  std::map<std::string, std::string> names;
  std::set<std::string> said;
  const auto fault = [&](const std::exception& error, ExitStatus status) {
    // One of the command line is the same for all.
    if (said.insert(error.what()).second) console.error(error.what());
    worst = std::max(worst, status);
  };
  for (const std::string& path : cases.paths) {
    try {
      Planned one{path, place_of(path, folder, names), {}, {}};
      one.folder = (fs::path(folder) / one.name).string();
      const LoadedCase loaded = load_case(path, options.overrides);
      const PlannedWork work = work_of_run(loaded.spec);
      Console nothing(true, true);
      one.estimate = check_estimate(loaded.spec, work, path, folder, options, nothing);
      one.timed = work.quick_study;
      OutputFolder::check(one.folder, folder_for(loaded, for_one(options, one), console));
      if (!options.history.empty())
        refuse_to_overwrite("--history", options.history, files_read(loaded, for_one(options, one)));
      all.push_back(std::move(one));
    } catch (const UsageError& error) {
      fault(error, ExitStatus::wrong_usage);
    } catch (const InputError& error) {
      fault(error, ExitStatus::invalid_input);
    } catch (const OutputError& error) {
      fault(error, ExitStatus::output_failed);
    }
  }
  return all;
}

/// Tells the results.json in a folder from any that takes its place; nothing where there is none.
std::optional<ino_t> file_number(const std::string& folder) {
  struct stat status {};
  if (::stat((fs::path(folder) / "results.json").c_str(), &status) != 0) return {};
  return status.st_ino;
}

/// While one exists, renderers that are started share the processors.
class SharedProcessors {
 public:
  explicit SharedProcessors(std::size_t by) : set_(std::getenv(threads_of_renderer) == nullptr && by > 1) {
    if (set_) ::setenv(threads_of_renderer, std::to_string(side_by_side() / by).c_str(), 1);
  }
  ~SharedProcessors() {
    if (set_) ::unsetenv(threads_of_renderer);
  }
  SharedProcessors(const SharedProcessors&) = delete;
  SharedProcessors& operator=(const SharedProcessors&) = delete;

 private:
  bool set_;
};

/// Passes on what one of them had to say, each remark once; returns its last error.
class Sayings {
 public:
  explicit Sayings(Console& console) : console_(console) {}

  std::string pass_on(const std::string& name, const std::string& text) {
    constexpr std::string_view program = "plumb: ", note = "note: ";
    std::string last;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      std::string line = text.substr(begin, end - begin);
      begin = end + 1;
      if (line.starts_with(program)) line.erase(0, program.size());
      if (line.starts_with(note)) {
        if (said_.insert(line).second) console_.remark(fmt::format("{}: {}", name, line.substr(note.size())));
      } else if (!line.empty()) {
        console_.error(fmt::format("{}: {}", name, line));
        last = line;
      }
    }
    return last;
  }

 private:
  Console& console_;
  std::set<std::string> said_;
};

/// The places of cases, those that are predicted to take longest first.
std::vector<std::size_t> longest_first(const std::vector<Planned>& cases) {
  std::vector<std::size_t> order(cases.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto predicted = [&](std::size_t k) { return cases[k].estimate.total(Resource::time); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return predicted(a) > predicted(b); });
  return order;
}

/// Leaves those of a share, dealt out by the time that they are predicted to take.
void keep_share(std::vector<Planned>& cases, const Share& share) {
  const std::vector<std::size_t> order = longest_first(cases);
  std::vector<bool> own(cases.size());
  for (std::size_t place = 0; place < order.size(); ++place) own[order[place]] = share.has(place);
  std::size_t k = 0;
  std::erase_if(cases, [&](const Planned&) { return !own[k++]; });
}

ExitStatus status_of_case(const OwnRunEnd& end) {
  // Whatever ended it from outside, there is nothing to look at.
  return end.fault.empty() ? static_cast<ExitStatus>(end.status) : ExitStatus::output_failed;
}

}  // namespace

ExitStatus run_many(const CaseList& list, const Options& options, Console& console) {
  refuse_options_for_one_case(options);
  const Share share = asked_share(options);
  const std::string folder =
      !options.output.empty()
          ? options.output
          : (list.folder.empty() ? std::string(default_index_folder)
                                 : (fs::path(default_index_folder) / list.folder).string()) +
                suffix_of(share);
  if (!options.history.empty()) check_history(options.history, console);
  ExitStatus worst = ExitStatus::done;
  std::vector<Planned> cases = planned(list, folder, options, console, worst);
  if (worst != ExitStatus::done) return worst;
  keep_share(cases, share);
  if (cases.empty())
    throw UsageError(
        fmt::format("--share {}: of {} cases this share has none", options.share, list.paths.size()));
  refuse_beyond_together(cases, folder, options);
  OutputFolder index(folder, use_of_index(console));
  if (!options.history.empty()) refuse_to_overwrite("--history", options.history, {}, index.path());

  const std::vector<std::size_t> order = longest_first(cases);
  std::vector<OwnRun> runs;
  std::vector<std::optional<ino_t>> before;
  std::vector<std::string> timed;
  for (const std::size_t k : order) {
    const Planned& one = cases[k];
    runs.push_back({arguments_for(options, one), one.estimate.total(Resource::memory), one.timed});
    before.push_back(file_number(one.folder));
    if (one.timed) timed.push_back(one.name);
  }
  const std::size_t at_once = std::clamp<std::size_t>(cases.size() - timed.size(), 1, side_by_side());
  if (!timed.empty() && cases.size() > 1)
    console.line(
        fmt::format("alone, after all others, as their studies are timed: {}", fmt::join(timed, ", ")));

  std::vector<IndexedReport> reports(cases.size());
  std::size_t ended = 0;
  Sayings sayings(console);
  const auto take = [&](std::size_t run, const OwnRunEnd& end) {
    const Planned& one = cases[order[run]];
    const auto now = file_number(one.folder);
    IndexedReport& report = reports[order[run]];
    // A start that is not finite leaves no report, and one of an earlier run says nothing of this one.
    if (now.has_value() && now != before[run])
      report = report_in(one.folder, one.name, find_document(one.folder), cases.size());
    else
      report.folder = one.name;
    const ExitStatus status = status_of_case(end);
    report.exit_status = static_cast<int>(status);
    const std::string how = end.fault.empty() ? fmt::format("exit {}", end.status) : end.fault;
    console.line(
        fmt::format("{:>3} of {}  {}  {:<24} {:>6.1f} s  {}", ++ended, cases.size(),
                    status == ExitStatus::done ? console.good(how) : console.bad(how), one.name, end.seconds,
                    report.document.is_null()
                        ? "no report"
                        : one_line(fmt::format("{}: {}", report.document.at("outcome").get<std::string>(),
                                               report.document.at("outcome_reason").get<std::string>()))));
    const std::string error = sayings.pass_on(one.name, end.errors);
    report.fault = end.fault.empty() ? error : end.fault;
    if (report.document.is_null() && !options.history.empty())
      append_history(options.history, entry_without_report(one.name, options.overrides, report.fault));
  };
  {
    const SharedProcessors shared(at_once);
    const auto stopping = [&] {
      if (ended > 0)
        console.remark(
            fmt::format("{} of {} cases are done, each in its folder below {}; the index is as it was", ended,
                        cases.size(), index.path()));
    };
    if (Job* job = job_of_process())
      run_in_job(*job, runs, take, stopping);
    else
      run_side_by_side(runs, memory_for_all(folder, options), take, stopping);
  }
  return write_index(std::move(reports), at_once, index, options, console);
}

}  // namespace plumb
