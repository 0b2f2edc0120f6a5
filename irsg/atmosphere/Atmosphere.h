#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/AtmosphereDescription.h"
#include "irsg/atmosphere/path/AtmosphericQuery.h"
#include "irsg/radiometry/SpectralSampling.h"
#include "irsg/radiometry/Spectrum.h"

namespace irsg {

class AtmosphereNodes;
class Band;
class SensorCkData;
struct CkRequest;

/// The seam between a scene and its air (report section 5, F13, F14). It is asked for one quantity
/// along one path at one spectral sampling, and answers with a value at every node, in W, m, sr and
/// um:
///   transmittance            0 to 1; 1 at range 0
///   path radiance            emitted and scattered into the path, W m-2 sr-1 um-1; 0 at range 0
///   background radiance      everything seen along an unbounded line of sight with no target in
///                            it, W m-2 sr-1 um-1
///   solar irradiance         direct sun on a plane normal to the beam, W m-2 um-1: of the part of
///                            its disc above the horizon of the altitude, see `sunView`
///   upward, downward flux    diffuse hemispherical ones on a horizontal plane, W m-2 um-1. The
///                            downward flux excludes the direct beam, the upward flux includes
///                            reflected sun
///   scattering optical depth of a path by scattering alone, which blurs (absorption by gases does
///                            not); >= 0
/// An implementation has native spectra, `nativeSpectrum`; those at a sampling are taken from them
/// unless it can do better. It answers only what it accepts; asking for more is a LogicError.
class Atmosphere {
  public:
    virtual ~Atmosphere() = default;

    /// How results and the log call it: "vacuum", "Beer-Lambert (haze.csv)".
    virtual std::string name() const = 0;
    /// The spectral base: what this atmosphere has data for.
    virtual SpectralRange base() const = 0;
    virtual bool supports(AtmosphereProperty property) const = 0;
    /// Why a property is not supported, in words that follow the name: "has no upward flux".
    virtual std::string refusal(AtmosphereProperty property) const;
    /// What a user should know about the settings and data it was made of.
    virtual std::vector<std::string> remarks() const { return {}; }
    /// What it is made of.
    virtual AtmosphereDescription describe() const { return {}; }
    /// True if the base covers a whole range; parts in 1e9 at its ends are forgiven.
    bool covers(const SpectralRange& range) const;
    /// False if the property is not supported; else true only if the base covers the whole range.
    bool accept(const SpectralRange& range, AtmosphereProperty property) const {
        return supports(property) && covers(range);
    }

    /// Apparent elevation of the horizon for a sensor at an altitude: lines of sight below it end
    /// on the ground. The dip of a sphere of 6371.23 km without refraction, unless an atmosphere
    /// has a geometry of its own.
    virtual double horizonElevation_rad(double altitude_m) const;
    /// How the sun is seen from an altitude: cut by that horizon, along straight lines unless an
    /// atmosphere refracts. Continuous in elevation and altitude.
    virtual SunView sunView(double altitude_m, const SunPosition& sun) const;
    /// How the target of a path is seen, in the geometry of the paths and lines of sight that this
    /// atmosphere answers for. Flat unless an atmosphere has one of its own.
    virtual TargetView targetView(const AtmosphericPath& path) const;
    virtual double ambientTemperature_K(double altitude_m) const;

    /// A value at every node. LogicError for what is not accepted, and for quadrature points of
    /// wideband-ck where they are not available; InputError for a path, a line of sight or an
    /// altitude below ground, a negative range or anything that is not finite.
    std::vector<double> provide(const AtmosphericQuery& query,
                                const SpectralSampling& sampling) const;
    /// The answer as a spectrum on the nodes that the atmosphere has of itself, over at least the
    /// range: a quadrature for products of such spectra is built on their nodes.
    Spectrum spectrum(const AtmosphericQuery& query, const SpectralRange& range) const;
    /// True where the answer depends on the azimuth between the view and the sun: where it does
    /// not, a cache needs no azimuth in its key.
    virtual bool dependsOnAzimuth(AtmosphereProperty) const { return false; }

    /// `spectrum` by the names of the quantities.
    Spectrum transmittance(const AtmosphericPath& path, const SpectralRange& range) const;
    Spectrum pathRadiance(const AtmosphericPath& path, const SunPosition& sun,
                          const SpectralRange& range) const;
    Spectrum backgroundRadiance(const LineOfSight& sight, const SunPosition& sun,
                                const SpectralRange& range) const;
    Spectrum solarIrradiance(double altitude_m, const SunPosition& sun,
                             const SpectralRange& range) const;
    Spectrum upwardFlux(double altitude_m, const SunPosition& sun,
                        const SpectralRange& range) const;
    Spectrum downwardFlux(double altitude_m, const SunPosition& sun,
                          const SpectralRange& range) const;
    Spectrum scatteringOpticalDepth(const AtmosphericPath& path, const SpectralRange& range) const;

    /// Where the native spectra are means over bins of a few nodes each: these nodes over bands
    /// that the base covers, one behind the other, each from where the one before it ends or later;
    /// or for some ascending wavelengths. Products of this air's quantities are right at them
    /// alone. Null where native spectra are all there is.
    virtual std::shared_ptr<const SpectralSampling>
    nodesOf(const std::vector<Band>& /*bands*/) const {
        return nullptr;
    }
    virtual std::shared_ptr<const SpectralSampling>
    nodesAt(const std::vector<double>& /*wavelengths_um*/) const {
        return nullptr;
    }

    /// True where this atmosphere can prepare quadrature points (F14, F17).
    virtual bool isWidebandModeAvailable() const { return false; }
    /// Why it cannot, in words that follow the name.
    virtual std::string widebandRefusal() const { return "has no wideband mode"; }
    /// The quadrature points of a sensor, at which this atmosphere answers: see SensorCkData.h.
    /// LogicError where they are not available.
    virtual std::shared_ptr<const SensorCkData> prepareCk(const CkRequest& request) const;
    /// The same air with other spectral bins; null where it has none.
    virtual std::shared_ptr<const Atmosphere> withBins(int /*resolution_per_cm*/) const {
        return nullptr;
    }
    /// The same air without tables, whose answers do not depend on what it was asked before; null
    /// where they never do.
    virtual std::shared_ptr<const Atmosphere> onTheFly() const { return nullptr; }

  protected:
    /// The answer to a query that was checked, over a range that the base covers.
    virtual Spectrum nativeSpectrum(const AtmosphericQuery& query,
                                    const SpectralRange& range) const;
    /// The answer at the quadrature points that this atmosphere prepared.
    virtual std::vector<double> valuesAtPoints(const AtmosphericQuery& query,
                                               const SensorCkData& points) const;

    /// The answer at nodes; nothing where they are those of other air.
    virtual std::optional<std::vector<double>> valuesAtNodes(const AtmosphericQuery&,
                                                             const AtmosphereNodes&) const {
        return std::nullopt;
    }

    /// LogicError unless the base covers the range.
    void checkRange(const SpectralRange& range) const;
    void checkPath(const AtmosphericPath& path) const;
    void checkSight(const LineOfSight& sight) const;
    void checkAltitude(double altitude_m, const char* what = "altitude") const;

  private:
    /// The part of a range that is in the base.
    SpectralRange covered(const SpectralRange& range) const;
    void checkQuery(const AtmosphericQuery& query) const;
};

} // namespace irsg
