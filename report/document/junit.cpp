#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "report/base/escape.h"
#include "report/document/document.h"
#include "report/document/junit_suites.h"
#include "report/document/report_formats.h"
#include "report/verdict/results.h"

namespace plumb {
namespace {

long failed_in(const JunitSuite& suite) {
  return std::count_if(suite.cases.begin(), suite.cases.end(),
                       [](const JunitCase& c) { return c.status == VerdictStatus::failed; });
}

/// Those that were not run, or are shown alone.
long skipped_in(const JunitSuite& suite) {
  return std::ssize(suite.cases) - failed_in(suite) -
         std::count_if(suite.cases.begin(), suite.cases.end(),
                       [](const JunitCase& c) { return c.status == VerdictStatus::passed; });
}

/// "rk4, 4 elements", or "given by chrono.csv".
std::string integration_name(const Document& document) {
  if (document.contains("computed_by")) return "given by " + document.at("computed_by").get<std::string>();
  const Document& solve = document.at("solve");
  return fmt::format("{}, {}", solve.at("method").get<std::string>(),
                     counted(solve.at("elements").get<long>(), "element", "elements"));
}

}  // namespace

std::vector<JunitSuite> suites_of(const std::vector<Verdict>& verdicts) {
  std::vector<JunitSuite> all;
  for (const VerdictKind kind : {VerdictKind::verification, VerdictKind::validation, VerdictKind::regression,
                                 VerdictKind::performance}) {
    JunitSuite suite{std::string(word(kind)), {}};
    for (const Verdict& verdict : verdicts)
      if (verdict.kind == kind)
        suite.cases.push_back({verdict.name + ": " + verdict.criterion, verdict.status, verdict.message, 0});
    if (!suite.cases.empty()) all.push_back(std::move(suite));
  }
  return all;
}

std::vector<JunitSuite> suites_of(const Document& document) {
  const Document& solve = document.at("solve");
  const std::string name = integration_name(document);
  std::vector<JunitSuite> all = suites_of(verdicts_of(document));
  all.insert(
      all.begin(),
      {"integration",
       {{name, document.at("complete").get<bool>() ? VerdictStatus::passed : VerdictStatus::failed,
         solve.at("message").get<std::string>(), std::max(0.0, solve.at("solve_seconds").get<double>())}},
       {{"outcome", document.at("outcome").get<std::string>()},
        {"outcome_reason", document.at("outcome_reason").get<std::string>()}}});
  return all;
}

std::string to_junit(const Document& document) {
  return junit_xml(document.at("title").get<std::string>(), suites_of(document));
}

std::string junit_xml(const std::string& name, std::vector<JunitSuite> all) {
  // No test at all would be shown as success.
  if (std::all_of(all.begin(), all.end(), [](const JunitSuite& suite) { return suite.cases.empty(); }))
    all.push_back(
        {"criteria", {{"none", VerdictStatus::not_run, "there is no criterion: nothing was judged"}}});
  long tests = 0, failures = 0, skipped = 0;
  for (const JunitSuite& suite : all) {
    tests += std::ssize(suite.cases);
    failures += failed_in(suite);
    skipped += skipped_in(suite);
  }
  const std::string title = escape_xml(name);
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" tests=\"{}\" failures=\"{}\" "
      "skipped=\"{}\">\n",
      title, tests, failures, skipped);
  for (const JunitSuite& suite : all) {
    xml += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\">\n",
                       escape_xml(suite.name), suite.cases.size(), failed_in(suite), skipped_in(suite));
    if (!suite.properties.empty()) {
      xml += "    <properties>\n";
      for (const auto& [property, value] : suite.properties)
        xml += fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", escape_xml(property),
                           escape_xml(value));
      xml += "    </properties>\n";
    }
    for (const JunitCase& test : suite.cases) {
      xml += fmt::format("    <testcase classname=\"{}.{}\" name=\"{}\" time=\"{:.3f}\"", title,
                         escape_xml(suite.name), escape_xml(test.name), test.seconds);
      if (test.status == VerdictStatus::passed) {
        // Over how much it passed.
        xml += test.message.empty() ? "/>\n"
                                    : fmt::format(">\n      <system-out>{}</system-out>\n    </testcase>\n",
                                                  escape_xml(test.message));
        continue;
      }
      // Some viewers show the attribute, some the text.
      const char* element = test.status == VerdictStatus::failed ? "failure" : "skipped";
      xml += fmt::format(">\n      <{0} message=\"{1}\">{1}</{0}>\n    </testcase>\n", element,
                         escape_xml(test.message));
    }
    xml += "  </testsuite>\n";
  }
  return xml + "</testsuites>\n";
}

ReportFormat junit_xml_format() {
  return {"junit.xml", [](const ReportContent& content) { return junit_xml(content.title, content.suites); }};
}

}  // namespace plumb
