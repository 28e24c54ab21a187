#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/scene/motion.h"
#include "report/exports/export_formats.h"
#include "report/figure/scene_of_run.h"

namespace plumb {

class Cable;

/// What is known at each point of a curve.
struct CurveField {
  std::string_view name;  ///< "axial_force"
  std::string_view unit;
  int components = 1;  ///< 1 or 3
};

/// The curves of all runs at a time.
struct CurveStep {
  std::vector<double> points;               ///< m, three a point
  std::vector<std::vector<double>> values;  ///< of each field, as many a point as it has components
  std::vector<long> ended;                  ///< of each run 1 where it has ended before, and stands still
};

/// Places on a cable of so many elements, counted in elements: all nodes, and between them so many that the
/// curve looks smooth, up to 8 pieces an element and, of many elements, some hundreds in all.
std::vector<double> places_of_a_curve(int elements);

/// Runs as curves over the times of their outputs, all of them together. A run is interpolated between its
/// own outputs, and stands still after its end.
class RunCurves {
 public:
  /// `runs` must outlive it. Throws OutputError where one has nothing to show.
  explicit RunCurves(const std::vector<ExportedRun>& runs);

  const std::vector<double>& times() const { return times_; }  ///< s, rising
  /// Points of each run; they stand one run after another.
  const std::vector<std::size_t>& counts() const { return counts_; }
  std::size_t points() const;  ///< of all runs
  /// What is known of all of them: of an external run, and of modes, that is nothing but where they are.
  const std::vector<CurveField>& fields() const { return fields_; }
  CurveStep at(double time) const;

 private:
  struct Curve {
    std::unique_ptr<SceneOfRun> scene;
    Motion motion;
    std::shared_ptr<const Cable> cable;  ///< of a run with states of its own
    std::vector<double> places;
  };
  std::deque<Curve> curves_;
  std::vector<double> times_;
  std::vector<std::size_t> counts_;
  std::vector<CurveField> fields_;
};

}  // namespace plumb
