#include "report/difference_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/page_template.h"

namespace plumb {

extern const std::string_view page_css;
extern const std::string_view difference_mustache;

using kainjow::mustache::data;

std::string headline(const std::vector<FileDifference>& files) {
  long compared = 0, failed = 0, within = 0;
  for (const FileDifference& file : files) {
    if (file.sameness != Sameness::not_compared) ++compared;
    if (fails(file.sameness)) ++failed;
    if (file.sameness == Sameness::within) ++within;
  }
  const std::string rest = within > 0 ? fmt::format(", {} only within tolerance", within) : "";
  if (failed > 0) return fmt::format("{} of {} files differ{}", failed, compared, rest);
  return fmt::format("None of {} files differs{}", compared, rest);
}

std::string to_difference_page(const std::string& a, const std::string& b,
                               const std::vector<FileDifference>& files) {
  std::vector<const FileDifference*> order;
  for (const FileDifference& file : files) order.push_back(&file);
  std::stable_partition(order.begin(), order.end(),
                        [](const FileDifference* file) { return fails(file->sameness); });
  data page, rows{data::type::list}, pictures{data::type::list};
  for (const FileDifference* file : order) {
    data row;
    row["name"] = file->name;
    row["word"] = word(file->sameness);
    row["bad"] = fails(file->sameness);
    row["in_words"] = file->in_words;
    rows.push_back(row);
    if (file->first.empty()) continue;
    row["first"] = data_uri(file->first);
    row["second"] = data_uri(file->second);
    row["has_marks"] = !file->marks.empty();
    if (!file->marks.empty()) row["marks"] = data_uri(file->marks);
    pictures.push_back(row);
  }
  page["css"] = std::string(page_css);
  page["first"] = a;
  page["second"] = b;
  page["headline"] = headline(files);
  page["good"] =
      std::none_of(files.begin(), files.end(), [](const FileDifference& f) { return fails(f.sameness); });
  page.set("rows", rows);
  page.set("pictures", pictures);
  return fill_in(difference_mustache, page);
}

}  // namespace plumb
