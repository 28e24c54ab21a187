#pragma once

#include <map>
#include <string>

#include "engine/study/work_precision/work_precision.h"
#include "render/gl/shapes.h"
#include "render/image/color.h"

namespace plumb {

/// How the curve of a method looks, on every mesh and in every figure: the colour tells the family, and no
/// two methods of a study share colour, marker and dash.
struct CurveStyle {
  Color color;       ///< on white
  Color dark_color;  ///< on a dark page
  Marker marker = Marker::circle;
  bool open_marker = false;
  Dash dash = Dash::solid;
};

/// A style for each label of the study's curves.
std::map<std::string, CurveStyle> curve_styles(const WorkPrecision& study);

/// That of curve k of other programs, in a colour and with a marker that no method has: hollow where its
/// times are those of another machine.
CurveStyle given_style(const WorkPrecision& study, std::size_t k);

/// "#0072b2".
std::string css(Color color);

}  // namespace plumb
