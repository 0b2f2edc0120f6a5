#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "irsg/atmosphere/Atmosphere.h"
#include "irsg/atmosphere/AtmosphereSmartParameters.h"
#include "irsg/atmosphere/ReflectingGround.h"
#include "irsg/atmosphere/engine/RadiativeTransfer.h"
#include "irsg/atmosphere/tables/AtmosphereTables.h"

namespace irsg {

/// The report's AtmosphereSmart (F14, F15): real air, described by its parameters and computed by
/// the RadiativeTransfer of the engine, spectra at the resolution of the parameters. The base is
/// BaseWavelengthMin to BaseWavelengthMax. In ScatteringMode 1 there are no fluxes (report, annex
/// A).
///
/// The gas table is read and the air's levels are made with the first spectral query, so that
/// looking into a file costs little. In IrradianceMode 1 quantities are kept in tables over range,
/// altitude and elevation that refine themselves to `tableTolerance`, in mode 2 everything is
/// computed on the fly. Const members may be called from several threads.
class AtmosphereSmart : public Atmosphere, public ReflectingGround {
  public:
    /// Of the tables: in transmittance, and relative for everything else.
    static constexpr double tableTolerance = 1e-3;

    /// Parameters that came from `file`, relative to which a radiosonde ascent is looked for;
    /// `gases` is the shipped table where it is null. Throws InputError as
    /// SmartAdapter::atmosphericModel.
    explicit AtmosphereSmart(AtmosphereSmartParameters parameters,
                             std::string name = "AtmosphereSmart",
                             const std::filesystem::path& file = {},
                             std::shared_ptr<const GasTable> gases = nullptr);
    /// Reads a KARMA parameter file; "AtmosphereSmart (NAME.xml)". Throws InputError naming every
    /// diagnostic with its line.
    static std::shared_ptr<AtmosphereSmart>
    fromXml(const std::filesystem::path& file, std::shared_ptr<const GasTable> gases = nullptr);

    /// The same air with other bins: 1, 5 or 15 cm-1, InputError otherwise.
    std::shared_ptr<AtmosphereSmart> withResolution(int resolution_per_cm) const;

    /// The same with other parameters. Throws InputError as the constructor.
    std::shared_ptr<AtmosphereSmart> withParameters(AtmosphereSmartParameters parameters) const;

    const AtmosphereSmartParameters& parameters() const { return parameters_; }
    const AtmosphericModel& air() const { return air_; }
    /// Throws InputError where the gas table cannot be read or does not hold the base.
    const RadiativeTransfer& transfer() const;

    std::string name() const override { return name_; }
    std::vector<std::string> remarks() const override { return remarks_; }
    SpectralRange base() const override {
        return {parameters_.baseWavelengthMin_um, parameters_.baseWavelengthMax_um};
    }
    bool supports(AtmosphereProperty property) const override;
    std::string refusal(AtmosphereProperty property) const override;

    /// Of the bent ray that touches the ground.
    double horizonElevation_rad(double altitude_m) const override;
    SunView sunView(double altitude_m, const SunPosition& sun) const override;
    /// Along the refracted ray between both.
    TargetView targetView(const AtmosphericPath& path) const override;
    /// Of the air; above the top of the profile that of its last level.
    double ambientTemperature_K(double altitude_m) const override;
    /// What the sun is scattered into.
    bool dependsOnAzimuth(AtmosphereProperty property) const override {
        return property == AtmosphereProperty::backgroundRadiance ||
               property == AtmosphereProperty::pathRadiance;
    }
    AtmosphereDescription describe() const override;
    Spectrum groundReflectivity() const override { return air_.groundAlbedo; }

    /// See AtmosphereNodes.h.
    std::shared_ptr<const SpectralSampling> nodesOf(const std::vector<Band>& bands) const override;
    std::shared_ptr<const SpectralSampling>
    nodesAt(const std::vector<double>& wavelengths_um) const override;

    bool isWidebandModeAvailable() const override { return true; }
    std::shared_ptr<const SensorCkData> prepareCk(const CkRequest& request) const override;
    std::shared_ptr<const Atmosphere> withBins(int resolution_per_cm) const override {
        return withResolution(resolution_per_cm);
    }
    std::shared_ptr<const Atmosphere> onTheFly() const override;

  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery& query,
                            const SpectralRange& range) const override;
    std::vector<double> valuesAtPoints(const AtmosphericQuery& query,
                                       const SensorCkData& points) const override;
    std::optional<std::vector<double>> valuesAtNodes(const AtmosphericQuery& query,
                                                     const AtmosphereNodes& nodes) const override;

  private:
    void makeTransfer() const;
    const AtmosphereTables& tables(const NodeSet& nodes) const;
    /// The answer at every node of a set.
    std::vector<double> valuesAt(const NodeSet& nodes, const AtmosphericQuery& query) const;

    AtmosphereSmartParameters parameters_;
    std::string name_;
    std::filesystem::path file_;
    std::vector<std::string> remarks_;
    AtmosphericModel air_;
    mutable std::shared_ptr<const GasTable> gases_;
    mutable std::once_flag once_;
    mutable std::shared_ptr<const RadiativeTransfer> transfer_;
    mutable std::mutex onTheFlyMutex_;
    mutable std::shared_ptr<const AtmosphereSmart> onTheFly_;
    mutable std::mutex tablesMutex_;
    mutable std::map<std::vector<std::uint32_t>, std::unique_ptr<AtmosphereTables>> tables_;
};

/// The air in the middle of a path, at the mean altitude of its ends, of an atmosphere that tells
/// what it is made of; no value for others and for null.
std::optional<AtmosphericState> airOfPath(const Atmosphere* atmosphere,
                                          const AtmosphericPath& path);

} // namespace irsg
