#include "engine/base/worker_processes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

namespace plumb {
namespace worker_processes_test {

WorkerJobs jobs_of(std::vector<std::size_t> lines, double longest_silence = 30) {
  WorkerJobs jobs;
  jobs.lines = std::move(lines);
  jobs.longest_silence = longest_silence;
  jobs.work = [wanted = jobs.lines](std::size_t job, std::size_t first, const TakeLine& take) {
    for (std::size_t k = first; k < wanted[job]; ++k) take(fmt::format("{}.{}", job, k));
  };
  return jobs;
}

std::vector<std::vector<JobLine>> lines_of(WorkerJobs jobs) {
  std::vector<std::vector<JobLine>> lines(jobs.lines.size());
  jobs.take = [&](std::size_t job, std::size_t line, const JobLine& what) {
    EXPECT_EQ(line, lines[job].size()) << "of job " << job;
    lines[job].push_back(what);
  };
  run_in_processes(jobs);
  return lines;
}

TEST(WorkerProcesses, GiveEveryLineOfEveryJobInOrder) {
  WorkerJobs jobs = jobs_of({3, 0, 1, 2, 5, 1, 1});
  const auto lines = lines_of(jobs);
  ASSERT_EQ(lines.size(), 7U);
  for (std::size_t job = 0; job < lines.size(); ++job) {
    ASSERT_EQ(lines[job].size(), jobs.lines[job]);
    for (std::size_t k = 0; k < lines[job].size(); ++k) {
      EXPECT_EQ(lines[job][k].text, fmt::format("{}.{}", job, k));
      EXPECT_EQ(lines[job][k].fault, "");
    }
  }
}

TEST(WorkerProcesses, LongLinesComeWhole) {
  WorkerJobs jobs = jobs_of({2});
  const std::string is_long(300000, 'x');
  jobs.work = [&](std::size_t, std::size_t first, const TakeLine& take) {
    for (std::size_t k = first; k < 2; ++k) take(is_long);
  };
  const auto lines = lines_of(jobs);
  EXPECT_EQ(lines[0][0].text, is_long);
  EXPECT_EQ(lines[0][1].text, is_long);
}

/// Four lines, of which the third goes wrong in some way.
std::vector<JobLine> with_third_line(const std::function<void()>& trouble, double longest_silence = 30) {
  WorkerJobs jobs = jobs_of({4, 4}, longest_silence);
  jobs.work = [&](std::size_t job, std::size_t first, const TakeLine& take) {
    for (std::size_t k = first; k < 4; ++k) {
      if (job == 0 && k == 2) trouble();
      take(fmt::format("{}", k));
    }
  };
  const auto lines = lines_of(jobs);
  EXPECT_EQ(lines[1].size(), 4U);
  for (const JobLine& line : lines[1]) EXPECT_EQ(line.fault, "") << "another job suffers";
  return lines[0];
}

void expect_third_lost(const std::vector<JobLine>& lines, const std::string& fault) {
  ASSERT_EQ(lines.size(), 4U);
  for (const std::size_t k : {0U, 1U, 3U}) {
    EXPECT_EQ(lines[k].text, fmt::format("{}", k));
    EXPECT_EQ(lines[k].fault, "");
  }
  EXPECT_EQ(lines[2].text, "");
  EXPECT_EQ(lines[2].fault, fault);
}

TEST(WorkerProcesses, OneThatCrashesLosesItsLineAlone) {
  expect_third_lost(with_third_line([] { ::kill(::getpid(), SIGKILL); }), "crashed (signal 9)");
}

TEST(WorkerProcesses, OneThatThrowsLosesItsLineAlone) {
  expect_third_lost(with_third_line([] { throw std::runtime_error("no"); }), "ended with status 1");
}

TEST(WorkerProcesses, OneThatEndsEarlyLosesItsLineAlone) {
  expect_third_lost(with_third_line([] { ::_exit(0); }), "ended early");
}

TEST(WorkerProcesses, OneThatHangsIsEnded) {
  const auto started = std::chrono::steady_clock::now();
  expect_third_lost(with_third_line([] { std::this_thread::sleep_for(std::chrono::minutes(10)); }, 2),
                    "hung: nothing for 2 s");
  EXPECT_LT(std::chrono::steady_clock::now() - started, std::chrono::minutes(9));
}

}  // namespace worker_processes_test
}  // namespace plumb
