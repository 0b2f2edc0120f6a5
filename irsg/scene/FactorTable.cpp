#include "irsg/scene/FactorTable.h"

#include <algorithm>

#include "irsg/radiometry/Units.h"

namespace irsg {

FactorAccumulator::FactorAccumulator(std::vector<SceneRadiometry::SurfaceKey> keys,
                                     std::vector<bool> transparent)
    : keys_(std::move(keys)), transparent_(std::move(transparent)) {}

void FactorAccumulator::beginWindow(const Sensor& sensor, const PixelWindow& window,
                                    int samplesPerAxis) {
    grid_ = PixelGrid(sensor);
    window_ = window;
    samplesPerAxis_ = samplesPerAxis;
    const auto n = static_cast<std::size_t>(samplesPerAxis);
    samplePrefix_.assign(static_cast<std::size_t>(window.width) * n *
                             static_cast<std::size_t>(window.height) * n,
                         0);
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

void FactorAccumulator::addLayer(const std::vector<float>& plane0,
                                 const std::vector<float>& plane1) {
    const int n = samplesPerAxis_;
    const int width = window_.width * n;
    for (int py = 0; py < window_.height; ++py) {
        for (int px = 0; px < window_.width; ++px) {
            const int x = window_.x + px, y = window_.y + py;
            double omega_sr = -1.0, cosOffAxis = 0.0;
            for (int sy = 0; sy < n; ++sy) {
                // GL's rows run from the bottom up.
                const int glRow = (window_.height - 1 - py) * n + sy;
                const std::size_t first =
                    static_cast<std::size_t>(glRow) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(px * n);
                for (std::size_t i = first; i < first + static_cast<std::size_t>(n); ++i) {
                    const float* sample = &plane0[4 * i];
                    if (sample[0] == 0.0f)
                        continue;
                    if (omega_sr < 0.0) {
                        const PixelGrid::Pixel pixel = grid_.at(x, y);
                        omega_sr = pixel.solidAngle_sr / (n * n);
                        cosOffAxis = pixel.cosOffAxis;
                    }
                    const int row = static_cast<int>(sample[0]) - 1;
                    const auto prefix = static_cast<std::size_t>(samplePrefix_[i]);
                    if (sums_.size() <= prefix)
                        sums_.resize(prefix + 1);
                    if (sums_[prefix].empty())
                        sums_[prefix].resize(keys_.size());
                    FactorSums& sums = sums_[prefix][static_cast<std::size_t>(row)];
                    const double thermal = sample[1], down = sample[2], sun = sample[3];
                    const double up = plane1[4 * i + 1];
                    const double cosOmega_sr = omega_sr * cosOffAxis;
                    sums.coverage_sr += omega_sr;
                    sums.thermal_sr += omega_sr * thermal;
                    sums.up_sr += omega_sr * up;
                    sums.down_sr += omega_sr * down;
                    sums.sun_sr += omega_sr * sun;
                    sums.coverageCos_sr += cosOmega_sr;
                    sums.thermalCos_sr += cosOmega_sr * thermal;
                    sums.upCos_sr += cosOmega_sr * up;
                    sums.downCos_sr += cosOmega_sr * down;
                    sums.sunCos_sr += cosOmega_sr * sun;
                    sums.pixels += 1.0 / (n * n);
                    if (transparent_[static_cast<std::size_t>(row)])
                        samplePrefix_[i] = extended(samplePrefix_[i], row);
                }
            }
        }
    }
}

ProjectedFactors FactorAccumulator::take(int layersLeftOver) const {
    ProjectedFactors factors;
    factors.layersLeftOver = layersLeftOver;
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

        const double thermal = through(radiometry, front, surface.thermal);
        const double up = through(radiometry, front, surface.up);
        const double down = through(radiometry, front, surface.down);
        const double sun = through(radiometry, front, surface.sun);
        const double path = through(radiometry, front, surface.path);

        // The background that this surface hides, as seen through what is in front of it.
        std::vector<double> hidden(radiometry.background());
        for (std::size_t i = 0; i < hidden.size(); ++i)
            hidden[i] *= 1.0 - surface.transmissivity[i];
        const double background = through(radiometry, front, hidden);

        double opacity = 1.0 - radiometry.scalarTransmissivity(row);
        for (const auto& [entity, material] : key.inFront)
            opacity *= radiometry.scalarTransmissivityOf(entity, material);

        const double radiance = thermal * sums.thermal_sr + up * sums.up_sr + down * sums.down_sr +
                                sun * sums.sun_sr + path * sums.coverage_sr;
        const double onDetector = thermal * sums.thermalCos_sr + up * sums.upCos_sr +
                                  down * sums.downCos_sr + sun * sums.sunCos_sr +
                                  (path - background) * sums.coverageCos_sr;

        auto add = [&](ObjectRadiometry& object) {
            const double square_m2 = object.range_m * object.range_m;
            object.intensity_W_sr += radiance * square_m2;
            object.contrastIntensity_W_sr += (radiance - background * sums.coverage_sr) * square_m2;
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
                                   const SceneRadiometry& radiometry, double range_m) {
    const std::size_t count = radiometry.wavelengths_um().size();
    IntensitySpectrum spectrum;
    spectrum.wavelengths_um = radiometry.wavelengths_um();
    for (double wavelength_um : spectrum.wavelengths_um)
        spectrum.wavenumbers_cm1.push_back(wavenumberFromWavelength_cm1(wavelength_um));
    spectrum.intensity_W_sr_um.resize(count);
    spectrum.contrastIntensity_W_sr_um.resize(count);
    spectrum.irradiance_W_m2_um.resize(count);
    spectrum.warnings = radiometry.warnings();

    const double square_m2 = range_m * range_m;
    for (const auto& [key, sums] : factors.sums) {
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
            spectrum.intensity_W_sr_um[i] += radiance * square_m2;
            spectrum.contrastIntensity_W_sr_um[i] +=
                (radiance - passed * hidden * sums.coverage_sr) * square_m2;
            spectrum.irradiance_W_m2_um[i] +=
                passed * (surface.thermal[i] * sums.thermalCos_sr + surface.up[i] * sums.upCos_sr +
                          surface.down[i] * sums.downCos_sr + surface.sun[i] * sums.sunCos_sr +
                          (surface.path[i] - hidden) * sums.coverageCos_sr);
        }
        if (key.inFront.empty())
            spectrum.coveredPixels += sums.pixels;
    }
    return spectrum;
}

} // namespace irsg
