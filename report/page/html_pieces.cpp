#include "report/page/html_pieces.h"

#include <algorithm>

namespace plumb {

std::string_view HtmlPiece::name() const {
  if (!is_tag) return {};
  return text.substr(1, text.find_first_of(" >\n", 1) - 1);
}

std::vector<HtmlPiece> html_pieces(std::string_view html) {
  std::vector<HtmlPiece> pieces;
  while (!html.empty()) {
    const bool is_tag = html.front() == '<';
    const std::size_t end = is_tag ? html.find('>') : html.find('<');
    const std::size_t length = std::min(html.size(), is_tag && end != html.npos ? end + 1 : end);
    pieces.push_back({html.substr(0, length), is_tag});
    html.remove_prefix(length);
  }
  return pieces;
}

}  // namespace plumb
