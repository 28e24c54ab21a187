#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

#include "engine/integrate/method.h"
#include "engine/model/cable.h"
#include "engine/model/huge_array.h"
#include "tests/engine/pendulum.h"

namespace {
std::atomic<long> allocations = 0;
}

// The linker sends every malloc and aligned_alloc of this program and of the engine here (-Wl,--wrap=…), and
// operator new asks malloc; what shared libraries ask for is not counted.
extern "C" void* __real_malloc(std::size_t size);
extern "C" void* __real_aligned_alloc(std::size_t alignment, std::size_t size);
extern "C" void* __wrap_malloc(std::size_t size) {
  ++allocations;
  return __real_malloc(size);
}
extern "C" void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __real_aligned_alloc(alignment, size);
}

// Not inlined, or the compiler sees a free of what it takes to come from the library's operator new.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return std::malloc(size > 0 ? size : 1);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace plumb {
namespace {

TEST(Allocation, NoMethodAllocatesWithinTheTimeLoop) {
  for (const MethodInfo& info : method_infos())
    for (const Support first : {Support::pinned, Support::clamped}) {
      if (!info.dynamic) continue;
      Case spec = pendulum(5, 6);
      spec.supports.first = first;
      const Cable cable(spec);
      const State start{0, cable.start_q(spec.start), cable.start_v(spec.start)};
      Dynamics dynamics(cable);
      const MethodSpec with = info.takes_step ? method(info.name, 1e-4) : method(info.name, {}, 1e-6);
      const std::unique_ptr<Method> integrator = make_method(with, dynamics, start);
      State between = start;
      const auto steps = [&](int count) {
        for (int k = 0; k < count; ++k) {
          ASSERT_TRUE(integrator->step(10).ok()) << info.name;
          integrator->interpolate(integrator->state().t, between);
        }
      };
      steps(20);  // buffers get their sizes
      const long before = allocations;
      steps(200);
      EXPECT_EQ(allocations - before, 0) << info.name << ", " << word(first);
    }
}

TEST(Allocation, OfAnyKindIsCounted) {
  const long before = allocations;
  const Eigen::VectorXd some = Eigen::VectorXd::Ones(100);
  asm volatile("" : : "r"(some.data()) : "memory");  // so that it is not optimised away
  EXPECT_EQ(allocations - before, 1);
  const HugeArray numbers(100);
  asm volatile("" : : "r"(numbers.data()) : "memory");
  EXPECT_EQ(allocations - before, 2);
  const auto one = std::make_unique<int>(1);
  asm volatile("" : : "r"(one.get()) : "memory");
  EXPECT_EQ(allocations - before, 3);
}

}  // namespace
}  // namespace plumb
