#pragma once

/** Before a function: compiles it for AVX2 too, and lets the loader choose.

    Only AVX2, without fused multiplication and addition, so that every processor computes the same
    bits. Sanitizers instrument the choice itself, which runs before they are ready.
*/
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
    !defined(__SANITIZE_ADDRESS__)
#define LIXEL_MULTIVERSION __attribute__((target_clones("avx2", "default")))
#else
#define LIXEL_MULTIVERSION
#endif
