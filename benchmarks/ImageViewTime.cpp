// How long the window of an image of 2048 x 2048 pixels takes for what people do with it: to show
// it, to pan, zoom and recolour, and what is worked out of it beside. The first two columns are how
// long the window does nothing else, the third how long it takes to be seen. Without a display.
#include <cmath>
#include <cstdio>
#include <functional>

#include <QApplication>
#include <QElapsedTimer>

#include "gui/Theme.h"
#include "gui/image/ColorBar.h"
#include "gui/image/ComparisonPanes.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageInspector.h"
#include "gui/image/ImageView.h"
#include "irsg/image/Histogram.h"

namespace {

using namespace smat::gui;

constexpr int side = 2048;

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

/// Between two acts `settle` waits for what they have begun in other threads, and shows it.
template <typename Act>
void measure(const char* what, int times, Act&& act, const std::function<void()>& settle = {}) {
    double best_ms = 1e9, sum_ms = 0.0, seen_ms = 0.0;
    for (int i = 0; i < times; ++i) {
        QElapsedTimer clock;
        clock.start();
        act(i);
        const double ms = since_ms(clock);
        best_ms = std::min(best_ms, ms);
        sum_ms += ms;
        if (settle)
            settle();
        seen_ms += since_ms(clock);
    }
    std::printf("%-52s %8.1f %8.1f %8.1f\n", what, best_ms, sum_ms / times, seen_ms / times);
    std::fflush(stdout);
}

template <typename Window, typename Paint>
std::function<void()> settling(const Window& window, const Paint& paint) {
    return [&window, &paint] {
        do {
            paint();
            QApplication::processEvents(QEventLoop::AllEvents, 1);
        } while (window.isBusy());
        paint();
    };
}

void measureView(ImageView& view, const irsg::RadianceImage& image) {
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

void measureComparison(const irsg::RadianceImage& a, const irsg::RadianceImage& b) {
    ComparisonWindow window(ComparisonSide::of(a, "A"), ComparisonSide::of(b, "B"));
    window.resize(1400, 1000);
    window.show();
    QImage paper(window.panes()->size(), QImage::Format_RGB32);
    const auto paint = [&] { window.panes()->render(&paper); };
    const auto settle = settling(window, paint);
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
    measure("in the background: all numbers", 3, [&](int) { irsg::compareImages(a, b); });
}

} // namespace

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    applyTheme(application, ThemeMode::light);
    const irsg::RadianceImage a = scene(0.02F), b = scene(0.03F);
    std::printf("%d x %d pixels in a window of 1400 x 1000%26s %8s %8s\n", side, side, "best ms",
                "mean ms", "seen ms");
    {
        ImageView view;
        view.resize(1400, 1000);
        view.show();
        QApplication::processEvents();
        measureView(view, a);
    }
    measureComparison(a, b);
    return 0;
}
