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

/// "#0072b2".
std::string css(Color color);

}  // namespace plumb
