#include "engine/kernels/kernels.h"

namespace plumb {
namespace kernels {
extern const Kernels for_any;
#ifdef PLUMB_HAS_V3_KERNELS
extern const Kernels for_v3;
#endif
}  // namespace kernels

const Kernels& plain_kernels() {
  return kernels::for_any;
}

const Kernels* v3_kernels() {
#ifdef PLUMB_HAS_V3_KERNELS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
      __builtin_cpu_supports("fma"))
    return &kernels::for_v3;
#endif
  return nullptr;
}

const Kernels& best_kernels() {
  static const Kernels& chosen = v3_kernels() != nullptr ? *v3_kernels() : plain_kernels();
  return chosen;
}

}  // namespace plumb
