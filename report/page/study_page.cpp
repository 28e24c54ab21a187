#include "report/page/study_page.h"

#include <fmt/format.h>

#include "report/base/base64.h"
#include "report/base/escape.h"
#include "report/figure/pictures.h"
#include "report/page/page_template.h"
#include "report/page/verdict_html.h"

namespace plumb {

extern const std::string_view study_page_mustache;
extern const std::string_view page_css;

namespace {

using kainjow::mustache::data;

std::string from_hex(std::string_view hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16));
  return bytes;
}

}  // namespace

std::string study_shell(const StudyShell& shell, const std::vector<Verdict>& verdicts,
                        const CaseSource& source, const Provenance& provenance, const Stages& stages) {
  data page;
  page["title"] = shell.title;
  page["subject"] = shell.subject;
  page["css"] = std::string(page_css) + shell.css;
  page["script_policy"] = shell.script_policy;
  page["headline"] = shell.headline;
  page["good"] = shell.good;
  data sections{data::type::list};
  for (const auto& [id, text] : shell.sections) {
    data entry;
    entry["id"] = id;
    entry["text"] = text;
    sections.push_back(entry);
  }
  page.set("sections", sections);
  page["section"] = shell.section;
  page["has_verdicts"] = !verdicts.empty();
  page["verdicts"] = verdict_html(verdicts);
  page["verdict_note"] = shell.verdict_note;
  set_case_and_provenance(page, source, provenance, stages);
  page["scripts"] = shell.scripts;
  return fill_in(study_page_mustache, page);
}

std::string script_policy(const std::vector<std::string_view>& hashes) {
  std::string policy = "script-src";
  for (const std::string_view hash : hashes) policy += fmt::format(" 'sha256-{}'", base64(from_hex(hash)));
  return policy;
}

std::string script_element(std::string_view text) {
  return fmt::format("<script>{}</script>\n", text);
}

std::string data_element(const std::string& id, const std::string& json) {
  return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id,
                     escape_json_for_html(json));
}

const Picture* find_picture(const std::vector<Picture>& pictures, const std::string& name) {
  for (const Picture& picture : pictures)
    if (picture.file == fmt::format("figures/{}.png", name)) return &picture;
  return nullptr;
}

}  // namespace plumb
