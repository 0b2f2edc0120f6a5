#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "irsg/image/RadianceImage.h"
#include "irsg/sensor/PointSpread.h"
#include "irsg/sensor/SensorBlur.h"
#include "irsg/sensor/SensorNumbers.h"

namespace irsg {

/// A target much smaller than a pixel.
struct PointTarget {
    double column_px = 0.0; ///< of its image, from the centre of the top left pixel
    double row_px = 0.0;
    double irradiance_W_m2 = 0.0; ///< on the pupil, in the sensor's band; negative: a contrast
};

/// What a sensor makes of a frame, top row first.
struct SensorReading {
    std::vector<float> counts;
    std::vector<float> radiance_W_m2_sr; ///< apparent: what the counts stand for
    std::size_t saturated = 0;           ///< pixels at the end of the well or of the converter
    std::size_t dead = 0, hot = 0;       ///< bad pixels, which the saturated ones do not count
};

/// From band radiance above the pixel grid, or on it, to counts: blur, mean over the pixel's active
/// area, signal, noise, counts. The noise of a frame follows from seed, number of the frame and
/// place alone (Philox), so that frames are equal to the byte on any number of threads.
class SensorChain {
  public:
    /// `source_K`: of what the point spread is averaged over the band for.
    explicit SensorChain(const SensorDescription& sensor, double source_K = 300.0,
                         ConeConvention convention = ConeConvention::exact);

    const SensorDescription& sensor() const { return sensor_; }
    const PointSpread& pointSpread() const { return spread_; }
    const PixelResponse& response() const { return response_; }

    /// The mean signal of each pixel (electrons, of a thermal detector watts), without noise or
    /// offset. `radiance` has `samples` x `samples` values of band radiance
    /// (SensorDescription::band) for each pixel, row by row; each is that of its whole square.
    /// Beyond the frame its outermost values go on. LogicError for another size; InputError with
    /// row and column for a value that is not finite.
    std::vector<double> exposed(const std::vector<float>& radiance_W_m2_sr, int samples,
                                const std::vector<PointTarget>& points = {}) const;
    /// What is read of these signals.
    SensorReading read(const std::vector<double>& signal, std::uint64_t seed,
                       std::uint32_t frame) const;
    /// The signal with noise of a pixel before the converter, offset included: for who studies the
    /// noise.
    std::vector<double> noisy(const std::vector<double>& signal, std::uint64_t seed,
                              std::uint32_t frame) const;

  private:
    /// The blur of the frames last asked for, which copies share: films have one.
    struct KeptBlur {
        std::mutex mutex;
        std::shared_ptr<const SensorBlur> blur;
    };
    std::shared_ptr<const SensorBlur> blur(int samples) const;
    /// Radiance by pixel. Of what is far beyond a full well only the pixels that its point spread
    /// reaches see anything, its rounding included.
    std::vector<double> blurred(const std::vector<float>& radiance_W_m2_sr, int samples) const;
    void addPoint(const PointTarget& point, std::vector<double>& signal) const;

    SensorDescription sensor_;
    PointSpread spread_;
    PixelResponse response_;
    PixelSignal offset_;
    double patternUnit_; ///< temporal noise at the reference background
    std::shared_ptr<KeptBlur> kept_;
};

/// Replaces an image of band radiance (channel `L`, `samples` squared values a pixel) by what the
/// sensor reads: the planes `counts` and `L`, apparent radiance, and attributes with seed and
/// numbers of bad pixels. `samples` divides its sides (LogicError). Returns the frame's report.
SensorReading readBySensor(RadianceImage& image, const SensorChain& chain, int samples,
                           std::uint64_t seed, std::uint32_t frame);

} // namespace irsg
