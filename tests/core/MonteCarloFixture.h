#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/signature/ScalingXml.h"
#include "smatcore/analysis/MonteCarlo.h"
#include "tests/core/AnalyticSource.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {

/// A target whose intensity is 100 + 3 T1 + 2 T2 + E1 (T1 - 1) + cos(azimuth) T2, in closed form.
class LinearView : public irsg::ScaledView {
  public:
    LinearView(double cosine, std::size_t count, double more = 0.0)
        : cosine_(cosine), count_(count), more_(more) {}
    std::size_t size() const override { return count_; }
    static double at(double cosine, double t1, double t2, double e1) {
        return 100.0 + 3.0 * t1 + 2.0 * t2 + e1 * (t1 - 1.0) + cosine * t2;
    }
    void evaluate(std::span<const double> scales, irsg::ScaledValues& values) const override {
        values.intensity.assign(count_, more_ + at(cosine_, scales[0], scales[1], scales[2]));
        values.contrastIntensity = values.intensity;
        values.irradiance = values.intensity;
    }

  private:
    double cosine_;
    std::size_t count_;
    double more_;
};

class LinearTarget : public AnalyticSource {
  public:
    double projectedArea_m2(const irsg::Vec3&) const override { return 1.0; }
    double intensity_W_sr(const irsg::Vec3& direction) const override {
        // Phases differ by a part in 1e4, as drawings do.
        const double phase =
            1e-4 * std::sin(1e7 * (viewpoint.forward().x + 0.37 * viewpoint.forward().y));
        return LinearView::at(direction.y, 1.0, 1.0, 1.0) + phase + more();
    }
    irsg::RenderReport measure() override {
        irsg::RenderReport report = AnalyticSource::measure();
        report.all.errors = stated;
        return report;
    }
    std::unique_ptr<const irsg::ScaledView> scaledView(const irsg::Outputs& outputs) override {
        asked = outputs.scalings();
        return std::make_unique<LinearView>(
            towardsCamera().y, std::max<std::size_t>(outputs.wavenumbers_per_cm().size(), 1),
            more());
    }
    /// What the intensity has more, for every micrometre of the band's lower end.
    double more() const { return perBandEdge * scene.sensor.band.range().min_um; }
    std::vector<irsg::ScalingInput> asked;
    std::optional<irsg::RadiometryErrors> stated;
    double perBandEdge = 0.0;
};

/// A project whose model has two scaling files, and the scene a test draws of it.
class MonteCarloTest : public testing::Test {
  protected:
    MonteCarloTest() {
        scale("temperature", "T1", irsg::ScalingKind::temperature,
              {{1, {{irsg::DistributionKind::uniform, 0.9, 1.1}, ""}},
               {2, {{irsg::DistributionKind::normal, 0.7, 1.3}, ""}},
               {3, {{irsg::DistributionKind::uniform, 0.9, 1.1}, "a spectrum"}},
               {9, {{irsg::DistributionKind::uniform, 0.9, 1.1}, "no entry"}}});
        scale("emissivity", "E1", irsg::ScalingKind::emissivity,
              {{1, {{irsg::DistributionKind::uniform, 0.5, 1.5}, ""}}, {2, {{}, "fixed at 1"}}});
        Project project;
        project.models = {{.file = model, .database = "none.sigdb"}};
        project.settings.set("polar.step", "90");
        data.analysis = AnalysisData::of(project, AnalysisKind::polar);
        data.options.samples = 512;
    }

    void scale(const char*, const char*, irsg::ScalingKind kind, const irsg::ScalingTable& table) {
        writtenFile(irsg::scalingFile(model, kind), irsg::scalingXml(table));
    }

    static SceneDescription scene(const Project& project, const Settings& settings) {
        SceneDescription made = sceneWithoutFiles(project, settings);
        auto database = std::make_shared<irsg::SignatureDatabase>();
        database->temperatures[1].name = "skin";
        database->temperatures[2].name = "pipe";
        database->temperatures[3].mode = irsg::EmissionMode::userSpectrum;
        database->materials[1].name = "paint";
        database->materials[2];
        made.entities.front().database = database;
        return made;
    }

    MonteCarloData& run(const ProgressCallback& progress = {}, std::stop_token stop = {}) {
        MonteCarlo(source, scene).run(data, progress, std::move(stop));
        return data;
    }
    std::string refusal() {
        return refusalOf([&] { run(); });
    }

    std::filesystem::path model = ownFolder() / "target.flt";
    LinearTarget source;
    MonteCarloData data;
};

inline double sigmaOf(const irsg::Distribution& distribution) {
    double sum = 0.0, square = 0.0;
    constexpr int count = 20000;
    for (int i = 0; i < count; ++i) {
        const double x = distribution.at((i + 0.5) / count);
        sum += x;
        square += x * x;
    }
    return std::sqrt(square / count - sum / count * (sum / count));
}

} // namespace smat::test
