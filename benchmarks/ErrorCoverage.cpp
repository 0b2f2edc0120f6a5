// How often the stated error of a number covers what is truly wrong with it, how much too large it
// is, and what it costs: random scenes against windows of 2048 samples and air of 1 cm-1. And how
// often what is chosen for a target error meets it.
//
//     bench_errors [SCENES] [FIRST] [targets|ck|times]
//     bench_errors samples [ASPECTS] [SAMPLE]
//
// With ck all scenes have air by wideband-ck; with times nothing is judged, and only what errors
// cost is told. With samples the scenes are the samples in two bands, from four elevations and
// three ranges.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "benchmarks/ErrorTally.h"
#include "benchmarks/SampleErrors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/analysis/TargetChoice.h"
#include "tests/support/RandomScenes.h"

using namespace irsg;
using namespace irsg::test;
using irsg::bench::ErrorTally;
using irsg::bench::median;

namespace {

double seconds(const std::vector<RandomScene>& scenes, bool errors) {
    // Of the processor: other work on the machine is not in it.
    const std::clock_t start = std::clock();
    for (const RandomScene& random : scenes) {
        Renderer renderer; // nothing is known from the scene before
        SensorView view = random.view;
        // A turn, as a sweep has it.
        for (int i = 0; i < 12; ++i) {
            Scene scene = random.scene;
            scene.entities.front().pose.attitude.yaw_rad += 0.5 * i;
            renderer.render(scene, view,
                            Outputs::reports().alongRange(random.alongRange).withErrors(errors));
        }
    }
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// A scene whose errors are to stay below a target.
struct Targeted {
    RandomScene random;
    double target;
    smat::SceneDescription scene;
    smat::RenderDoor door = smat::openRenderDoor();

    Targeted(RandomScene given, double aim) : random(std::move(given)), target(aim) {
        scene.entities = random.scene.entities;
        scene.environment = random.scene.environment;
        scene.sensor = random.view.sensor;
        scene.settings = random.scene.settings;
    }
    smat::PlacedCase turned(const smat::SceneDescription& inSomeWay, double turned_rad) const {
        smat::PlacedCase made{inSomeWay, {inSomeWay.sensor, random.view.viewpoint}, {}};
        made.scene.entities.front().pose.attitude.yaw_rad += turned_rad;
        return made;
    }
    smat::TargetChoice choice(std::size_t views, double step_rad, std::size_t cases) {
        smat::ProbedViews probed(door, scene, views, random.alongRange,
                                 [=, this](const smat::SceneDescription& inSomeWay, std::size_t i) {
                                     return turned(inSomeWay, step_rad * static_cast<double>(i));
                                 });
        return smat::chooseForTarget(
            probed, target, {cases, 1, false, scene.settings.mode == CalculationMode::spectral});
    }
    RenderReport measured(const smat::CalculationConfiguration& configuration, double turned_rad,
                          bool errors) {
        return turned(configuration.applied(scene), turned_rad)
            .render(
                door,
                Outputs::reports(scene.allBands()).alongRange(random.alongRange).withErrors(errors))
            .reports.front();
    }
};

/// Equal numbers, equal targets: 0.1 to 5 %.
double targetOf(int number) {
    return 1e-3 * std::pow(50.0, std::fmod(0.618034 * number, 1.0));
}

RandomAtmosphere atmosphereOf(int number) {
    // Half of them without air, a tenth wideband.
    return number % 2 == 0    ? RandomAtmosphere::none
           : number % 10 == 9 ? RandomAtmosphere::wideband
                              : RandomAtmosphere::spectral;
}

void judgeTargets(int first, int scenes) {
    Renderer renderer;
    int promised = 0, kept = 0, impossible = 0;
    std::vector<double> parts; // of the target
    double alone_s = 0.0, chosen_s = 0.0;
    for (int i = first; i < first + scenes; ++i) {
        const RandomScene random = randomScene(static_cast<unsigned>(i), atmosphereOf(i));
        const auto truth = judged(renderer, random);
        Targeted one(random, targetOf(i));
        const smat::TargetChoice choice = one.choice(1, 0.0, 1);
        const ObjectRadiometry own = one.measured(choice.configuration, 0.0, false).all;
        const double wrong = std::max(std::abs(own.intensity_W_sr / truth[0].truth - 1.0),
                                      std::abs(own.contrastIntensity_W_sr / truth[1].truth - 1.0));
        if (choice.isMet) {
            ++promised;
            kept += wrong <= one.target ? 1 : 0;
            parts.push_back(wrong / one.target);
        } else {
            ++impossible;
        }
        std::fprintf(stderr, "%d,%.3g,%s,%.3g,%.3g,%s,%s\n", i, one.target,
                     choice.isMet ? "met" : "no way", choice.reached, wrong,
                     wrong <= one.target ? "kept" : "MISSED", choice.sentences.front().c_str());
        if (i - first >= 12)
            continue;
        // A turn: the choice, and then errors, against the same way alone.
        constexpr int aspects = 36;
        constexpr double step_rad = 2.0 * pi / aspects;
        const auto turn_s = [&](bool chooses) {
            Targeted fresh(random, one.target);
            const std::clock_t start = std::clock();
            smat::CalculationConfiguration configuration = choice.configuration;
            if (chooses)
                (void)fresh.choice(4, step_rad * aspects / 4, aspects);
            for (int k = 0; k < aspects; ++k)
                (void)fresh.measured(configuration, step_rad * k, chooses);
            return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        };
        alone_s += turn_s(false);
        chosen_s += turn_s(true);
    }
    std::printf("| target error | scenes |\n|---|---|\n"
                "| some way meets it | %d |\n| no way does | %d |\n"
                "| met truly, of those that are said to | %.1f %% |\n"
                "| true error as a part of the target, median | %.2f |\n"
                "| turns of 36 aspects, choice and errors against the same way alone | %.2f |\n",
                promised, impossible, promised > 0 ? 100.0 * kept / promised : 0.0, median(parts),
                chosen_s / alone_s);
}

} // namespace

int main(int argc, char** argv) {
    if (argc > 1 && std::string(argv[1]) == "samples") {
        bench::judgeSamples(argc > 2 ? std::atoi(argv[2]) : 2, argc > 3 ? argv[3] : "");
        return 0;
    }
    const int scenes = argc > 1 ? std::atoi(argv[1]) : 200;
    const int first = argc > 2 ? std::atoi(argv[2]) : 0;
    if (argc > 3 && std::string(argv[3]) == "targets") {
        judgeTargets(first, scenes);
        return 0;
    }
    const bool isWideband = argc > 3 && std::string(argv[3]) == "ck";
    const bool isTimed = argc > 3 && std::string(argv[3]) == "times";
    Renderer renderer;
    const char* const names[] = {"no air", "computed air, spectral", "computed air, wideband-ck"};
    ErrorTally all, of[3], intensity, contrast;
    std::vector<RandomScene> timed[3];
    for (int i = first; i < first + scenes; ++i) {
        const RandomAtmosphere air = isWideband ? RandomAtmosphere::wideband : atmosphereOf(i);
        const RandomScene random = randomScene(static_cast<unsigned>(i), air);
        if (timed[static_cast<int>(air)].size() < 6)
            timed[static_cast<int>(air)].push_back(random);
        if (isTimed)
            continue;
        const auto found = judged(renderer, random);
        for (const JudgedNumber& one : found) {
            all.add(one);
            of[static_cast<int>(air)].add(one);
        }
        intensity.add(found[0]);
        contrast.add(found[1]);
        for (const JudgedNumber& one : found)
            std::fprintf(stderr, "%d,%d,%.6g,%.3g,%.3g,%.3g,%.3g,%s,%s\n", i, static_cast<int>(air),
                         one.truth, one.wrong() / std::abs(one.truth),
                         one.error.sampling / std::abs(one.truth),
                         one.error.air / std::abs(one.truth),
                         one.error.background / std::abs(one.truth),
                         one.isCovered() ? "covered" : "MISSED", random.name.c_str());
    }
    if (!isTimed) {
        ErrorTally::printHead();
        intensity.print("intensity");
        contrast.print("contrast intensity");
        for (int k = 0; k < 3; ++k)
            of[k].print(names[k]);
        all.print("all");
    }
    std::printf(
        "\n| turns of 12 aspects | without errors, s | with, s | ratio |\n|---|---|---|---|\n");
    for (int k = 0; k < 3; ++k) {
        seconds(timed[k], false);
        double without = 0.0, with = 0.0;
        for (int turn = 0; turn < 3; ++turn)
            without += seconds(timed[k], false), with += seconds(timed[k], true);
        std::printf("| %s | %.2f | %.2f | %.2f |\n", names[k], without, with, with / without);
    }
    return 0;
}
