#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/key.h"
#include "engine/case/report_specs.h"
#include "engine/case/scene_settings.h"
#include "engine/case/study_specs.h"

namespace plumb {

/// What a cable is modelled as.
enum class CableModel {
  /// Elements with positions and slopes: stretches and bends.
  cable,
  /// Half of each link's mass at either end, straight links between that stretch only, ε = ½(λ² − 1) or λ − 1
  /// with λ the ratio of lengths. Slopes are no unknowns; those of outputs follow the neighbouring nodes.
  chain,
  /// A rigid rod on a joint at its first end, which does not turn about its own axis: a spherical pendulum.
  /// It neither stretches nor bends; its nodes lie on a straight line.
  rigid,
};

/// How strain and curvature are measured.
enum class StrainModel {
  /// ε = ½(r'·r' − 1), κ = |r' × r''| / |r'|³ (Gerstmayr and Shabana 2006; Project Chrono).
  green_geometric,
  /// ε = |r'| − 1, κ = |r' × r''| / |r'|² (Gerstmayr and Irschik 2008; Exudyn).
  engineering_material,
};

/// Which integration points the internal forces use.
enum class QuadratureRule {
  /// 5 Gauss points for the axial part (exact for Green strain), 3 for bending.
  full,
  /// 3 Lobatto points for the axial part, 2 Gauss points for bending: avoids axial locking of coarse, stiff
  /// meshes.
  reduced,
};

enum class Support {
  free,
  /// Position held.
  pinned,
  /// Position and direction held; the length of the slope (the axial stretch) stays free.
  clamped,
};

/// Rates of the slopes at the start.
enum class SlopeRates {
  /// ω × r', as a rigid rotation has it.
  rigid,
  /// 0, as the published series was computed: the nodes turn, the slopes do not yet.
  zero,
};

/// Elements that a cable may have.
constexpr int most_elements_of_a_cable = 1'000'000;

/// The cable as a continuum and its mesh. All lengths and areas are those of the undeformed cable.
struct CableSpec {
  double length = 0;          ///< L, m
  double area = 0;            ///< A, m²
  double density = 0;         ///< ρ, kg/m³
  double youngs_modulus = 0;  ///< E, Pa
  double second_moment = 0;   ///< I, m⁴; of a circular section, A²/4π, unless given
  int elements = 0;           ///< of equal length
  CableModel model = CableModel::cable;
  StrainModel strain = StrainModel::green_geometric;
  QuadratureRule quadrature = QuadratureRule::full;
  /// Half of each element's mass at either end, as a chain has it; no key: a mistake made on purpose.
  bool lumped = false;

  friend bool operator==(const CableSpec&, const CableSpec&) = default;
};

void visit_keys(SpecOf<CableSpec> auto& cable, auto&& visit) {
  visit(Key{.name = "length", .meaning = "length L", .range = Range::positive("m"), .required = true},
        cable.length);
  visit(Key{.name = "area", .meaning = "area A", .range = Range::positive("m²"), .required = true},
        cable.area);
  visit(Key{.name = "density", .meaning = "density ρ", .range = Range::positive("kg/m³"), .required = true},
        cable.density);
  visit(Key{.name = "youngs_modulus",
            .meaning = "Young's modulus E",
            .range = Range::positive("Pa"),
            .required = true},
        cable.youngs_modulus);
  visit(Key{.name = "second_moment",
            .meaning = "second moment of area I",
            .range = Range::at_least(0, "m⁴"),
            .not_of_chain = true,
            .not_of_rigid = true},
        cable.second_moment);
  visit(Key{.name = "elements",
            .meaning = "elements",
            .range = Range::whole_between(1, most_elements_of_a_cable),
            .required = true,
            .of_computation = true},
        cable.elements);
  visit(Key{.name = "model", .meaning = "model", .of_computation = true}, cable.model);
  visit(Key{.name = "strain", .meaning = "strain model", .of_computation = true, .not_of_rigid = true},
        cable.strain);
  visit(Key{.name = "quadrature",
            .meaning = "quadrature",
            .of_computation = true,
            .not_of_chain = true,
            .not_of_rigid = true},
        cable.quadrature);
}

/// The cable starts straight and evenly stretched, with its first end at the origin.
struct StartSpec {
  Vec3 direction{1, 0, 0};         ///< of the straight cable; a unit vector once read
  Vec3 angular_velocity{0, 0, 0};  ///< ω about the first end, rad/s
  SlopeRates slope_rates = SlopeRates::rigid;
  /// Of the last end along the cable, m/s, beside the rotation; along the rest as the first axial vibration
  /// of a cable held at its first end has it, sin(πs/2).
  double axial_speed = 0;
  /// Greatest displacement of the start from the straight line, m, in the first buckling mode
  /// (first_buckling); negative to the other side.
  double imperfection = 0;
  double stretch = 1;  ///< of all of it: its length over L

  friend bool operator==(const StartSpec&, const StartSpec&) = default;
};

void visit_keys(SpecOf<StartSpec> auto& start, auto&& visit) {
  visit(Key{.name = "direction", .meaning = "direction at the start"}, start.direction);
  visit(Key{.name = "angular_velocity",
            .meaning = "angular velocity at the start",
            .range = Range::any("rad/s")},
        start.angular_velocity);
  visit(Key{.name = "slope_rates", .meaning = "slope rates at the start", .of_computation = true},
        start.slope_rates);
  visit(Key{.name = "axial_speed",
            .meaning = "axial speed of the last end at the start",
            .range = Range::any("m/s")},
        start.axial_speed);
  visit(Key{.name = "imperfection",
            .meaning = "imperfection of the start, in the first buckling mode",
            .range = Range::any("m")},
        start.imperfection);
  // A slope near the floor counts as collapsed.
  visit(Key{.name = "stretch", .meaning = "stretch at the start", .range = Range::between(0.01, 100, "")},
        start.stretch);
}

/// How a support moves from where its end starts, m: expressions in `t` and the parameters.
struct MotionSpec {
  std::string x = "0", y = "0", z = "0";

  friend bool operator==(const MotionSpec&, const MotionSpec&) = default;
};

void visit_keys(SpecOf<MotionSpec> auto& motion, auto&& visit) {
  visit(Key{.name = "x", .meaning = "motion along x", .range = Range::any("m")}, motion.x);
  visit(Key{.name = "y", .meaning = "motion along y", .range = Range::any("m")}, motion.y);
  visit(Key{.name = "z", .meaning = "motion along z", .range = Range::any("m")}, motion.z);
}

/// How a clamp turns from where it starts.
struct RotationSpec {
  Vec3 axis{0, 0, 1};       ///< a unit vector once read
  std::string angle = "0";  ///< rad: an expression in `t` and the parameters

  friend bool operator==(const RotationSpec&, const RotationSpec&) = default;
};

void visit_keys(SpecOf<RotationSpec> auto& rotation, auto&& visit) {
  visit(Key{.name = "axis", .meaning = "axis", .required = true}, rotation.axis);
  visit(Key{.name = "angle", .meaning = "angle", .range = Range::any("rad"), .required = true},
        rotation.angle);
}

struct SupportsSpec {
  Support first = Support::free;
  Support last = Support::free;
  std::optional<MotionSpec> first_motion = {}, last_motion = {};
  std::optional<RotationSpec> first_rotation = {};

  bool move() const { return first_motion || last_motion || first_rotation; }

  friend bool operator==(const SupportsSpec&, const SupportsSpec&) = default;
};

void visit_keys(SpecOf<SupportsSpec> auto& supports, auto&& visit) {
  visit(Key{.name = "first", .meaning = "support of the first end"}, supports.first);
  visit(Key{.name = "last", .meaning = "support of the last end"}, supports.last);
  visit(Key{.name = "first_motion", .meaning = "motion of the first end"}, supports.first_motion);
  visit(Key{.name = "last_motion", .meaning = "motion of the last end"}, supports.last_motion);
  visit(Key{.name = "first_rotation", .meaning = "rotation of the first end"}, supports.first_rotation);
}

enum class LoadKind {
  force,        ///< N, at a place
  moment,       ///< N m, at a place; it turns the slope there
  distributed,  ///< N for each metre of the undeformed cable, all along it
};

/// A [[load]]. What it does to the cable is said in model/load.cpp and model/variable_loads.cpp.
struct LoadSpec {
  LoadKind kind = LoadKind::force;
  double at = 0;  ///< material coordinate as a fraction of the length; 0 of a distributed one
  Vec3 value{0, 0, 0};
  /// It turns with the cable where it acts, by the shortest rotation from the direction at the start to that
  /// now.
  bool follows = false;
  std::string factor = "1";  ///< an expression in `t` and the parameters, by which it is multiplied

  friend bool operator==(const LoadSpec&, const LoadSpec&) = default;
};

void visit_keys(SpecOf<LoadSpec> auto& load, auto&& visit) {
  visit(Key{.name = "kind", .meaning = "kind", .required = true}, load.kind);
  visit(Key{.name = "at", .meaning = "place", .range = Range::between(0, 1, "fraction of the length")},
        load.at);
  visit(Key{.name = "value",
            .meaning = "force or moment",
            .range = Range::any("N, N m or N/m"),
            .required = true},
        load.value);
  visit(Key{.name = "follows", .meaning = "turns with the cable"}, load.follows);
  visit(Key{.name = "factor", .meaning = "factor"}, load.factor);
}

/// A [[mass]]: a point of mass on the cable.
struct MassSpec {
  double at = 0;    ///< material coordinate as a fraction of the length
  double mass = 0;  ///< kg

  friend bool operator==(const MassSpec&, const MassSpec&) = default;
};

void visit_keys(SpecOf<MassSpec> auto& mass, auto&& visit) {
  visit(Key{.name = "at",
            .meaning = "place",
            .range = Range::between(0, 1, "fraction of the length"),
            .required = true},
        mass.at);
  visit(Key{.name = "mass", .meaning = "mass", .range = Range::positive("kg"), .required = true}, mass.mass);
}

/// What damps the motion. What it does to the cable is said in model/damping.h.
struct DampingSpec {
  double mass = 0;      ///< 1/s: a force of this times M v against the motion
  double material = 0;  ///< s: of Kelvin and Voigt, stresses of this times the rates of strain

  friend bool operator==(const DampingSpec&, const DampingSpec&) = default;
};

void visit_keys(SpecOf<DampingSpec> auto& damping, auto&& visit) {
  visit(Key{.name = "mass", .meaning = "damping by mass", .range = Range::at_least(0, "1/s")}, damping.mass);
  visit(Key{.name = "material", .meaning = "damping of the material", .range = Range::at_least(0, "s")},
        damping.material);
}

/// What a load does to the cable is said in model/load.cpp.
struct LoadsSpec {
  Vec3 gravity{0, 0, 0};          ///< m/s²
  Vec3 end_force{0, 0, 0};        ///< on the last end, in a fixed direction, N
  std::vector<LoadSpec> applied;  ///< the [[load]] tables

  friend bool operator==(const LoadsSpec&, const LoadsSpec&) = default;
};

/// All but the [[load]] tables.
void visit_keys(SpecOf<LoadsSpec> auto& loads, auto&& visit) {
  visit(Key{.name = "gravity", .meaning = "gravity", .range = Range::any("m/s²")}, loads.gravity);
  visit(Key{.name = "end_force", .meaning = "force on the last end", .range = Range::any("N")},
        loads.end_force);
}

/// The name of [method] that leaves model, mesh and method to what the scene needs. It is put in the place of
/// a method before anything is integrated.
inline constexpr std::string_view scene_method = "scene";

/// A method by name with what it was given. Which of these a method takes is said by its MethodInfo.
struct MethodSpec {
  std::string name;
  std::optional<double> step;                ///< h, s, > 0; fixed-step methods
  std::optional<double> rtol;                ///< relative tolerance, in (0, 1); error-controlled methods
  std::optional<double> atol;                ///< absolute tolerance of L, L/T, 1 and 1/T, > 0
  std::map<std::string, double> parameters;  ///< the method's own, all set: given ones and defaults

  friend bool operator==(const MethodSpec&, const MethodSpec&) = default;
};

struct TimeSpec {
  double end = 0;              ///< s
  double output_interval = 0;  ///< s, at most the end; the end itself is always an output

  friend bool operator==(const TimeSpec&, const TimeSpec&) = default;
};

void visit_keys(SpecOf<TimeSpec> auto& time, auto&& visit) {
  visit(Key{.name = "end",
            .meaning = "end time",
            .range = Range::positive("s"),
            .required = true,
            .of_computation = true},
        time.end);
  visit(Key{.name = "output_interval",
            .meaning = "time between outputs",
            .range = Range::positive("s"),
            .required = true,
            .of_computation = true},
        time.output_interval);
}

enum class Quantity {
  position,
  relative_position,  ///< from the first end, in the frame that goes and turns with its support
  velocity,
  slope,
  axial_strain,
  axial_force,
  curvature,
  bending_moment
};

struct ProbeSpec {
  std::string name;  ///< unique; letters, digits, - and _, and not "t"
  double at = 0;     ///< material coordinate as a fraction of the length
  Quantity quantity = Quantity::position;

  friend bool operator==(const ProbeSpec&, const ProbeSpec&) = default;
};

void visit_keys(SpecOf<ProbeSpec> auto& probe, auto&& visit) {
  visit(Key{.name = "name", .meaning = "a name", .required = true}, probe.name);
  visit(Key{.name = "at", .range = Range::between(0, 1, "fraction of the length"), .required = true},
        probe.at);
  visit(Key{.name = "quantity"}, probe.quantity);
}

enum class Norm { max, rms };

/// One series of a reference beside one column of the probes, or what is read off it (column_quantity.h).
struct Comparison {
  std::string series;  ///< a column of the reference: "mid_y"
  std::string column;  ///< "mid.y", "greatest mid.y"

  friend bool operator==(const Comparison&, const Comparison&) = default;
};

/// A reference file and what it is held against.
struct ReferenceUse {
  std::string name;  ///< unique; default: the file's name without its ending
  std::string file;  ///< relative to the case file
  std::vector<Comparison> compare;
  Norm norm = Norm::max;
  double tolerance = 0;   ///< in the unit of the series, > 0
  std::string reason;     ///< why this tolerance; may be empty
  CoverageSpec coverage;  ///< over how much of the reference
  double whole_load = 1;  ///< all loads of the case together, in the unit of a reference over a load, > 0

  friend bool operator==(const ReferenceUse&, const ReferenceUse&) = default;
};

/// A plot of one column of the probes over another, or over time.
struct FigureSpec {
  std::string name;     ///< unique, the PNG's file name
  std::string title;    ///< default: the name
  std::string x = "t";  ///< "t" or a column; of modes "mode", and else as of a probe
  std::string y;        ///< a column
  std::string x_label;  ///< default: the column's name
  std::string y_label;
  std::string reference;    ///< name of a [[reference]] that compares these columns, or empty
  bool equal_axes = false;  ///< one scale for both axes, which have the same unit

  friend bool operator==(const FigureSpec&, const FigureSpec&) = default;
};

/// How far a work-precision study goes. The form that `plumb run` makes is shorter than that of `plumb
/// study`.
struct StudyExtent {
  std::vector<int> elements;         ///< meshes, rising, the case's own among them
  std::vector<std::string> methods;  ///< names, in the order of method_infos()
  int points = 0;                    ///< runs a curve
  int repeats = 0;                   ///< timed runs of each
  double time_limit = 0;             ///< of one run, s

  friend bool operator==(const StudyExtent&, const StudyExtent&) = default;
};

/// All but its lists.
void visit_keys(SpecOf<StudyExtent> auto& extent, auto&& visit) {
  visit(Key{.name = "points", .range = Range::whole_between(3, 20)}, extent.points);
  visit(Key{.name = "repeats", .range = Range::whole_between(1, 50)}, extent.repeats);
  visit(Key{.name = "time_limit", .range = Range::positive("s")}, extent.time_limit);
}

/// [study.work_precision]: every method over steps or tolerances and meshes.
struct WorkPrecisionSpec {
  double end = 0;                 ///< s; at most that of the case
  double largest_step = 0;        ///< s
  double smallest_step = 0;       ///< s, less than the largest
  double loosest_tolerance = 0;   ///< rtol and atol
  double tightest_tolerance = 0;  ///< less than the loosest
  StudyExtent full;
  StudyExtent quick;

  friend bool operator==(const WorkPrecisionSpec&, const WorkPrecisionSpec&) = default;
};

/// All but its extents.
void visit_keys(SpecOf<WorkPrecisionSpec> auto& study, auto&& visit) {
  visit(Key{.name = "end", .range = Range::positive("s")}, study.end);
  visit(Key{.name = "largest_step", .range = Range::positive("s")}, study.largest_step);
  visit(Key{.name = "smallest_step", .range = Range::positive("s")}, study.smallest_step);
  visit(Key{.name = "loosest_tolerance", .range = Range::below_one()}, study.loosest_tolerance);
  visit(Key{.name = "tightest_tolerance", .range = Range::below_one()}, study.tightest_tolerance);
}

/// What a case file says, checked.
struct Case {
  std::string title;
  std::map<std::string, double> parameters;
  CableSpec cable;
  StartSpec start;
  SupportsSpec supports;
  LoadsSpec loads;
  std::vector<MassSpec> masses;
  DampingSpec damping;
  MethodSpec method;
  TimeSpec time;
  std::vector<ProbeSpec> probes;
  std::vector<ReferenceUse> references;
  std::vector<FigureSpec> figures;
  SceneSpec scene;
  std::optional<WorkPrecisionSpec> work_precision;
  std::optional<StabilitySpec> stability;
  std::vector<VariantSpec> variants;
  std::optional<SweepSpec> sweep;
  std::optional<EconomySpec> economy;
  std::vector<GivenRunSpec> given_runs;
  std::optional<UncertaintySpec> uncertainty;
  std::optional<BudgetSpec> error_budget;
  std::optional<SensitivitySpec> sensitivity;

  // Compiled once, as they are long and many use them.
  Case();
  Case(const Case&);
  Case(Case&&) noexcept;
  Case& operator=(const Case&);
  Case& operator=(Case&&) noexcept;
  ~Case();

  bool operator==(const Case&) const;
};

/// Shows the tables that say what moves: `visit(name, spec)` for each, in order.
void visit_motion(SpecOf<Case> auto& spec, auto&& visit) {
  visit("cable", spec.cable);
  visit("start", spec.start);
  visit("supports", spec.supports);
  visit("loads", spec.loads);
  visit("damping", spec.damping);
}

/// The work-precision study of a case: what its table says, or the defaults where it has none, of the methods
/// that take the case.
WorkPrecisionSpec work_precision_of(const Case& spec);

/// The words that case files use: "green-geometric", "full", "pinned", "rigid", "position", "max".
std::string_view word(CableModel);
std::string_view word(StrainModel);
std::string_view word(QuadratureRule);
std::string_view word(Support);
std::string_view word(SlopeRates);
std::string_view word(LoadKind);
std::string_view word(Quantity);
std::string_view word(Norm);

/// Unit of a probed quantity: "m", "m/s", "1", "N", "1/m", "N m".
std::string_view unit(Quantity);
/// True for position, velocity and slope, which have the columns NAME.x, NAME.y and NAME.z.
bool is_vector(Quantity);
/// Names of a probe's columns, in order: "tip.x", "tip.y", "tip.z", or "tip" alone for a scalar.
std::vector<std::string> column_names(const ProbeSpec&);

}  // namespace plumb
