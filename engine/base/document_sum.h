#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace plumb {

/// The key of a JSON document of Plumb's that holds the SHA-256 of all else in it, so that one that was
/// changed after it was written is known. It is over keys and values: neither their order nor white space
/// matters.
inline constexpr const char* check_sum_key = "check_sum";

enum class DocumentSum { right, wrong, none };

/// Whether a document is as it was written.
DocumentSum sum_in(const nlohmann::json& document);

/// The text of an object with its check sum, ended by a new line. `indent` is as in `dump`: -1 is one line.
std::string to_summed_text(nlohmann::ordered_json document, int indent);

/// Throws InputError, which names the file, for a document that was changed, or where it must have a check
/// sum has none.
void refuse_changed(const nlohmann::json& document, const std::string& file, bool must_have_sum);

/// The same for the text of a document that must have a check sum; also for one that is no JSON.
void refuse_changed_text(const std::string& text, const std::string& file);

/// What to say where a document without a check sum is taken as it is.
std::string remark_without_sum(const std::string& file);

}  // namespace plumb
