#include "benchmarks/SampleErrors.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "benchmarks/ErrorTally.h"
#include "irsg/atmosphere/EnvironmentVariants.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/analysis/CaseChecks.h"
#include "smatcore/analysis/PlacedCase.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/project/SceneBuilder.h"

namespace irsg::bench {

namespace {

using test::JudgedNumber;

/// A sample in a band, as its project has it and as finely as it gets.
class Sample {
  public:
    Sample(const std::string& name, const char* band) {
        const auto folder = std::filesystem::path(SMAT_SOURCE_DIR) / "samples" / name;
        const smat::Project project = smat::loadProject(folder / (name + ".smat"));
        smat::Settings settings = project.settings;
        settings.set("sensor.band", band);
        settings.set("environment.terrain", ""); // waves are for pictures
        usual_ = smat::SceneBuilder().build(project, settings);
        usual_.environment = onTheFly(usual_.environment);
        fine_ = usual_;
        RenderSettings& render = fine_.settings;
        render.tileSide_samples = 2048;
        render.atmosphereSliceFrom = 1e-3;
        render.pointSourceBelow_px = 0.0;
        render.lightError *= 0.1;
        if (render.background == BackgroundMode::environment)
            render.backgroundRows = 65;
        fine_.environment = withBins(usual_.environment, 1);
        placer_.emplace(door_, usual_);
        reach_m_ = usual_.entities.front().model->bounds().diagonal_m();
    }

    /// A view from a direction and a range, or from the nearest beyond it from which all of the
    /// model is in the frame: what is not is in no sum.
    smat::AnalysisCase viewed(double azimuth_rad, double elevation_rad, double range_m) const {
        smat::AnalysisCase one;
        one.azimuth_rad = azimuth_rad;
        for (;; range_m *= 1.1) {
            // No lower than a mast, wherever the target is.
            constexpr double lowest_m = 5.0;
            const double down = (lowest_m - usual_.entities.front().pose.position_m.z) / range_m;
            one.elevation_rad =
                std::max(elevation_rad, down > -1.0 ? std::asin(std::min(down, 1.0)) : -0.5 * pi);
            one.range_m = range_m;
            const smat::PlacedCase placed = placer_->place(usual_, one);
            const Entity& target = placed.scene.entities.front();
            if (!smat::reachesBeyondFrame(target, target.pose, placed.view.viewpoint,
                                          placed.view.sensor))
                return one;
        }
    }

    std::array<JudgedNumber, 2> judged(const smat::AnalysisCase& one) {
        const auto measured = [&](const smat::SceneDescription& scene, bool errors) {
            return placer_->place(scene, one)
                .render(door_, Outputs::reports().withErrors(errors))
                .reports.front()
                .all;
        };
        fine_.sensor.width_px = fine_.sensor.height_px = 512;
        fine_.sensor.horizontalFieldOfView_rad = 2.0 * std::atan(1.1 * reach_m_ / one.range_m);
        const ObjectRadiometry own = measured(usual_, true), truth = measured(fine_, false);
        return {JudgedNumber{own.intensity_W_sr, truth.intensity_W_sr, own.errors->intensity_W_sr},
                JudgedNumber{own.contrastIntensity_W_sr, truth.contrastIntensity_W_sr,
                             own.errors->contrastIntensity_W_sr}};
    }

  private:
    smat::RenderDoor door_ = smat::openRenderDoor();
    smat::SceneDescription usual_, fine_;
    std::optional<smat::CasePlacer> placer_;
    double reach_m_ = 0.0;
};

struct SampleViews {
    const char* name;
    std::array<double, 4> elevations_deg;
    std::array<double, 3> ranges_m;
};

} // namespace

void judgeSamples(int aspects, const std::string& only) {
    // Sensors above the sea or ground that models stand on.
    const SampleViews samples[] = {{"turboprop4", {-20, 0, 12, 45}, {900, 2500, 10000}},
                                   {"heron", {-10, 0, 14, 45}, {120, 1000, 5000}},
                                   {"tern", {-15, 0, 12, 45}, {150, 1000, 6000}},
                                   {"corvette", {1, 4.2, 15, 45}, {230, 1500, 6000}},
                                   {"ship", {1, 8, 20, 45}, {400, 1500, 8000}},
                                   {"box", {-30, 0, 30, 60}, {300, 1000, 5000}},
                                   {"sphere", {-30, 0, 30, 60}, {40, 100, 1000}},
                                   {"chessboard", {10, 25, 50, 80}, {60, 300, 2000}}};
    ErrorTally tuned, kept, all;
    std::map<std::string, ErrorTally> of;
    int number = 0;
    for (const SampleViews& views : samples)
        for (const char* band : {"3-5", "8-12"}) {
            if (!only.empty() && only != views.name)
                continue;
            Sample sample(views.name, band);
            for (const double elevation_deg : views.elevations_deg)
                for (const double range_m : views.ranges_m) {
                    ++number;
                    // Of each range and elevation some.
                    const bool isKept = (number + (number - 1) / 3) % 3 == 0;
                    for (int k = 0; k < aspects; ++k) {
                        // Azimuths that no two combinations share.
                        const double azimuth_deg =
                            360.0 * std::fmod(0.618034 * (number * aspects + k), 1.0);
                        const smat::AnalysisCase view =
                            sample.viewed(radians(azimuth_deg), radians(elevation_deg), range_m);
                        const auto found = sample.judged(view);
                        for (const JudgedNumber& one : found) {
                            const bool isContrast = &one == &found[1];
                            (isKept ? kept : tuned).add(one);
                            all.add(one);
                            of[views.name].add(one);
                            of[std::string(band) + " um"].add(one);
                            of[isContrast ? "contrast intensity" : "intensity"].add(one);
                            const double size = std::abs(found[0].truth);
                            std::fprintf(
                                stderr, "%s,%s,%g,%g,%.3f,%s,%.6g,%.3g,%.3g,%.3g,%.3g,%.3g,%s,%s\n",
                                views.name, band, elevation_deg, view.range_m, azimuth_deg,
                                isContrast ? "contrast" : "intensity", one.truth,
                                (one.value - one.truth) / size, one.error.sampling / size,
                                one.error.air / size, one.error.background / size,
                                one.error.exchange / size, one.isCovered() ? "covered" : "MISSED",
                                isKept ? "kept" : "tuned");
                        }
                    }
                }
        }
    ErrorTally::printHead();
    for (const auto& [name, tally] : of)
        tally.print(name);
    tuned.print("two thirds of the combinations");
    kept.print("a third that nothing was tuned to");
    all.print("all");
}

} // namespace irsg::bench
