#include "irsg/sensor/SensorBlur.h"

#include <complex>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"

namespace irsg {

namespace {

/// A kernel on a square, whose second half lies before the beginning, on a wider grid. What lies at
/// the square's middle belongs to both ends.
std::vector<float> widened(const std::vector<double>& square, std::size_t side, std::size_t wide,
                           std::size_t high, double scale) {
    std::vector<float> kernel(wide * high);
    const std::size_t middle = side / 2;
    struct Place {
        std::size_t from, to;
        double factor;
    };
    const auto placesOf = [&](std::size_t length) {
        std::vector<Place> places;
        for (std::size_t i = 0; i < side; ++i)
            if (i == middle) {
                places.push_back({i, middle, 0.5});
                places.push_back({i, length - middle, 0.5});
            } else {
                places.push_back({i, i < middle ? i : length - side + i, 1.0});
            }
        return places;
    };
    const std::vector<Place> alongX = placesOf(wide), alongY = placesOf(high);
    for (const Place& y : alongY)
        for (const Place& x : alongX)
            kernel[y.to * wide + x.to] +=
                static_cast<float>(scale * x.factor * y.factor * square[y.from * side + x.from]);
    return kernel;
}

/// sum += a b, of b the conjugate where asked for. Written out, because the product of
/// std::complex looks for infinities.
template <bool isConjugate>
void addProduct(const std::complex<float>* a, const std::complex<float>* b, std::size_t count,
                std::complex<float>* sum) {
    for (std::size_t i = 0; i < count; ++i) {
        const float re = b[i].real(), im = isConjugate ? -b[i].imag() : b[i].imag();
        sum[i] = {sum[i].real() + (a[i].real() * re - a[i].imag() * im),
                  sum[i].imag() + (a[i].real() * im + a[i].imag() * re)};
    }
}

/// The mean of the cells at the upper left of the pixels.
double levelOf(const std::vector<float>& radiance, std::size_t width, std::size_t height,
               std::size_t cells) {
    double sum = 0.0;
    for (std::size_t y = 0; y < height; ++y) {
        double row = 0.0;
        for (std::size_t x = 0; x < width; ++x)
            row += static_cast<double>(radiance[(y * width * cells + x) * cells]);
        sum += row;
    }
    return sum / static_cast<double>(width * height);
}

} // namespace

SensorBlur::SensorBlur(const PointSpread& spread, std::size_t width_px, std::size_t height_px,
                       int samples)
    : width_(width_px),
      height_(height_px),
      wide_(smoothSize(width_px + spread.side_px())),
      high_(smoothSize(height_px + spread.side_px())),
      cells_(static_cast<std::size_t>(samples)),
      samples_(samples),
      whole_(0.0) {
    // A cell sends the part of the pixel's radiance that its area is.
    const double area = 1.0 / (samples * samples);
    const std::size_t half = (cells_ + 1) / 2;
    const auto placeOf = [&](std::size_t i) {
        return (static_cast<double>(i) + 0.5) / samples - 0.5;
    };
    const auto timesMirrored = [&](std::size_t i) { return 2 * i + 1 == cells_ ? 1.0 : 2.0; };
    for (std::size_t v = 0; v < half; ++v)
        for (std::size_t u = 0; u < half; ++u) {
            HalfSpectrum square = spread.spectrumOf(1.0 / samples, placeOf(u), placeOf(v));
            whole_ += area * timesMirrored(u) * timesMirrored(v) * square.values.front().real();
            kernels_.push_back(transformOf(
                widened(transformBack(std::move(square)), spread.side_px(), wide_, high_, area),
                wide_, high_));
        }
}

void SensorBlur::add(const std::vector<float>& radiance, std::size_t column, std::size_t row,
                     double level, HalfSpectrumOf<float>& sum) const {
    std::vector<float> image(wide_ * high_);
    // Half of what is added goes on behind the end, half stands before the beginning.
    const std::size_t past = width_ + (wide_ - width_) / 2;
    const std::size_t pastRows = height_ + (high_ - height_) / 2;
    parallelFor(high_, [&](std::size_t y) {
        const std::size_t fromRow = y < height_ ? y : y < pastRows ? height_ - 1 : 0;
        const float* const from =
            radiance.data() + (fromRow * cells_ + row) * width_ * cells_ + column;
        float* const to = image.data() + y * wide_;
        const auto at = [&](std::size_t x) {
            return static_cast<float>(static_cast<double>(from[x * cells_]) - level);
        };
        for (std::size_t x = 0; x < width_; ++x)
            to[x] = at(x);
        for (std::size_t x = width_; x < wide_; ++x)
            to[x] = x < past ? to[width_ - 1] : to[0];
    });
    const HalfSpectrumOf<float> transform = transformOf(image, wide_, high_);
    // The spread is even: a place mirrored at the columns has the conjugate of the rows turned
    // round, at both the conjugate, at the rows the rows turned round.
    const bool isMirrored = 2 * column + 1 > cells_, isTurned = 2 * row + 1 > cells_;
    const std::size_t half = (cells_ + 1) / 2;
    const HalfSpectrumOf<float>& kernel = kernels_[(isTurned ? cells_ - 1 - row : row) * half +
                                                   (isMirrored ? cells_ - 1 - column : column)];
    const std::size_t columns = sum.columns();
    parallelFor(high_, [&](std::size_t y) {
        const std::size_t from = isMirrored != isTurned ? (high_ - y) % high_ : y;
        const auto* const a = transform.values.data() + y * columns;
        const auto* const b = kernel.values.data() + from * columns;
        if (isMirrored)
            addProduct<true>(a, b, columns, sum.values.data() + y * columns);
        else
            addProduct<false>(a, b, columns, sum.values.data() + y * columns);
    });
}

std::vector<double> SensorBlur::blurred(const std::vector<float>& radiance) const {
    if (radiance.size() != width_ * height_ * cells_ * cells_)
        throw LogicError("radiance of another size than the sensor's grid");
    const double level = levelOf(radiance, width_, height_, cells_);
    HalfSpectrumOf<float> sum(wide_, high_);
    for (std::size_t row = 0; row < cells_; ++row)
        for (std::size_t column = 0; column < cells_; ++column)
            add(radiance, column, row, level, sum);
    const std::vector<float> differences = transformBack(std::move(sum));
    std::vector<double> result(width_ * height_);
    parallelFor(height_, [&](std::size_t y) {
        for (std::size_t x = 0; x < width_; ++x)
            result[y * width_ + x] =
                whole_ * level + static_cast<double>(differences[y * wide_ + x]);
    });
    return result;
}

} // namespace irsg
