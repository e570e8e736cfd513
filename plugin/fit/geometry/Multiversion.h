#pragma once

/** Before a function: compiles it for AVX2 too, and lets the loader choose.

    Only AVX2, without fused multiplication and addition, so that every processor computes the same
    bits. Sanitizers instrument the choice itself, which runs before they are ready.

    A function has it where the fits that use it gain more than 5 %. Time without it, relative to the time
    with it, in lixel-bench-fit: geometric mean of all techniques, lights and 10 to 10 000 boxes, and
    the most.

        all of them             3.06   4.4
        lanesReaching           1.80   3.2
        lanesInside             1.33   2.0
        findBounds              1.23   1.6
        smallestMap             1.14   2.8   (Optimal, XPSM)
        ImageHull, lanesBeyond  1.12   1.3
        meetBlock               1.09   1.9   (Optimal, XPSM)
        ImageHull, findBeyond   1.06   1.15
        judge                   1.06   1.6   (Optimal, XPSM)
        runsAlong               1.05   1.16
        castRays                1.03   1.11  (Optimal, XPSM)
        sumOver                 1.02   1.08  (Optimal, XPSM)

    reach and meetDiscs work on hulls and surface clouds, which that benchmark does not have.
*/
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
    !defined(__SANITIZE_ADDRESS__)
#define LIXEL_MULTIVERSION __attribute__((target_clones("avx2", "default")))
#else
#define LIXEL_MULTIVERSION
#endif
