#include "engine/base/document_sum.h"

#include <fmt/format.h>

#include "engine/base/errors.h"
#include "engine/base/message.h"
#include "engine/base/parse_json.h"
#include "engine/base/sha256.h"

namespace plumb {
namespace {

using Json = nlohmann::json;

/// `nlohmann::json` has its keys sorted.
std::string sum_of(Json document) {
  document.erase(check_sum_key);
  return sha256(document.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

DocumentSum sum_in(const Json& document) {
  const auto stored = document.find(check_sum_key);
  if (stored == document.end()) return DocumentSum::none;
  return *stored == sum_of(document) ? DocumentSum::right : DocumentSum::wrong;
}

std::string to_summed_text(nlohmann::ordered_json document, int indent) {
  document.erase(check_sum_key);
  // As a reader will see it: what is not finite is null.
  const std::string sum = sum_of(Json::parse(document.dump(-1, ' ', false, Json::error_handler_t::replace)));
  document[check_sum_key] = sum;
  return document.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

void refuse_changed(const Json& document, const std::string& file, bool must_have_sum) {
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
  refuse_changed(parse_json<Json>(text, file), file, true);
}

std::string remark_without_sum(const std::string& file) {
  return fmt::format("{} has no {}: nothing tells whether it is as it was written", file, check_sum_key);
}

}  // namespace plumb
