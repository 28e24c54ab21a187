#include "report/diff/difference_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/page/page_scripts.h"
#include "report/page/page_template.h"

namespace plumb {

extern const std::string_view difference_mustache, difference_css;

using kainjow::mustache::data;

namespace {

/// Pictures on the page, which has them whole.
constexpr std::size_t most_shown = 12;

}  // namespace

std::string headline(const std::vector<FileDifference>& files) {
  const auto count = [&](auto&& counts) { return std::count_if(files.begin(), files.end(), counts); };
  const auto failed = count([](const FileDifference&file) { return fails(file.sameness); }),
             within = count([](const FileDifference&file) { return file.sameness == Sameness::within; });
  const long all = compared(files);
  if (all == 0)
    return files.empty()
               ? "There is nothing to compare: that is no agreement"
               : fmt::format("Nothing in {} files can be compared: that is no agreement", files.size());
  const std::string rest = within > 0 ? fmt::format(", {} only within tolerance", within) : "";
  if (failed > 0) return fmt::format("{} of {} files differ{}", failed, all, rest);
  return fmt::format("None of {} files differs{}", all, rest);
}

std::string to_difference_page(const std::string& a, const std::string& b,
                               const std::vector<FileDifference>& files) {
  std::vector<const FileDifference*> order;
  for (const FileDifference& file : files) order.push_back(&file);
  std::stable_partition(order.begin(), order.end(),
                        [](const FileDifference* file) { return fails(file->sameness); });
  data page, rows{data::type::list}, pictures{data::type::list};
  const auto row_of = [](const FileDifference& file) {
    data row;
    row["name"] = file.name;
    row["word"] = word(file.sameness);
    row["bad"] = fails(file.sameness);
    row["in_words"] = file.in_words;
    return row;
  };
  for (const FileDifference* file : order) rows.push_back(row_of(*file));

  std::erase_if(order, [](const FileDifference* file) { return file->first.empty(); });
  std::stable_sort(order.begin(), order.end(), [](const FileDifference* one, const FileDifference* other) {
    return std::pair(fails(one->sameness), one->number) > std::pair(fails(other->sameness), other->number);
  });
  const std::size_t left_out = order.size() - std::min(order.size(), most_shown);
  order.resize(order.size() - left_out);
  for (const FileDifference* file : order) {
    data row = row_of(*file);
    row["first"] = data_uri(file->first);
    row["second"] = data_uri(file->second);
    row["has_marks"] = !file->marks.empty();
    if (!file->marks.empty()) row["marks"] = data_uri(file->marks);
    pictures.push_back(row);
  }
  page["first"] = a;
  page["second"] = b;
  page["headline"] = headline(files);
  page["good"] = !differs(files) && compared(files) > 0;
  page.set("rows", rows);
  page["left_out"] = left_out > 0
                         ? fmt::format("{} more pictures differ by less and are not shown.", left_out)
                         : std::string();
  page.set("pictures", pictures);
  return html_page(fmt::format("{} and {} – Plumb diff", a, b), difference_css,
                   fill_in(difference_mustache, page));
}

}  // namespace plumb
