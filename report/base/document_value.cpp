#include "report/base/document_value.h"

#include <fmt/format.h>

#include <cmath>

namespace plumb {
namespace {

constexpr const char* none = "not finite";

}  // namespace

std::string four_digits(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : none;
}

std::string four_digits(const Document& value) {
  return value.is_number() ? four_digits(value.get<double>()) : none;
}

}  // namespace plumb
