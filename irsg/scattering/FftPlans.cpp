#include "irsg/scattering/FftPlans.h"

#include <algorithm>
#include <new>

#include <dlfcn.h>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/scattering/FftLibrary.h"

namespace irsg {

namespace {

/// From this many points on a transform is divided into this many pieces, whatever the machine.
constexpr long threadedFrom = 256L * 256L;
constexpr int pieces = 4;
/// Sizes are taken from as many in each octave, so that objects that move are not planned for anew
/// at every step.
constexpr int stepsOfOctave = 8;

/// Runs the pieces of a transform on the house's threads.
void runPieces(void* (*work)(char*), char* data, std::size_t size, int count, void*) {
    parallelFor(static_cast<std::size_t>(count), [&](std::size_t i) { work(data + i * size); });
}

/// The library of transforms, or a null pointer.
const FftLibrary* loadedLibrary() {
#ifdef IRSG_LINKS_FFTW
    return irsgFftLibrary();
#else
    using Offer = const FftLibrary* (*)();
    static const FftLibrary* const library = []() -> const FftLibrary* {
        void* const loaded = dlopen("libirsg_fftw.so", RTLD_NOW | RTLD_LOCAL);
        void* const offer = loaded == nullptr ? nullptr : dlsym(loaded, "irsgFftLibrary");
        return offer == nullptr ? nullptr : reinterpret_cast<Offer>(offer)();
    }();
    return library;
#endif
}

const FftLibrary& library() {
    const FftLibrary* const loaded = loadedLibrary();
    if (loaded == nullptr)
        throw InputError(
            {"libirsg_fftw.so", "", "no library of Fourier transforms", "package irsg-scattering"});
    return *loaded;
}

void* allocated(std::size_t bytes) {
    void* const memory = library().allocate(bytes);
    if (memory == nullptr)
        throw std::bad_alloc();
    return memory;
}

} // namespace

bool areTransformsInstalled() {
    return loadedLibrary() != nullptr;
}

void FftRelease::operator()(void* memory) const {
    library().release(memory);
}

FftBuffer<float> fftReals(std::size_t count) {
    return FftBuffer<float>(static_cast<float*>(allocated(count * sizeof(float))));
}

FftBuffer<std::complex<float>> fftComplex(std::size_t count) {
    return FftBuffer<std::complex<float>>(
        static_cast<std::complex<float>*>(allocated(count * sizeof(std::complex<float>))));
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
    FftLibrary::Plan *forward = nullptr, *backward = nullptr;

    Pair(int w, int h) : width(w), height(h) {
        const auto columns = static_cast<std::size_t>(width) / 2 + 1;
        const FftBuffer<float> reals =
            fftReals(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        const FftBuffer<std::complex<float>> spectrum =
            fftComplex(columns * static_cast<std::size_t>(height));
        const int parts = static_cast<long>(width) * height >= threadedFrom ? pieces : 1;
        forward = library().planForward(width, height, parts, reals.get(), spectrum.get());
        backward = library().planBackward(width, height, parts, spectrum.get(), reals.get());
        if (forward == nullptr || backward == nullptr)
            throw LogicError("FFTW has no plan for a transform");
    }
    ~Pair() {
        library().destroy(forward);
        library().destroy(backward);
    }
    Pair(const Pair&) = delete;
    Pair& operator=(const Pair&) = delete;
};

FftPlans::FftPlans() {
    if (!library().divideBy(runPieces))
        throw LogicError("FFTW has no threads");
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
    library().forward(of(width, height).forward, reals, spectrum);
}

void FftPlans::backward(int width, int height, std::complex<float>* spectrum, float* reals) {
    library().backward(of(width, height).backward, spectrum, reals);
}

std::size_t FftPlans::planned() const {
    const std::lock_guard lock(mutex_);
    return pairs_.size();
}

} // namespace irsg
