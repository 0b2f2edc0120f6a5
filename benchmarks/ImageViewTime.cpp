// How long the window of an image of 2048 x 2048 pixels takes for what people do with it: to show
// it, to pan, zoom and recolour, and what is worked out of it beside. Columns: processor time of
// the window's thread for the act itself (what else the machine does hardly changes it), the
// longest it then needs for one of the answers that come from other threads, and how long all takes
// to be seen. Without a display.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string_view>

#include <QApplication>
#include <QElapsedTimer>

#include "benchmarks/Fluidity.h"
#include "gui/image/ColorBar.h"
#include "gui/image/ComparisonPanes.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageInspector.h"
#include "gui/image/ImageView.h"
#include "gui/widgets/Theme.h"
#include "irsg/image/Histogram.h"

namespace {

using namespace smat::gui;

constexpr int side = 2048;

Fluidity fluidity;

/// A sky with a horizon, structure at every scale and a hot target.
irsg::RadianceImage scene(float noise) {
    irsg::RadianceImage image(side, side);
    std::uint32_t state = 1;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            state = state * 1664525U + 1013904223U;
            const float grain = static_cast<float>(state >> 8U) / 16777216.0F;
            const float target = std::exp(
                -0.0001F * static_cast<float>((x - 900) * (x - 900) + (y - 800) * (y - 800)));
            image.primary().values[image.offset(x, y)] =
                0.5F + 0.0003F * static_cast<float>(y) + 4.0F * target + noise * grain;
        }
    return image;
}

double since_ms(const QElapsedTimer& clock) {
    return static_cast<double>(clock.nsecsElapsed()) * 1e-6;
}

/// Of this thread.
double processor_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// Means over some acts. After each `settle` waits for what it has begun in other threads, shows
/// it, and says how long its longest step kept the window's thread busy, in ms.
template <typename Act>
void measure(const char* what, int times, Act&& act, const std::function<double()>& settle = {}) {
    double window_ms = 0.0, longest_ms = 0.0, seen_ms = 0.0;
    for (int i = 0; i < times; ++i) {
        QElapsedTimer clock;
        clock.start();
        const double begun_ms = processor_ms();
        act(i);
        window_ms += processor_ms() - begun_ms;
        if (settle)
            longest_ms += settle();
        seen_ms += since_ms(clock);
    }
    // What is worked out in other threads keeps nobody waiting.
    if (!std::string_view(what).starts_with("in the background"))
        fluidity.validate(what, std::max(window_ms, longest_ms) / times);
    std::printf("%-52s %8.1f %8.1f %8.1f\n", what, window_ms / times, longest_ms / times,
                seen_ms / times);
    std::fflush(stdout);
}

template <typename Window, typename Paint>
std::function<double()> settling(const Window& window, const Paint& paint) {
    return [&window, &paint] {
        double longest_ms = 0.0;
        do {
            const double begun_ms = processor_ms();
            QApplication::processEvents(QEventLoop::AllEvents, 1);
            paint();
            longest_ms = std::max(longest_ms, processor_ms() - begun_ms);
        } while (window.isBusy());
        paint();
        return longest_ms;
    };
}

void measureView(ImageView& view, const std::shared_ptr<const irsg::RadianceImage>& image) {
    QImage paper(view.canvas()->size(), QImage::Format_RGB32);
    const auto paint = [&] { view.canvas()->render(&paper); };
    const auto settle = settling(view, paint);
    measure(
        "show: limits, colours, first picture", 5,
        [&](int) {
            view.setImage(image);
            paint();
        },
        settle);
    measure("paint, fitted into the window", 50, [&](int) { paint(); });
    measure("pan, fitted into the window", 50, [&](int i) {
        CanvasView at = view.canvas()->view();
        at.centre += QPointF(i % 2 == 0 ? 3.0 : -3.0, 1.0);
        view.canvas()->setView(at);
        paint();
    });
    view.canvas()->showActualSize();
    measure("pan, one to one", 50, [&](int i) {
        CanvasView at = view.canvas()->view();
        at.centre += QPointF(i % 2 == 0 ? 7.0 : -7.0, 2.0);
        view.canvas()->setView(at);
        paint();
    });
    measure("zoom, from a tenth to a hundred times", 60, [&](int i) {
        view.canvas()->setZoom(0.1 * std::pow(1000.0, i / 60.0));
        paint();
    });
    view.canvas()->setView({view.canvas()->printingZoom(), QPointF(900.0, 800.0), false});
    measure("paint with values on the pixels", 20, [&](int) { paint(); });
    view.canvas()->fit();
    measure(
        "recolour: other map", 20,
        [&](int i) {
            view.setColorMap(i % 2 == 0 ? "inferno" : "white-hot");
            paint();
        },
        settle);
    measure(
        "recolour: exposure", 20,
        [&](int i) {
            view.colorBar()->changeExposure(i % 2 == 0 ? 0.25 : -0.25);
            paint();
        },
        settle);
    const auto limits = [&](const char* what, LimitMode mode) {
        measure(
            what, 5,
            [&](int) {
                view.colorBar()->setMode(mode);
                emit view.colorBar()->modeChosen(mode);
                paint();
            },
            settle);
    };
    limits("limits by percentiles, recolour, paint", LimitMode::percentile);
    limits("limits of the target, recolour, paint", LimitMode::target);
    measure("values under the mouse", 50, [&](int i) { view.readoutAt(i, i); });
    const auto& plane = view.image().primary();
    measure("in the background: histogram of 256 bins", 5,
            [&](int) { irsg::imageHistogram(view.image(), plane, 256); });
    measure("in the background: statistics of the image", 5,
            [&](int) { figuresOf(view.image(), plane, std::nullopt); });
}

void measureComparison(const std::shared_ptr<const irsg::RadianceImage>& a,
                       const std::shared_ptr<const irsg::RadianceImage>& b) {
    ComparisonWindow window({a, "A", {}}, {b, "B", {}});
    window.resize(1400, 1000);
    window.show();
    QImage paper(window.panes()->size(), QImage::Format_RGB32);
    const auto paint = [&] { window.panes()->render(&paper); };
    const auto settle = settling(window, paint);
    settle();
    measure(
        "comparison: two images put in", 3,
        [&](int) {
            window.setSides(window.side(0), window.side(1));
            paint();
        },
        settle);
    measure("comparison: pan of all three", 30, [&](int i) {
        auto* canvas = window.panes()->canvas(0);
        canvas->centreOn({1000 + i, 1000}, 0.3);
        paint();
    });
    measure(
        "comparison: other kind of difference", 4,
        [&](int i) {
            window.setDifferenceMode(irsg::allDifferenceModes[i]);
            paint();
        },
        settle);
    measure("in the background: all numbers", 3, [&](int) { irsg::compareImages(*a, *b); });
}

} // namespace

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    applyTheme(application, ThemeMode::light);
    const auto a = std::make_shared<const irsg::RadianceImage>(scene(0.02F));
    const auto b = std::make_shared<const irsg::RadianceImage>(scene(0.03F));
    std::printf("%d x %d pixels in a window of 1400 x 1000%26s %8s %8s\n", side, side, "window",
                "longest", "seen ms");
    {
        ImageView view;
        view.resize(1400, 1000);
        view.show();
        QApplication::processEvents();
        measureView(view, a);
    }
    measureComparison(a, b);
    return fluidity.verdict();
}
