// The 3-D view as a hand feels it: times between frames while the sample aircraft is dragged, and
// how long the infrared display takes to follow a drag, an edited database and a setting; at the
// end (alone with --editor) edits of an emissivity (alone with --edits), and from a key in a field
// of the database editor to the new picture on the screen. "Computed" is the time that all threads
// of the program have worked for one of them. Run it on an idle machine under a display (xvfb-run
// will do); the load is printed beside the figures.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <QApplication>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMouseEvent>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <sys/resource.h>

#include "benchmarks/Fluidity.h"
#include "gui/MainWindow.h"
#include "gui/database/DatabaseDock.h"
#include "gui/view/SceneView.h"
#include "gui/view/ViewOverlay.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/Workbench.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/project/ProjectFile.h"

using namespace smat;
using namespace smat::gui;

namespace {

constexpr int width_px = 1000, height_px = 700;
constexpr int windowWidth_px = 1580, windowHeight_px = 960;

Fluidity fluidity;

std::string load() {
    std::ifstream file("/proc/loadavg");
    std::string one;
    file >> one;
    return one;
}

double milliseconds(const QElapsedTimer& clock) {
    return static_cast<double>(clock.nsecsElapsed()) * 1e-6;
}

/// Time that the threads of this process have computed, ms: it stays nearly the same on a busy
/// machine.
double computed_ms() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto ms = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_usec) * 1e-3;
    };
    return ms(usage.ru_utime) + ms(usage.ru_stime);
}

void printHeading() {
    std::printf("%-44s %9s %9s %9s %9s   %s\n", "ms", "median", "95 %", "worst", "computed", "of");
}

void print(const char* what, const std::function<std::vector<double>()>& measure) {
    const double before_ms = computed_ms();
    std::vector<double> times_ms = measure();
    const double computed = (computed_ms() - before_ms) / static_cast<double>(times_ms.size());
    std::ranges::sort(times_ms);
    if (std::string_view(what).find("dragging") != std::string_view::npos)
        fluidity.validate(what, times_ms[times_ms.size() / 2]);
    std::printf("%-44s %9.1f %9.1f %9.1f %9.1f   %zu\n", what, times_ms[times_ms.size() / 2],
                times_ms[times_ms.size() * 95 / 100], times_ms.back(), computed, times_ms.size());
    std::fflush(stdout);
}

/// Handles events until it is done. Sleeps between them: a loop that asks again and again would
/// take its time from what it measures, and be counted as computed.
bool waitFor(const std::function<bool()>& done, double seconds = 30.0) {
    QTimer alarm;
    alarm.setSingleShot(true);
    alarm.setTimerType(Qt::PreciseTimer);
    alarm.start(static_cast<int>(seconds * 1e3));
    while (!done() && alarm.isActive())
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    return done();
}

void move(SceneView& view, QEvent::Type type, const QPointF& at) {
    QMouseEvent event(
        type, at, view.mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
        type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&view, &event);
}

/// Drags over `steps` frames, each begun when the one before is on the screen.
std::vector<double> drag(SceneView& view, int steps, const std::function<bool()>& isNext,
                         const std::function<void()>& begin) {
    std::vector<double> times_ms;
    move(view, QEvent::MouseButtonPress, {300, 300});
    for (int i = 1; i <= steps; ++i) {
        begin();
        QElapsedTimer clock;
        clock.start();
        move(view, QEvent::MouseMove, QPointF(300 + 5 * i % 600, 300 + 20 + i % 40));
        if (!waitFor(isNext))
            break;
        times_ms.push_back(milliseconds(clock));
    }
    move(view, QEvent::MouseButtonRelease, {300, 300});
    return times_ms;
}

/// Times of a view that cannot draw mean nothing.
void endWithoutPictures(const SceneView& view) {
    QObject::connect(&view, &SceneView::pictureFailed, [](const QStringList& sentences) {
        std::fprintf(stderr, "%s\n", sentences.join('\n').toUtf8().constData());
        std::exit(1);
    });
}

/// Processor time from edits of an emissivity until the first picture of the new state, and until
/// the one that rests; and whether there was a picture all the while.
void editEmissivities(Workbench& workbench, SceneView& view) {
    const auto upToDate = [&] { return view.isUpToDate() && view.shownPicture() != nullptr; };
    waitFor(upToDate, 120.0);
    std::printf("\nprocessor s of an edit of an emissivity: first picture, final picture\n");
    bool isFirst = false, isGrey = false;
    const auto connection =
        QObject::connect(&view, &SceneView::pictureShown, [&] { isFirst = true; });
    for (const double emissivity : {0.4, 0.7, 0.5, 0.8}) {
        isFirst = false;
        const double begin_ms = computed_ms();
        const auto since_s = [&] { return 1e-3 * (computed_ms() - begin_ms); };
        workbench.database().edit("paint", [=](irsg::SignatureDatabase& database) {
            database.materials.begin()->second.emissivity = irsg::Spectrum::constant(emissivity);
        });
        const auto look = [&](const std::function<bool()>& is) {
            waitFor(
                [&] {
                    isGrey = isGrey || view.shownPicture() == nullptr;
                    return is();
                },
                120.0);
        };
        look([&] { return isFirst; });
        const double first_s = since_s();
        look(upToDate);
        std::printf("  %.2f  %.2f\n", first_s, since_s());
    }
    QObject::disconnect(connection);
    std::printf("a picture all the while: %s\n", isGrey ? "no" : "yes");
    workbench.database().discard();
    waitFor(upToDate, 120.0);
}

/// From a key in the editor's field of T0 until the picture of the new value is on the screen: the
/// program's own window on a copy of the sample.
void editInTheWindow(const std::filesystem::path& sample, bool editsAlone) {
    namespace fs = std::filesystem;
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    const fs::path copy = root / "samples" / sample.parent_path().filename();
    fs::create_directories(copy.parent_path());
    fs::copy(sample.parent_path(), copy, fs::copy_options::recursive);
    // The sample's atmosphere lies beside the samples.
    fs::create_directory_symlink(fs::path(SMAT_SOURCE_DIR) / "resources", root / "resources");
    Workbench workbench;
    MainWindow window(workbench);
    window.resize(windowWidth_px, windowHeight_px);
    window.show();
    window.open(copy / sample.filename());
    SceneView* view = window.sceneView();
    DatabaseDock* dock = &window.databaseEditor();
    dock->raise();
    view->setDisplay(ViewDisplay::infrared);
    const auto upToDate = [&] { return view->isUpToDate() && view->shownPicture() != nullptr; };
    endWithoutPictures(*view);
    waitFor(upToDate);
    view->showWholeModel();
    editEmissivities(workbench, *view);
    if (editsAlone) {
        workbench.database().discard();
        return;
    }
    dock->select(
        {EntryKind::temperature, workbench.database().value().temperatures.begin()->first});
    dock->findChild<QTabWidget*>("temperatureTabs")->setCurrentIndex(1);
    auto* field = dock->findChild<QLineEdit*>("base_K");
    auto* tabs = window.findChild<QTabWidget*>("tabs");
    waitFor([] { return false; }, 1.0);
    std::printf("\nin the window, view %d x %d\n", view->width(), view->height());
    bool shown = false, swapped = false;
    QObject::connect(view, &SceneView::pictureShown, [&] {
        shown = true;
        swapped = false;
    });
    QObject::connect(view, &QOpenGLWidget::frameSwapped, [&] { swapped = true; });
    const auto press = [&](double pause_s) {
        std::vector<double> times_ms;
        for (int i = 0; i < 40; ++i) {
            waitFor([] { return false; }, pause_s);
            shown = swapped = false;
            QElapsedTimer clock;
            clock.start();
            QKeyEvent key(QEvent::KeyPress, Qt::Key_Up, Qt::NoModifier);
            QApplication::sendEvent(field, &key);
            waitFor([&] { return shown && swapped; });
            times_ms.push_back(milliseconds(clock));
        }
        return times_ms;
    };
    for (const auto quantity :
         {InfraredQuantity::radiance, InfraredQuantity::apparentTemperature}) {
        view->infrared().setQuantity(quantity);
        waitFor(upToDate);
        const char* word = quantity == InfraredQuantity::radiance ? "radiance" : "temperature";
        print((std::string("key to screen, after a pause, ") + word).c_str(),
              [&] { return press(0.6); });
        print((std::string("key to screen, key held down, ") + word).c_str(),
              [&] { return press(0.03); });
        Settings fine = workbench.settings();
        fine.set(key::polarStep, "0.5");
        AnalysisData job = AnalysisData::of(workbench.project(), AnalysisKind::polar, fine);
        workbench.start(std::move(job));
        print((std::string("key to screen, an analysis runs, ") + word).c_str(),
              [&] { return press(0.3); });
        if (!workbench.isRunning())
            std::printf("the analysis had ended before\n");
        workbench.cancel();
        waitFor([&] { return !workbench.isRunning(); });
        tabs->setCurrentIndex(0); // from the results to the model
    }
    workbench.database().discard();
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    applyTheme(application, ThemeMode::light);
    if (const QString problem = SceneView::problem(); !problem.isEmpty()) {
        std::fprintf(stderr, "%s\n", problem.toUtf8().constData());
        return 1;
    }
    const bool editsAlone = argc > 1 && std::string(argv[1]) == "--edits";
    const bool editorAlone = editsAlone || (argc > 1 && std::string(argv[1]) == "--editor");
    if (editorAlone)
        --argc, ++argv;
    const std::string sample =
        argc > 1 ? argv[1] : std::string(SMAT_SOURCE_DIR) + "/samples/turboprop4/turboprop4.smat";
    if (editorAlone) {
        std::printf("%s, load %s\n", sample.c_str(), load().c_str());
        printHeading();
        editInTheWindow(sample, editsAlone);
        std::printf("load %s\n", load().c_str());
        return 0;
    }
    const Project project = loadProject(sample);

    QElapsedTimer clock;
    clock.start();
    DisplayScene scene = loadDisplayScene(project, project.settings);
    std::printf("%s, %d x %d, load %s, model loaded in %.0f ms\n", sample.c_str(), width_px,
                height_px, load().c_str(), milliseconds(clock));
    SceneView view;
    if (argc > 2) {
        QSurfaceFormat format = view.format();
        format.setSamples(std::atoi(argv[2]));
        view.setFormat(format);
    }
    endWithoutPictures(view);
    view.resize(width_px, height_px);
    view.setScene(std::move(scene));
    view.setProject(project, project.settings);
    view.show();
    view.showWholeModel();
    waitFor([&] { return view.frameCount() > 2; }, 2.0);
    std::printf("%s, %d samples a pixel\n\n", view.renderer().toUtf8().constData(),
                view.format().samples());
    printHeading();

    // From the movement of the mouse until the frame is on the screen.
    bool swapped = false;
    QObject::connect(&view, &QOpenGLWidget::frameSwapped, [&] { swapped = true; });
    const auto isSwapped = [&] { return swapped; };
    const auto begin = [&] { swapped = false; };
    drag(view, 20, isSwapped, begin);
    const auto dragged = [&] { return drag(view, 150, isSwapped, begin); };
    print("visible, dragging", dragged);
    view.overlay().setModelAxesVisible(true);
    view.overlay().setSunVectorVisible(true);
    print("visible, dragging, all axes and the sun", dragged);
    view.setWireframe(true);
    print("wireframe, dragging", dragged);
    view.setWireframe(false);

    // From the movement until its infrared picture is there.
    bool shown = false;
    QObject::connect(&view, &SceneView::pictureShown, [&] { shown = true; });
    const auto isShown = [&] { return shown; };
    const auto isFull = [&] {
        return shown && view.shownPicture() != nullptr && !view.shownPicture()->coarse;
    };
    const auto forget = [&] { shown = false; };
    for (const auto quantity :
         {InfraredQuantity::radiance, InfraredQuantity::apparentTemperature}) {
        const bool warm = quantity == InfraredQuantity::apparentTemperature;
        const char* word = warm ? "apparent temperature" : "radiance";
        forget();
        clock.restart();
        view.infrared().setQuantity(quantity);
        view.setDisplay(ViewDisplay::infrared);
        waitFor(isFull);
        std::printf("infrared, %s, first picture %.0f ms\n", word, milliseconds(clock));
        print((std::string("infrared, dragging, ") + word).c_str(),
              [&] { return drag(view, 100, isShown, forget); });
        waitFor(isFull);

        // An edited database, as the editor hands it over.
        const auto file = project.resolve(project.models.front().database);
        irsg::SignatureDatabase database = irsg::loadSignatureFile(file).database;
        const auto edit = [&] {
            std::vector<double> edits_ms;
            for (int i = 0; i < 30; ++i) {
                waitFor([] { return false; }, 0.35); // a person's pause
                database.temperatures.begin()->second.terms.base_K += 1.0;
                forget();
                clock.restart();
                view.setEditedDatabase(file,
                                       std::make_shared<const irsg::SignatureDatabase>(database));
                waitFor(isFull);
                edits_ms.push_back(milliseconds(clock));
            }
            return edits_ms;
        };
        print((std::string("infrared, edited database, ") + word).c_str(), edit);

        Settings settings = project.settings;
        const auto moveSun = [&] {
            std::vector<double> settings_ms;
            for (int i = 0; i < 20; ++i) {
                waitFor([] { return false; }, 0.4);
                settings.set(key::environmentSunAzimuth, 10 * i);
                forget();
                clock.restart();
                view.setProject(project, settings);
                waitFor(isFull);
                settings_ms.push_back(milliseconds(clock));
            }
            return settings_ms;
        };
        print((std::string("infrared, the sun moved, ") + word).c_str(), moveSun);
    }
    view.hide();
    editInTheWindow(sample, false);
    std::printf("load %s\n", load().c_str());
    return fluidity.verdict();
}
