#include "irsg/sensor/SensorChain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/sensor/NormalQuantile.h"
#include "irsg/signature/random/Philox.h"
#include "irsg/signature/random/PortableMath.h"

namespace irsg {

namespace {

/// What random numbers are for; each its own sequence.
enum class Draw : std::uint32_t { pixel = 1, electrons, tv, th, t, vh, v, h, bad };

/// Below so many electrons their number is drawn by Poisson's law, above as a normal one, whose
/// third moment then is off by less than 0.15 of the deviation.
constexpr double mostPoisson_e = 50.0;
/// Of the frames that a pattern stays the same in.
constexpr std::uint32_t everyFrame = 0xffffffffu;

struct Pair {
    double first = 0.0, second = 0.0;
};

std::array<std::uint32_t, 4> words(std::uint64_t seed, Draw draw, std::uint32_t frame,
                                   std::uint64_t number) {
    return philox4x32({static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32),
                       frame, static_cast<std::uint32_t>(draw)},
                      {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
}

Pair uniforms(std::uint64_t seed, Draw draw, std::uint32_t frame, std::uint64_t number) {
    const auto w = words(seed, draw, frame, number);
    return {unitFromBits(static_cast<std::uint64_t>(w[0]) << 32 | w[1]),
            unitFromBits(static_cast<std::uint64_t>(w[2]) << 32 | w[3])};
}

/// Two standard normal numbers.
Pair normals(std::uint64_t seed, Draw draw, std::uint32_t frame, std::uint64_t number) {
    const Pair u = uniforms(seed, draw, frame, number);
    return {normalQuantile(u.first), normalQuantile(u.second)};
}

/// The normal numbers of a row of pixels, of which two neighbours share a draw.
void rowOfNormals(std::uint64_t seed, Draw draw, std::uint32_t frame, std::uint64_t first,
                  std::span<double> row) {
    for (std::size_t i = 0; i < row.size(); i += 2) {
        const Pair pair = uniforms(seed, draw, frame, first + i / 2);
        row[i] = pair.first;
        if (i + 1 < row.size())
            row[i + 1] = pair.second;
    }
    normalQuantiles(row);
}

/// A number of electrons of this mean, by inversion of Poisson's law.
double poisson(double mean, double unit) {
    double term = portable::exp(-mean), sum = term;
    int count = 0;
    while (sum < unit && count < 1000)
        sum += term *= mean / ++count;
    return count;
}

/// A normal number of mean 0 for each of `count` owners, or none where there is no deviation.
std::vector<double> series(std::uint64_t seed, Draw draw, std::uint32_t frame, std::size_t count,
                           double deviation) {
    std::vector<double> values(count);
    for (std::size_t i = 0; deviation > 0.0 && i < count; ++i)
        values[i] = deviation * normals(seed, draw, frame, i).first;
    return values;
}

/// Pixels that have one of these within a square of this half side.
std::vector<std::uint8_t> grown(const std::vector<std::uint8_t>& pixels, std::size_t width,
                                std::size_t height, std::size_t reach) {
    std::vector<std::uint8_t> all(pixels.size());
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            if (pixels[y * width + x] == 0)
                continue;
            const std::size_t fromX = x - std::min(x, reach), toX = std::min(width, x + reach + 1);
            for (std::size_t row = y - std::min(y, reach); row < std::min(height, y + reach + 1);
                 ++row)
                std::fill(all.begin() + static_cast<std::ptrdiff_t>(row * width + fromX),
                          all.begin() + static_cast<std::ptrdiff_t>(row * width + toX),
                          std::uint8_t{1});
        }
    return all;
}

} // namespace

SensorChain::SensorChain(const SensorDescription& sensor, double source_K,
                         ConeConvention convention)
    : sensor_(sensor),
      spread_(sensor, source_K),
      response_(sensor, convention),
      offset_(response_.offset()),
      patternUnit_(
          response_.noise(response_.signal(sensor.noise.referenceTemperature_K)).temporal()),
      kept_(std::make_shared<KeptBlur>()) {}

std::shared_ptr<const SensorBlur> SensorChain::blur(int samples) const {
    const std::lock_guard lock(kept_->mutex);
    if (!kept_->blur || kept_->blur->samples() != samples)
        kept_->blur = std::make_shared<const SensorBlur>(
            spread_, static_cast<std::size_t>(sensor_.detector.columns),
            static_cast<std::size_t>(sensor_.detector.rows), samples);
    return kept_->blur;
}

void SensorChain::addPoint(const PointTarget& point, std::vector<double>& signal) const {
    const double column = std::floor(point.column_px), row = std::floor(point.row_px);
    const std::vector<double> image =
        transformBack(spread_.spectrumOf(0.0, point.column_px - column, point.row_px - row));
    const auto side = static_cast<long>(spread_.side_px());
    const double scale =
        point.irradiance_W_m2 * response_.signalPerIrradiance() * sensor_.detector.fillFactor;
    for (long y = 0; y < side; ++y)
        for (long x = 0; x < side; ++x) {
            // What lies in the second half is before the point.
            const long inX = static_cast<long>(column) + (x < side / 2 ? x : x - side);
            const long inY = static_cast<long>(row) + (y < side / 2 ? y : y - side);
            if (inX < 0 || inY < 0 || inX >= sensor_.detector.columns ||
                inY >= sensor_.detector.rows)
                continue;
            signal[static_cast<std::size_t>(inY * sensor_.detector.columns + inX)] +=
                scale * image[static_cast<std::size_t>(y * side + x)];
        }
}

std::vector<double> SensorChain::blurred(const std::vector<float>& radiance_W_m2_sr,
                                         int samples) const {
    const std::shared_ptr<const SensorBlur> blurring = blur(samples);
    // The blur is of single precision: what is far beyond a full well is blurred by itself, and
    // reaches no farther than the point spread.
    constexpr double manyWells = 4.0;
    const auto most_W_m2_sr =
        static_cast<float>(manyWells * response_.fullSignal() / response_.signalPerRadiance());
    const auto width = static_cast<std::size_t>(sensor_.detector.columns);
    const auto height = static_cast<std::size_t>(sensor_.detector.rows);
    const auto cells = static_cast<std::size_t>(samples);
    float beyond_W_m2_sr = 0.0f;
    for (std::size_t at = 0; at < radiance_W_m2_sr.size(); ++at) {
        if (!std::isfinite(radiance_W_m2_sr[at]))
            throw InputError({"",
                              "radiance in row " + std::to_string(at / (width * cells)) +
                                  ", column " + std::to_string(at % (width * cells)),
                              numberText(radiance_W_m2_sr[at]), "a finite number"});
        beyond_W_m2_sr = std::max(beyond_W_m2_sr, std::abs(radiance_W_m2_sr[at]) - most_W_m2_sr);
    }
    if (beyond_W_m2_sr <= 0.0f)
        return blurring->blurred(radiance_W_m2_sr);
    std::vector<float> usual = radiance_W_m2_sr, bright(usual.size());
    std::vector<std::uint8_t> isBright(width * height);
    for (std::size_t at = 0; at < usual.size(); ++at) {
        usual[at] = std::clamp(usual[at], -most_W_m2_sr, most_W_m2_sr);
        if (usual[at] == radiance_W_m2_sr[at])
            continue;
        bright[at] = (radiance_W_m2_sr[at] - usual[at]) / beyond_W_m2_sr;
        isBright[at / (width * cells) / cells * width + at % (width * cells) / cells] = 1;
    }
    std::vector<double> sum = blurring->blurred(usual);
    const std::vector<double> more = blurring->blurred(bright);
    const std::vector<std::uint8_t> isReached =
        grown(isBright, width, height, spread_.side_px() / 2);
    for (std::size_t at = 0; at < sum.size(); ++at)
        if (isReached[at] != 0)
            sum[at] += static_cast<double>(beyond_W_m2_sr) * more[at];
    return sum;
}

std::vector<double> SensorChain::exposed(const std::vector<float>& radiance_W_m2_sr, int samples,
                                         const std::vector<PointTarget>& points) const {
    if (samples < 1)
        throw LogicError("radiance without samples");
    std::vector<double> signal = blurred(radiance_W_m2_sr, samples);
    const double scale = response_.signalPerRadiance();
    for (double& value : signal)
        value *= scale;
    for (const PointTarget& point : points)
        addPoint(point, signal);
    return signal;
}

std::vector<double> SensorChain::noisy(const std::vector<double>& signal, std::uint64_t seed,
                                       std::uint32_t frame) const {
    const auto width = static_cast<std::size_t>(sensor_.detector.columns);
    const auto height = static_cast<std::size_t>(sensor_.detector.rows);
    if (signal.size() != width * height)
        throw LogicError("signals of another size than the sensor's grid");
    const SensorNoise& parts = sensor_.noise;
    const double unit = patternUnit_;
    const std::vector<double> ofRows = series(seed, Draw::v, everyFrame, height, unit * parts.v);
    const std::vector<double> ofColumns = series(seed, Draw::h, everyFrame, width, unit * parts.h);
    const std::vector<double> rowsNow = series(seed, Draw::tv, frame, height, unit * parts.tv);
    const std::vector<double> columnsNow = series(seed, Draw::th, frame, width, unit * parts.th);
    const double frameNow = series(seed, Draw::t, frame, 1, unit * parts.t).front();
    const bool isThermal = sensor_.detector.isThermal();
    // Without photons' and dark noise.
    const PixelNoise fixed = response_.noise({});
    const double read = std::hypot(fixed.read, fixed.thermal);
    const double offset = offset_.offset();
    std::vector<double> values(signal.size());
    const auto valueOf = [&](std::size_t at, double normal) {
        const double mean = signal[at] + offset;
        if (isThermal || mean <= 0.0)
            return mean + read * normal;
        if (mean > mostPoisson_e) // one normal number for all that is normal
            return mean + std::sqrt(mean + read * read) * normal;
        const Pair more = uniforms(seed, Draw::electrons, frame, at);
        return poisson(mean, more.first) + read * normal;
    };
    parallelFor(height, [&](std::size_t y) {
        const std::uint64_t first = y * ((width + 1) / 2);
        double* const row = values.data() + y * width;
        rowOfNormals(seed, Draw::pixel, frame, first, {row, width});
        std::vector<double> pattern;
        if (parts.vh > 0.0) {
            pattern.resize(width);
            rowOfNormals(seed, Draw::vh, everyFrame, first, pattern);
        }
        for (std::size_t x = 0; x < width; ++x) {
            const double ofPixel = pattern.empty() ? 0.0 : unit * parts.vh * pattern[x];
            row[x] = valueOf(y * width + x, row[x]) + ofPixel + ofRows[y] + ofColumns[x] +
                     rowsNow[y] + columnsNow[x] + frameNow;
        }
    });
    return values;
}

SensorReading SensorChain::read(const std::vector<double>& signal, std::uint64_t seed,
                                std::uint32_t frame) const {
    const std::vector<double> values = noisy(signal, seed, frame);
    const SensorElectronics& electronics = sensor_.electronics;
    const SensorNoise& parts = sensor_.noise;
    const double top = std::ldexp(1.0, electronics.bits) - 1.0;
    const double full = response_.fullSignal(), offset = offset_.offset();
    const bool hasBad = parts.deadPixelFraction > 0.0 || parts.hotPixelFraction > 0.0;
    SensorReading result;
    result.counts.resize(values.size());
    result.radiance_W_m2_sr.resize(values.size());
    const auto width = static_cast<std::size_t>(sensor_.detector.columns);
    struct Special {
        std::size_t saturated = 0, dead = 0, hot = 0;
    };
    std::vector<Special> ofRows(values.size() / width);
    const double perRadiance = 1.0 / response_.signalPerRadiance();
    parallelFor(ofRows.size(), [&](std::size_t y) {
        Special& row = ofRows[y];
        for (std::size_t at = y * width; at < (y + 1) * width; ++at) {
            double value = values[at];
            const double bad = hasBad ? uniforms(seed, Draw::bad, everyFrame, at).first : 1.0;
            if (bad < parts.deadPixelFraction) {
                value = 0.0;
                ++row.dead;
            } else if (bad < parts.deadPixelFraction + parts.hotPixelFraction) {
                value = full;
                ++row.hot;
            } else if (value >= full) {
                value = full;
                ++row.saturated;
            }
            const double counts = std::clamp(
                std::floor(electronics.offset_counts + value / electronics.gain + 0.5), 0.0, top);
            result.counts[at] = static_cast<float>(counts);
            result.radiance_W_m2_sr[at] = static_cast<float>(
                ((counts - electronics.offset_counts) * electronics.gain - offset) * perRadiance);
        }
    });
    for (const Special& row : ofRows) {
        result.saturated += row.saturated;
        result.dead += row.dead;
        result.hot += row.hot;
    }
    return result;
}

SensorReading readBySensor(RadianceImage& image, const SensorChain& chain, int samples,
                           std::uint64_t seed, std::uint32_t frame) {
    const SensorDetector& detector = chain.sensor().detector;
    if (image.width() != detector.columns * samples || image.height() != detector.rows * samples)
        throw LogicError("an image of another size than the sensor's grid");
    SensorReading result = chain.read(chain.exposed(image.primary().values, samples), seed, frame);
    RadianceImage read(detector.columns, detector.rows, "counts", "");
    read.attributes = image.attributes;
    read.channels.front().values = result.counts;
    read.channel("L", "W m-2 sr-1").values = result.radiance_W_m2_sr;
    read.attributes["sensor.title"] = chain.sensor().title;
    read.attributes["sensor.seed"] = std::to_string(seed);
    read.attributes["sensor.frame"] = std::to_string(frame);
    read.attributes["sensor.saturatedPixels"] = std::to_string(result.saturated);
    read.attributes["sensor.deadPixels"] = std::to_string(result.dead);
    read.attributes["sensor.hotPixels"] = std::to_string(result.hot);
    image = std::move(read);
    return result;
}

} // namespace irsg
