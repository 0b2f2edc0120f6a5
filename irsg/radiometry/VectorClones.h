#pragma once

/// Before a function with long loops: it is compiled for the vectors of newer processors too, and
/// the program takes the widest that its processor has. Files that use it are compiled without
/// contraction of products and sums (CMakeLists.txt), so all versions give the same bits.
/// Sanitizers, which cannot run before a program starts, get the plain version.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) &&       \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define IRSG_VECTOR_CLONES [[gnu::target_clones("avx512f", "avx2", "default")]]
#else
#define IRSG_VECTOR_CLONES
#endif
