#pragma once

#include <complex>
#include <cstddef>

namespace irsg {

/// FFTW in single precision as a table of functions. FFTW is under the GPL, so it stays in a
/// library of its own, libirsg_fftw, which is loaded at the first transform and may be missing. The
/// library needs nothing of irsg. Planning is not safe between threads; transforms are.
struct FftLibrary {
    /// Runs work(data), work(data + size), ... to the number of `count`.
    using RunPieces = void (*)(void* (*work)(char*), char* data, std::size_t size, int count,
                               void*);
    struct Plan;

    /// Memory that vector instructions can use; a null pointer where there is none left.
    void* (*allocate)(std::size_t bytes);
    void (*release)(void* memory);
    /// Once before the first plan: how the pieces of a transform are run. False where the library
    /// cannot divide transforms.
    bool (*divideBy)(RunPieces run);
    /// Plans of width x height points in so many pieces, by size alone (FFTW_ESTIMATE); a null
    /// pointer where there is none. The arrays have the sizes of those that are transformed later.
    Plan* (*planForward)(int width, int height, int pieces, float* reals,
                         std::complex<float>* spectrum);
    Plan* (*planBackward)(int width, int height, int pieces, std::complex<float>* spectrum,
                          float* reals);
    void (*forward)(const Plan* plan, float* reals, std::complex<float>* spectrum);
    void (*backward)(const Plan* plan, std::complex<float>* spectrum, float* reals);
    void (*destroy)(Plan* plan);
};

/// The only name that libirsg_fftw offers.
extern "C" const FftLibrary* irsgFftLibrary();

} // namespace irsg
