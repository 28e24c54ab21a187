#pragma once

#include <string>
#include <vector>

#include "engine/case/case.h"

namespace plumb {

/// What a command takes of the machine.
enum class Resource {
  memory,  ///< bytes
  disk,    ///< bytes
  time,    ///< s on one processor
};

/// "memory", "disk", "time".
std::string_view word(Resource);

/// One part of what a command will take.
struct EstimatedPart {
  Resource resource;
  /// The stage of the work; the memory of one is free again in the next. Empty: held all the time.
  std::string stage;
  std::string what;  ///< with its factors: "states: 2001 outputs × 9 nodes"
  std::string keys;  ///< of the case, that it depends on: "cable.elements, time.output_interval"
  double amount;     ///< ≥ 0
};

/// Address space that drawing maps, libraries and threads of the renderer, bytes: measured, rounded up.
inline constexpr double renderer_address_space = 650e6;

/// What a command is expected to take: memory and disk within a factor of two, time within a factor of ten
/// where steps are given, and at least that where a method chooses them.
struct Estimate {
  std::vector<EstimatedPart> parts;
  double drawing_address_space =
      0;  ///< beyond the memory, of libraries that are mapped and hardly used, bytes

  /// All of a resource, bytes or s: of memory that of the stage that takes most.
  double total(Resource) const;
  /// The parts that make up that total, the greatest first.
  std::vector<EstimatedPart> parts_of(Resource) const;
};

/// How large one run of a case is.
struct RunSize {
  double elements;
  double outputs;
  double seconds;  ///< on one processor

  /// Bytes of the states of a run on so many elements.
  double states(double on_elements) const;
  double states() const { return states(elements); }
};

/// The parts that a kind of study will take, without their stage.
using StudyEstimate = std::vector<EstimatedPart> (*)(const Case& spec, const RunSize& run);

/// Those of a work-precision study as far as that.
std::vector<EstimatedPart> work_precision_parts(const StudyExtent& extent, const RunSize& run);

/// Those of finding out what the criteria of a case notice.
std::vector<EstimatedPart> sensitivity_parts(const Case& spec, const RunSize& run);

/// What is to be done with a case.
struct PlannedWork {
  bool solves = false;
  bool writes_run = false;        ///< run.h5 and probes.csv
  bool writes_table = false;      ///< probes.csv alone
  bool assesses = false;          ///< [uncertainty], [error_budget] and [sensitivity]
  bool quick_study = false;       ///< the work-precision study of a report
  bool draws = false;             ///< figures and frames, and the report
  StudyEstimate study = nullptr;  ///< that of the kind of study; nullptr: none
  double frames = -1;             ///< that are asked for; -1: all
};

/// Products are made in floating point, so that none is too large to be seen as large.
Estimate estimate(const Case& spec, const PlannedWork& work);

/// Bytes that a step of the method holds beside the state, a node.
double bytes_a_node(std::string_view method);
/// What a step of the method takes, s an element.
double seconds_an_element(std::string_view method);

/// "3.2 GB", "1.5 h".
std::string amount_in_words(Resource, double amount);

}  // namespace plumb
