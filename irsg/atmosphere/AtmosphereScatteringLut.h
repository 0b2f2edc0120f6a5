#pragma once

#include <filesystem>

#include "irsg/atmosphere/Environment.h"
#include "irsg/karma/KarmaXml.h"

namespace irsg {

/// The scattering atmosphere of the report's section 9 (F44): a member of an Environment that names
/// the MTF database its haze is made with. Of the air it knows at most how strongly droplets of one
/// concentration scatter; what they take out of the direct light belongs to the transmittance of
/// another atmosphere. With a scattering coefficient it answers for the scattering optical depth
/// before all others, without one it leaves that to them.
class AtmosphereScatteringLut : public Atmosphere {
  public:
    /// `coefficient_per_m`: scattering coefficient of the droplets, m-1, >= 0; 0 where other
    /// atmospheres tell the optical depth. InputError for anything else.
    explicit AtmosphereScatteringLut(std::filesystem::path database,
                                     double coefficient_per_m = 0.0);
    /// Parameters `MTFDatabase` (string: a path as in KARMA files) and, where it is given,
    /// `ScatteringCoefficient` (double, km-1). Throws InputError with file and line.
    static AtmosphereScatteringLut fromKarma(const KarmaXml& document);

    const std::filesystem::path& database() const { return database_; }
    double coefficient_per_m() const { return coefficient_per_m_; }

    std::string name() const override;
    SpectralRange base() const override { return {0.2, 40.0}; }
    bool supports(AtmosphereProperty property) const override;
    AtmosphereDescription describe() const override;

  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery& query,
                            const SpectralRange& range) const override;

  private:
    std::filesystem::path database_;
    double coefficient_per_m_;
};

/// The first of an environment, or null.
const AtmosphereScatteringLut* scatteringLutOf(const Environment& environment);

} // namespace irsg
