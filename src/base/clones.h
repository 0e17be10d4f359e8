// Functions compiled for several instruction sets, the best one chosen when the program starts.
#pragma once

// The vector width never shows in a result: products and sums stay separate (-ffp-contract=off) and
// no sum is reordered. The sanitizers do not know such choices.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(KNOTFIT_SANITIZED)
#define KNOTFIT_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define KNOTFIT_CLONES
#endif
