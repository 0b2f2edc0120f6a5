#include "irsg/sensor/FourierTransform.h"

#include <algorithm>
#include <string>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/sensor/FourierLanes.h"

namespace irsg {

namespace {

std::size_t withoutFactors(std::size_t size) {
    for (const std::size_t factor : {2, 3, 5})
        while (size % factor == 0)
            size /= factor;
    return size;
}

/// work(first, last) for pieces of `width` numbers up to `count`.
void inPieces(std::size_t count, std::size_t width, const auto& work) {
    parallelFor((count + width - 1) / width, [&](std::size_t piece) {
        work(piece * width, std::min(count, (piece + 1) * width));
    });
}

/// Two rows in one line, as real and imaginary part.
template <typename Real>
void transformRows(const std::vector<Real>& values, HalfSpectrumOf<Real>& spectrum) {
    using Plan = FourierLanes<Real>;
    constexpr std::size_t lanes = Plan::lanes;
    const std::size_t width = spectrum.width, columns = spectrum.columns();
    const Plan plan(width);
    inPieces(spectrum.height, 2 * lanes, [&](std::size_t first, std::size_t last) {
        const std::size_t rows = last - first, ones = (rows + 1) / 2, others = rows / 2;
        typename Plan::Lines lines(width), scratch(width);
        for (std::size_t x = 0; x < width; ++x) {
            const Real* const from = &values[first * width + x];
            for (std::size_t l = 0; l < ones; ++l)
                lines.real[x * lanes + l] = from[2 * l * width];
            for (std::size_t l = 0; l < others; ++l)
                lines.imaginary[x * lanes + l] = from[(2 * l + 1) * width];
        }
        plan.transform(lines, scratch);
        constexpr Real half = 0.5;
        for (std::size_t k = 0; k < columns; ++k) {
            const std::size_t here = k * lanes, mirrored = (width - k) % width * lanes;
            std::complex<Real>* const to = &spectrum.values[first * columns + k];
            for (std::size_t l = 0; l < ones; ++l) {
                const Real re = lines.real[here + l], im = lines.imaginary[here + l];
                const Real mirroredRe = lines.real[mirrored + l];
                const Real mirroredIm = lines.imaginary[mirrored + l];
                to[2 * l * columns] = {half * (re + mirroredRe), half * (im - mirroredIm)};
                if (l < others)
                    to[(2 * l + 1) * columns] = {half * (im + mirroredIm),
                                                 half * (mirroredRe - re)};
            }
        }
    });
}

template <typename Real>
void transformColumns(HalfSpectrumOf<Real>& spectrum, bool isBack) {
    using Plan = FourierLanes<Real>;
    constexpr std::size_t lanes = Plan::lanes;
    const std::size_t height = spectrum.height, columns = spectrum.columns();
    const Plan plan(height);
    inPieces(columns, lanes, [&](std::size_t first, std::size_t last) {
        typename Plan::Lines lines(height), scratch(height);
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = first; x < last; ++x) {
                const std::complex<Real> value = spectrum.values[y * columns + x];
                lines.real[y * lanes + x - first] = value.real();
                lines.imaginary[y * lanes + x - first] = value.imag();
            }
        if (isBack)
            plan.transformBack(lines, scratch);
        else
            plan.transform(lines, scratch);
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = first; x < last; ++x)
                spectrum.values[y * columns + x] = {lines.real[y * lanes + x - first],
                                                    lines.imaginary[y * lanes + x - first]};
    });
}

/// Two rows of conjugate halves in one line.
template <typename Real>
std::vector<Real> rowsBack(const HalfSpectrumOf<Real>& spectrum) {
    using Plan = FourierLanes<Real>;
    constexpr std::size_t lanes = Plan::lanes;
    const std::size_t width = spectrum.width, height = spectrum.height;
    const std::size_t columns = spectrum.columns();
    const Real scale = static_cast<Real>(1.0 / static_cast<double>(width * height));
    const Plan plan(width);
    std::vector<Real> values(width * height);
    inPieces(height, 2 * lanes, [&](std::size_t first, std::size_t last) {
        const std::size_t rows = last - first, ones = (rows + 1) / 2, others = rows / 2;
        typename Plan::Lines lines(width), scratch(width);
        for (std::size_t k = 0; k < columns; ++k) {
            const std::complex<Real>* const from = &spectrum.values[first * columns + k];
            const std::size_t here = k * lanes, mirrored = (width - k) % width * lanes;
            for (std::size_t l = 0; l < ones; ++l) {
                const std::complex<Real> one = from[2 * l * columns];
                const std::complex<Real> other =
                    l < others ? from[(2 * l + 1) * columns] : std::complex<Real>();
                lines.real[here + l] = one.real() - other.imag();
                lines.imaginary[here + l] = one.imag() + other.real();
                if (k > 0) {
                    lines.real[mirrored + l] = one.real() + other.imag();
                    lines.imaginary[mirrored + l] = other.real() - one.imag();
                }
            }
        }
        plan.transformBack(lines, scratch);
        for (std::size_t x = 0; x < width; ++x) {
            Real* const to = &values[first * width + x];
            for (std::size_t l = 0; l < ones; ++l)
                to[2 * l * width] = scale * lines.real[x * lanes + l];
            for (std::size_t l = 0; l < others; ++l)
                to[(2 * l + 1) * width] = scale * lines.imaginary[x * lanes + l];
        }
    });
    return values;
}

template <typename Real>
HalfSpectrumOf<Real> transformed(const std::vector<Real>& values, std::size_t width,
                                 std::size_t height) {
    if (values.empty() || values.size() != width * height)
        throw LogicError("a transform of " + std::to_string(values.size()) +
                         " numbers on a grid of other sides");
    HalfSpectrumOf<Real> spectrum(width, height);
    transformRows(values, spectrum);
    transformColumns(spectrum, false);
    return spectrum;
}

} // namespace

std::size_t smoothSize(std::size_t size) {
    std::size_t candidate = std::max<std::size_t>(1, size);
    while (withoutFactors(candidate) != 1)
        ++candidate;
    return candidate;
}

HalfSpectrum transformOf(const std::vector<double>& values, std::size_t width, std::size_t height) {
    return transformed(values, width, height);
}

HalfSpectrumOf<float> transformOf(const std::vector<float>& values, std::size_t width,
                                  std::size_t height) {
    return transformed(values, width, height);
}

std::vector<double> transformBack(HalfSpectrum spectrum) {
    transformColumns(spectrum, true);
    return rowsBack(spectrum);
}

std::vector<float> transformBack(HalfSpectrumOf<float> spectrum) {
    transformColumns(spectrum, true);
    return rowsBack(spectrum);
}

} // namespace irsg
