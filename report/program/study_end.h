#pragma once

#include <string>
#include <vector>

#include "engine/run/output_folder.h"
#include "report/base/stages.h"
#include "report/program/console.h"
#include "report/program/options.h"
#include "report/verdict/verdict.h"

/// How every kind of study ends.
namespace plumb {

/// The report of a study: its files, and what is said of it.
struct StudyReport {
  std::string page, json, junit, summary;
  std::string headline;
  std::vector<Verdict> verdicts;
};

/// Of results with the functions to_json, to_junit, to_summary and headline.
template <class Results>
StudyReport study_report(const Results& results, std::string page) {
  return {std::move(page),     to_json(results),  to_junit(results),
          to_summary(results), headline(results), results.verdicts};
}

/// Writes index.html, results.json, junit.xml and summary.md, puts the folder in place and ends the stage.
/// Throws OutputError.
void put_in_place(const StudyReport& report, OutputFolder& folder, Stages& stages);

/// Says the headline, where the time went and where the report is; with --json prints results.json. The exit
/// status is that of the verdicts.
ExitStatus say_end(const StudyReport& report, const OutputFolder& folder, const Stages& stages,
                   const Options& options, Talk& talk);

}  // namespace plumb
