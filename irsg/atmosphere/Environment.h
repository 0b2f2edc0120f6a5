#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/Atmosphere.h"

namespace irsg {

/// A value and which atmosphere gave it.
template <typename Value>
struct Provided {
    Value value;
    std::string providedBy;
};

/// The world around a scene (report section 5): the sun and an ordered list of atmospheres. The
/// first that accepts (property, range) answers. Where none accepts, an InputError lists each and
/// why it refused, except that the background falls back to `defaultBackground` and the ambient
/// temperature to `defaultAmbient_K` where they are set.
class Environment {
  public:
    Environment() = default;
    /// Vacuum alone.
    static Environment vacuum();

    void add(std::shared_ptr<const Atmosphere> atmosphere);
    const std::vector<std::shared_ptr<const Atmosphere>>& atmospheres() const {
        return atmospheres_;
    }

    /// The same with what `other` makes of each atmosphere, which stays where that is nothing.
    Environment
    with(const std::function<std::shared_ptr<const Atmosphere>(const Atmosphere&)>& other) const;

    SunPosition sun;
    std::optional<Spectrum> defaultBackground; ///< W m-2 sr-1 um-1
    std::optional<double> defaultAmbient_K = 288.15;

    /// The first that accepts, or null.
    const Atmosphere* find(const SpectralRange& range, AtmosphereProperty property) const;

    /// Of the atmosphere that answers for the background; see Atmosphere::horizonElevation_rad.
    double horizonElevation_rad(double altitude_m, const SpectralRange& range) const;
    /// Of the atmosphere that answers for the direct sun, see Atmosphere::sunView.
    SunView sunView(double altitude_m, const SpectralRange& range) const;

    /// Of the atmosphere that answers for the transmittance, see Atmosphere::targetView.
    TargetView targetView(const AtmosphericPath& path, const SpectralRange& range) const;

    /// A value at every node of a sampling. At quadrature points of wideband-ck the atmosphere that
    /// prepared them answers, and there is no default (F29); InputError for what it does not
    /// support. Direct light of a sun whose whole disc is below the horizon is zero, whoever
    /// answers.
    Provided<std::vector<double>> provide(const AtmosphericQuery& query,
                                          const SpectralSampling& sampling) const;
    /// Throws the InputError of provide() where nothing here provides a quantity over a range.
    void checkProvided(AtmosphereProperty quantity, const SpectralRange& range,
                       bool isWideband) const;
    /// provide() on the nodes of the answering atmosphere; see Atmosphere::spectrum.
    Provided<Spectrum> spectrum(const AtmosphericQuery& query, const SpectralRange& range) const;
    /// What `spectrum` and `answer` depend on, for as long as the atmospheres and defaults stay.
    AtmosphericQueryKey keyOf(const AtmosphericQuery& query, const SpectralRange& range) const;
    AtmosphericQueryKey keyOf(const AtmosphericQuery& query,
                              const SpectralSampling& sampling) const;
    Provided<double> ambientTemperature_K(double altitude_m) const;

    /// Nodes of the air that answers for the transmittance, see Atmosphere::nodesOf; null where it
    /// has none.
    std::shared_ptr<const SpectralSampling> nodesOf(const Band& band) const;
    /// Those of several bands in one, each an output of its own (AtmosphereNodes::outputs); null as
    /// well where bands could be answered by different atmospheres.
    std::shared_ptr<const SpectralSampling> nodesOf(const std::vector<Band>& bands) const;
    std::shared_ptr<const SpectralSampling>
    nodesAt(const std::vector<double>& wavelengths_um) const;

    /// The atmosphere that has quadrature points for a band, of several the one that supports the
    /// most quantities, of equals the first; null where there is none.
    const Atmosphere* findWideband(const SpectralRange& range) const;
    /// The same; InputError listing each atmosphere and why it has no quadrature points for the
    /// band: there is no default in wideband mode (F29).
    const Atmosphere& requireWideband(const SpectralRange& range) const;
    Provided<std::shared_ptr<const SensorCkData>> prepareCk(const CkRequest& request) const;

  private:
    const Atmosphere& requireWideband(const SpectralRange& range,
                                      AtmosphereProperty property) const;
    const Atmosphere& require(const SpectralRange& range, AtmosphereProperty property) const;
    bool isByDefault(const SpectralRange& range, AtmosphereProperty property) const;

    std::vector<std::shared_ptr<const Atmosphere>> atmospheres_;
};

} // namespace irsg
