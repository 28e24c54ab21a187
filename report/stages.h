#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace plumb {

/// Where the time of a command went: stages in order, wall-clock seconds.
class Stages {
 public:
  /// Ends the stage under way, if any, and begins another.
  void begin(const std::string& name) {
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

 private:
  std::vector<std::pair<std::string, double>> stages_;
  std::chrono::steady_clock::time_point started_;
  bool running_ = false;
};

}  // namespace plumb
