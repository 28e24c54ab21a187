#include "report/document/document.h"
#include "report/study/uncertainty/budget_section.h"
#include "report/study/uncertainty/uncertainty_section.h"
#include "tests/fuzz/target.h"
#include "tests/report/made_run.h"
#include "tests/report/study/uncertainty/made_assessment.h"

namespace plumb::fuzz {
namespace {

const Run& made_run() {
  static const Run run = run_with("made", R"([uncertainty]
samples = 4
seed = 9
[[uncertainty.input]]
key = "cable.density"
spread = 0.25
relative = true
source = "a <sheet>"
[error_budget]
reference = "known"
interval = 0.001
[[error_budget.item]]
name = "gravity"
set = { loads.gravity = [0, 0, 0] }
reason = "as <stated>"
[[error_budget.item]]
name = "step"
set = { method.step = 0.2 }
[[error_budget.item]]
name = "strain"
set = { cable.strain = "engineering-material" }
together = false
)");
  return run;
}

bool feed(std::string_view input) {
  return reads<InputError>([&] {
    const Assessment read = decode_assessment(std::string(input), "assessment.json", made_run());
    const std::string written = encode_assessment(read);
    promise(encode_assessment(decode_assessment(written, "assessment.json", made_run())) == written,
            "an assessment that is written and read again is another");
    std::vector<RunSection> sections;
    if (read.uncertainty) sections.push_back(uncertainty_section(*read.uncertainty, made_run().loaded.spec));
    if (read.error_budget) sections.push_back(budget_section(*read.error_budget));
    document_of(evaluate(made_run(), {}, sections), {});
  });
}

std::vector<std::string> seeds() {
  return {encode_assessment({made_uncertainty(), made_budget()}),
          encode_assessment({made_uncertainty(PartState::no_part), {}}),
          encode_assessment({{}, made_budget()})};
}

}  // namespace

const Target assessment_target{"assessment", feed, seeds};

}  // namespace plumb::fuzz
