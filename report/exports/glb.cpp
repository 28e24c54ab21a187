#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/base/errors.h"
#include "engine/base/interrupt.h"
#include "render/scene/scene_camera.h"
#include "render/scene/theme.h"
#include "render/scene/tube.h"
#include "report/exports/run_curves.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr int sides = 16;

// Numbers of the format's own (glTF 2.0, section 5).
constexpr int unsigned_byte = 5121, unsigned_int = 5125, floats = 5126;
constexpr int vertex_data = 34962, index_data = 34963;

/// The JSON and the bytes of a GLB file (glTF 2.0, section 4.4).
class Glb {
 public:
  Json json{{"asset", {{"version", "2.0"}, {"generator", "Plumb " PLUMB_VERSION}}}};

  /// Appends to a list of the JSON. Returns its place there.
  std::size_t add(const char* list, Json item) {
    json[list].push_back(std::move(item));
    return json[list].size() - 1;
  }

  /// Numbers as "SCALAR", "VEC3", "VEC4" or "MAT4" of `components`; with `bounds` their least and greatest.
  template <class Number>
  std::size_t accessor(const std::vector<Number>& numbers, int component_type, const char* type,
                       std::size_t components, int target, bool bounds = false) {
    Json view{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", numbers.size() * sizeof(Number)}};
    if (target != 0) view["target"] = target;
    // More than a file of this format can hold.
    if (bytes_.size() + numbers.size() * sizeof(Number) > std::numeric_limits<std::uint32_t>::max() / 2)
      throw OutputError("glb: the animation is too large; scene.frame_rate sets how many frames it has");
    bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number));
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    Json item{{"bufferView", add("bufferViews", std::move(view))},
              {"componentType", component_type},
              {"count", numbers.size() / components},
              {"type", type}};
    if (component_type == unsigned_byte && target == vertex_data && normalized_) item["normalized"] = true;
    if (bounds) {
      std::vector<Number> least(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(components));
      std::vector<Number> greatest = least;
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        least[k % components] = std::min(least[k % components], numbers[k]);
        greatest[k % components] = std::max(greatest[k % components], numbers[k]);
      }
      item["min"] = least;
      item["max"] = greatest;
    }
    return add("accessors", std::move(item));
  }

  /// Shares of 255, as weights are.
  std::size_t shares(const std::vector<std::uint8_t>& numbers) {
    normalized_ = true;
    const std::size_t place = accessor(numbers, unsigned_byte, "VEC4", 4, vertex_data);
    normalized_ = false;
    return place;
  }

  std::string file() {
    json["buffers"] = {{{"byteLength", bytes_.size()}}};
    std::string text = json.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    constexpr std::uint32_t version = 2, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
    std::string file = "glTF";
    const auto number = [&](std::size_t value) {
      for (int k = 0; k < 4; ++k) file += static_cast<char>(value >> (8 * k) & 255U);
    };
    constexpr std::size_t headers = 12 + 8 + 8;
    number(version);
    number(headers + text.size() + bytes_.size());
    number(text.size());
    number(json_chunk);
    file += text;
    number(bytes_.size());
    number(binary_chunk);
    return file + bytes_;
  }

 private:
  std::string bytes_;
  bool normalized_ = false;
};

/// The components of a linear colour; files of colours are in sRGB.
Json linear(const Color& color) {
  const auto part = [](float c) {
    return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F);
  };
  return {part(color.r), part(color.g), part(color.b), 1};
}

Json rotation_json(const Eigen::Quaterniond& q) {
  return {q.x(), q.y(), q.z(), q.w()};
}

/// A point of the curve with the directions of the tube's ring there, over the frames.
struct Joint {
  std::vector<float> places, turns;
  Eigen::Quaterniond last = Eigen::Quaterniond::Identity();
  Eigen::Isometry3d start = Eigen::Isometry3d::Identity();
};

/// The joints of a cable at the times. Rings are carried along it without twist, and the first over time, so
/// that between two frames nothing turns by more than the cable does.
std::vector<Joint> joints_of(const Motion& motion, const std::vector<double>& places,
                             const std::vector<double>& times) {
  std::vector<Joint> joints(places.size());
  const auto along = [](const Vec3& normal, const Vec3& tangent) {
    const Vec3 rest = normal - normal.dot(tangent) * tangent;
    constexpr double least = 1e-6;
    return rest.norm() > least ? Vec3(rest.normalized()) : Vec3(tangent.unitOrthogonal());
  };
  Vec3 first_normal = motion.point(motion.output(0), 0).tangent.unitOrthogonal();
  for (const double time : times) {
    stop_if_interrupted();
    const Eigen::VectorXd state = motion.state(time);
    Vec3 normal = first_normal;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const CurvePoint point = motion.point(state, places[k]);
      normal = along(normal, point.tangent);
      if (k == 0) first_normal = normal;
      Eigen::Matrix3d axes;
      axes << normal, point.tangent.cross(normal), point.tangent;
      Joint& joint = joints[k];
      Eigen::Quaterniond turn(axes);
      turn.normalize();
      if (turn.dot(joint.last) < 0) turn.coeffs() *= -1;
      joint.last = turn;
      if (joint.places.empty()) joint.start = Eigen::Translation3d(point.position) * turn;
      for (int c = 0; c < 3; ++c) joint.places.push_back(static_cast<float>(point.position[c]));
      for (int c = 0; c < 4; ++c) joint.turns.push_back(static_cast<float>(turn.coeffs()[c]));
    }
  }
  return joints;
}

/// The tube around the cable at the first frame, each ring of which moves with one joint; in the directions
/// of the file, which `upright` turns to.
std::size_t add_mesh(Glb& glb, const Motion& motion, const std::vector<double>& places, double radius,
                     const Color& color, const std::string& name, const Eigen::Quaterniond& upright) {
  std::vector<CurvePoint> curve;
  for (const double place : places) curve.push_back(motion.point(motion.output(0), place));
  const TubeMesh tube = tube_mesh(curve, radius, sides);
  std::vector<float> positions, normals;
  std::vector<std::uint8_t> joints, weights;
  constexpr std::size_t numbers = 6;
  const std::size_t vertices = tube.vertices.size() / numbers, rings = vertices / sides,
                    cap = (rings - places.size()) / 2;
  for (std::size_t k = 0; k < vertices; ++k) {
    const float* vertex = tube.vertices.data() + numbers * k;
    const Vec3 position = upright * Vec3(vertex[0], vertex[1], vertex[2]);
    const Vec3 normal = (upright * Vec3(vertex[3], vertex[4], vertex[5])).normalized();
    for (int c = 0; c < 3; ++c) positions.push_back(static_cast<float>(position[c]));
    for (int c = 0; c < 3; ++c) normals.push_back(static_cast<float>(normal[c]));
    const std::size_t ring = k / sides;
    joints.push_back(static_cast<std::uint8_t>(std::clamp(ring, cap, cap + places.size() - 1) - cap));
    joints.insert(joints.end(), 3, 0);
    weights.insert(weights.end(), {255, 0, 0, 0});
  }
  const std::size_t material = glb.add(
      "materials", {{"name", name},
                    {"pbrMetallicRoughness",
                     {{"baseColorFactor", linear(color)}, {"metallicFactor", 0}, {"roughnessFactor", 0.5}}}});
  Json attributes;
  attributes["POSITION"] = glb.accessor(positions, floats, "VEC3", 3, vertex_data, true);
  attributes["NORMAL"] = glb.accessor(normals, floats, "VEC3", 3, vertex_data);
  attributes["JOINTS_0"] = glb.accessor(joints, unsigned_byte, "VEC4", 4, vertex_data);
  attributes["WEIGHTS_0"] = glb.shares(weights);
  Json primitive{{"attributes", attributes},
                 {"indices", glb.accessor(tube.indices, unsigned_int, "SCALAR", 1, index_data)},
                 {"material", material}};
  return glb.add("meshes", {{"name", name}, {"primitives", Json::array({std::move(primitive)})}});
}

/// Places along a cable at which the tube has rings, few enough for a byte to number them and for players
/// that bound the joints of a skin.
std::vector<double> rings_of(int elements) {
  constexpr int most = 128;
  std::vector<double> places;
  if (const int pieces = std::min(8, most / elements); pieces >= 1) {
    for (int k = 0; k <= elements * pieces; ++k) places.push_back(static_cast<double>(k) / pieces);
  } else {
    for (int k = 0; k <= most; ++k) places.push_back(static_cast<double>(elements) * k / most);
  }
  return places;
}

/// Each cable is a tube with a skin: every ring of it hangs on one node, which an animation moves and turns.
/// Players that know no more than skins of one weight a vertex show it as it is, where tubes with a shape a
/// frame are more than many take.
void write_glb(const std::vector<ExportedRun>& runs, const PutFile& put) {
  Glb glb;
  std::vector<std::unique_ptr<SceneOfRun>> scenes;
  std::vector<double> times;
  double frame_rate = 0, end = 0;
  for (const ExportedRun& run : runs) {
    scenes.push_back(std::make_unique<SceneOfRun>(run.run));
    const SceneOfRun& scene = *scenes.back();
    if (scene.motion() == nullptr)
      throw OutputError(run.label + ": there is nothing to export: " + scene.notes().front());
    frame_rate = std::max(frame_rate, scene.input().spec.frame_rate);
    end = std::max(end, scene.motion()->times.back());
  }
  for (int k = 0; k < frame_count(end, frame_rate); ++k) times.push_back(std::min(k / frame_rate, end));
  constexpr double rounding = 1e-6;
  if (end - times.back() > rounding / frame_rate) times.push_back(end);
  times.back() = times.size() > 1 ? end : times.back();

  const SceneInput& first = scenes.front()->input();
  const Vec3 up = first.gravity.isZero() ? Vec3(Vec3::UnitY()) : Vec3(-first.gravity.normalized());
  const Eigen::Quaterniond upright = Eigen::Quaterniond::FromTwoVectors(up, Vec3::UnitY());
  Json roots = Json::array(), channels = Json::array(), samplers = Json::array();
  const std::vector<float> key_times(times.begin(), times.end());
  const std::size_t input = glb.accessor(key_times, floats, "SCALAR", 1, 0, true);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const SceneInput& scene = scenes[k]->input();
    const Motion motion(*scenes[k]->motion());
    const std::vector<double> places = rings_of(motion.elements());
    const Theme& colors = theme(first.spec.theme);
    const Color color = k == 0 ? colors.cable : colors.series[(k - 1) % colors.series.size()];
    const std::size_t mesh =
        add_mesh(glb, motion, places, drawn_radius(scene.spec, scene.length, scene.radius), color,
                 runs[k].label, upright);
    std::vector<float> inverses;
    Json nodes = Json::array();
    const std::vector<Joint> joints = joints_of(motion, places, times);
    for (const Joint& joint : joints) {
      const Vec3 place = joint.start.translation();
      const Eigen::Matrix4f inverse = (upright * joint.start).inverse().matrix().cast<float>();
      inverses.insert(inverses.end(), inverse.data(), inverse.data() + inverse.size());
      const Eigen::Quaterniond turn(joint.start.rotation());
      nodes.push_back(glb.add("nodes", {{"name", fmt::format("{} {}", runs[k].label, nodes.size())},
                                        {"translation", {place.x(), place.y(), place.z()}},
                                        {"rotation", rotation_json(turn)}}));
      const auto animate = [&](const char* path, std::size_t output) {
        samplers.push_back({{"input", input}, {"interpolation", "LINEAR"}, {"output", output}});
        channels.push_back(
            {{"sampler", samplers.size() - 1}, {"target", {{"node", nodes.back()}, {"path", path}}}});
      };
      animate("translation", glb.accessor(joint.places, floats, "VEC3", 3, 0));
      animate("rotation", glb.accessor(joint.turns, floats, "VEC4", 4, 0));
    }
    const std::size_t skeleton = glb.add(
        "nodes",
        {{"name", runs[k].label + " (points)"}, {"rotation", rotation_json(upright)}, {"children", nodes}});
    const std::size_t skin =
        glb.add("skins", {{"inverseBindMatrices", glb.accessor(inverses, floats, "MAT4", 16, 0)},
                          {"skeleton", skeleton},
                          {"joints", nodes}});
    roots.push_back(skeleton);
    roots.push_back(glb.add("nodes", {{"name", runs[k].label}, {"mesh", mesh}, {"skin", skin}}));
  }
  glb.add("animations", {{"name", "motion"}, {"channels", channels}, {"samplers", samplers}});
  glb.json["scene"] = glb.add("scenes", {{"name", runs.front().run.loaded.spec.title}, {"nodes", roots}});
  put("run.glb", glb.file());
}

}  // namespace

ExportFormat glb_export() {
  return {.name = "glb",
          .file = "run.glb",
          .summary = "an animation for browsers, Blender and viewers of glTF 2.0",
          .write = write_glb};
}

}  // namespace plumb
