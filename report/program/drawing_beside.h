#pragma once

#include <atomic>
#include <future>
#include <vector>

#include "engine/run/output_folder.h"
#include "engine/run/run.h"
#include "report/base/stages.h"
#include "report/figure/pictures.h"
#include "report/verdict/run_section.h"

namespace plumb {

/// All pictures of a report: those of the run, and then those of its sections once these are known. A
/// renderer belongs to one thread. `progress` may throw.
Pictures draw_all(const Run& run, const std::shared_future<const std::vector<RunSection>*>& sections,
                  OutputFolder& folder, Stages& stages, const DrawingProgress& progress);

/// Draws all pictures of a report on a thread of its own, while what its sections show is being computed.
/// Where no thread is to be had they are drawn in finish().
class DrawingBeside {
 public:
  /// Begins. `run` and `folder` must outlive it.
  DrawingBeside(const Run& run, OutputFolder& folder);
  /// Ends it early where it was not finished.
  ~DrawingBeside();
  DrawingBeside(const DrawingBeside&) = delete;
  DrawingBeside& operator=(const DrawingBeside&) = delete;

  /// Waits for the pictures, with those of these sections. Throws what the drawing threw; its stages are
  /// there in any case.
  Pictures finish(const std::vector<RunSection>& sections);
  const Stages& stages() const { return stages_; }

 private:
  Stages stages_;
  std::promise<const std::vector<RunSection>*> sections_;
  std::atomic<bool> abandoned_ = false;
  bool finished_ = false;
  std::future<Pictures> pictures_;
};

}  // namespace plumb
