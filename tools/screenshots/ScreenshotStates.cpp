#include <fstream>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QListWidget>
#include <QMouseEvent>
#include <QTabWidget>

#include "gui/analysis/ResultPage.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "smatcore/settings/SettingKeys.h"
#include "tools/screenshots/ScreenshotTaker.h"

namespace smat::gui {

void ScreenshotTaker::keepCrosshair() {
    auto* list = window_.findChild<QListWidget*>("resultList");
    for (int i = 0; i < list->count(); ++i) {
        const ResultEntry* entry = workbench_.result(list->item(i)->data(Qt::UserRole).toInt());
        list->item(i)->setSelected(entry != nullptr && entry->data->kind == AnalysisKind::spectrum);
    }
    window_.findChild<QAction*>("showResultAction")->trigger();
    settle();
    auto* panel = window_.currentPage()->findChild<PlotPanel*>();
    if (panel == nullptr)
        return;
    QWidget* sheet = panel->surface().sheet();
    const QPointF at(sheet->width() * 0.4, sheet->height() * 0.4);
    QMouseEvent move(QEvent::MouseMove, at, sheet->mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(sheet, &move);
    settle();
    keep(window_, "plot-crosshair");
}

void ScreenshotTaker::keepRunning() {
    Settings fine = workbench_.settings();
    fine.set(key::polarStep, "0.02");
    workbench_.start(AnalysisData::of(workbench_.project(), AnalysisKind::polar, fine));
    double done = 0.0;
    const auto progress =
        QObject::connect(&workbench_, &Workbench::jobProgressed, &window_,
                         [&done](const Progress& now) { done = static_cast<double>(now.done); });
    constexpr double casesToSee = 60.0;
    waitWhile([this, &done] { return workbench_.isRunning() && done < casesToSee; });
    QObject::disconnect(progress);
    keep(window_, "window-running");
    workbench_.cancel();
    settle();
    keep(window_, "window-cancelled");
}

void ScreenshotTaker::keepRefusals() {
    // Images of two sizes, and one of them.
    const auto other = folder_ / "other-size.txt";
    std::ofstream(other) << "1 2 3\n4 5 6\n";
    auto* comparison =
        window_.compareImages({images_.front(), QString::fromStdString(other.string())});
    waitWhile([comparison] { return comparison->isBusy(); });
    settle();
    keep(window_, "comparison-refused");
    delete window_.findChild<QTabWidget*>("tabs")->currentWidget();
    std::filesystem::remove(other);

    // An infrared picture that cannot be made.
    window_.findChild<QTabWidget*>("tabs")->setCurrentIndex(0);
    workbench_.set(key::environmentAtmospheres, "haze of yesterday.csv");
    auto* infrared = window_.findChild<QAction*>("infraredDisplay");
    infrared->trigger();
    settle();
    keep(window_, "infraredDisplay-refused");
    infrared->trigger();
    workbench_.undoStack().undo();
    settle();
}

QStringList ScreenshotTaker::takeFirstSteps() {
    std::filesystem::create_directories(folder_);
    window_.resize(1360, 840);
    window_.show();
    if (!window_.open(project_))
        return told_;
    settle();
    keep(window_, "first-window");
    auto* infrared = window_.findChild<QAction*>("infraredDisplay");
    infrared->trigger();
    settle();
    keep(window_, "first-infrared");
    auto* database = window_.findChild<QDockWidget*>("databaseDock");
    database->show();
    database->raise();
    settle();
    keep(window_, "first-database");
    raiseResults();
    infrared->trigger();
    accept_ = true;
    current_ = "first-polar-dialog";
    window_.findChild<QAction*>("new-polar")->trigger();
    settle();
    keep(window_, "first-polar");
    // Its sample has scaling files.
    current_ = "first-monteCarlo";
    window_.findChild<QAction*>("monteCarlo")->trigger();
    settle();
    fill(window_.findChild<QTabWidget*>("tabs")->currentWidget());
    keepPage("monteCarlo-page");
    window_.close();
    return told_;
}

QStringList ScreenshotTaker::takeSpectra() {
    std::filesystem::create_directories(folder_);
    window_.resize(1360, 840);
    window_.show();
    if (!window_.open(project_))
        return told_;
    settle();
    const auto database = workbench_.database().snapshot();
    if (auto* pages = raiseDatabase(); pages == nullptr || !database || database->spectra.empty())
        told_ << "no spectrum is there to be shown";
    else
        for (int i = 0; i < pages->count(); ++i)
            if (pages->tabText(i).remove('&').startsWith("Spectr"))
                keepTab(*pages, i);
    window_.close();
    return told_;
}

QStringList ScreenshotTaker::takeWithoutGl() {
    std::filesystem::create_directories(folder_);
    window_.resize(1360, 840);
    window_.show();
    if (window_.open(project_)) {
        settle();
        keep(window_, "window-without-gl");
    }
    window_.close();
    return told_;
}

} // namespace smat::gui
