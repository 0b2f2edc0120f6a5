#include "irsg/scattering/MtfFilter.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"

namespace irsg {

namespace {

/// Transforms of the haze that are kept, for objects that take turns.
constexpr std::size_t mostKernels = 4;

std::size_t columnsOf(int width) {
    return static_cast<std::size_t>(width) / 2 + 1;
}
int wrapped(int index, int period) {
    const int rest = index % period;
    return rest < 0 ? rest + period : rest;
}

} // namespace

HazeWindow HazeWindow::grown(int by_px, int frameWidth, int frameHeight) const {
    const int left = std::max(x - by_px, 0), top = std::max(y - by_px, 0);
    const int right = std::min(x + width + by_px, frameWidth);
    const int bottom = std::min(y + height + by_px, frameHeight);
    return {left, top, std::max(right - left, 0), std::max(bottom - top, 0)};
}

MtfFilter::MtfFilter(std::shared_ptr<const PixelHaze> haze)
    : haze_(std::move(haze)), kernels_(mostKernels) {}

MtfFilter::Axis MtfFilter::axis(int object, int objectSize, int to, int toSize) const {
    const int nearest = to - (object + objectSize - 1);
    const int farthest = to + toSize - 1 - object;
    Axis axis;
    axis.first = std::max(nearest, -haze_->support_px());
    axis.last = std::min(farthest, haze_->support_px());
    // Displacements a period apart are taken for each other: none with haze may meet another.
    axis.period =
        fastFftSize(std::max({axis.last - nearest, farthest - axis.first, objectSize - 1}) + 1);
    return axis;
}

const MtfFilter::Kernel& MtfFilter::kernelOf(const Axis& across, const Axis& down) {
    Kernel* const known = kernels_.find(
        [&](const Kernel& kernel) { return kernel.across == across && kernel.down == down; });
    if (known != nullptr)
        return *known;
    const auto width = static_cast<std::size_t>(across.period);
    const auto count = width * static_cast<std::size_t>(down.period);
    const FftBuffer<float> values = fftReals(count);
    FftPlans::shared().prepare(across.period, down.period);
    std::fill_n(values.get(), count, 0.0f);
    for (int dy = down.first; dy <= down.last; ++dy)
        for (int dx = across.first; dx <= across.last; ++dx)
            values[static_cast<std::size_t>(wrapped(dy, down.period)) * width +
                   static_cast<std::size_t>(wrapped(dx, across.period))] =
                static_cast<float>(haze_->at(dx, dy) / static_cast<double>(count));
    Kernel kernel{across, down,
                  fftComplex(columnsOf(across.period) * static_cast<std::size_t>(down.period))};
    FftPlans::shared().forward(across.period, down.period, values.get(), kernel.spectrum.get());
    return kernels_.add(std::move(kernel));
}

std::size_t MtfFilter::points(const HazeWindow& object, const HazeWindow& to) const {
    return static_cast<std::size_t>(axis(object.x, object.width, to.x, to.width).period) *
           static_cast<std::size_t>(axis(object.y, object.height, to.y, to.height).period);
}

void MtfFilter::addHaze(const HazeWindow& object, std::span<const float> values,
                        const HazeWindow& to, std::span<float> sums) {
    if (values.size() != object.size() || sums.size() != to.size())
        throw LogicError("a window has as many values as pixels");
    if (object.isEmpty() || to.isEmpty())
        return;
    const Axis across = axis(object.x, object.width, to.x, to.width);
    const Axis down = axis(object.y, object.height, to.y, to.height);
    if (across.first > across.last || down.first > down.last)
        return;
    const Kernel& kernel = kernelOf(across, down);

    const auto width = static_cast<std::size_t>(across.period);
    const std::size_t reals = width * static_cast<std::size_t>(down.period);
    const std::size_t columns = columnsOf(across.period) * static_cast<std::size_t>(down.period);
    if (reals > realsRoom_)
        reals_ = fftReals(realsRoom_ = reals);
    if (columns > spectrumRoom_)
        spectrum_ = fftComplex(spectrumRoom_ = columns);
    std::fill_n(reals_.get(), reals, 0.0f);
    for (int y = 0; y < object.height; ++y)
        std::copy_n(&values[static_cast<std::size_t>(y) * static_cast<std::size_t>(object.width)],
                    object.width, &reals_[static_cast<std::size_t>(y) * width]);
    FftPlans::shared().forward(across.period, down.period, reals_.get(), spectrum_.get());
    // Where a window is clipped the haze is not symmetric in it: its transform is complex. Written
    // out, as the product of two std::complex looks for infinities.
    for (std::size_t i = 0; i < columns; ++i) {
        const std::complex<float> a = spectrum_[i], b = kernel.spectrum[i];
        spectrum_[i] = {a.real() * b.real() - a.imag() * b.imag(),
                        a.real() * b.imag() + a.imag() * b.real()};
    }
    FftPlans::shared().backward(across.period, down.period, spectrum_.get(), reals_.get());
    for (int y = 0; y < to.height; ++y) {
        const float* row =
            &reals_[static_cast<std::size_t>(wrapped(to.y + y - object.y, down.period)) * width];
        float* sum = &sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(to.width)];
        int column = wrapped(to.x - object.x, across.period);
        for (int x = 0; x < to.width; ++x) {
            sum[x] += row[column];
            if (++column == across.period)
                column = 0;
        }
    }
}

} // namespace irsg
