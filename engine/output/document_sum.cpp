#include "engine/output/document_sum.h"

#include <fmt/format.h>

#include "engine/errors.h"
#include "engine/input/parse_json.h"
#include "engine/message.h"
#include "engine/output/sha256.h"

namespace plumb {
namespace {

using nlohmann::json;

/// `nlohmann::json` has its keys sorted.
std::string sum_of(json document) {
  document.erase(check_sum_key);
  return sha256(document.dump(-1, ' ', false, json::error_handler_t::replace));
}

}  // namespace

DocumentSum sum_in(const json& document) {
  const auto stored = document.find(check_sum_key);
  if (stored == document.end()) return DocumentSum::none;
  return *stored == sum_of(document) ? DocumentSum::right : DocumentSum::wrong;
}

std::string to_summed_text(nlohmann::ordered_json document, int indent) {
  document.erase(check_sum_key);
  // As a reader will see it: what is not finite is null.
  const std::string sum = sum_of(json::parse(document.dump(-1, ' ', false, json::error_handler_t::replace)));
  document[check_sum_key] = sum;
  return document.dump(indent, ' ', false, json::error_handler_t::replace) + "\n";
}

void refuse_changed(const json& document, const std::string& file, bool must_have_sum) {
  const DocumentSum sum = document.is_object() ? sum_in(document) : DocumentSum::none;
  if (sum == DocumentSum::wrong)
    throw InputError(one_line(
        fmt::format("{}: cannot be used: it was changed after it was written: its {} is not that of its "
                    "content",
                    file, check_sum_key)));
  if (sum == DocumentSum::none && must_have_sum)
    throw InputError(one_line(fmt::format(
        "{}: cannot be used: it has no {}, as all has that this version writes", file, check_sum_key)));
}

void refuse_changed_text(const std::string& text, const std::string& file) {
  refuse_changed(parse_json<json>(text, file), file, true);
}

std::string remark_without_sum(const std::string& file) {
  return fmt::format("{} has no {}: nothing tells whether it is as it was written", file, check_sum_key);
}

}  // namespace plumb
