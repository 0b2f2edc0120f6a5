#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/LookupTable.h"
#include "smatcore/data/ImageSource.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::test {

/// A renderer in closed form: keeps what it is told, and asks its heirs for the intensity of the
/// target towards a direction.
class AnalyticSource : public ImageSource {
  public:
    void configure(const SceneDescription& given) override {
        scene = given;
        poses.clear();
        states.clear();
        for (const irsg::Entity& entity : scene.entities) {
            poses.push_back(entity.pose);
            states.push_back(entity.state);
        }
    }
    irsg::Vec3 referencePointInModel(std::size_t) override { return referencePoint; }
    void setPose(std::size_t entity, const irsg::Pose& pose) override { poses.at(entity) = pose; }
    void setState(std::size_t entity, const irsg::EntityState& state) override {
        states.at(entity) = state;
    }
    void setViewpoint(const irsg::Viewpoint& given) override {
        viewpoint = given;
        positions.push_back(given.position_m);
    }

    /// From the reference point to the camera, in model axes, and how far.
    irsg::Vec3 towardsCamera() const {
        const irsg::Pose& pose = poses.front();
        return irsg::normalized(pose.attitude.rotation().transposed() *
                                (viewpoint.position_m - pose.toWorld(referencePoint)));
    }
    double range_m() const {
        return irsg::length(viewpoint.position_m - poses.front().toWorld(referencePoint));
    }

    virtual double intensity_W_sr(const irsg::Vec3& direction) const = 0;
    virtual double projectedArea_m2(const irsg::Vec3& direction) const = 0;

    irsg::RenderReport measure() override {
        ++drawings;
        irsg::RenderReport report;
        const irsg::Vec3 direction = towardsCamera();
        const double d_m = range_m();
        report.background_W_m2_sr = scene.render.background_W_m2_sr;
        report.all.range_m = d_m;
        report.all.intensity_W_sr = intensity_W_sr(direction);
        report.all.contrastIntensity_W_sr =
            report.all.intensity_W_sr - report.background_W_m2_sr * projectedArea_m2(direction);
        report.all.irradiance_W_m2 = report.all.contrastIntensity_W_sr / (d_m * d_m);
        const double pitch = scene.sensor.pixelPitch();
        report.all.coveredPixels = projectedArea_m2(direction) / (d_m * d_m * pitch * pitch);
        report.answeredBy = {"transmittance: closed form"};
        return report;
    }
    std::vector<irsg::RenderReport> measure(const std::vector<irsg::Band>& bands) override {
        const irsg::Band own = scene.sensor.band;
        std::vector<irsg::RenderReport> reports;
        for (const irsg::Band& band : bands) {
            scene.sensor.band = band;
            reports.push_back(measure());
        }
        scene.sensor.band = own;
        return reports;
    }
    irsg::RenderedImage render() override {
        irsg::RenderedImage rendered{
            irsg::RadianceImage(scene.sensor.width_px, scene.sensor.height_px), measure()};
        const irsg::Vec3 direction = towardsCamera();
        const auto radiance =
            static_cast<float>(intensity_W_sr(direction) / projectedArea_m2(direction));
        auto& values = rendered.image.primary().values;
        values.at(rendered.image.offset(scene.sensor.width_px / 2, scene.sensor.height_px / 2)) =
            radiance;
        return rendered;
    }
    irsg::IntensitySpectrum
    measureSpectrum(const std::vector<double>& wavenumbers_per_cm) override {
        irsg::IntensitySpectrum spectrum;
        spectrum.wavenumbers_per_cm = wavenumbers_per_cm;
        const double area_m2 = projectedArea_m2(towardsCamera());
        for (const double wavenumber : wavenumbers_per_cm) {
            const double wavelength_um = irsg::wavelengthFromWavenumber_um(wavenumber);
            const double intensity =
                area_m2 * irsg::planckRadiance_W_m2_sr_um(wavelength_um, 320.0);
            spectrum.wavelengths_um.push_back(wavelength_um);
            spectrum.intensity_W_sr_um.push_back(intensity);
            spectrum.contrastIntensity_W_sr_um.push_back(intensity);
            spectrum.irradiance_W_m2_um.push_back(intensity / (range_m() * range_m()));
        }
        return spectrum;
    }

    std::unique_ptr<const irsg::ScaledView> scaledView(const std::vector<irsg::ScalingInput>&,
                                                       const std::vector<double>&) override {
        throw irsg::LogicError("this renderer has no scales");
    }
    std::vector<std::unique_ptr<const irsg::ScaledView>>
    scaledViews(const std::vector<irsg::ScalingInput>& inputs,
                const std::vector<irsg::Band>& bands) override {
        const irsg::Band own = scene.sensor.band;
        std::vector<std::unique_ptr<const irsg::ScaledView>> views;
        for (const irsg::Band& band : bands) {
            scene.sensor.band = band;
            views.push_back(scaledView(inputs, {}));
        }
        scene.sensor.band = own;
        return views;
    }

    std::string rendererDescription() override { return "closed form"; }
    irsg::StageTimes stageTimes() const override { return {}; }
    void resetStageTimes() override {}

    SceneDescription scene;
    irsg::Vec3 referencePoint;
    std::vector<irsg::Pose> poses;
    std::vector<irsg::EntityState> states;
    irsg::Viewpoint viewpoint;
    std::vector<irsg::Vec3> positions; ///< of every viewpoint that was set
    int drawings = 0;
};

/// A grey sphere of radius 1 m and emissivity 0.9. Its temperature follows a table over time.
class GreySphere : public AnalyticSource {
  public:
    static constexpr double emissivity = 0.9;
    irsg::LookupTable temperature_K{{0.0, 1.0}, {320.0, 320.0}};

    double projectedArea_m2(const irsg::Vec3&) const override { return irsg::pi; }
    double intensity_W_sr(const irsg::Vec3&) const override {
        const double now_K = temperature_K.at(states.front().time_s);
        return irsg::pi * emissivity * irsg::bandRadiance_W_m2_sr(scene.sensor.band, now_K);
    }
};

/// A box whose sides have the intensities 1 to 6 W sr-1 along their normals and the cosine law away
/// from them.
class SixSidedBox : public AnalyticSource {
  public:
    static constexpr double front = 1, starboard = 2, tail = 3, port = 4, top = 5, belly = 6;

    double projectedArea_m2(const irsg::Vec3& u) const override {
        return std::abs(u.x) + std::abs(u.y) + std::abs(u.z);
    }
    double intensity_W_sr(const irsg::Vec3& u) const override {
        const auto side = [](double ahead, double behind, double cosine) {
            return cosine > 0.0 ? ahead * cosine : -behind * cosine;
        };
        return side(starboard, port, u.x) + side(front, tail, u.y) + side(top, belly, u.z);
    }
};

/// A scene without files: one target placed by the settings.
inline SceneDescription sceneWithoutFiles(const Project& project, const Settings& settings) {
    SceneDescription scene;
    scene.sensor = sensorOf(project, settings);
    scene.bands = bandsOf(project, settings);
    scene.render = renderSettingsOf(settings);
    irsg::Entity target;
    target.name = "target";
    target.pose = targetPoseOf(settings);
    target.state.time_s = settings[key::stateTime];
    scene.entities.push_back(target);
    return scene;
}

} // namespace smat::test
