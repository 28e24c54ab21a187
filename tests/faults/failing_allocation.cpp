// A library to be loaded before a program (LD_PRELOAD), which makes one allocation of it fail.
//   PLUMB_FAIL_ALLOCATION=N   the N-th call of malloc and its kin after main has begun returns nullptr
//   PLUMB_FAIL_ALLOCATION=N+  and so do all after it
//   PLUMB_COUNT_ALLOCATIONS=FILE  how many there were is written to FILE at the end
#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

std::atomic<bool> counting = false;
std::atomic<long> calls = 0;
long failing = -1;
bool all_after = false;

/// Where the code of libhdf5 lies. It crashes where an allocation of its own fails, which a program can only
/// keep from it by asking for the memory before.
std::uintptr_t spared_from = 0, spared_to = 0;

int find_spared(dl_phdr_info* library, std::size_t, void*) {
  if (library->dlpi_name == nullptr || std::strstr(library->dlpi_name, "libhdf5") == nullptr) return 0;
  for (int k = 0; k < library->dlpi_phnum; ++k) {
    const auto& segment = library->dlpi_phdr[k];
    if (segment.p_type != PT_LOAD || (segment.p_flags & PF_X) == 0) continue;
    spared_from = library->dlpi_addr + segment.p_vaddr;
    spared_to = spared_from + segment.p_memsz;
  }
  return 0;
}

bool fails(const void* caller) {
  const auto address = reinterpret_cast<std::uintptr_t>(caller);
  if (address >= spared_from && address < spared_to) return false;
  if (!counting.load(std::memory_order_relaxed)) return false;
  const long call = ++calls;
  if (failing < 0 || !(call == failing || (all_after && call > failing))) return false;
  errno = ENOMEM;
  return true;
}

using Main = int (*)(int, char**, char**);
Main real_main = nullptr;

void write_count() {
  counting = false;
  const char* path = std::getenv("PLUMB_COUNT_ALLOCATIONS");
  if (path == nullptr) return;
  const int file = ::open(path, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0) return;
  ::dprintf(file, "%ld\n", calls.load());
  ::close(file);
}

int counted_main(int count, char** arguments, char** environment) {
  if (const char* text = std::getenv("PLUMB_FAIL_ALLOCATION")) {
    char* end = nullptr;
    failing = std::strtol(text, &end, 10);
    all_after = *end == '+';
  }
  ::dl_iterate_phdr(find_spared, nullptr);
  counting = true;
  const int status = real_main(count, arguments, environment);
  write_count();
  return status;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) {
  return fails(__builtin_return_address(0)) ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
  return fails(__builtin_return_address(0)) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) {
  return fails(__builtin_return_address(0)) ? nullptr : __libc_realloc(old, size);
}

char* strdup(const char* text) {
  const std::size_t size = std::strlen(text) + 1;
  void* const copy = fails(__builtin_return_address(0)) ? nullptr : __libc_malloc(size);
  return copy != nullptr ? static_cast<char*>(std::memcpy(copy, text, size)) : nullptr;
}

void* memalign(std::size_t alignment, std::size_t size) {
  return fails(__builtin_return_address(0)) ? nullptr : __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return fails(__builtin_return_address(0)) ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** result, std::size_t alignment, std::size_t size) {
  if (fails(__builtin_return_address(0))) return ENOMEM;
  *result = __libc_memalign(alignment, size);
  return *result != nullptr ? 0 : ENOMEM;
}

int __libc_start_main(Main main, int count, char** arguments, void (*init)(), void (*fini)(),
                      void (*end_of_linker)(), void* stack) {
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  const auto start = reinterpret_cast<Start>(::dlsym(RTLD_NEXT, "__libc_start_main"));
  real_main = main;
  return start(counted_main, count, arguments, init, fini, end_of_linker, stack);
}

}  // extern "C"
