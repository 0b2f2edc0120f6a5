// Draws a second of a Monte Carlo analysis by drawing scenes anew and by sums of projected factors,
// and the draws that Sobol' sequences save, on the sample aircraft. Seconds are those of
// processors.

#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>

#include "irsg/scene/InteractiveRenderer.h"
#include "smatcore/analysis/MonteCarlo.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/project/SceneBuilder.h"

namespace {

using namespace smat;

/// Of processor time, of all threads: what else the machine does counts little.
double seconds(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// One view of the target of a project.
struct View {
    SceneDescription scene;
    irsg::InteractiveRenderer irsg;
    std::vector<SceneScaling> scalings;
    std::vector<irsg::ScalingInput> inputs;

    View(const Project& project, double azimuth_rad, double range_m) {
        SceneBuilder builder;
        scene = builder.build(project, project.settings);
        std::vector<std::string> remarks;
        scalings = sceneScalings(project, scene, remarks);
        for (const SceneScaling& one : scalings)
            inputs.push_back(one.input);
        irsg.scene.environment = scene.environment;
        irsg.view.sensor = scene.sensor;
        irsg.scene.settings = scene.settings;
        irsg.scene.entities = scene.entities;
        irsg.view.viewpoint =
            irsg::Viewpoint::about(irsg.referencePoint(0), 0.0, azimuth_rad, 0.2, range_m);
    }
    void scale(const std::vector<double>& values) {
        std::vector<irsg::Entity> entities = scene.entities;
        for (std::size_t i = 0; i < values.size(); ++i)
            (inputs[i].kind == irsg::ScalingKind::temperature
                 ? entities.front().temperatureScale
                 : entities.front().emissivityScale)[inputs[i].index] = values[i];
        irsg.scene.entities = std::move(entities);
    }
};

void rates(const Project& project) {
    View view(project, 1.0, 900.0);
    const ScalingRealisations realisations(view.scalings, RealisationSequence::plain, 1);
    const ScalingRealisations points(view.scalings, RealisationSequence::sobol, 1);
    view.irsg.measure();
    const auto report = [](const char* what, double s, int count) {
        std::printf("| %-58s | %12.1f |\n", what, count / s);
    };
    std::printf("| %-58s | %12s |\n|---|---|\n", "draws of one view", "a CPU second");
    report("image drawn anew (render)", seconds([&] {
               for (std::size_t i = 0; i < 5; ++i) {
                   view.scale(realisations.at(i));
                   view.irsg.imageWithReport();
               }
           }),
           5);
    report("factors kept, spectra anew (measure)", seconds([&] {
               for (std::size_t i = 0; i < 20; ++i) {
                   view.scale(realisations.at(i));
                   view.irsg.measure();
               }
           }),
           20);
    view.irsg.scene.entities = view.scene.entities;
    std::unique_ptr<const irsg::ScaledView> band, spectrum;
    const double making = seconds([&] { band = view.irsg.scaledView(view.inputs); });
    std::vector<double> wavenumbers;
    for (double wavenumber = 2000.0; wavenumber <= 3333.0; wavenumber += 5.0)
        wavenumbers.push_back(wavenumber);
    spectrum = view.irsg.scaledSpectrum(view.inputs, wavenumbers);
    irsg::ScaledValues values;
    const auto nominal = std::vector<double>(view.inputs.size(), 1.0);
    report("scaled view, in a band", seconds([&] {
               for (std::size_t i = 0; i < 20000; ++i)
                   band->evaluate(nominal, values);
           }),
           20000);
    report("scaled view, 267 wavenumbers", seconds([&] {
               for (std::size_t i = 0; i < 2000; ++i)
                   spectrum->evaluate(nominal, values);
           }),
           2000);
    report("scales of a plain draw", seconds([&] {
               for (std::size_t i = 0; i < 20000; ++i)
                   realisations.at(i);
           }),
           20000);
    report("scales of a Sobol' draw", seconds([&] {
               for (std::size_t i = 0; i < 20000; ++i)
                   points.at(i);
           }),
           20000);
    std::printf("\nmaking the scaled view takes %.1f ms\n\n", 1e3 * making);
}

/// Standard error of a mean or percentile over independent repetitions, in parts of the spread.
void savings(const Project& project) {
    View view(project, 1.0, 900.0);
    const auto band = view.irsg.scaledView(view.inputs);
    const auto sampleOf = [&](RealisationSequence sequence, std::uint64_t seed, std::size_t count) {
        const ScalingRealisations realisations(view.scalings, sequence, seed);
        std::vector<double> sample;
        irsg::ScaledValues values;
        for (std::size_t i = 0; i < count; ++i) {
            band->evaluate(realisations.at(i), values);
            sample.push_back(values.contrastIntensity[0]);
        }
        return sample;
    };
    const double sigma = standardDeviationOf(sampleOf(RealisationSequence::sobol, 99, 8192));
    std::printf(
        "| draws | plain mean | Sobol' mean | plain draws for it | plain p95 | Sobol' p95 | "
        "plain draws for it |\n|---|---|---|---|---|---|---|\n");
    for (const std::size_t count : {256, 1024, 4096}) {
        double error[2][2];
        for (const RealisationSequence sequence :
             {RealisationSequence::plain, RealisationSequence::sobol}) {
            std::vector<double> means, percentiles;
            for (std::uint64_t repeat = 0; repeat < 100; ++repeat) {
                std::vector<double> sample = sampleOf(sequence, 1000 + repeat, count);
                means.push_back(meanOf(sample));
                std::sort(sample.begin(), sample.end());
                percentiles.push_back(percentileOf(sample, 95.0));
            }
            const int s = sequence == RealisationSequence::sobol ? 1 : 0;
            error[s][0] = standardDeviationOf(means) / sigma;
            error[s][1] = standardDeviationOf(percentiles) / sigma;
        }
        std::printf("| %zu |", count);
        for (int k = 0; k < 2; ++k)
            std::printf(" %.2g | %.2g | %.3g |", error[0][k], error[1][k],
                        static_cast<double>(count) * std::pow(error[0][k] / error[1][k], 2));
        std::printf("\n");
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: montecarlo-draws PROJECT.smat\n");
        return 2;
    }
    const smat::Project project = smat::loadProject(argv[1]);
    rates(project);
    savings(project);
}
