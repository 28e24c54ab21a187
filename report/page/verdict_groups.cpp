#include "report/page/verdict_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/base/document_value.h"
#include "report/figure/number_markup.h"
#include "report/page/page_template.h"
#include "report/page/verdict_html.h"

namespace plumb {

extern const std::string_view verdict_groups_mustache;

const std::array<KindText, 4> kind_texts{
    KindText{VerdictKind::validation, "Validation",
             "Held against published figures: does the model describe what was published? No closer than the "
             "uncertainty of those figures."},
    KindText{
        VerdictKind::verification, "Verification",
        "Held against an exact or a converged solution: are the equations solved right? It tells nothing of "
        "the real thing."},
    KindText{
        VerdictKind::regression, "Regression",
        "Held against Plumb's own earlier output: has anything moved? An error that stays the same passes."},
    KindText{VerdictKind::performance, "Performance",
             "Work against error: what does an answer cost? It does not make the answer right."}};

namespace {

using kainjow::mustache::data;

std::string with_unit(double value, const std::string& unit) {
  return four_digits(value) + unit_after(unit);
}

std::string margin(const Verdict& verdict) {
  const bool judged = verdict.status == VerdictStatus::passed || verdict.status == VerdictStatus::failed;
  if (!judged || !std::isfinite(verdict.value)) return "–";
  const double rest = verdict.limit - verdict.value;
  std::string text = with_unit(std::abs(rest), verdict.unit) + (rest >= 0 ? " to spare" : " too much");
  // Where nothing at all is allowed, there is no share of it.
  if (verdict.limit > 0) text += fmt::format(" ({:.3g} % of the limit)", 100 * verdict.value / verdict.limit);
  return text;
}

data row_of(const Verdict& verdict) {
  data row;
  row["status"] = std::string(word(verdict.status));
  row["class"] = class_of(verdict.status);
  row["name"] = verdict.name;
  row["criterion"] = verdict.criterion;
  row["found"] =
      verdict.status == VerdictStatus::not_run ? "not run" : with_unit(verdict.value, verdict.unit);
  row["margin"] = margin(verdict);
  row["detail"] = verdict.detail;
  return row;
}

/// "2 failed, 1 not run, 3 passed"
std::string counts(const std::vector<Verdict>& verdicts) {
  std::string text;
  for (const VerdictStatus status : statuses_by_urgency) {
    const long n = count_of(verdicts, status);
    if (n > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", n, word(status));
  }
  return text;
}

struct Group {
  KindText text;
  std::vector<Verdict> verdicts;
};

std::vector<Group> groups_of(const std::vector<Verdict>& verdicts) {
  std::vector<Group> groups;
  for (const KindText& text : kind_texts) {
    Group group{text, {}};
    for (const Verdict& verdict : verdicts)
      if (verdict.kind == text.kind) group.verdicts.push_back(verdict);
    std::stable_sort(group.verdicts.begin(), group.verdicts.end(), [](const Verdict& a, const Verdict& b) {
      return urgency(a.status) < urgency(b.status);
    });
    groups.push_back(std::move(group));
  }
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    const auto worst = [](const Group& g) {
      return g.verdicts.empty() ? std::ssize(statuses_by_urgency) : urgency(g.verdicts.front().status);
    };
    return worst(a) < worst(b);
  });
  return groups;
}

}  // namespace

std::string verdict_groups(const std::vector<Verdict>& verdicts, const std::string& command) {
  data groups{data::type::list}, none{data::type::list};
  for (const Group& group : groups_of(verdicts)) {
    data item;
    item["kind"] = std::string(word(group.text.kind));
    item["title"] = group.text.title;
    item["evidence"] = group.text.evidence;
    if (group.verdicts.empty()) {
      none.push_back(item);
      continue;
    }
    item["counts"] = counts(group.verdicts);
    item["command"] = command;
    data rows{data::type::list};
    for (const Verdict& verdict : group.verdicts) rows.push_back(row_of(verdict));
    item.set("verdicts", rows);
    groups.push_back(item);
  }
  data values;
  values["has_none"] = none.is_non_empty_list();
  values.set("groups", groups);
  values.set("none", none);
  return fill_in(verdict_groups_mustache, values);
}

data verdict_marks(const std::vector<Verdict>& verdicts) {
  data marks{data::type::list};
  for (const Group& group : groups_of(verdicts)) {
    data mark;
    mark["title"] = group.text.title;
    const bool any = !group.verdicts.empty();
    mark["class"] = any ? class_of(group.verdicts.front().status) : std::string("none");
    mark["counts"] = any ? counts(group.verdicts) : std::string("none");
    mark["link"] = any ? data(std::string(word(group.text.kind)) + "-verdicts") : data(false);
    marks.push_back(mark);
  }
  return marks;
}

}  // namespace plumb
