// What it takes to be told what a pixel is made of, and how far that is from what was drawn: random
// pixels of the samples' pictures, half of them from the middle third, and clicks in the window's
// panel, from the click until the answer is shown. Without a display.
//
//     bench_explain [PIXELS] [SIDE]        10000 pixels of all samples together, 128 x 128 each
//
// Columns: pixels and those whose 3 x 3 neighbours hit the same facet, with their largest relative
// difference; that of all pixels, at 99.9 % and the largest; of an explanation the median time and
// the longest; of a click the same, and what the processor had to do for it, the longest.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <random>
#include <vector>

#include <QApplication>

#include "gui/image/PixelPanel.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/PixelExplainer.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/settings/SettingKeys.h"

using namespace smat;

namespace {

using Clock = std::chrono::steady_clock;

double since_ms(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Of all threads of the program.
double processor_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// At this part of the sorted values; 0 where there are none.
double at(std::vector<double> values, double part) {
    if (values.empty())
        return 0.0;
    std::ranges::sort(values);
    const double last = static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(std::ceil(part * last))];
}

struct Found {
    std::vector<double> all, sameFacet; ///< relative differences
    std::vector<double> explain_ms, click_ms, clickProcessor_ms;

    void add(const Found& other) {
        const auto append = [](std::vector<double>& to, const std::vector<double>& from) {
            to.insert(to.end(), from.begin(), from.end());
        };
        append(all, other.all);
        append(sameFacet, other.sameFacet);
        append(explain_ms, other.explain_ms);
        append(click_ms, other.click_ms);
        append(clickProcessor_ms, other.clickProcessor_ms);
    }
    void print(const char* name) const {
        std::printf("| %s | %zu | %zu | %.1e | %.1e | %.1e | %.2f | %.1f | %.1f | %.1f | %.1f |\n",
                    name, all.size(), sameFacet.size(), at(sameFacet, 1.0), at(all, 0.999),
                    at(all, 1.0), at(explain_ms, 0.5), at(explain_ms, 1.0), at(click_ms, 0.5),
                    at(click_ms, 1.0), at(clickProcessor_ms, 1.0));
    }
};

/// Uniform over the picture, or its middle third.
class Places {
  public:
    Places(unsigned seed, int side) : random_(seed), side_(side) {}
    QPoint next(bool middle) {
        const int from = middle ? side_ / 3 : 0, to = middle ? 2 * side_ / 3 : side_;
        std::uniform_int_distribution<int> one(from, to - 1);
        const int x = one(random_);
        return {x, one(random_)};
    }

  private:
    std::mt19937 random_;
    int side_;
};

Found measured(const std::filesystem::path& file, int pixels, int side, unsigned seed) {
    const Project project = loadProject(file);
    Settings settings;
    settings.set(key::sensorWidth, side);
    settings.set(key::sensorHeight, side);
    settings.set(key::renderScattering, "false"); // haze of droplets is not explained, and said
    AnalysisData asked = AnalysisData::of(project, AnalysisKind::image, settings);
    asked.settings = eachBand(asked.settings).front();
    const auto explainer = std::make_shared<PixelExplainer>(asked);
    Places places(seed, side);
    Found found;
    for (int i = 0; i < pixels; ++i) {
        const QPoint place = places.next(i % 2 == 0);
        const auto start = Clock::now();
        const ExplainedPixel pixel = explainer->explain(place.x(), place.y());
        found.explain_ms.push_back(since_ms(start));
        const double difference = std::abs(pixel.relative());
        found.all.push_back(difference);
        if (pixel.computed.isInterior)
            found.sameFacet.push_back(difference);
    }
    gui::PixelPanel panel;
    panel.setMaker([explainer] { return [explainer] { return explainer; }; });
    bool isAnswered = false;
    QObject::connect(&panel, &gui::PixelPanel::answered, [&] { isAnswered = true; });
    panel.resize(460, 700);
    panel.setVisible(true);
    panel.prepare();
    while (panel.isBusy())
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    constexpr int clicks = 100;
    for (int i = 0; i < clicks; ++i) {
        isAnswered = false;
        const auto start = Clock::now();
        const double processor = processor_ms();
        panel.ask(places.next(true), std::nullopt);
        while (!isAnswered)
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        QApplication::processEvents(); // it is painted
        found.click_ms.push_back(since_ms(start));
        found.clickProcessor_ms.push_back(processor_ms() - processor);
    }
    return found;
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    const int pixels = argc > 1 ? std::atoi(argv[1]) : 10000;
    const int side = argc > 2 ? std::atoi(argv[2]) : 128;
    std::vector<std::filesystem::path> projects;
    for (const auto& folder :
         std::filesystem::directory_iterator(std::filesystem::path(SMAT_SOURCE_DIR) / "samples"))
        for (const auto& file : std::filesystem::directory_iterator(folder.path()))
            if (file.path().extension() == ".smat" &&
                file.path().stem() == folder.path().filename())
                projects.push_back(file.path());
    std::ranges::sort(projects);
    if (pixels < 1 || side < 4 || projects.empty()) {
        std::fprintf(stderr, "bench_explain [PIXELS] [SIDE]: numbers above 0 and 3\n");
        return 2;
    }
    std::printf(
        "| sample | pixels | same facet | largest there | 99.9 %% of all | largest of all | "
        "explained, ms | longest | click, ms | longest | processor, longest |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|\n");
    Found all;
    const int each =
        (pixels + static_cast<int>(projects.size()) - 1) / static_cast<int>(projects.size());
    unsigned seed = 1;
    for (const auto& project : projects) {
        try {
            const Found found = measured(project, each, side, seed++);
            found.print(project.stem().string().c_str());
            all.add(found);
        } catch (const irsg::InputError& error) {
            std::printf("| %s | %s |\n", project.stem().string().c_str(), error.what());
        }
        std::fflush(stdout);
    }
    all.print("all");
    return 0;
}
