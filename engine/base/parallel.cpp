#include "engine/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/base/interrupt.h"

namespace plumb {

void for_each_in_parallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex guard;
  const auto take = [&] {
    for (std::size_t k = next++; k < count; k = next++) {
      try {
        stop_if_interrupted();
        work(k);
      } catch (...) {
        const std::lock_guard lock(guard);
        if (!failure) failure = std::current_exception();
        next = count;
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    const std::size_t wanted =
        std::min<std::size_t>(count, std::max(1U, std::thread::hardware_concurrency()));
    try {
      for (std::size_t k = 1; k < wanted; ++k) threads.emplace_back(take);
    } catch (const std::exception&) {
      // No more threads, nor memory for them, are to be had: those there are, this one among them, do all.
    }
    take();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace plumb
