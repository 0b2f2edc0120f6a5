#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace irsg {

/// Whether Fourier transforms can be computed: FFTW is under the GPL and comes in a library of its
/// own, libirsg_fftw, which is loaded when this or a transform is first asked for. Without it what
/// follows throws InputError; the rest of the folder needs none.
bool areTransformsInstalled();

/// Memory that FFTW's vector instructions can use.
struct FftRelease {
    void operator()(void* memory) const;
};
template <typename Value>
using FftBuffer = std::unique_ptr<Value[], FftRelease>;
FftBuffer<float> fftReals(std::size_t count);
FftBuffer<std::complex<float>> fftComplex(std::size_t count);

/// The next size from `atLeast` on whose factors are 2, 3, 5 and 7, of a few in each octave.
int fastFftSize(int atLeast);

/// Two-dimensional real transforms of a size, forward and back, planned once and kept. Rows are
/// contiguous; a spectrum has width / 2 + 1 columns; neither direction divides by the number of
/// points. Plans follow from the size alone (FFTW_ESTIMATE, no wisdom): measured ones depend on a
/// clock, and with them the last bits of each result. Large transforms use the threads of
/// parallelFor.
class FftPlans {
  public:
    /// One for the process, as FFTW's planner is.
    static FftPlans& shared();

    void forward(int width, int height, float* reals, std::complex<float>* spectrum);
    /// Destroys the spectrum.
    void backward(int width, int height, std::complex<float>* spectrum, float* reals);
    /// Plans both directions of a size, unless they are known.
    void prepare(int width, int height);
    /// Sizes that were planned since the program began.
    std::size_t planned() const;

  private:
    struct Pair;
    FftPlans();
    ~FftPlans();
    const Pair& of(int width, int height);

    mutable std::mutex mutex_;
    std::vector<std::unique_ptr<Pair>> pairs_;
};

} // namespace irsg
