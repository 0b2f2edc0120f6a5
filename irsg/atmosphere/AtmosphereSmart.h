#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "irsg/atmosphere/Atmosphere.h"
#include "irsg/atmosphere/AtmosphereSmartParameters.h"
#include "irsg/atmosphere/engine/RadiativeTransfer.h"

namespace irsg {

/// The report's AtmosphereSmart (F14, F15): real air, described by its parameters and computed by
/// the RadiativeTransfer of the engine, spectra at the resolution of the parameters. The base is
/// BaseWavelengthMin to BaseWavelengthMax. In ScatteringMode 1 there are no fluxes (report, annex
/// A).
///
/// The gas table is read and the air's levels are made with the first spectral query, so that
/// looking into a file costs little. Const members may be called from several threads.
class AtmosphereSmart : public Atmosphere {
  public:
    /// Parameters that came from `file`, relative to which a radiosonde ascent is looked for;
    /// `gases` is the shipped table where it is null. Throws InputError as SmartAdapter::airModel.
    explicit AtmosphereSmart(AtmosphereSmartParameters parameters,
                             std::string name = "AtmosphereSmart",
                             const std::filesystem::path& file = {},
                             std::shared_ptr<const GasTable> gases = nullptr);
    /// Reads a KARMA parameter file; "AtmosphereSmart (NAME.xml)". Throws InputError naming every
    /// offence with its line.
    static std::shared_ptr<AtmosphereSmart>
    fromXml(const std::filesystem::path& file, std::shared_ptr<const GasTable> gases = nullptr);

    const AtmosphereSmartParameters& parameters() const { return parameters_; }
    const AirModel& air() const { return air_; }
    /// Throws InputError where the gas table cannot be read or does not hold the base.
    const RadiativeTransfer& transfer() const;

    std::string name() const override { return name_; }
    std::vector<std::string> remarks() const override { return remarks_; }
    SpectralRange base() const override {
        return {parameters_.baseWavelengthMin_um, parameters_.baseWavelengthMax_um};
    }
    bool supports(AtmosphereProperty property) const override;
    std::string refusal(AtmosphereProperty property) const override;

    Spectrum transmittance(const AirPath& path, const SpectralRange& range) const override;
    Spectrum pathRadiance(const AirPath& path, const SunPosition& sun,
                          const SpectralRange& range) const override;
    Spectrum backgroundRadiance(const LineOfSight& sight, const SunPosition& sun,
                                const SpectralRange& range) const override;
    Spectrum solarIrradiance(double altitude_m, const SunPosition& sun,
                             const SpectralRange& range) const override;
    Spectrum upwardFlux(double altitude_m, const SunPosition& sun,
                        const SpectralRange& range) const override;
    Spectrum downwardFlux(double altitude_m, const SunPosition& sun,
                          const SpectralRange& range) const override;
    /// Of the air; above the top of the profile that of its last level.
    double ambientTemperature_K(double altitude_m) const override;
    Spectrum scatteringOpticalDepth(const AirPath& path, const SpectralRange& range) const override;

  private:
    void makeTransfer() const;

    AtmosphereSmartParameters parameters_;
    std::string name_;
    std::vector<std::string> remarks_;
    AirModel air_;
    mutable std::shared_ptr<const GasTable> gases_;
    mutable std::once_flag once_;
    mutable std::unique_ptr<const RadiativeTransfer> transfer_;
};

} // namespace irsg
