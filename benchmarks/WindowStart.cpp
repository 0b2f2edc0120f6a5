// From the start of the process to the window on the screen, with and without a project: the
// program starts itself again and again and waits until the child says that it has painted.
#include <algorithm>
#include <cstdio>
#include <vector>

#include <QApplication>
#include <QElapsedTimer>
#include <QProcess>
#include <QTimer>

#include "gui/MainWindow.h"
#include "gui/settings/Preferences.h"
#include "gui/view/SceneView.h"
#include "gui/widgets/Theme.h"

namespace {

constexpr double allowed_s = 1.5;

/// What `smat FILE` does, and a word on the output once the window, or the model in it, is painted.
int runChild(int argc, char** argv, const QString& file) {
    QElapsedTimer clock;
    clock.start();
    QApplication application(argc, argv);
    smat::gui::applyTheme(application, smat::gui::Preferences::load().theme);
    const auto application_ms = clock.elapsed();
    smat::gui::Workbench workbench;
    smat::gui::MainWindow window(workbench);
    const auto made_ms = clock.elapsed();
    window.show();
    if (!file.isEmpty())
        window.open(file.toStdString());
    const auto* view = window.sceneView();
    const long before = view == nullptr ? 0 : view->frameCount();
    QTimer watch;
    QObject::connect(&watch, &QTimer::timeout, [&] {
        if (view != nullptr && view->frameCount() == before)
            return;
        std::printf("%lld %lld %lld\n", static_cast<long long>(application_ms),
                    static_cast<long long>(made_ms), static_cast<long long>(clock.elapsed()));
        std::fflush(stdout);
        QApplication::quit();
    });
    watch.start(1);
    return QApplication::exec();
}

struct Start {
    double whole_s = 0.0;
    QString stages;
};

Start startOnce(const QStringList& arguments) {
    QElapsedTimer clock;
    QProcess process;
    clock.start();
    process.start(QCoreApplication::applicationFilePath(), QStringList{"--child"} + arguments);
    while (!process.canReadLine() && process.waitForReadyRead(60000)) {
    }
    Start start{static_cast<double>(clock.nsecsElapsed()) * 1e-9, process.readLine().trimmed()};
    process.waitForFinished();
    return start;
}

} // namespace

int main(int argc, char** argv) {
    if (argc > 1 && QString(argv[1]) == "--child")
        return runChild(argc, argv, argc > 2 ? QString(argv[2]) : QString());

    QCoreApplication application(argc, argv);
    const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 10;
    const QString sample = SMAT_SOURCE_DIR "/samples/turboprop4/turboprop4.smat";
    bool isQuick = true;
    for (const auto& [what, arguments] :
         {std::pair<const char*, QStringList>{"empty window", {}}, {"sample aircraft", {sample}}}) {
        std::vector<Start> starts;
        for (int i = 0; i < runs; ++i)
            starts.push_back(startOnce(arguments));
        std::sort(starts.begin(), starts.end(),
                  [](const Start& a, const Start& b) { return a.whole_s < b.whole_s; });
        const Start& median = starts[starts.size() / 2];
        std::printf("%-16s median %.2f s, best %.2f s, worst %.2f s   "
                    "(application, window made, painted: %s ms)\n",
                    what, median.whole_s, starts.front().whole_s, starts.back().whole_s,
                    qPrintable(median.stages));
        isQuick = isQuick && (!arguments.isEmpty() || median.whole_s <= allowed_s);
    }
    std::printf("the empty window %s within %.1f s\n", isQuick ? "shows" : "does NOT show",
                allowed_s);
    return isQuick ? EXIT_SUCCESS : EXIT_FAILURE;
}
