#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/codec.h"
#include "engine/run/provenance.h"
#include "engine/study/journal.h"
#include "engine/study/workers.h"

namespace plumb {

/// Which points of a part are computed where a study is divided into shares.
enum class Division {
  split,   ///< each point by one share
  shared,  ///< all of them by every share: what comes later needs them
};

/// Points that are asked for together.
struct Part {
  Part(const char* part_name, Company part_company = Company::together,
       Division part_division = Division::split)
      : name(part_name), company(part_company), division(part_division) {}
  Part(const char* part_name, Division part_division) : name(part_name), division(part_division) {}

  std::string name;  ///< "references", "errors"
  Company company = Company::together;
  Division division = Division::split;
};

/// Which points of a study this program computes, of those that its journal has not.
struct Scope {
  std::size_t share = 1;  ///< 1 to `shares`
  std::size_t shares = 1;
  bool computes = true;                            ///< false: none, what is there is put together
  std::optional<std::set<std::string>> only = {};  ///< keys: none but these
};

/// Thrown where this program has done what it was to do of a study, and that is not the whole.
struct NotWhole : std::exception {
  const char* what() const noexcept override { return "the rest of the study is computed elsewhere"; }
};

/// Called now and then with the part of a study that is under way ("references", "errors") and the
/// share of it that is done, 0 to 1. Never called twice at once, but from any thread.
using StudyProgress = std::function<void(const std::string& part, double share)>;

/// A piece of a study that can be computed by itself.
template <class Result>
struct StudyPoint {
  std::string key;  ///< all that its result depends on, beside what the journal's identity has
  std::function<Result()> compute;
  double work = 1;        ///< as of a Task; the same in every share
  std::size_t group = 0;  ///< as of a Task
  double patience = 60;   ///< as of a Task
};

/// Runs the points of a study. What the journal holds is not computed again; each other result is written
/// down as soon as it is there, and read back from what was written, so that a study that was interrupted
/// gives what one gives that was not.
///
/// Where it computes a share only, points of others have the result `Result{}`, and the study ends with
/// conclude() before anything is made of them.
class Runner {
 public:
  explicit Runner(Journal& journal, StudyProgress progress = {});
  Runner(Journal& journal, StudyProgress progress, Workers& workers, Scope scope = {});

  /// Points that are planned: their results, in the order of the points, are there after compute().
  template <class Result>
  using Planned = std::shared_ptr<std::vector<Result>>;

  /// Plans points, which are computed with all that is planned beside them, so that no part waits for the
  /// last point of another. `lost` makes the result of one whose process left none, and is needed for those
  /// apart.
  template <class Result>
  Planned<Result> plan(const Part& part, std::vector<StudyPoint<Result>> asked,
                       const std::function<Result(std::size_t, const std::string& fault)>& lost = {}) {
    const auto results = std::make_shared<std::vector<Result>>(asked.size());
    const auto points = std::make_shared<const std::vector<StudyPoint<Result>>>(std::move(asked));
    PlannedPart planned{part, {}, {}, {}};
    for (std::size_t k = 0; k < points->size(); ++k) {
      const StudyPoint<Result>& point = (*points)[k];
      const bool known = find(part.name, point, (*results)[k]);
      planned.points.push_back({full_key(part.name, point.key), known, true});
      planned.tasks.push_back(
          {[points, k] { return timed([&] { return text_of(encode((*points)[k].compute())); }); }, point.work,
           point.group, point.patience, planned.points.back().key});
    }
    planned.read = [results](std::size_t k, const std::string& line) { (*results)[k] = read<Result>(line); };
    if (lost)
      planned.lost = [lost](std::size_t k, const std::string& fault) {
        return text_of(encode(lost(k, fault)));
      };
    add(std::move(planned));
    return results;
  }

  /// Computes all that is planned; `what` it is called together. Throws NotWhole where something is missing
  /// that what follows would need.
  void compute(const std::string& what);

  /// Plans and computes one part: the results of its points, in their order.
  template <class Result>
  std::vector<Result> run(const Part& part, std::vector<StudyPoint<Result>> points,
                          const std::function<Result(std::size_t, const std::string& fault)>& lost = {}) {
    const Planned<Result> planned = plan(part, std::move(points), lost);
    compute(part.name);
    return std::move(*planned);
  }

  /// The result of one point, found or computed by the caller: a part of another point, which is worth
  /// keeping where that one is interrupted. What the journal has is taken if it is `good`.
  template <class Result>
  Result once(const std::string& part, const StudyPoint<Result>& point,
              const std::function<bool(const Result&)>& good = {}) {
    Result result{};
    if (find(part, point, result) && (!good || good(result))) return result;
    const auto [seconds, line] = untimed(timed([&] { return text_of(encode(point.compute())); }));
    journal_.add(full_key(part, point.key), line, seconds);
    return read<Result>(line);
  }

  /// After the last part: throws NotWhole unless all of its points are there. What comes after evaluates
  /// them.
  void conclude() const;

  /// Whether the known points of parts were computed on processors of one kind, so that their times may be
  /// held against one another.
  bool alike(const std::vector<std::string>& parts) const;
  /// That of this program now, and where points came from that were computed elsewhere.
  Provenance provenance() const;

  /// The keys of points that this program was not to compute and that are not there.
  const std::vector<std::string>& missing() const { return missing_; }
  /// How many points were planned, and how many of them are this program's own, known or computed.
  std::size_t points() const { return points_; }
  std::size_t own_points() const { return own_points_; }

  /// What another program needs of the journal to compute what is missing, as the text of a journal that
  /// names it.
  std::string missing_text(const StudyIdentity& identity) const;

  void say(const std::string& part, double share);

 private:
  struct PointState {
    std::string key;  // with its part
    bool known;
    bool own = true;  // to be computed here
  };
  struct PlannedPart {
    Part part;
    std::vector<PointState> points;
    std::vector<Task> tasks;  // one a point
    std::function<void(std::size_t point, const std::string& line)> read;
    std::function<std::string(std::size_t point, const std::string& fault)> lost = {};
  };

  static std::string full_key(const std::string& part, const std::string& key) { return part + ": " + key; }
  /// A line with the seconds of the processor before it that it took to compute, and these apart again.
  static std::string timed(const std::function<std::string()>& compute);
  static std::pair<double, std::string> untimed(const std::string& line);
  static std::string text_of(const nlohmann::ordered_json& json);
  void add(PlannedPart planned);
  std::vector<bool> own_of(const PlannedPart& planned) const;
  void compute_in(Company company, std::vector<PlannedPart>& parts, const std::string& what);
  void spread(PlannedPart& planned);

  template <class Result>
  static Result read(const std::string& line) {
    return decoded<Result>(nlohmann::ordered_json::parse(line));
  }

  template <class Result>
  bool find(const std::string& part, const StudyPoint<Result>& point, Result& result) const {
    const auto line = journal_.find(full_key(part, point.key));
    if (!line) return false;
    try {
      result = read<Result>(*line);
    } catch (const std::exception&) {  // of another version
      return false;
    }
    return true;
  }

  Journal& journal_;
  StudyProgress progress_;
  LocalWorkers own_workers_;
  Workers* workers_;
  Scope scope_;
  std::vector<PlannedPart> planned_;
  std::map<std::string, std::set<std::string>> processors_;  // by part
  std::set<std::string> kept_for_others_;                    // begins of keys
  std::vector<std::string> missing_;
  std::size_t points_ = 0;
  std::size_t own_points_ = 0;
  std::mutex saying_;
};

}  // namespace plumb
