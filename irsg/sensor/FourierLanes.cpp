#include "irsg/sensor/FourierLanes.h"

#include <array>
#include <cmath>
#include <utility>

#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Where the numbers of one group come from and go to.
template <typename Real>
struct Ends {
    const Real *fromReal, *fromImaginary; ///< number j is `apart` numbers behind j - 1
    Real *toReal, *toImaginary;           ///< number j is `count` numbers behind j - 1
    std::size_t apart, count;
    const Real *cosines, *sines; ///< of the turns of numbers 1 to radix - 1
};

/// (re, im) turned by number j's turn, or as it is where all turns are 0.
template <bool isTurned, typename Real>
void put(const Ends<Real>& ends, std::size_t j, std::size_t i, Real re, Real im) {
    Real* const __restrict toReal = ends.toReal + j * ends.count;
    Real* const __restrict toImaginary = ends.toImaginary + j * ends.count;
    if (!isTurned || j == 0) {
        toReal[i] = re;
        toImaginary[i] = im;
    } else {
        const Real cosine = ends.cosines[j - 1], sine = ends.sines[j - 1];
        toReal[i] = re * cosine - im * sine;
        toImaginary[i] = re * sine + im * cosine;
    }
}

template <bool isTurned, typename Real>
void sumsOfTwo(const Ends<Real> ends) {
    const std::size_t count = ends.count;
    const Real* const __restrict re = ends.fromReal;
    const Real* const __restrict im = ends.fromImaginary;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const Real r0 = re[i], r1 = re[i + ends.apart], i0 = im[i], i1 = im[i + ends.apart];
        put<isTurned>(ends, 0, i, r0 + r1, i0 + i1);
        put<isTurned>(ends, 1, i, r0 - r1, i0 - i1);
    }
}

template <bool isTurned, typename Real>
void sumsOfFour(const Ends<Real> ends) {
    const std::size_t count = ends.count, apart = ends.apart;
    const Real* const __restrict re = ends.fromReal;
    const Real* const __restrict im = ends.fromImaginary;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        const Real evenR = re[i] + re[i + 2 * apart], evenI = im[i] + im[i + 2 * apart];
        const Real lessR = re[i] - re[i + 2 * apart], lessI = im[i] - im[i + 2 * apart];
        const Real oddR = re[i + apart] + re[i + 3 * apart];
        const Real oddI = im[i + apart] + im[i + 3 * apart];
        // -i times the difference of the odd numbers.
        const Real turnedR = im[i + apart] - im[i + 3 * apart];
        const Real turnedI = re[i + 3 * apart] - re[i + apart];
        put<isTurned>(ends, 0, i, evenR + oddR, evenI + oddI);
        put<isTurned>(ends, 1, i, lessR + turnedR, lessI + turnedI);
        put<isTurned>(ends, 2, i, evenR - oddR, evenI - oddI);
        put<isTurned>(ends, 3, i, lessR - turnedR, lessI - turnedI);
    }
}

/// cos(2 pi j k / radix) and sines, of j and k from 1 to (radix - 1) / 2.
template <std::size_t radix, typename Real>
struct Roots {
    static constexpr std::size_t half = (radix - 1) / 2;
    std::array<std::array<Real, half>, half> cosines, sines;

    Roots() {
        for (std::size_t j = 0; j < half; ++j)
            for (std::size_t k = 0; k < half; ++k) {
                const double angle =
                    2.0 * pi * static_cast<double>((j + 1) * (k + 1) % radix) / radix;
                cosines[j][k] = static_cast<Real>(std::cos(angle));
                sines[j][k] = static_cast<Real>(std::sin(angle));
            }
    }
};

/// Numbers k and radix - k enter by their sum and their difference.
template <std::size_t radix, bool isTurned, typename Real>
void sumsOfOdd(const Ends<Real> ends) {
    static const Roots<radix, Real> shared;
    const Roots<radix, Real> roots = shared;
    constexpr std::size_t half = Roots<radix, Real>::half;
    const std::size_t count = ends.count, apart = ends.apart;
    const Real* const __restrict re = ends.fromReal;
    const Real* const __restrict im = ends.fromImaginary;
#pragma GCC ivdep
    for (std::size_t i = 0; i < count; ++i) {
        Real sumR[half], sumI[half], lessR[half], lessI[half];
        Real allR = re[i], allI = im[i];
        for (std::size_t k = 0; k < half; ++k) {
            const std::size_t one = i + (k + 1) * apart, other = i + (radix - 1 - k) * apart;
            sumR[k] = re[one] + re[other];
            sumI[k] = im[one] + im[other];
            lessR[k] = re[one] - re[other];
            lessI[k] = im[one] - im[other];
            allR += sumR[k];
            allI += sumI[k];
        }
        put<isTurned>(ends, 0, i, allR, allI);
        for (std::size_t j = 0; j < half; ++j) {
            Real evenR = re[i], evenI = im[i], oddR = 0, oddI = 0;
            for (std::size_t k = 0; k < half; ++k) {
                evenR += roots.cosines[j][k] * sumR[k];
                evenI += roots.cosines[j][k] * sumI[k];
                oddR += roots.sines[j][k] * lessI[k];
                oddI -= roots.sines[j][k] * lessR[k];
            }
            put<isTurned>(ends, j + 1, i, evenR + oddR, evenI + oddI);
            put<isTurned>(ends, radix - 1 - j, i, evenR - oddR, evenI - oddI);
        }
    }
}

/// Any other radix, by the definition.
template <typename Real>
void sumsOfAny(const Ends<Real> ends, std::size_t radix) {
    for (std::size_t i = 0; i < ends.count; ++i)
        for (std::size_t j = 0; j < radix; ++j) {
            double re = 0.0, im = 0.0;
            for (std::size_t k = 0; k < radix; ++k) {
                const double angle =
                    -2.0 * pi * static_cast<double>(j * k % radix) / static_cast<double>(radix);
                const double cosine = std::cos(angle), sine = std::sin(angle);
                const double r = ends.fromReal[i + k * ends.apart];
                const double m = ends.fromImaginary[i + k * ends.apart];
                re += r * cosine - m * sine;
                im += r * sine + m * cosine;
            }
            put<true>(ends, j, i, static_cast<Real>(re), static_cast<Real>(im));
        }
}

template <bool isTurned, typename Real>
void sums(const Ends<Real>& ends, std::size_t radix) {
    switch (radix) {
    case 2:
        return sumsOfTwo<isTurned>(ends);
    case 3:
        return sumsOfOdd<3, isTurned>(ends);
    case 4:
        return sumsOfFour<isTurned>(ends);
    case 5:
        return sumsOfOdd<5, isTurned>(ends);
    default:
        return sumsOfAny(ends, radix);
    }
}

std::size_t radixOf(std::size_t size) {
    for (const std::size_t radix : {4, 2, 3, 5})
        if (size % radix == 0)
            return radix;
    std::size_t prime = 7;
    while (size % prime != 0)
        prime += 2;
    return prime;
}

} // namespace

template <typename Real>
FourierLanes<Real>::FourierLanes(std::size_t size) {
    std::size_t stride = 1;
    while (size > 1) {
        const std::size_t radix = radixOf(size), groups = size / radix;
        Stage stage{radix, groups, stride, {}, {}};
        for (std::size_t place = 0; place < groups; ++place)
            for (std::size_t j = 1; j < radix; ++j) {
                const double angle =
                    -2.0 * pi * static_cast<double>(place * j) / static_cast<double>(size);
                stage.cosines.push_back(static_cast<Real>(std::cos(angle)));
                stage.sines.push_back(static_cast<Real>(std::sin(angle)));
            }
        stages_.push_back(std::move(stage));
        stride *= radix;
        size = groups;
    }
}

template <typename Real>
void FourierLanes<Real>::run(Lines& lines, Lines& scratch, bool isBack) const {
    for (const Stage& stage : stages_) {
        const std::size_t count = stage.stride * lanes;
        // Real and imaginary parts exchanged before and after turn the other way.
        const Real* const re = (isBack ? lines.imaginary : lines.real).data();
        const Real* const im = (isBack ? lines.real : lines.imaginary).data();
        Real* const toRe = (isBack ? scratch.imaginary : scratch.real).data();
        Real* const toIm = (isBack ? scratch.real : scratch.imaginary).data();
        for (std::size_t place = 0; place < stage.groups; ++place) {
            const std::size_t from = place * count, to = place * stage.radix * count,
                              turn = place * (stage.radix - 1);
            const Ends<Real> ends{re + from,
                                  im + from,
                                  toRe + to,
                                  toIm + to,
                                  stage.groups * count,
                                  count,
                                  stage.cosines.data() + turn,
                                  stage.sines.data() + turn};
            if (place == 0)
                sums<false>(ends, stage.radix);
            else
                sums<true>(ends, stage.radix);
        }
        std::swap(lines, scratch);
    }
}

template class FourierLanes<float>;
template class FourierLanes<double>;

} // namespace irsg
