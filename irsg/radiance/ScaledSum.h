#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "irsg/radiance/PlanckTable.h"
#include "irsg/radiance/ScaleSeries.h"

namespace irsg {

/// What a surface adds to a view, in units of intensity and of irradiance.
struct ScaledPair {
    double intensity = 0.0, irradiance = 0.0;
};

/// A surface of a view, wavelength by wavelength.
struct ScaledSurface {
    /// Multiplies the emission or the reflectivity.
    struct Drive {
        std::vector<double> intensity, irradiance;
        ScaledPair at(std::size_t i) const { return {intensity[i], irradiance[i]}; }
    };
    double temperature_K = 0.0; ///< 0 for a user-defined spectrum
    std::vector<double> emissivity, absorbedAtMost;
    Drive emitted, reflected; ///< `emitted` is the emission itself of a user-defined spectrum
};

/// The sum over a band of what a surface adds, as a function of the scales s of its temperature and
/// e of its emissivity. With W(s) what a wavelength adds by its emissivity, less what it then
/// reflects no more, that is
///   sum over 1 - t > e eps of e eps W(s) + sum over the others of (1 - t) W(s) + a constant.
/// Wavelengths are sorted by their limits (1 - t) / eps; then the two sums up to a place are all
/// there is to know, and no integral is left. They are numbers where the temperature stays, and
/// ScaleSeries where it does not: at some of the places, with the wavelengths between looked at one
/// by one.
class ScaledSum {
  public:
    /// Scales of the temperature and the largest one of the emissivity.
    struct Range {
        double least = 1.0, most = 1.0, mostEmissivity = 1.0;
    };
    /// Of nodes of the table from `first` on. No value where no series is good enough.
    static std::optional<ScaledSum> of(const ScaledSurface& surface, PlanckTable& planck,
                                       std::size_t first, const Range& range);

    ScaledPair at(double scaleT, double scaleE) const;

  private:
    /// A wavelength by its limit.
    struct Limited {
        double limit;
        std::size_t wavelength;
    };
    /// Up to a place: `below` of 1 - t, `above` of the emissivity.
    struct Sums {
        ScaledPair below, above;
    };
    struct SeriesPair {
        ScaleSeries intensity, irradiance;
    };
    struct Series {
        SeriesPair below, above;
    };
    /// A wavelength that is looked at by itself.
    struct Single {
        double wavelength_um, emissivity, absorbedAtMost;
        ScaledPair emitted;
    };
    static std::vector<Limited> sorted(const ScaledSurface& surface, double mostEmissivity);
    void setConstants(const ScaledSurface& surface, const SharedValues& planck, std::size_t first,
                      const std::vector<Limited>& order);
    bool setSeries(const ScaledSurface& surface, PlanckTable& planck, std::size_t first,
                   const Range& range, const std::vector<Limited>& order);

    double temperature_K_ = 0.0;
    std::vector<double> limits_;      // distinct, ascending: one place before, one behind each
    std::vector<std::size_t> begins_; // of a limit's wavelengths in their order, and their number
    std::vector<Sums> constants_;     // by place: what does not depend on s
    std::size_t stride_ = 1;          // places from one series to the next
    std::vector<Series> series_;      // what does
    std::vector<Single> singles_;     // in the order of the limits
    ScaledPair white_, measured_;
};

} // namespace irsg
