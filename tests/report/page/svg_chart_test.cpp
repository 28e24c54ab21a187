#include "report/page/svg_chart.h"

#include <gtest/gtest.h>

#include <regex>

namespace plumb {
namespace svg_chart_test {

TEST(SvgChart, TickLabelsDoNotRunIntoTheLabelOfTheAxis) {
  constexpr double letter = 6.5, foot_of_label = 16;
  for (const double size : {1e-14, 0.001234, 1.0, 98765.0, 1e9}) {
    SvgChart chart;
    chart.width = 400;
    chart.height = 200;
    chart.x = fitted_axis({0, 1}, false, "x");
    chart.y = fitted_axis({size, 1.0004 * size}, false, "speed [m s⁻¹]");
    const std::string svg = to_svg(chart);
    const std::regex label("<text x=\"([-0-9.]+)\" y=\"[-0-9.]+\" text-anchor=\"end\">([^<]*)</text>");
    long seen = 0;
    for (std::sregex_iterator at(svg.begin(), svg.end(), label), end; at != end; ++at, ++seen) {
      const std::string text = (*at)[2];
      const auto letters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
      EXPECT_GE(std::stod((*at)[1]) - letter * static_cast<double>(letters), foot_of_label)
          << "'" << text << "' of values about " << size;
    }
    EXPECT_GE(seen, 2) << svg;
    EXPECT_EQ(svg.find("^{"), svg.npos) << "powers are typeset: " << svg;
  }
}

}  // namespace svg_chart_test
}  // namespace plumb
