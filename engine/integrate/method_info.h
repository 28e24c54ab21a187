#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// A key of [method] that belongs to one method.
struct MethodParameter {
  std::string name;
  std::string meaning;  ///< one phrase, with the unit
  double minimum = 0;   ///< inclusive
  double maximum = 0;   ///< inclusive
  double fallback = 0;
  bool whole = false;  ///< whole numbers only
};

/// What a method is and takes: the same words serve the case reader, `plumb doctor` and the report.
struct MethodInfo {
  std::string name;     ///< as in the case file
  std::string summary;  ///< one line
  std::string source;   ///< paper or library
  std::string order;    ///< of accuracy in time: "2", "1 to 5"
  bool implicit = false;
  bool takes_step = false;        ///< [method] step, required
  bool takes_tolerances = false;  ///< [method] rtol and atol
  std::vector<MethodParameter> parameters;
};

/// rtol where the case gives none.
inline constexpr double default_rtol = 1e-8;

/// Every method there is, in the order they are to be shown.
std::span<const MethodInfo> method_infos();

/// The method of that name, or nullptr.
const MethodInfo* find_method(std::string_view name);

}  // namespace plumb
