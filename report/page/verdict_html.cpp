#include "report/page/verdict_html.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/base/document_value.h"
#include "report/figure/number_markup.h"
#include "report/page/page_template.h"

namespace plumb {

extern const std::string_view verdicts_mustache;

namespace {

using kainjow::mustache::data;

data verdict_rows(const std::vector<Verdict>& verdicts) {
  std::vector<const Verdict*> order;
  for (const Verdict& verdict : verdicts) order.push_back(&verdict);
  // What failed comes first, then what was not run.
  std::stable_sort(order.begin(), order.end(), [](const Verdict* a, const Verdict* b) {
    return urgency(a->status) < urgency(b->status);
  });
  data rows{data::type::list};
  for (const Verdict* verdict : order) {
    data row;
    row["status"] = std::string(word(verdict->status));
    row["class"] = class_of(verdict->status);
    row["kind"] = std::string(word(verdict->kind));
    row["name"] = verdict->name;
    row["criterion"] = verdict->criterion;
    row["found"] = verdict->status == VerdictStatus::not_run
                       ? "not run"
                       : four_digits(verdict->value) + unit_after(verdict->unit);
    // Where nothing at all is allowed, there is no share of it.
    row["share"] = verdict->status == VerdictStatus::not_run ||
                           verdict->status == VerdictStatus::another_model || !(verdict->limit > 0)
                       ? "–"
                       : fmt::format("{:.3g} %", 100 * verdict->value / verdict->limit);
    row["detail"] = verdict->detail;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::string class_of_status(std::string status) {
  std::replace(status.begin(), status.end(), ' ', '-');
  return status;
}

std::string class_of(VerdictStatus status) {
  return class_of_status(std::string(word(status)));
}

std::string verdict_html(const std::vector<Verdict>& verdicts) {
  data values;
  values["verdicts"] = verdict_rows(verdicts);
  return fill_in(verdicts_mustache, values);
}

}  // namespace plumb
