#include "engine/study/stability/stability.h"

namespace plumb {

std::string_view word(MapAxis axis) {
  switch (axis) {
    case MapAxis::parameter:
      return "parameter";
    case MapAxis::elements:
      return "elements";
    case MapAxis::duration:
      return "duration";
  }
  return "";
}

std::string_view word(LimitKind kind) {
  switch (kind) {
    case LimitKind::none:
      return "none";
    case LimitKind::vibration:
      return "vibration";
    case LimitKind::contraction:
      return "contraction";
    case LimitKind::always:
      return "always";
  }
  return "";
}

bool is_stable(Outcome outcome) {
  return outcome == Outcome::accurate || outcome == Outcome::inaccurate;
}

}  // namespace plumb
