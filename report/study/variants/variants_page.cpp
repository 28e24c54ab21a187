#include "report/study/variants/variants_page.h"

#include <fmt/format.h>

#include <cmath>

#include "report/page/page_template.h"
#include "report/verdict/results.h"

namespace plumb {

extern const std::string_view page_css;
extern const std::string_view study_css;
extern const std::string_view variants_page_mustache;

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
  row["unit"] = figure.unit;
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

std::string to_variants_page(const VariantsResults& results, const std::vector<Picture>& pictures) {
  const Variants& study = results.study.result;
  data page;
  page["title"] = study.title;
  page["css"] = std::string(page_css) + std::string(study_css);
  page["headline"] = headline(results);
  page["good"] = all_passed(results.verdicts);
  data variants{data::type::list}, figures{data::type::list};
  bool any_figure = false;
  for (const VariantResult& variant : study.variants) {
    variants.push_back(variant_row(variant));
    for (const ExpectationFound& figure : variant.expectations) {
      figures.push_back(figure_row(variant, figure));
      any_figure = true;
    }
  }
  page.set("variants", variants);
  page["has_figures"] = any_figure;
  page.set("figures", figures);
  data drawn{data::type::list};
  for (const Picture& picture : pictures) {
    data values;
    values["uri"] = data_uri(picture.png);
    values["alt"] = picture.alt;
    values["title"] = picture.title;
    values["file"] = picture.file;
    drawn.push_back(values);
  }
  page["has_pictures"] = !pictures.empty();
  page.set("pictures", drawn);
  set_case_and_provenance(page, results.study.loaded.source, study.provenance, results.stages);
  return fill_in(variants_page_mustache, page);
}

}  // namespace plumb
