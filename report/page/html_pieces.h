#pragma once

#include <string_view>
#include <vector>

namespace plumb {

/// A tag, "<td class=…>", or the text between two tags, still escaped.
struct HtmlPiece {
  std::string_view text;
  bool is_tag = false;

  /// "td" of <td …> and "/td" of </td>; empty for a text.
  std::string_view name() const;
};

/// HTML that this program made, in which no attribute has a ">", piece by piece.
std::vector<HtmlPiece> html_pieces(std::string_view html);

}  // namespace plumb
