#include "irsg/sensor/FourierTransform.h"

#include <algorithm>
#include <string>
#include <utility>

#include <kissfft/kissfft.hh>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"

namespace irsg {

namespace {

using Complex = std::complex<double>;
using Plan = kissfft<double>;

/// Rows, or columns, that one thread takes at once.
constexpr std::size_t lanes = 16;

std::size_t withoutFactors(std::size_t size) {
    for (const std::size_t factor : {2, 3, 5})
        while (size % factor == 0)
            size /= factor;
    return size;
}

/// work(first, last) for pieces of `lanes` numbers up to `count`.
void inLanes(std::size_t count, const auto& work) {
    parallelFor((count + lanes - 1) / lanes, [&](std::size_t piece) {
        work(piece * lanes, std::min(count, (piece + 1) * lanes));
    });
}

bool isZero(const double* values, std::size_t count) {
    return std::all_of(values, values + count, [](double value) { return value == 0.0; });
}

/// Two rows in one transform, as real and imaginary part.
void transformRows(const std::vector<double>& values, HalfSpectrum& spectrum) {
    const std::size_t width = spectrum.width, columns = spectrum.columns();
    const Plan shared(width, false);
    inLanes(spectrum.height, [&](std::size_t first, std::size_t last) {
        const Plan plan = shared; // it has a buffer
        std::vector<Complex> both(width), result(width);
        for (std::size_t y = first; y < last; y += 2) {
            const bool isPair = y + 1 < last;
            const double* const row = &values[y * width];
            if (isZero(row, isPair ? 2 * width : width))
                continue;
            for (std::size_t x = 0; x < width; ++x)
                both[x] = {row[x], isPair ? row[width + x] : 0.0};
            plan.transform(both.data(), result.data());
            Complex* const to = &spectrum.values[y * columns];
            for (std::size_t k = 0; k < columns; ++k) {
                const Complex here = result[k], mirrored = std::conj(result[(width - k) % width]);
                to[k] = 0.5 * (here + mirrored);
                if (isPair) {
                    const Complex twice = here - mirrored; // of i times the second row
                    to[columns + k] = {0.5 * twice.imag(), -0.5 * twice.real()};
                }
            }
        }
    });
}

void transformColumns(HalfSpectrum& spectrum, bool inverse) {
    const std::size_t height = spectrum.height, columns = spectrum.columns();
    const Plan shared(height, inverse);
    inLanes(columns, [&](std::size_t first, std::size_t last) {
        const Plan plan = shared; // it has a buffer
        std::vector<Complex> lines((last - first) * height), result(height);
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = first; x < last; ++x)
                lines[(x - first) * height + y] = spectrum.values[y * columns + x];
        for (std::size_t x = first; x < last; ++x) {
            Complex* const line = &lines[(x - first) * height];
            plan.transform(line, result.data());
            std::ranges::copy(result, line);
        }
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = first; x < last; ++x)
                spectrum.values[y * columns + x] = lines[(x - first) * height + y];
    });
}

/// Two rows of conjugate halves in one transform.
std::vector<double> rowsBack(const HalfSpectrum& spectrum) {
    const std::size_t width = spectrum.width, height = spectrum.height;
    const std::size_t columns = spectrum.columns();
    const double scale = 1.0 / static_cast<double>(width * height);
    const Plan shared(width, true);
    std::vector<double> values(width * height);
    inLanes(height, [&](std::size_t first, std::size_t last) {
        const Plan plan = shared; // it has a buffer
        std::vector<Complex> both(width), result(width);
        for (std::size_t y = first; y < last; y += 2) {
            const bool isPair = y + 1 < last;
            const Complex* const one = &spectrum.values[y * columns];
            for (std::size_t k = 0; k < columns; ++k) {
                const Complex other = isPair ? one[columns + k] : Complex();
                both[k] = {one[k].real() - other.imag(), one[k].imag() + other.real()};
                if (k > 0)
                    both[width - k] = {one[k].real() + other.imag(), other.real() - one[k].imag()};
            }
            plan.transform(both.data(), result.data());
            for (std::size_t x = 0; x < width; ++x) {
                values[y * width + x] = scale * result[x].real();
                if (isPair)
                    values[(y + 1) * width + x] = scale * result[x].imag();
            }
        }
    });
    return values;
}

} // namespace

std::size_t smoothSize(std::size_t size) {
    std::size_t candidate = std::max<std::size_t>(1, size);
    while (withoutFactors(candidate) != 1)
        ++candidate;
    return candidate;
}

HalfSpectrum transformOf(const std::vector<double>& values, std::size_t width, std::size_t height) {
    if (values.empty() || values.size() != width * height)
        throw LogicError("a transform of " + std::to_string(values.size()) +
                         " numbers on a grid of other sides");
    HalfSpectrum spectrum(width, height);
    transformRows(values, spectrum);
    transformColumns(spectrum, false);
    return spectrum;
}

std::vector<double> transformBack(HalfSpectrum spectrum) {
    transformColumns(spectrum, true);
    return rowsBack(spectrum);
}

} // namespace irsg
