// Inter-reflection of the library beside a path tracer in double precision that knows nothing of it
// (tests/support/PathTracer.h), on bodies that are hard and on models of others.
//
//     bench_exchange [--case NAME] [--error E]
//     bench_exchange --public
//     bench_exchange FILE... [--two-sided] [--emission-alone] [--own-normals]
//     bench_exchange --write DIR ...; then benchmarks/mitsuba_witness.py DIR
//
// Every body is grey, opaque and even, in vacuum, and seen from the same distance by both. Band 3-5
// um. The error of the reflected part is that of what inter-reflection adds to the library's own
// number without it, unless there is sky, of which bodies hide a part. Closed forms are of parallel
// projection, from which the viewer's distance of 1000 radii differs by some 1e-4.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "benchmarks/exchange/ExchangeCases.h"
#include "benchmarks/exchange/WrittenScene.h"
#include "irsg/core/ParallelFor.h"

using namespace irsg;
using namespace irsg::bench;
using namespace irsg::test;

namespace {

struct Options {
    std::string only, folder;
    std::vector<std::string> files;
    FileAspects aspects;
    bool isPublic = false;
    double lightError = RenderSettings{}.lightError;
    /// Known far better than what it judges: of 16 batches the error itself is off by a fifth, and
    /// tracing ends where it seems small.
    double tracedError = 5e-5, traced_s = 10.0;
    int turns = 1; ///< of hard surfaces and samples, evenly around from their own on
    unsigned threads = 0, seed = 1;
};

double processor_s() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Measured {
    double value = 0.0, error = 0.0, spent_s = 0.0;
    std::vector<std::string> warnings;
};

Measured measured(Renderer& renderer, const ExchangeCase& one, double lightError, bool isLit) {
    Scene scene = sceneOf(one);
    scene.settings.lightError = lightError;
    if (!isLit)
        scene.settings.bounces = 0;
    const double start_s = processor_s();
    Measured found;
    if (one.place_m) {
        const Rendered rendered = renderer.render(scene, viewOf(one), Outputs::image());
        const std::vector<float>& pixels = rendered.image.find("L")->values;
        for (const float pixel : pixels)
            found.value += static_cast<double>(pixel) / static_cast<double>(pixels.size());
        found.warnings = rendered.reports.front().warnings;
    } else {
        const RenderReport report =
            renderer.render(scene, viewOf(one), Outputs::reports().withErrors()).reports.front();
        const ObjectRadiometry& body = one.body ? report.objects.at(*one.body) : report.all;
        found.value = body.intensity_W_sr;
        found.error = body.errors ? body.errors->intensity_W_sr.sum() : 0.0;
        found.warnings = report.warnings;
    }
    found.spent_s = processor_s() - start_s;
    return found;
}

std::string percent(double part, double of, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, of > 1e-12 ? "%+.*f" : "–", digits, 100.0 * part / of);
    return text;
}

/// How far numbers are off, as parts of the truth, where there is one to speak of.
struct Tally {
    int count = 0, stated = 0, covered = 0;
    double squares = 0.0, worst = 0.0;

    void add(const Tally& other) {
        count += other.count, stated += other.stated, covered += other.covered;
        squares += other.squares;
        worst = std::max(worst, other.worst);
    }
    void print(const std::string& name) const {
        if (count > 1)
            std::printf("    %s: rms %.3f %%, worst %.3f %%, covered %d of %d\n", name.c_str(),
                        100.0 * std::sqrt(squares / count), 100.0 * worst, covered, stated);
    }
};

Tally judged(Renderer& renderer, const ExchangeCase& one, const Options& options) {
    TraceSettings settings;
    settings.relativeError = options.tracedError;
    settings.longest_s = options.traced_s;
    settings.seed = options.seed;
    const TracedLight truth = truthOf(one, settings);
    const Measured found = measured(renderer, one, options.lightError, true);
    Renderer other;
    const double alone = measured(other, one, options.lightError, false).value;

    const double direct = truth.emitted.value + truth.onceFromOutside.value;
    const double wrong = found.value - truth.total.value;
    const double wrongBetween =
        one.isLitAround() ? wrong : found.value - alone - truth.between.value;
    const bool isCovered = std::abs(wrong) <= std::hypot(found.error, 2.0 * truth.total.error);
    char closedForm[64] = "";
    if (one.closedForm)
        std::snprintf(closedForm, sizeof closedForm, "%.6g (%s)", *one.closedForm,
                      percent(truth.total.value - *one.closedForm, *one.closedForm, 3).c_str());
    std::printf("| %s | %s | %.6g | %.2g | %s | %.6g | %.6g | %.2g | %s | %s | %s | %s | %.2f | "
                "%.2f |\n",
                one.name.c_str(), one.variant.c_str(), truth.total.value, truth.total.error,
                closedForm, truth.between.value, found.value, found.error,
                percent(wrong, truth.total.value, 3).c_str(),
                percent(wrongBetween, truth.between.value, 2).c_str(),
                one.isLitAround() ? "" : percent(alone - direct, direct, 3).c_str(),
                one.place_m ? ""
                : isCovered ? "yes"
                            : "NO",
                found.spent_s, truth.processor_s);
    if (!options.folder.empty())
        writeScene(one,
                   {truth.total.value, truth.total.error, found.value, found.error, found.spent_s},
                   options.folder);
    for (const std::string& warning : found.warnings)
        std::printf("    %s\n", warning.c_str());
    std::fflush(stdout);
    Tally tally;
    if (!one.place_m)
        tally.stated = 1, tally.covered = isCovered ? 1 : 0;
    if (truth.total.value > 1e-12) {
        tally.worst = std::abs(wrong) / truth.total.value;
        tally.squares = tally.worst * tally.worst;
        tally.count = 1;
    }
    return tally;
}

/// All of one body by one renderer.
Tally judged(const NamedCases& named, const Options& options) try {
    Renderer renderer;
    Tally all;
    for (const ExchangeCase& one : named.make())
        for (int i = 0; i < options.turns; ++i) {
            ExchangeCase turned = one;
            turned.azimuth_deg += 360.0 * i / options.turns;
            if (i > 0)
                turned.closedForm.reset();
            if (options.turns > 1)
                turned.variant += " + " + std::to_string(360 * i / options.turns) + "°";
            all.add(judged(renderer, turned, options));
        }
    all.print(named.name);
    return all;
} catch (const std::exception& error) {
    std::printf("    %s: %s\n", named.name.c_str(), error.what());
    return {};
}

std::vector<NamedCases> chosen(const Options& options) {
    std::vector<NamedCases> cases;
    for (const std::string& file : options.files)
        cases.push_back({std::filesystem::path(file).filename().string(),
                         [&options, file] { return options.aspects.of(file); }});
    if (options.isPublic)
        for (NamedCases& named : publicModelCases(options.aspects))
            cases.push_back(std::move(named));
    if (!cases.empty())
        return cases;
    for (std::vector<NamedCases> some : {sampleCases(), hardSurfaces()})
        for (NamedCases& named : some)
            if (named.name.starts_with(options.only))
                cases.push_back(std::move(named));
    return cases;
}

} // namespace

int main(int argc, char** argv) try {
    Options options;
    CLI::App app{"inter-reflection beside a path tracer"};
    app.add_option("files", options.files, "model files, each from 8 aspects");
    app.add_flag("--public", options.isPublic, "twelve models of Debian's packages");
    app.add_option("--case", options.only, "cases whose name begins so");
    app.add_option("--aspects", options.turns, "of each case, evenly around from its own on")
        ->check(CLI::Range(1, 360));
    app.add_option("--write", options.folder, "folder for the scenes, with these numbers");
    app.add_flag("--two-sided", options.aspects.isTwoSided, "read the files two-sided");
    app.add_flag("--emission-alone", options.aspects.isEmissionAlone,
                 "the files without sun and sky");
    app.add_flag(
        "--own-normals", options.aspects.hasOwnNormals,
        "reflect by the normals of the files, not by those of facets as the truth has them");
    app.add_option("--elevation", options.aspects.elevation_deg, "of the viewer of files, degrees");
    app.add_option("--error", options.lightError, "RenderSettings::lightError");
    app.add_option("--traced-error", options.tracedError, "standard error of the truth, of 1");
    app.add_option("--traced-seconds", options.traced_s, "processor time of a truth at most");
    app.add_option("--seed", options.seed, "of the truth");
    app.add_option("--threads", options.threads, "of the library; 0: as many as there are");
    CLI11_PARSE(app, argc, argv);
    setMostThreads(options.threads);
    std::printf("| case | variant | truth, W/sr | ± | closed form | of it between surfaces "
                "| library | stated ± | total, %% | reflected part, %% | without bounces, %% "
                "| covered | library, s | tracer, s |\n"
                "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    Tally all;
    for (const NamedCases& named : chosen(options))
        all.add(judged(named, options));
    all.print("all");
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
