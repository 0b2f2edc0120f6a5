// Frame times of the plot windows with 20 curves of 10,000 points, and how long a cancel takes to
// be answered: bench_plots [curves] [points]. Wants a display (xvfb-run). Processor times are those
// of the window's thread alone: what else the machine does hardly changes them.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <numbers>
#include <string>

#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWindow>

#include "benchmarks/Fluidity.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PolarPlot.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/Workbench.h"

namespace {

using namespace smat::gui;
using Clock = std::chrono::steady_clock;

Fluidity fluidity;

double since_ms(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// A restless curve: waves with noise, so that thinning has to keep all of it.
Curve restless(int number, int points, double from, double to) {
    Curve curve{QStringLiteral("curve %1").arg(number + 1), {}, {}};
    unsigned state = 77U + static_cast<unsigned>(number);
    for (int i = 0; i < points; ++i) {
        state = state * 1664525U + 1013904223U;
        const double noise = static_cast<double>(state >> 8U) / (1U << 24U);
        const double part = static_cast<double>(i) / points;
        curve.x.push_back(from + (to - from) * part);
        curve.y.push_back(1000.0 + 200.0 * number +
                          300.0 * std::sin(part * 2.0 * std::numbers::pi * (3 + number)) +
                          150.0 * noise);
    }
    return curve;
}

double processor_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

/// Median and worst of the frames that `step` makes.
void measure(const std::string& plot, const char* what, int frames,
             const std::function<void(int)>& step) {
    std::vector<double> times_ms, processor;
    for (int i = 0; i < frames; ++i) {
        const auto start = Clock::now();
        const double begun_ms = processor_ms();
        step(i);
        processor.push_back(processor_ms() - begun_ms);
        times_ms.push_back(since_ms(start));
    }
    std::sort(times_ms.begin(), times_ms.end());
    std::sort(processor.begin(), processor.end());
    fluidity.validate(plot + ": " + what, times_ms[times_ms.size() / 2]);
    std::printf("  %-22s median %6.1f   worst %6.1f   processor %6.1f ms\n", what,
                times_ms[times_ms.size() / 2], times_ms.back(), processor[processor.size() / 2]);
    std::fflush(stdout);
}

template <typename Data>
Data withErrors(Data data) {
    for (Curve& curve : data.curves)
        curve.error.assign(curve.y.size(), 60.0);
    return data;
}

void send(QWidget* to, QEvent&& event) {
    QCoreApplication::sendEvent(to, &event);
}

/// A window that is not there yet does not paint.
void show(QWidget& window) {
    window.resize(1000, 700);
    window.show();
    const auto begun = Clock::now();
    while (since_ms(begun) < 5000.0 &&
           (window.windowHandle() == nullptr || !window.windowHandle()->isExposed()))
        QApplication::processEvents(QEventLoop::AllEvents, 20);
    QApplication::processEvents();
}

void drive(const char* name, PlotSurface& surface) {
    QWidget* sheet = surface.sheet();
    QWidget* plot = surface.widget();
    const QPointF middle(sheet->rect().center());
    const auto frame = [&] { plot->repaint(); };
    std::printf("%s\n", name);
    measure(name, "show all", 10, [&](int) {
        surface.resetView();
        frame();
    });
    measure(name, "zoom by the wheel", 30, [&](int i) {
        send(sheet, QWheelEvent(middle, sheet->mapToGlobal(middle), {}, {0, i < 15 ? 120 : -120},
                                Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false));
        frame();
    });
    surface.zoomAt(middle, 0.7);
    send(sheet, QMouseEvent(QEvent::MouseButtonPress, middle, sheet->mapToGlobal(middle),
                            Qt::RightButton, Qt::RightButton, Qt::NoModifier));
    measure(name, "pan", 40, [&](int i) {
        const QPointF at = middle + QPointF(6.0 * (i + 1), 2.0 * i);
        send(sheet, QMouseEvent(QEvent::MouseMove, at, sheet->mapToGlobal(at), Qt::NoButton,
                                Qt::RightButton, Qt::NoModifier));
        frame();
    });
    send(sheet, QMouseEvent(QEvent::MouseButtonRelease, middle, sheet->mapToGlobal(middle),
                            Qt::RightButton, Qt::NoButton, Qt::NoModifier));
    measure(name, "crosshair", 60, [&](int i) {
        const QPointF at = middle + QPointF(3.0 * i - 90.0, 40.0 * std::sin(i / 5.0));
        send(sheet, QMouseEvent(QEvent::MouseMove, at, sheet->mapToGlobal(at), Qt::NoButton,
                                Qt::NoButton, Qt::NoModifier));
        sheet->repaint();
    });
}

/// From the cancel to the answer, with a drawing of many seconds under way.
void cancelling() {
    Workbench workbench;
    workbench.open(std::filesystem::path(SMAT_SOURCE_DIR) / "samples/ship/ship.smat");
    auto settings = workbench.settings();
    settings.set(smat::key::sensorWidth, 7000);
    settings.set(smat::key::sensorHeight, 7000);
    settings.set(smat::key::renderAntialiasing, 2);
    workbench.start(
        smat::AnalysisData::of(workbench.project(), smat::AnalysisKind::image, settings));
    const auto begun = Clock::now();
    while (since_ms(begun) < 1000.0 && workbench.isRunning())
        QApplication::processEvents(QEventLoop::AllEvents, 10);
    if (!workbench.isRunning()) {
        std::printf("cancel: the drawing was over before\n");
        return;
    }
    const auto asked = Clock::now();
    workbench.cancel();
    while (workbench.isRunning())
        QApplication::processEvents(QEventLoop::AllEvents, 5);
    std::printf("cancel answered after %.0f ms\n", since_ms(asked));
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    applyTheme(application, ThemeMode::light);
    const int curves = argc > 1 ? std::atoi(argv[1]) : 20;
    const int points = argc > 2 ? std::atoi(argv[2]) : 10000;
    std::printf("%d curves of %d points, 1000 x 700\n", curves, points);

    CartesianPlot cartesian(PlotStyle::screen(QApplication::palette()));
    PlotData data{
        .title = "Intensity", .xTitle = "Range (m)", .yTitle = "Intensity (W/sr)", .curves = {}};
    PolarData around{.title = "Intensity",
                     .conditions = {},
                     .radiusTitle = "Intensity (W/sr)",
                     .directionNote = "clockwise",
                     .curves = {}};
    for (int i = 0; i < curves; ++i) {
        data.curves.push_back(restless(i, points, 500.0, 10000.0));
        around.curves.push_back(restless(i, points, 0.0, 360.0));
    }
    cartesian.setData(data);
    show(cartesian);
    drive("Cartesian", cartesian);
    cartesian.setLogarithmic(QwtPlot::yLeft, true);
    drive("Cartesian, logarithmic", cartesian);
    cartesian.setLogarithmic(QwtPlot::yLeft, false);
    cartesian.setData(withErrors(data));
    drive("Cartesian with bands", cartesian);
    cartesian.hide();
    PolarPlot polar(PlotStyle::screen(QApplication::palette()));
    polar.setData(around);
    show(polar);
    drive("Polar", polar);
    polar.setData(withErrors(around));
    drive("Polar with bands", polar);
    cancelling();
    return fluidity.verdict();
}
