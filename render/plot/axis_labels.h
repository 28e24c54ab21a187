#pragma once

#include <string>
#include <vector>

#include "render/plot/plot_layout.h"

namespace plumb {

/// A text around a panel, and where it stands.
struct PlacedText {
  std::string text;  ///< with markup
  TextStyle style;   ///< smaller than others of its kind where it would not fit
  Point at{0, 0};    ///< of its base line, pixels
  Align align = Align::left;
  bool turned = false;  ///< by 90° against the clock

  /// What it covers, from the top of its capitals to the foot of its descending letters.
  Rect box(const Font& font) const;
};

/// Labels of the ticks, their powers of ten, and the labels and title of a panel that is laid out. What is
/// empty is left out; no two of them meet.
std::vector<PlacedText> axis_labels(const Panel& panel, const PanelLayout& layout, const PlotSizes& sizes,
                                    const Font& font);

/// The title of a plot that is laid out.
PlacedText plot_title(const Plot& plot, const PlotLayout& layout, const PlotSizes& sizes, const Font& font);

}  // namespace plumb
