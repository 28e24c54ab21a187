#include "engine/base/deep_stack.h"

#include <pthread.h>
#include <sys/mman.h>

#include <exception>

#include "engine/base/errors.h"

namespace plumb {
namespace {

/// What every stack of a process or thread has free, and what a thread has beyond that which it is asked for.
constexpr std::size_t usual = 1024 * 1024;

struct Work {
  const std::function<void()>& act;
  std::exception_ptr thrown;
};

void* act(void* given) {
  auto& work = *static_cast<Work*>(given);
  try {
    work.act();
  } catch (...) {
    work.thrown = std::current_exception();
  }
  return nullptr;
}

/// Memory that is taken only where it is touched.
class Stack {
 public:
  explicit Stack(std::size_t bytes)
      : bytes_(bytes),
        memory_(::mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                       MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0)) {}
  ~Stack() {
    if (there()) ::munmap(memory_, bytes_);
  }
  Stack(const Stack&) = delete;
  Stack& operator=(const Stack&) = delete;
  bool there() const { return memory_ != MAP_FAILED; }
  void* memory() const { return memory_; }

 private:
  std::size_t bytes_;
  void* memory_;
};

}  // namespace

void on_deep_stack(std::size_t bytes, const std::function<void()>& work) {
  if (bytes <= usual / 2) return work();
  constexpr std::size_t page = 64 * 1024;
  const std::size_t size = (bytes + usual + page - 1) / page * page;
  const Stack stack(size);
  Work given{work, nullptr};
  pthread_t thread{};
  pthread_attr_t attributes;
  if (::pthread_attr_init(&attributes) != 0) throw InputError("there is no memory for a thread");
  const bool started = stack.there() && ::pthread_attr_setstack(&attributes, stack.memory(), size) == 0 &&
                       ::pthread_create(&thread, &attributes, act, &given) == 0;
  ::pthread_attr_destroy(&attributes);
  if (!started) throw InputError("there is no memory or thread for how deep it may be");
  ::pthread_join(thread, nullptr);
  if (given.thrown) std::rethrow_exception(given.thrown);
}

}  // namespace plumb
