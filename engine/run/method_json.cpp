#include "engine/run/method_json.h"

#include "engine/base/codec.h"

namespace plumb {
namespace {

template <class Archive>
void members_of_method(Archive& a, MethodSpec& method) {
  a("name", method.name);
  a("parameters", method.parameters);
  a("step", method.step);
  a("rtol", method.rtol);
  a("atol", method.atol);
}

}  // namespace

nlohmann::ordered_json to_stored(const MethodSpec& method) {
  ObjectWriter writer;
  members_of_method(writer, const_cast<MethodSpec&>(method));  // which only reads
  return writer.json;
}

void from_stored(const nlohmann::ordered_json& json, MethodSpec& method) {
  ObjectReader reader(json);
  members_of_method(reader, method);
}

}  // namespace plumb
