#include "irsg/sensor/PointSpread.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/Units.h"
#include "irsg/sensor/Sinc.h"

namespace irsg {

namespace {

/// Of the optics' table, for each so many waves of defocus, which turns its phase as often.
constexpr std::size_t radialSteps = 1024;
constexpr double wavesPerTable = 10.0;
/// Neighbours on either side of a place between which the table is interpolated.
constexpr std::size_t reach = 4;
constexpr std::size_t largestSide = 512;
/// Pixels wider than so many times the finest pattern of the optics have no image worth the name.
constexpr double largestCutoff = 500.0;

/// Lagrange's polynomial through 2 `reach` values at whole numbers from 1 - reach on, at t from 0
/// to 1. Its error is below 1e-8 of an oscillation that turns by 0.25 rad from value to value.
double interpolated(const double* values, double t) {
    constexpr int count = 2 * static_cast<int>(reach), first = 1 - static_cast<int>(reach);
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        double weight = 1.0;
        for (int k = 0; k < count; ++k)
            if (k != i)
                weight *= (t - (first + k)) / (i - k);
        sum += weight * values[i];
    }
    return sum;
}

/// A power of two that holds twice the spread, and of diffraction's far wings all but parts in a
/// thousand.
std::size_t sideFor(const SensorTransfer& transfer, double pixelAngle_rad) {
    const double spread_px = transfer.spread_rad() / pixelAngle_rad;
    const double cutoff_per_px = transfer.cutoff_per_rad() * pixelAngle_rad;
    if (cutoff_per_px > largestCutoff)
        throw InputError({"", "detector.pitch_um",
                          numberText(std::round(cutoff_per_px)) +
                              " times the period of the finest pattern that the optics transmit",
                          "at most " + numberText(largestCutoff) + " times"});
    std::size_t side = cutoff_per_px <= 8.0 ? 64 : cutoff_per_px <= 32.0 ? 32 : 16;
    while (static_cast<double>(side) < 2.0 * spread_px)
        side *= 2;
    if (side > largestSide)
        throw InputError(
            {"", "sensor",
             "a point spread over more than " + numberText(std::round(spread_px)) + " pixels",
             "at most " + std::to_string(largestSide / 2)});
    return side;
}

} // namespace

PointSpread::PointSpread(const SensorDescription& sensor, double source_K)
    : transfer_(sensor, source_K),
      perPixel_(1.0 / sensor.pixelAngle_rad()),
      fillFactor_(sensor.detector.fillFactor),
      isRound_(sensor.optics.pupil != PupilShape::square),
      cutoff_(transfer_.cutoff_per_rad() * sensor.pixelAngle_rad()),
      side_(sideFor(transfer_, sensor.pixelAngle_rad())) {
    if (isRound_) {
        const auto steps =
            radialSteps * static_cast<std::size_t>(
                              std::max(1.0, std::ceil(transfer_.defocus_waves() / wavesPerTable)));
        radial_.resize(steps + 1);
        parallelFor(steps, [&](std::size_t i) {
            radial_[i] = transfer_.optics(transfer_.cutoff_per_rad() * static_cast<double>(i) /
                                              static_cast<double>(steps),
                                          0.0);
        });
        radial_[0] = 1.0;
    }
    const auto side = static_cast<double>(side_);
    const auto most = static_cast<long>(std::ceil(cutoff_ * side));
    // From 0 on: the transfer is even.
    for (long i = 0; i <= most; ++i)
        frequencies_.push_back(static_cast<double>(i) / side);
    const std::size_t count = frequencies_.size();
    wide_.resize(count * count);
    parallelFor(count, [&](std::size_t y) {
        const double columns = transfer_.alongColumns(perPixel_ * frequencies_[y]);
        for (std::size_t x = 0; x < count; ++x)
            wide_[y * count + x] = columns * opticsAt(frequencies_[x], frequencies_[y]) *
                                   transfer_.alongRows(perPixel_ * frequencies_[x]);
    });
    wide_[0] = 1.0;
}

void PointSpread::check(const SensorDescription& sensor) {
    sideFor(SensorTransfer(sensor), sensor.pixelAngle_rad());
}

double PointSpread::opticsAt(double x_per_px, double y_per_px) const {
    if (!isRound_)
        return transfer_.optics(perPixel_ * x_per_px, perPixel_ * y_per_px);
    const std::size_t last = radial_.size() - 1;
    const double place = std::hypot(x_per_px, y_per_px) / cutoff_ * static_cast<double>(last);
    if (place >= static_cast<double>(last))
        return 0.0;
    const auto i =
        std::clamp<std::size_t>(static_cast<std::size_t>(place), reach - 1, last - reach);
    return interpolated(radial_.data() + i + 1 - reach, place - static_cast<double>(i));
}

double PointSpread::transferAt(double x_per_px, double y_per_px) const {
    return opticsAt(x_per_px, y_per_px) * transfer_.alongRows(perPixel_ * x_per_px) *
           transfer_.alongColumns(perPixel_ * y_per_px);
}

double PointSpread::energyAt(double columns_px, double rows_px) const {
    const GaussRule& rule = gaussLegendre(12);
    // Defocus turns the phase by 4 pi a wave and unit of the pupil's shift, of which there are two
    // up to the cutoff: no panel sees more than 8 rad of it.
    const double ofDefocus = 5.0 * transfer_.defocus_waves() / cutoff_;
    const auto panelsOf = [&](double length, double offset_px) {
        return static_cast<std::size_t>(
            std::ceil(4.0 + length * (1.5 * (std::abs(offset_px) + 1.0) + ofDefocus)));
    };
    // x = cutoff sin(a), whose chord of the round pupil is cutoff cos(a).
    const std::size_t panels = panelsOf(cutoff_, columns_px);
    std::vector<double> sums(panels);
    parallelFor(panels, [&](std::size_t panel) {
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double angle = 0.5 * pi * (static_cast<double>(panel) + rule.nodes[i]) /
                                 static_cast<double>(panels);
            const double x = cutoff_ * std::sin(angle);
            const double chord = isRound_ ? cutoff_ * std::cos(angle) : cutoff_;
            const std::size_t inner = panelsOf(chord, rows_px);
            double along = 0.0;
            for (std::size_t part = 0; part < inner; ++part)
                for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
                    const double y = chord * (static_cast<double>(part) + rule.nodes[j]) /
                                     static_cast<double>(inner);
                    along += rule.weights[j] * transferAt(x, y) * std::cos(2.0 * pi * y * rows_px);
                }
            sums[panel] += rule.weights[i] * along * chord / static_cast<double>(inner) *
                           std::cos(2.0 * pi * x * columns_px) * cutoff_ * std::cos(angle) * 0.5 *
                           pi / static_cast<double>(panels);
        }
    });
    double sum = 0.0;
    for (const double part : sums)
        sum += part;
    return 4.0 * fillFactor_ * sum;
}

HalfSpectrum PointSpread::spectrumOf(double cell_px, double column_px, double row_px) const {
    HalfSpectrum spectrum(side_, side_);
    const std::size_t count = frequencies_.size(), columns = spectrum.columns();
    const auto most = static_cast<long>(count) - 1;
    const auto side = static_cast<long>(side_);
    struct Turn {
        std::complex<double> factor;
        std::size_t bin, at;
    };
    const auto turnsOf = [&](double shift_px, std::size_t bins) {
        std::vector<Turn> turns;
        for (long i = -most; i <= most; ++i) {
            const auto bin = static_cast<std::size_t>(((i % side) + side) % side);
            const auto at = static_cast<std::size_t>(std::abs(i));
            const double frequency = static_cast<double>(i) / static_cast<double>(side_);
            if (bin < bins)
                turns.push_back(
                    {std::polar(1.0, -2.0 * pi * frequency * shift_px) * sinc(cell_px * frequency),
                     bin, at});
        }
        return turns;
    };
    const std::vector<Turn> alongX = turnsOf(column_px, columns), alongY = turnsOf(row_px, side_);
    std::vector<std::complex<double>> row(columns);
    for (const Turn& y : alongY) {
        std::ranges::fill(row, 0.0);
        for (const Turn& x : alongX)
            row[x.bin] += wide_[y.at * count + x.at] * x.factor;
        for (std::size_t k = 0; k < columns; ++k)
            spectrum.values[y.bin * columns + k] += row[k] * y.factor;
    }
    return spectrum;
}

} // namespace irsg
