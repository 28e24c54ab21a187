#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plumb {

/// The stage in which a run is integrated, whose failures are those of the solver.
inline constexpr std::string_view solving_stage = "solving";

/// Where the time of a command went: stages in order, wall-clock seconds.
class Stages {
 public:
  /// Ends the stage under way, if any, and begins another.
  void begin(std::string_view name) {
    current_ = name;
    end();
    stages_.emplace_back(name, 0.0);
    started_ = std::chrono::steady_clock::now();
    running_ = true;
  }

  void end() {
    if (running_)
      stages_.back().second =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
    running_ = false;
  }

  /// Takes down a stage that was timed before.
  void add(const std::string& name, double seconds) { stages_.emplace_back(name, seconds); }

  const std::vector<std::pair<std::string, double>>& all() const { return stages_; }

  /// Takes down what was done meanwhile beside these.
  void add_beside(const Stages& others) {
    stages_.insert(stages_.end(), others.stages_.begin(), others.stages_.end());
    any_beside_ = true;
  }
  /// Whether stages overlap, so that their sum is more than the time that passed.
  bool any_beside() const { return any_beside_; }

  /// Time since these were made, s.
  double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - made_).count();
  }

  /// The stage that was begun last of all, of any command of this program, by this thread; empty before.
  static std::string_view current() { return current_; }

 private:
  inline static thread_local std::string current_;
  std::vector<std::pair<std::string, double>> stages_;
  std::chrono::steady_clock::time_point started_;
  std::chrono::steady_clock::time_point made_ = std::chrono::steady_clock::now();
  bool running_ = false;
  bool any_beside_ = false;
};

}  // namespace plumb
