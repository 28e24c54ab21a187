#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "report/verdict/verdict.h"

namespace plumb {

/// A test case of junit.xml.
struct JunitCase {
  std::string name;
  VerdictStatus status;
  std::string message;
  double seconds = 0;
};

struct JunitSuite {
  std::string name;
  std::vector<JunitCase> cases;
  std::vector<std::pair<std::string, std::string>> properties = {};  ///< names and values
};

/// A suite for each kind of verdict that there is.
std::vector<JunitSuite> suites_of(const std::vector<Verdict>& verdicts);

/// The suites of a run: one for the integration before those of its verdicts.
std::vector<JunitSuite> suites_of(const nlohmann::ordered_json& document);

/// The text of junit.xml; `name` is that of the whole. Where there is no test case there is one that was
/// skipped.
std::string junit_xml(const std::string& name, std::vector<JunitSuite> suites);

}  // namespace plumb
