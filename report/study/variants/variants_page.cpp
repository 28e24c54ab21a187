#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/figure/number_markup.h"
#include "report/page/page_template.h"
#include "report/study/variants/variants_results.h"

namespace plumb {

extern const std::string_view variants_mustache;

namespace {

using kainjow::mustache::data;

data tag(const VariantResult& variant) {
  data values;
  const bool expects = variant.spec.expects_anything();
  values["class"] = !expects ? "not-run" : variant.met() ? "passed" : "failed";
  values["status"] = !expects ? "shown" : variant.met() ? "passed" : "failed";
  return values;
}

data variant_row(const VariantResult& variant) {
  const Trajectory& t = variant.trajectory;
  data row = tag(variant);
  row["name"] = variant.spec.name;
  data changes{data::type::list};
  for (const std::string& change : variant.spec.overrides) changes.push_back(data{"change", change});
  row["has_changes"] = !variant.spec.overrides.empty();
  row.set("changes", changes);
  row["expected"] = variant.spec.outcome.empty() ? "any outcome" : variant.spec.outcome;
  row["says"] = variant.spec.says;
  row["has_says"] = !variant.spec.says.empty();
  row["reason"] = variant.spec.reason;
  row["found"] = std::string(word(t.outcome));
  row["end"] = fmt::format("{:.4g} of {:.4g}", t.end_time, variant.run.time.end);
  row["steps"] = t.counters.steps < 0 ? "–" : std::to_string(t.counters.steps);
  row["message"] = t.message;
  return row;
}

data figure_row(const VariantResult& variant, const ExpectationFound& figure) {
  const ExpectationSpec& expected = figure.expected;
  data row;
  row["variant"] = variant.spec.name;
  row["quantity"] = expected.from.empty() ? expected.quantity
                                          : fmt::format("{} from \"{}\"", expected.quantity, expected.from);
  row["unit"] = unit_text(figure.unit);
  row["expected"] = to_margin(expected.value, expected.within);
  row["within"] = fmt::format("{:.2g}", expected.within);
  row["found"] = to_margin(figure.found, expected.within);
  const double off = figure.found - expected.value;
  row["off"] = std::isfinite(off) ? fmt::format("{:+.2g}", off) : "–";
  row["source"] = expected.source;
  row["class"] = figure.met() ? "passed" : "failed";
  row["status"] = figure.met() ? "passed" : "failed";
  return row;
}

}  // namespace

StudySection shown_variants(const Variants& study, const std::vector<Picture>& pictures) {
  data values, variants{data::type::list}, figures{data::type::list};
  for (const VariantResult& variant : study.variants) {
    variants.push_back(variant_row(variant));
    for (const ExpectationFound& figure : variant.expectations)
      figures.push_back(figure_row(variant, figure));
  }
  StudySection section;
  section.links = {{"variants", "Variants"}};
  if (!figures.list_value().empty()) section.links.emplace_back("figures", "Figures");
  if (!pictures.empty()) section.links.emplace_back("pictures", "Pictures");
  const auto any = [&](auto is) { return std::any_of(study.variants.begin(), study.variants.end(), is); };
  const bool any_early = any(ended_early);
  values["has_messages"] =
      any([](const VariantResult& variant) { return !variant.trajectory.message.empty(); });
  values["has_shown"] = any([](const VariantResult& variant) { return !variant.spec.expects_anything(); });
  values["any_early"] = any_early;
  values["has_figures"] = !figures.list_value().empty();
  values["has_pictures"] = !pictures.empty();
  values.set("variants", variants);
  values.set("figures", figures);
  values.set("pictures", picture_rows(pictures));
  section.html = fill_in(variants_mustache, values);
  section.verdict_note = std::string("All are <strong>verification</strong>") +
                         (any_early ? ": a failure that is expected and shown is one that is passed." : ".");
  return section;
}

}  // namespace plumb
