#include "report/study/work_precision/compared_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace plumb {
namespace {

bool shown(const WorkPrecision& study, const WorkPrecisionRun& run, StudyQuestion question) {
  return fate_of(study, run, question) == RunFate::good && study.work(run) > 0;
}

/// Cost of the line's best run over that of the cheapest run with at most its error; infinite without a run.
double handicap(const WorkPrecision& study, const StudyLine& line, const std::vector<StudyLine>& all,
                StudyQuestion question) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t k : line.runs) {
    const WorkPrecisionRun& run = study.runs[k];
    if (!shown(study, run, question)) continue;
    double cheapest = study.work(run);
    for (const StudyLine& other : all)
      for (const std::size_t j : other.runs)
        if (shown(study, study.runs[j], question) &&
            errors_of(study.runs[j], question).tip_max <= errors_of(run, question).tip_max)
          cheapest = std::min(cheapest, study.work(study.runs[j]));
    least = std::min(least, study.work(run) / cheapest);
  }
  return least;
}

RunFate fate_of_error(const WorkPrecision& study, double error) {
  if (!std::isfinite(error) || error < 0) return RunFate::failed;
  return study.length > 0 && error > wrong_beyond * study.length ? RunFate::wrong : RunFate::good;
}

}  // namespace

const std::vector<std::size_t>& front_of(const WorkPrecision& study, StudyQuestion question) {
  return question == StudyQuestion::time ? study.time_front : study.total_front;
}

const CertifiedReference* reference_of(const WorkPrecision& study, StudyQuestion question) {
  if (question == StudyQuestion::total)
    return study.converged_reference.elements > 0 ? &study.converged_reference : nullptr;
  for (const CertifiedReference& reference : study.mesh_references)
    if (reference.elements == study.fixed_elements) return &reference;
  return nullptr;
}

RunFate fate_of(const WorkPrecision& study, const WorkPrecisionRun& run, StudyQuestion question) {
  return run.completed() ? fate_of_error(study, errors_of(run, question).tip_max) : RunFate::failed;
}

RunFate fate_of(const WorkPrecision& study, const GivenPoint& point, StudyQuestion question) {
  return fate_of_error(study, errors_of(point, question).tip_max);
}

std::string machine_in_words(const GivenCurve& curve) {
  if (!curve.machine.empty()) return curve.machine;
  return curve.is_elsewhere() ? "another machine" : "this machine";
}

std::string label_of(const WorkPrecision& study, const GivenCurve& curve) {
  constexpr std::size_t longest = 40;
  std::string program = curve.program;
  if (program.size() > longest) {
    // To the end of a word.
    const std::size_t end = program.find_last_of(' ', longest);
    program = program.substr(0, end == program.npos ? longest : end);
    while (!program.empty() && (program.back() & 0xc0) == 0x80) program.pop_back();
    program += "…";
  }
  std::string label = curve.name + (program.empty() ? " (external run)" : ": " + program);
  if (curve.threads > 1) label += fmt::format(", {} threads", curve.threads);
  if (study.is_scaled(curve))
    label += ", scaled from another machine";
  else if (curve.is_elsewhere())
    label += ", another machine";
  return label;
}

std::string trouble_of(const WorkPrecision& study, const WorkPrecisionRun& run, StudyQuestion question) {
  switch (fate_of(study, run, question)) {
    case RunFate::good:
      return "";
    case RunFate::wrong:
      return fmt::format("stable but wrong: {:.3g} m off", errors_of(run, question).tip_max);
    case RunFate::failed:
      break;
  }
  if (run.completed()) return "not compared: there is no reference that reaches its outputs";
  return run.message.empty() ? std::string(word(run.outcome)) : run.message;
}

bool any_compared(const WorkPrecision& study, StudyQuestion question) {
  return std::any_of(study.runs.begin(), study.runs.end(), [&](const WorkPrecisionRun& run) {
    return fate_of(study, run, question) != RunFate::failed;
  });
}

std::vector<StudyLine> study_lines(const WorkPrecision& study, StudyQuestion question) {
  std::vector<StudyLine> lines;
  for (std::size_t c = 0; c < study.curves.size(); ++c) {
    const MethodCurve& curve = study.curves[c];
    if (question == StudyQuestion::time && curve.elements != study.fixed_elements) continue;
    auto line = std::find_if(lines.begin(), lines.end(),
                             [&](const StudyLine& known) { return known.label == curve.label; });
    if (line == lines.end())
      line = lines.insert(lines.end(), {curve.label, curve.method, curve.family, {}, {}});
    line->curves.push_back(c);
    line->runs.insert(line->runs.end(), curve.runs.begin(), curve.runs.end());
  }
  return lines;
}

std::vector<StudyLine> chosen_lines(const WorkPrecision& study, StudyQuestion question, std::size_t most) {
  std::vector<StudyLine> lines = study_lines(study, question);
  if (lines.size() <= most) return lines;
  struct Rank {
    std::size_t line;
    std::size_t on_front;
    double handicap;
  };
  const std::vector<std::size_t>& front = front_of(study, question);
  std::vector<Rank> ranks;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto on_front = static_cast<std::size_t>(std::count_if(
        lines[i].runs.begin(), lines[i].runs.end(),
        [&](std::size_t run) { return std::find(front.begin(), front.end(), run) != front.end(); }));
    ranks.push_back({i, on_front, handicap(study, lines[i], lines, question)});
  }
  std::stable_sort(ranks.begin(), ranks.end(), [](const Rank& a, const Rank& b) {
    return a.on_front != b.on_front ? a.on_front > b.on_front : a.handicap < b.handicap;
  });
  std::set<std::size_t> chosen;
  std::map<MethodFamily, std::size_t> members;
  const auto choose = [&](const auto& wanted) {
    for (const Rank& rank : ranks) {
      const MethodFamily family = lines[rank.line].family;
      if (chosen.size() == most || chosen.contains(rank.line) || !wanted(rank, members[family])) continue;
      chosen.insert(rank.line);
      ++members[family];
    }
  };
  const std::size_t share = (most + 1) / 2;
  choose([](const Rank&, std::size_t of_family) { return of_family == 0; });
  choose([&](const Rank& rank, std::size_t of_family) { return rank.on_front > 0 && of_family < share; });
  choose([&](const Rank&, std::size_t of_family) { return of_family < share; });
  choose([](const Rank&, std::size_t) { return true; });
  std::vector<StudyLine> result;
  for (const std::size_t line : chosen) result.push_back(lines[line]);
  return result;
}

}  // namespace plumb
