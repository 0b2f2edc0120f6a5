#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/scene/ApparentRadiance.h"
#include "irsg/scene/Irsg.h"

namespace irsg {

/// The geometry that the air is asked for, once per object.
struct ObjectGeometry {
    AirPath path;                 ///< sensor to reference point
    double aspectAngle_rad = 0.0; ///< nose axis to the direction reference point -> sensor
};

/// A scene's spectra, on wavelengths of the caller's choice or on the quadrature of a band.
class SceneRadiometry {
  public:
    /// For in-band quantities: nodes and weights are those of the sensor's band.
    SceneRadiometry(const Environment& environment, const std::vector<Entity>& entities,
                    const std::vector<ObjectGeometry>& geometry, const RenderSettings& settings,
                    const LineOfSight& centre, const Band& band);
    /// For in-band quantities in wideband mode: nodes and weights are the terms of the data, which
    /// the environment prepared.
    SceneRadiometry(const Environment& environment, const std::vector<Entity>& entities,
                    const std::vector<ObjectGeometry>& geometry, const RenderSettings& settings,
                    const LineOfSight& centre, std::shared_ptr<const SensorCkData> ck);
    /// For spectra at given wavelengths, ascending; weights are 1.
    SceneRadiometry(const Environment& environment, const std::vector<Entity>& entities,
                    const std::vector<ObjectGeometry>& geometry, const RenderSettings& settings,
                    const LineOfSight& centre, std::vector<double> wavelengths_um);

    /// Surfaces by (entity, codes), in that order; the rows of a drawing.
    using SurfaceKey = std::pair<int, IrCodes>;
    const std::vector<SurfaceKey>& keys() const { return keys_; }
    const std::vector<SurfaceSpectra>& surfaces() const { return surfaces_; }
    int row(int entity, const IrCodes& codes) const;

    const std::vector<double>& wavelengths_um() const { return wavelengths_um_; }
    const std::vector<double>& weights_um() const { return weights_um_; }
    const std::vector<double>& background() const { return background_; }
    /// Spectral transmissivity of a material of an entity.
    const std::vector<double>& transmissivity(int entity, int material) const;

    /// Sum of weight times value.
    double integrate(const std::vector<double>& values) const;
    double integrate(const std::vector<double>& a, const std::vector<double>& b) const;
    double backgroundInBand_W_m2_sr() const { return integrate(background_); }
    /// Transmissivity of a row as one number, weighted with the background's radiance, or with the
    /// response alone where there is none.
    double scalarTransmissivity(int row) const;
    double scalarTransmissivityOf(int entity, int material) const;
    /// Largest relative error that the scalar makes for any surface seen through any other.
    double transmissivityResidue() const;

    const std::vector<std::string>& answeredBy() const { return answeredBy_; }
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    void ask(const Environment& environment, const std::vector<Entity>& entities,
             const std::vector<ObjectGeometry>& geometry, const RenderSettings& settings,
             const LineOfSight& centre, const SpectralRange& range);
    void sample(const std::vector<Entity>& entities, const std::vector<ObjectGeometry>& geometry,
                const RenderSettings& settings, double bandArea_um);
    void note(const std::string& quantity, const std::string& who);

    /// Spectra of one object's air on their own axes.
    struct Air {
        Spectrum transmittance, pathRadiance, solarIrradiance, upwardFlux, downwardFlux;
        double ambient_K = 288.15;
        /// Transmittance to the reference distance of a user-defined spectrum, by its name.
        std::map<std::string, Spectrum> toReference;
        std::set<std::string> insideReference; ///< names of spectra measured from farther away
    };
    std::vector<const Spectrum*> allSpectra(const std::vector<Entity>& entities) const;
    /// A user-defined spectrum in the mode's own form.
    const UserSpectrum* inMode(const UserSpectrum* spectrum);

    std::shared_ptr<const SensorCkData> ck_; ///< null in spectral mode
    std::map<const UserSpectrum*, UserSpectrum> converted_;

    std::vector<Air> air_;
    Spectrum backgroundSpectrum_;
    std::vector<double> wavelengths_um_, weights_um_, background_;
    std::vector<SurfaceKey> keys_;
    std::vector<SurfaceSpectra> surfaces_;
    std::map<std::pair<int, int>, std::vector<double>> transmissivities_;
    std::vector<std::string> answeredBy_, warnings_;
};

/// The spectra of a scene's materials and user-defined spectra: what wideband terms are trained on.
std::vector<const Spectrum*> spectraOf(const std::vector<Entity>& entities);

/// The entry or material behind a code, with the entity's fallback; null where there is none.
const TemperatureEntry* temperatureEntry(const Entity& entity, int index);
const Material* materialEntry(const Entity& entity, int index);

} // namespace irsg
