#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.h"

namespace plumb {

/// A number of a model that a program may have wrong.
struct ModelNumber {
  std::string key;    ///< "cable.density", or "cable.bending_stiffness" for EI alone
  std::string words;  ///< "density"
};

/// All of a case that are not 0: of the cable its length, density and stiffnesses, of start, loads, masses
/// and damping each number, of moving supports each way. What is counted or chosen is none of them.
std::vector<ModelNumber> model_numbers(const Case& spec);

/// What makes one of these that many times what the case has, as --set takes it; of a stretch what is beyond
/// 1, of a load all of its components.
std::vector<std::string> scaled(const Case& spec, std::string_view key, double factor);

/// "loads.gravity=[0, -9.8, 0]", as --set takes it.
std::string set_vector(std::string_view key, const Vec3& value);

}  // namespace plumb
