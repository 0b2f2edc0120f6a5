#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/signature/LookupTable.h"
#include "smatcore/data/RenderDoor.h"
#include "smatcore/data/SceneDescription.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::test {

/// A renderer in closed form: keeps the view that it is asked for, and asks its heirs for the
/// intensity of the target towards a direction.
class AnalyticSource {
  public:
    AnalyticSource() = default;
    AnalyticSource(const AnalyticSource&) = delete;
    AnalyticSource& operator=(const AnalyticSource&) = delete;
    virtual ~AnalyticSource() = default;

    /// The door to it; it must outlive the door.
    RenderDoor door() {
        return {.begin =
                    [this](const irsg::Scene& given, const irsg::SensorView& view,
                           const irsg::Outputs& outputs) {
                        auto made = std::make_shared<irsg::Rendered>(of(given, view, outputs));
                        return irsg::PendingRender([made] { return std::move(*made); });
                    },
                .referencePoint = [this](const irsg::Entity&) { return referencePoint; },
                .description = [](const irsg::Scene&) { return std::string("closed form"); },
                .explainer = [](const irsg::Scene&, const irsg::SensorView&)
                    -> std::function<irsg::PixelExplanation(int, int)> {
                    throw irsg::LogicError("this renderer does not explain pixels");
                },
                .stageTimes = [] { return irsg::StageTimes(); }};
    }
    operator RenderDoor() { return door(); }

    /// From the reference point to the camera, in model axes, and how far.
    irsg::Vec3 towardsCamera() const {
        const irsg::Pose& pose = target().pose;
        return irsg::normalized(pose.attitude.rotation().transposed() *
                                (viewpoint.position_m - pose.toWorld(referencePoint)));
    }
    double range_m() const {
        return irsg::length(viewpoint.position_m - target().pose.toWorld(referencePoint));
    }
    const irsg::Entity& target() const { return scene.entities.front(); }

    virtual double intensity_W_sr(const irsg::Vec3& direction) const = 0;
    virtual double projectedArea_m2(const irsg::Vec3& direction) const = 0;

    /// A report in the sensor's band.
    virtual irsg::RenderReport measure() {
        ++drawings;
        irsg::RenderReport report;
        const irsg::Vec3 direction = towardsCamera();
        const double d_m = range_m();
        report.background_W_m2_sr = scene.settings.background_W_m2_sr;
        report.all.range_m = d_m;
        report.all.intensity_W_sr = intensity_W_sr(direction);
        report.all.contrastIntensity_W_sr =
            report.all.intensity_W_sr - report.background_W_m2_sr * projectedArea_m2(direction);
        report.all.irradiance_W_m2 = report.all.contrastIntensity_W_sr / (d_m * d_m);
        const double pitch = scene.sensor.pixelPitch();
        report.all.coveredPixels = projectedArea_m2(direction) / (d_m * d_m * pitch * pitch);
        report.providedBy = {"transmittance: closed form"};
        return report;
    }
    /// What is asked for of the bands, or of that of the sensor.
    virtual std::vector<irsg::RenderReport> reports(const irsg::Outputs& outputs) {
        std::vector<irsg::RenderReport> made;
        inEachBand(outputs, [&] { made.push_back(measure()); });
        return made;
    }
    virtual irsg::Rendered image(const irsg::Outputs&) {
        irsg::Rendered rendered;
        rendered.image = irsg::RadianceImage(scene.sensor.width_px, scene.sensor.height_px);
        rendered.reports.push_back(measure());
        const irsg::Vec3 direction = towardsCamera();
        const auto radiance =
            static_cast<float>(intensity_W_sr(direction) / projectedArea_m2(direction));
        auto& values = rendered.image.primary().values;
        values.at(rendered.image.offset(scene.sensor.width_px / 2, scene.sensor.height_px / 2)) =
            radiance;
        return rendered;
    }
    virtual irsg::IntensitySpectrum spectrum(const std::vector<double>& wavenumbers_per_cm) {
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
    /// In the sensor's band, or at the wavenumbers where there are any.
    virtual std::unique_ptr<const irsg::ScaledView> scaledView(const irsg::Outputs&) {
        throw irsg::LogicError("this renderer has no scales");
    }
    virtual std::vector<std::unique_ptr<const irsg::ScaledView>>
    scaledViews(const irsg::Outputs& outputs) {
        std::vector<std::unique_ptr<const irsg::ScaledView>> views;
        inEachBand(outputs, [&] { views.push_back(scaledView(outputs)); });
        return views;
    }

    SceneDescription scene; ///< that was asked for last, with its sensor
    irsg::Vec3 referencePoint;
    irsg::Viewpoint viewpoint;
    std::vector<irsg::Vec3> positions; ///< of the camera in every view that was asked for
    int drawings = 0;
    bool statesErrors = true; ///< where they are asked for

  protected:
    void inEachBand(const irsg::Outputs& outputs, const std::function<void()>& work) {
        const irsg::Band own = scene.sensor.band;
        for (const irsg::Band& band :
             outputs.bands().empty() ? std::vector<irsg::Band>{own} : outputs.bands()) {
            scene.sensor.band = band;
            work();
        }
        scene.sensor.band = own;
    }

  private:
    irsg::Rendered of(const irsg::Scene& given, const irsg::SensorView& view,
                      const irsg::Outputs& outputs) {
        static_cast<irsg::Scene&>(scene) = given;
        scene.sensor = view.sensor;
        viewpoint = view.viewpoint;
        positions.push_back(viewpoint.position_m);
        irsg::Rendered made;
        if (outputs.hasImage()) {
            made = image(outputs);
        } else if (outputs.hasReports()) {
            made.reports = reports(outputs);
        } else if (!outputs.scalings().empty()) {
            made.scaled = scaledViews(outputs);
        } else {
            made.spectrum = spectrum(outputs.wavenumbers_per_cm());
        }
        if (statesErrors && outputs.errors().value_or(true)) {
            addErrors(made);
        }
        return made;
    }
    /// Of what an heir states none of: closed forms are exact.
    static void addErrors(irsg::Rendered& made) {
        const auto add = [](irsg::ObjectRadiometry& sums) {
            if (!sums.errors) {
                sums.errors.emplace();
            }
        };
        for (irsg::RenderReport& report : made.reports) {
            add(report.all);
            for (irsg::ObjectRadiometry& object : report.objects) {
                add(object);
            }
        }
        made.spectrum.errors.resize(made.spectrum.wavelengths_um.size());
    }
};

/// A grey sphere of radius 1 m and emissivity 0.9. Its temperature follows a table over time.
class GreySphere : public AnalyticSource {
  public:
    static constexpr double emissivity = 0.9;
    irsg::LookupTable temperature_K{{0.0, 1.0}, {320.0, 320.0}};

    double projectedArea_m2(const irsg::Vec3&) const override { return irsg::pi; }
    double intensity_W_sr(const irsg::Vec3&) const override {
        const double now_K = temperature_K.at(target().state.time_s);
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
    scene.settings = irsg::RenderSettings::direct();
    scene.sensor = sensorOf(project, settings);
    scene.setBands(bandsOf(project, settings));
    scene.settings = renderSettingsOf(settings);
    irsg::Entity target;
    target.name = "target";
    target.pose = targetPoseOf(settings);
    target.state.time_s = settings[key::stateTime];
    scene.entities.push_back(target);
    return scene;
}

} // namespace smat::test
