#include "report/document/changes.h"
#include "report/document/document.h"
#include "report/document/regression.h"
#include "report/page/page.h"
#include "report/program/run_sections.h"
#include "tests/fuzz/target.h"
#include "tests/report/made_run.h"

namespace plumb::fuzz {
namespace {

Document small_document() {
  static const Run run = run_with("made");
  return document_of(evaluate(run, {}), {});
}

/// As the program does with it: the page again from it alone, and what moved since an earlier one.
bool feed(std::string_view input) {
  static const MemoryFile file("results.json");
  static const Document known = small_document();
  return reads<InputError, Document::exception>([&] {
    const Document document = read_document(file.hold(input));
    verdicts_of(document);
    try {
      Document now = known;
      hold_against_baseline(now, document, "before", default_regression_share);
      to_junit(now);
    } catch (const InputError&) {
      // That of another case.
    }
    const std::string page =
        to_page(document, pictures_of(document, "/dev/shm/plumb-fuzz-nothing"), page_sections());
    promise(page.find("<html") != std::string::npos, "a page that is none");
    to_junit(document);
    promise(to_summary(document).size() < 64 * 1024, "a summary of 64 KiB or more");
  });
}

std::vector<std::string> seeds() {
  return {to_json(small_document())};
}

}  // namespace

const Target results_target{"results", feed, seeds};

}  // namespace plumb::fuzz
