#include "report/page/page_data.h"

namespace plumb {
namespace {

Document figures_of(const Document& document) {
  Document figures = Document::array();
  for (const char* list : {"figures", "study_figures", "error_budget_figures"}) {
    if (!document.contains(list)) continue;
    for (const Document& figure : document.at(list))
      if (figure.contains("panels"))
        figures.push_back({{"file", figure.at("file")},
                           {"title", figure.at("title")},
                           {"chart", list == std::string("figures")},
                           {"panels", figure.at("panels")}});
  }
  return figures;
}

}  // namespace

std::string page_data(const Document& document) {
  const Document data{{"figures", figures_of(document)},
                      {"frame_rate", document.at("animation").at("player_frame_rate")},
                      {"end_time", document.at("solve").at("end_time")}};
  return data.dump(-1, ' ', false, Document::error_handler_t::replace);
}

}  // namespace plumb
