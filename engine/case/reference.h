#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.h"

namespace plumb {

/// What a reference can prove: a published one validates, a computed one verifies.
enum class ReferenceKind {
  published,  ///< somebody else's figures, from a publication
  computed,   ///< a closed form or a converged solution; must never be called published
};

/// Over what the series of a reference stand.
enum class Abscissa {
  time,  ///< s
  mode,  ///< numbers of modes, from 1
  /// of statics, in a unit in which the case says how much its whole load is (ReferenceUse::whole_load)
  load,
};
/// "t", "mode", "load": the name of the first column.
std::string_view word(Abscissa);

struct ReferenceSeries {
  std::string name;         ///< "mid_y"
  std::string description;  ///< "vertical position of the middle"
  std::string figure;       ///< where it stands in the source: "Fig. 3"
  std::string unit;
  double uncertainty = 0;             ///< half-width, in `unit`, > 0
  std::string uncertainty_basis;      ///< "rounding of the printed digits"
  std::vector<double> values;         ///< one a time
  std::vector<double> exact;          ///< of Reference::exact, as `values`; empty: there is none
  double exact_uncertainty = 0;       ///< half-width of `exact`, in `unit`, > 0 where there is one
  std::optional<double> model_error;  ///< what Reference::model moves it by, in `unit`, > 0
};

/// The closed form or independent solution of what figures are of: to tell errors of a run from errors of the
/// print.
struct ExactSolution {
  std::string obtained;           ///< "complete elliptic integrals, to the last digit"
  std::string uncertainty_basis;  ///< what the uncertainty of its numbers rests on
};

/// What the computation behind figures has in common with a run: an error that is in both is not in their
/// difference (ASME V&V 20-2009, correlated errors). What is not stated is not shared.
struct SharedErrors {
  std::optional<int> elements;                        ///< its mesh; a run on as many has the same error of it
  StrainModel strain = StrainModel::green_geometric;  ///< of that mesh
  QuadratureRule quadrature = QuadratureRule::full;   ///< of that mesh
  std::vector<std::string> inputs;  ///< uncertain inputs of which it has the value that the case has
  std::string model;                ///< what both models leave out, in words; may be empty

  /// True for a cable on the same mesh with elements of the same kind.
  bool has_mesh_of(const CableSpec& cable) const;
  bool has_input(const std::string& key) const;
};

/// What is different in the model behind figures, so that a right run differs from them.
struct OtherModel {
  std::vector<std::string> differences;  ///< one at least: "the beam shears"
  std::string error_basis;  ///< what ReferenceSeries::model_error rests on; empty where no series has one
};

/// The cable that figures are of. What is not stated may be any.
struct ReferenceCable {
  std::optional<double> length;             ///< L, m
  std::optional<double> axial_stiffness;    ///< EA, N
  std::optional<double> bending_stiffness;  ///< EI, N m²
  std::optional<double> mass_per_length;    ///< ρA, kg/m
};

/// A reference file, checked: series over common times, each with source, figure, unit, how obtained and
/// uncertainty.
struct Reference {
  std::string title;
  ReferenceKind kind = ReferenceKind::computed;
  std::string source;    ///< the publication or program
  std::string obtained;  ///< how the numbers came from the source
  std::vector<std::string> notes;
  ReferenceCable cable;
  std::optional<ExactSolution> exact;
  std::optional<OtherModel> model;
  SharedErrors shares;
  Abscissa abscissa = Abscissa::time;
  /// s, strictly increasing, ≥ 0. Of modes their numbers; in the references of a case loads are the times at
  /// which the run has them.
  std::vector<double> times;
  std::vector<ReferenceSeries> series;

  /// The series of that name, or nullptr.
  const ReferenceSeries* find(std::string_view name) const;
};

/// Where a cable is not the one of the reference, to a millionth: "EA is 62.5 N, that of the reference 40 N".
/// Nothing where they agree or nothing is stated. `whose` is what else the other cable is of.
std::string difference(const ReferenceCable& reference, const CableSpec& cable,
                       const std::string& whose = "of the reference");

}  // namespace plumb
