#include "engine/wide/contact_kernels.h"

namespace engine {
namespace baseline {
extern const ContactKernels kContactKernels;
}
#if defined(ENGINE_HAS_AVX2)
namespace avx2 {
extern const ContactKernels kContactKernels;
}
#endif

const ContactKernels& contactKernels(Instructions wanted) {
#if defined(ENGINE_HAS_AVX2)
    if (wanted != Instructions::baseline && __builtin_cpu_supports("avx2"))
        return avx2::kContactKernels;
#endif
    static_cast<void>(wanted);
    return baseline::kContactKernels;
}

}  // namespace engine
