#include "irsg/scene/radiance/FactorTable.h"

#include <algorithm>

#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Adds one sample of solid angle `omega_sr` and `share` of a pixel.
void addSample(FactorSums& sums, const FactorLayer& layer, double omega_sr, double cosOffAxis,
               double share) {
    const double thermal_sr = omega_sr * static_cast<double>(layer.thermal);
    const double up_sr = omega_sr * static_cast<double>(layer.up);
    const double down_sr = omega_sr * static_cast<double>(layer.down);
    const double sun_sr = omega_sr * static_cast<double>(layer.sun);
    sums.coverage_sr += omega_sr;
    sums.thermal_sr += thermal_sr;
    sums.up_sr += up_sr;
    sums.down_sr += down_sr;
    sums.sun_sr += sun_sr;
    sums.coverageCos_sr += omega_sr * cosOffAxis;
    sums.thermalCos_sr += thermal_sr * cosOffAxis;
    sums.upCos_sr += up_sr * cosOffAxis;
    sums.downCos_sr += down_sr * cosOffAxis;
    sums.sunCos_sr += sun_sr * cosOffAxis;
    sums.pixels += share;
}

} // namespace

FactorAccumulator::FactorAccumulator(const Sensor& sensor, const FrameBackground& background,
                                     const SceneRadiometry& radiometry)
    : grid_(sensor), background_(background), keys_(radiometry.keys()) {
    for (const SurfaceSpectra& surface : radiometry.surfaces())
        transparent_.push_back(surface.isTransparent());
}

int FactorAccumulator::extended(int prefix, int row) {
    const auto [place, isNew] = extensions_.try_emplace({prefix, row}, prefix);
    if (!isNew)
        return place->second;

    const auto& [entity, codes] = keys_[static_cast<std::size_t>(row)];
    Prefix longer = prefixes_[static_cast<std::size_t>(prefix)];
    const std::pair<int, int> material{entity, codes.material};
    longer.insert(std::ranges::upper_bound(longer, material), material);
    const auto [id, isNewPrefix] =
        prefixIds_.try_emplace(longer, static_cast<int>(prefixes_.size()));
    if (isNewPrefix)
        prefixes_.push_back(longer);
    return place->second = id->second;
}

void FactorAccumulator::add(const SampleWindow& window, const FactorSamples& samples) {
    const bool backgroundVaries = !background_.isUniform();
    layersLeftOver_ += samples.layersLeftOver;

    window.forEachRun([&](std::size_t first, int count, int x, int y, double weight) {
        const std::size_t last = first + static_cast<std::size_t>(count);
        if (samples.first[first] == samples.first[last])
            return;
        const PixelGrid::Pixel pixel = grid_.at(x, y);
        const double share = weight * window.share();
        const double omega_sr = pixel.solidAngle_sr * share;
        const double behind_W_m2 = backgroundVaries ? omega_sr * background_.at(x, y) : 0.0;
        for (std::size_t i = first; i < last; ++i) {
            int prefix = 0;
            for (std::uint32_t k = samples.first[i]; k < samples.first[i + 1]; ++k) {
                const FactorLayer& layer = samples.layers[k];
                FactorSums& sums = sumsOf(prefix, layer.row);
                addSample(sums, layer, omega_sr, pixel.cosOffAxis, share);
                if (backgroundVaries) {
                    sums.background_W_m2 += behind_W_m2;
                    sums.backgroundCos_W_m2 += behind_W_m2 * pixel.cosOffAxis;
                }
                if (transparent_[static_cast<std::size_t>(layer.row)])
                    prefix = extended(prefix, layer.row);
            }
        }
    });
}

FactorSums& FactorAccumulator::sumsOf(int prefix, int row) {
    const auto index = static_cast<std::size_t>(prefix);
    if (sums_.size() <= index)
        sums_.resize(index + 1);
    if (sums_[index].empty())
        sums_[index].resize(keys_.size());
    return sums_[index][static_cast<std::size_t>(row)];
}

ProjectedFactors FactorAccumulator::take() const {
    ProjectedFactors factors;
    factors.layersLeftOver = layersLeftOver_;
    for (std::size_t prefix = 0; prefix < sums_.size(); ++prefix)
        for (std::size_t row = 0; row < sums_[prefix].size(); ++row) {
            const FactorSums& sums = sums_[prefix][row];
            if (sums.coverage_sr > 0.0)
                factors.sums.emplace(
                    FactorKey{keys_[row].first, keys_[row].second, prefixes_[prefix]}, sums);
        }
    return factors;
}

namespace {

/// Product of the transmissivities in front of a surface; empty when there are none.
std::vector<double> transmissivityInFront(const FactorKey& key, const SceneRadiometry& radiometry) {
    std::vector<double> product;
    for (const auto& [entity, material] : key.inFront) {
        const std::vector<double>& t = radiometry.transmissivity(entity, material);
        if (product.empty())
            product = t;
        else
            for (std::size_t i = 0; i < product.size(); ++i)
                product[i] *= t[i];
    }
    return product;
}

/// In-band integral of a surface's term seen through what lies in front.
double through(const SceneRadiometry& radiometry, const std::vector<double>& front,
               const std::vector<double>& term) {
    return front.empty() ? radiometry.integrate(term) : radiometry.integrate(front, term);
}

} // namespace

void evaluateFactors(const ProjectedFactors& factors, const SceneRadiometry& radiometry,
                     const FrameBackground& frameBackground,
                     const std::vector<ObjectGeometry>& geometry,
                     const std::vector<Entity>& entities, RenderReport& report) {
    report.objects.resize(entities.size());
    for (std::size_t e = 0; e < entities.size(); ++e) {
        report.objects[e] = {};
        report.objects[e].name = entities[e].name;
        report.objects[e].range_m = geometry[e].path.range_m;
    }
    report.all = {};
    report.all.name = "all";
    report.all.range_m = geometry.empty() ? 0.0 : geometry.front().path.range_m;

    for (const auto& [key, sums] : factors.sums) {
        const int row = radiometry.row(key.entity, key.codes);
        const SurfaceSpectra& surface = radiometry.surfaces()[static_cast<std::size_t>(row)];
        const std::vector<double> front = transmissivityInFront(key, radiometry);

        // A term that no sample has a factor of, such as the sun's on a gas, is not integrated.
        const auto ofTerm = [&](const std::vector<double>& term, double factor_sr) {
            return factor_sr != 0.0 ? through(radiometry, front, term) : 0.0;
        };
        const double thermal = ofTerm(surface.thermal, sums.thermal_sr);
        const double up = ofTerm(surface.up, sums.up_sr);
        const double down = ofTerm(surface.down, sums.down_sr);
        const double sun = ofTerm(surface.sun, sums.sun_sr);
        const double path = ofTerm(surface.path, sums.coverage_sr);

        double opacity = 1.0 - radiometry.scalarTransmissivity(row);
        for (const auto& [entity, material] : key.inFront)
            opacity *= radiometry.scalarTransmissivityOf(entity, material);

        // The background that this surface hides, as seen through what is in front of it.
        double hidden_W_m2 = opacity * sums.background_W_m2;
        double hiddenCos_W_m2 = opacity * sums.backgroundCos_W_m2;
        if (frameBackground.isUniform()) {
            std::vector<double> hidden(radiometry.background());
            for (std::size_t i = 0; i < hidden.size(); ++i)
                hidden[i] *= 1.0 - surface.transmissivity[i];
            const double background = through(radiometry, front, hidden);
            hidden_W_m2 = background * sums.coverage_sr;
            hiddenCos_W_m2 = background * sums.coverageCos_sr;
        }

        const double radiance = thermal * sums.thermal_sr + up * sums.up_sr + down * sums.down_sr +
                                sun * sums.sun_sr + path * sums.coverage_sr;
        const double onDetector = thermal * sums.thermalCos_sr + up * sums.upCos_sr +
                                  down * sums.downCos_sr + sun * sums.sunCos_sr +
                                  path * sums.coverageCos_sr - hiddenCos_W_m2;

        // An intensity is at the range of the object that has it, also in the sum of all.
        const double range_m = geometry[static_cast<std::size_t>(key.entity)].path.range_m;
        const double square_m2 = range_m * range_m;
        auto add = [&](ObjectRadiometry& object) {
            object.intensity_W_sr += radiance * square_m2;
            object.contrastIntensity_W_sr += (radiance - hidden_W_m2) * square_m2;
            object.irradiance_W_m2 += onDetector;
            object.coveredPixels += opacity * sums.pixels;
            object.solidAngle_sr += opacity * sums.coverage_sr;
        };
        add(report.objects[static_cast<std::size_t>(key.entity)]);
        add(report.all);
    }
    report.layersLeftOver = factors.layersLeftOver;
}

IntensitySpectrum evaluateSpectrum(const ProjectedFactors& factors,
                                   const SceneRadiometry& radiometry,
                                   const std::vector<ObjectGeometry>& geometry,
                                   const std::vector<Entity>& entities) {
    const std::size_t count = radiometry.wavelengths_um().size();
    IntensitySpectrum spectrum;
    spectrum.wavelengths_um = radiometry.wavelengths_um();
    for (double wavelength_um : spectrum.wavelengths_um)
        spectrum.wavenumbers_cm1.push_back(wavenumberFromWavelength_cm1(wavelength_um));
    spectrum.intensity_W_sr_um.resize(count);
    spectrum.contrastIntensity_W_sr_um.resize(count);
    spectrum.irradiance_W_m2_um.resize(count);
    spectrum.warnings = radiometry.warnings();
    if (entities.size() > 1)
        for (const Entity& entity : entities)
            spectrum.objects.push_back({entity.name, std::vector<double>(count),
                                        std::vector<double>(count), std::vector<double>(count)});

    for (const auto& [key, sums] : factors.sums) {
        const auto entity = static_cast<std::size_t>(key.entity);
        ObjectSpectrum* own = spectrum.objects.empty() ? nullptr : &spectrum.objects[entity];
        const double range_m = geometry[entity].path.range_m;
        const double square_m2 = range_m * range_m;
        const int row = radiometry.row(key.entity, key.codes);
        const SurfaceSpectra& surface = radiometry.surfaces()[static_cast<std::size_t>(row)];
        const std::vector<double> front = transmissivityInFront(key, radiometry);
        for (std::size_t i = 0; i < count; ++i) {
            const double passed = front.empty() ? 1.0 : front[i];
            const double hidden = (1.0 - surface.transmissivity[i]) * radiometry.background()[i];
            const double radiance =
                passed * (surface.thermal[i] * sums.thermal_sr + surface.up[i] * sums.up_sr +
                          surface.down[i] * sums.down_sr + surface.sun[i] * sums.sun_sr +
                          surface.path[i] * sums.coverage_sr);
            const double intensity = radiance * square_m2;
            const double contrast = (radiance - passed * hidden * sums.coverage_sr) * square_m2;
            const double irradiance =
                passed * (surface.thermal[i] * sums.thermalCos_sr + surface.up[i] * sums.upCos_sr +
                          surface.down[i] * sums.downCos_sr + surface.sun[i] * sums.sunCos_sr +
                          (surface.path[i] - hidden) * sums.coverageCos_sr);
            spectrum.intensity_W_sr_um[i] += intensity;
            spectrum.contrastIntensity_W_sr_um[i] += contrast;
            spectrum.irradiance_W_m2_um[i] += irradiance;
            if (own != nullptr) {
                own->intensity_W_sr_um[i] += intensity;
                own->contrastIntensity_W_sr_um[i] += contrast;
                own->irradiance_W_m2_um[i] += irradiance;
            }
        }
        if (key.inFront.empty())
            spectrum.coveredPixels += sums.pixels;
    }
    return spectrum;
}

} // namespace irsg
