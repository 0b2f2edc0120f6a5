#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "irsg/radiance/ApparentRadiance.h"
#include "irsg/radiance/GasColumnSpectra.h"
#include "irsg/radiance/RadianceTerms.h"
#include "irsg/radiance/SceneSampling.h"
#include "irsg/radiance/SurfaceRows.h"

namespace irsg {

/// A scene's spectra on the nodes of its bands, one band behind the other: what every drawn row of
/// SurfaceRows sends, and the air between each row and the sensor. Their products, which are what
/// arrives, are left to SurfaceRadianceTable: an object has many more rows than surfaces and air.
class SceneRadiometry {
  public:
    /// `bands` hold the air of the entities in the same order, sliced as `geometry` says. Their
    /// databases must live as long.
    SceneRadiometry(const RadianceTerms& terms, const std::vector<Entity>& entities,
                    const std::vector<ObjectGeometry>& geometry,
                    const std::vector<SampledBand>& bands);

    /// The same but for the aspect angles in `geometry`: changes the factors of measured spectra
    /// that depend on them, and returns the drawn rows that they have changed of.
    std::vector<int> turn(const std::vector<Entity>& entities,
                          const std::vector<ObjectGeometry>& geometry);

    /// The same but for what the air itself sends along the way to the objects, and what is to be
    /// told of it.
    void seeAlong(const std::vector<SampledBand>& bands);

    const RadianceTerms& terms() const { return *terms_; }
    const SurfaceRows& rows() const { return rows_; }
    /// By drawn row, those of lobes behind.
    const std::vector<SurfaceSpectra>& surfaces() const { return surfaces_; }
    /// By surface that is drawn: its model, null for a Lambertian one.
    const std::vector<std::shared_ptr<const SurfaceModel>>& models() const { return models_; }
    const SurfaceSpectra& surface(int row) const {
        return surfaces_[static_cast<std::size_t>(rows_.renderedOf(row))];
    }

    /// What says how a drawn row depends on the scale of its emissivity: itself, or of what mirrors
    /// the air the component.
    const SurfaceSpectra& scaling(int drawn) const;

    const std::vector<double>& wavelengths_um() const { return wavelengths_um_; }
    const std::vector<double>& weights_um() const { return weights_um_; }
    /// Nodes that are summed together, first and behind the last: a band's, or one wavelength.
    const std::vector<std::pair<std::size_t, std::size_t>>& outputs() const { return outputs_; }
    /// The air between a row's place and the sensor.
    const AtmosphereSamples& air(int row) const;
    /// Between which rows of its slices an output takes the air of a row: its air is linear there.
    SliceBetween rowsAbout(int row, std::size_t output) const;
    /// Spectral transmissivity of a material of an entity; of a mirror's component its amount.
    const std::vector<double>& transmissivity(int entity, int material) const;

    /// Of a column of gas of an entity.
    const GasColumnSpectra::Column& gasColumn(int entity, int number) const {
        return gasColumns_->of(entity, number);
    }
    /// The gases of entities that have any, without the air before them.
    const std::map<int, GasColumnSpectra::OfEntity>& gases() const { return gases_; }

    /// Weights times what materials in front let through, for `count` nodes from `first` on. With
    /// `throughAir` of light that passes the air afterwards, whose lines coincide with those of
    /// gas. Of a gas `drawn` the column in front is its own, and what passes is the part of the
    /// light that it takes away; nothing where there is none.
    void fillPassed(const std::vector<OccluderMaterial>& front, std::size_t first,
                    std::size_t count, double* values, bool throughAir = false,
                    int drawn = -1) const;
    bool isGas(int drawn) const { return surfaces_[static_cast<std::size_t>(drawn)].isGas; }
    /// The drawn rows that a kind of a row stands for: of a gas those of all gases of its entity.
    std::vector<int> partsOf(int drawn) const;
    /// Sum of weight times value over an output.
    double integrate(const std::vector<double>& values, std::size_t output = 0) const;
    /// In-band emission of a drawn row as it arrives from its first row, W m-2 sr-1.
    double thermal_W_m2_sr(int drawn, std::size_t output = 0) const;

    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    void joinAtmosphere(const std::vector<SampledBand>& bands);
    /// The gases among the rows, by drawn row.
    std::map<int, GasZone> gasZones(const std::vector<SurfaceKey>& keys,
                                    const std::vector<Entity>& entities,
                                    const std::vector<ObjectGeometry>& geometry) const;
    void takeGases(const std::vector<Entity>& entities, const std::vector<SampledBand>& bands);
    void fillSurface(int drawn, const std::vector<Entity>& entities,
                     const std::vector<ObjectGeometry>& geometry,
                     const std::vector<SampledBand>& bands);
    /// The lobes of a surface.
    void fillLobes(int drawn, const DirectionalSpectra& directional);
    void fillThermal(int drawn);
    SurfaceInput inputOf(int drawn, const std::vector<Entity>& entities,
                         const std::vector<ObjectGeometry>& geometry) const;
    /// A spectrum of the scene's databases at the nodes; sampled once.
    std::vector<double> sampled(const Spectrum& spectrum, const std::vector<SampledBand>& bands);

    const RadianceTerms* terms_;
    SurfaceRows rows_;
    std::vector<double> wavelengths_um_, weights_um_;
    std::vector<std::pair<std::size_t, std::size_t>> outputs_;
    std::vector<SurfaceSpectra> surfaces_;
    std::vector<std::shared_ptr<const SurfaceModel>> models_;
    std::vector<std::vector<AtmosphereSamples>> air_; // by entity and node
    std::vector<std::vector<int>> sliceSteps_;        // by entity and output
    std::vector<std::vector<SharedValues>>
        specular_;                  // by entity and place of its SpecularEnvironmentGrid
    std::vector<double> ambient_K_; // by entity
    /// By drawn row: in-band emission of every part at a factor of 1, output by output.
    std::vector<std::vector<double>> thermal_W_m2_sr_;
    std::map<std::pair<int, int>, std::vector<double>> transmissivities_;
    std::map<int, GasColumnSpectra::OfEntity> gases_;
    std::unique_ptr<const GasColumnSpectra> gasColumns_; // where there is gas
    std::vector<std::string> warnings_;
    std::mutex sampling_;
    std::map<const Spectrum*, std::vector<double>> samples_;
};

/// True where the aspect angle enters what a temperature entry sends.
bool dependsOnAspect(const TemperatureEntry& entry);

/// Spectral radiance behind the objects at the field's centre on the nodes of the bands, one behind
/// the other, as the settings ask for it.
SharedValues backgroundOf(const std::vector<SampledBand>& bands, const RenderSettings& settings);
/// What `of(band)` has in each band, one behind the other; null where no band has any.
SharedValues joinedOver(const std::vector<SampledBand>& bands,
                        const std::function<SharedValues(const SampledBand&)>& of);

} // namespace irsg
