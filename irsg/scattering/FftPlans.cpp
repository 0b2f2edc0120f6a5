#include "irsg/scattering/FftPlans.h"

#include <algorithm>
#include <new>

#include <fftw3.h>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"

namespace irsg {

namespace {

/// From this many points on a transform is divided into this many pieces, whatever the machine.
constexpr long threadedFrom = 256L * 256L;
constexpr int pieces = 4;
/// Sizes are taken from as many in each octave, so that objects that move are not planned for anew
/// at every step.
constexpr int stepsOfOctave = 8;

fftwf_complex* raw(std::complex<float>* values) {
    return reinterpret_cast<fftwf_complex*>(values);
}

/// Runs the pieces of a transform on the house's threads.
void runPieces(void* (*work)(char*), char* data, std::size_t size, int count, void*) {
    parallelFor(static_cast<std::size_t>(count), [&](std::size_t i) { work(data + i * size); });
}

} // namespace

void FftRelease::operator()(void* memory) const {
    fftwf_free(memory);
}

FftBuffer<float> fftReals(std::size_t count) {
    auto* memory = fftwf_alloc_real(count);
    if (!memory)
        throw std::bad_alloc();
    return FftBuffer<float>(memory);
}

FftBuffer<std::complex<float>> fftComplex(std::size_t count) {
    auto* memory = fftwf_alloc_complex(count);
    if (!memory)
        throw std::bad_alloc();
    return FftBuffer<std::complex<float>>(reinterpret_cast<std::complex<float>*>(memory));
}

int fastFftSize(int atLeast) {
    int step = 1;
    while (step * 2 * stepsOfOctave <= atLeast)
        step *= 2;
    for (int size = (std::max(atLeast, 1) + step - 1) / step * step;; size += step) {
        int rest = size;
        for (const int factor : {2, 3, 5, 7})
            while (rest % factor == 0)
                rest /= factor;
        if (rest == 1)
            return size;
    }
}

struct FftPlans::Pair {
    int width, height;
    fftwf_plan forward = nullptr, backward = nullptr;

    Pair(int w, int h) : width(w), height(h) {
        const auto columns = static_cast<std::size_t>(width) / 2 + 1;
        const FftBuffer<float> reals =
            fftReals(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        const FftBuffer<std::complex<float>> spectrum =
            fftComplex(columns * static_cast<std::size_t>(height));
        const long points = static_cast<long>(width) * height;
        fftwf_plan_with_nthreads(points >= threadedFrom ? pieces : 1);
        forward =
            fftwf_plan_dft_r2c_2d(height, width, reals.get(), raw(spectrum.get()), FFTW_ESTIMATE);
        backward =
            fftwf_plan_dft_c2r_2d(height, width, raw(spectrum.get()), reals.get(), FFTW_ESTIMATE);
        if (!forward || !backward)
            throw LogicError("FFTW has no plan for a transform");
    }
    ~Pair() {
        fftwf_destroy_plan(forward);
        fftwf_destroy_plan(backward);
    }
    Pair(const Pair&) = delete;
    Pair& operator=(const Pair&) = delete;
};

FftPlans::FftPlans() {
    if (fftwf_init_threads() == 0)
        throw LogicError("FFTW has no threads");
    fftwf_threads_set_callback(runPieces, nullptr);
}

FftPlans::~FftPlans() = default;

FftPlans& FftPlans::shared() {
    // Never destroyed: transforms may still be asked for by other static objects.
    static FftPlans* const plans = new FftPlans;
    return *plans;
}

const FftPlans::Pair& FftPlans::of(int width, int height) {
    const std::lock_guard lock(mutex_);
    const auto known = std::ranges::find_if(pairs_, [&](const std::unique_ptr<Pair>& pair) {
        return pair->width == width && pair->height == height;
    });
    if (known != pairs_.end())
        return **known;
    pairs_.push_back(std::make_unique<Pair>(width, height));
    return *pairs_.back();
}

void FftPlans::prepare(int width, int height) {
    of(width, height);
}

void FftPlans::forward(int width, int height, float* reals, std::complex<float>* spectrum) {
    fftwf_execute_dft_r2c(of(width, height).forward, reals, raw(spectrum));
}

void FftPlans::backward(int width, int height, std::complex<float>* spectrum, float* reals) {
    fftwf_execute_dft_c2r(of(width, height).backward, raw(spectrum), reals);
}

std::size_t FftPlans::planned() const {
    const std::lock_guard lock(mutex_);
    return pairs_.size();
}

} // namespace irsg
