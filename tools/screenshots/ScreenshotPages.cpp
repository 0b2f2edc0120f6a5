#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QListWidget>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QSpinBox>
#include <QTabBar>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>

#include "gui/analysis/ResultPage.h"
#include "gui/atmosphere/AtmospherePage.h"
#include "gui/database/DatabaseDock.h"
#include "gui/image/ComparisonPanes.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PolarPlot.h"
#include "gui/tools/AtmosphereToolPage.h"
#include "gui/tools/DetectionPage.h"
#include "gui/tools/GasPage.h"
#include "gui/tools/MonteCarloPage.h"
#include "smatcore/settings/SettingKeys.h"
#include "tools/screenshots/ScreenshotTaker.h"

namespace smat::gui {
namespace {

/// Enough draws for bands and a ranking to look at, in some seconds.
constexpr int draws = 256, rankedPairs = 64, drawingsOfACase = 1;
/// Of a rose of the patrol aircraft, in a minute.
constexpr double aspectStep_deg = 30.0;

template <typename Widget>
Widget* shown(QWidget& within, const char* name) {
    for (auto* found : within.findChildren<Widget*>(name))
        if (found->isVisible())
            return found;
    return nullptr;
}

} // namespace

void ScreenshotTaker::fill(QWidget* page) {
    if (dynamic_cast<GasPage*>(page) != nullptr)
        for (const char* beside : {"gasParts", "gasProduct"})
            page->findChild<QCheckBox*>(beside)->setChecked(true);
    if (auto* tool = dynamic_cast<AtmosphereToolPage*>(page)) {
        tool->compute();
        waitWhile([tool] { return tool->isRunning(); });
    }
    if (const auto* air = dynamic_cast<AtmospherePage*>(page))
        waitWhile([air] { return air->isBusy(); });
    if (auto* monteCarlo = dynamic_cast<MonteCarloPage*>(page)) {
        keepPage(current_ + "-empty");
        if (!current_.startsWith("first-")) // other samples have no scaling files
            return;
        page->findChild<QSpinBox*>("samples")->setValue(draws);
        page->findChild<QSpinBox*>("pairs")->setValue(rankedPairs);
        page->findChild<QSpinBox*>("subpixelShifts")->setValue(drawingsOfACase);
        monteCarlo->run();
        waitWhile([monteCarlo] { return monteCarlo->isRunning(); });
    }
    if (auto* detection = dynamic_cast<DetectionPage*>(page)) {
        keepPage(current_ + "-empty");
        page->findChild<QDoubleSpinBox*>("aspectStep")->setValue(aspectStep_deg);
        detection->run();
        waitWhile([detection] { return detection->isRunning(); });
    }
    if (current_ == "compareImages" && images_.size() == 2) {
        keepPage(current_ + "-empty");
        auto* comparison = window_.compareImages(images_);
        waitWhile([comparison] { return comparison->isBusy(); });
    }
    settle();
}

void ScreenshotTaker::closeTabs() {
    auto* tabs = window_.findChild<QTabWidget*>("tabs");
    for (int i = tabs->count() - 1; i > 0; --i)
        emit tabs->tabCloseRequested(i);
    settle();
}

void ScreenshotTaker::keepComparison() {
    closeTabs();
    auto* tabs = window_.findChild<QTabWidget*>("tabs");
    auto* comparison = window_.compareImages(images_);
    waitWhile([comparison] { return comparison->isBusy(); });
    settle();
    auto* modes = comparison->findChild<QComboBox*>("differenceMode");
    for (const auto mode : irsg::allDifferenceModes) {
        comparison->setDifferenceMode(mode);
        settle();
        keepPage("comparison-mode-" + QString::number(modes->currentIndex() + 1));
    }
    comparison->setDifferenceMode(irsg::allDifferenceModes[0]);
    comparison->findChild<QCheckBox*>("markPixels")->setChecked(true);
    auto* sides = comparison->findChild<QTabWidget*>("comparisonTabs");
    for (int i = 1; i < sides->count(); ++i) {
        sides->setCurrentIndex(i);
        settle();
        keepPage(QString("comparison-tab-%1").arg(i + 1));
    }
    sides->setCurrentIndex(0);
    comparison->findChild<QCheckBox*>("markPixels")->setChecked(false);
    comparison->goToWorstPixel();
    settle();
    keepPage("comparison-worst-pixel");
    comparison->panes()->fit();
    comparison->panes()->setWipe(true);
    settle();
    keepPage("comparison-wipe");
    delete tabs->currentWidget();
}

void ScreenshotTaker::keepProjectAnalyses() {
    accept_ = true;
    for (QAction* action : window_.findChild<QMenu*>("projectAnalyses")->actions()) {
        current_ = "analysis-" + QString(action->text()).remove(QChar(0x2026)).replace(' ', '-');
        // Two runs that differ, for overlays and differences.
        const bool twice = current_ == "analysis-polar";
        if (!isWanted(current_) && !(twice && isWanted("plot-")))
            continue;
        action->trigger();
        settle();
        raiseResults();
        keep(window_, current_ + "-page");
        if (twice) {
            workbench_.set(key::statePower, "0.2");
            action->trigger();
            settle();
            workbench_.undoStack().undo();
        }
        auto* tabs = window_.findChild<QTabWidget*>("tabs");
        if (tabs->currentIndex() > 0)
            emit tabs->tabCloseRequested(tabs->currentIndex());
    }
}

void ScreenshotTaker::keepResults() {
    auto* list = window_.findChild<QListWidget*>("resultList");
    auto* tabs = window_.findChild<QTabWidget*>("tabs");
    const auto choose = [&](AnalysisKind kind, int number) {
        list->clearSelection();
        for (int i = 0, chosen = 0; i < list->count() && chosen < number; ++i) {
            const auto id = list->item(i)->data(Qt::UserRole).toInt();
            const ResultEntry* entry = workbench_.result(id);
            if (entry == nullptr || entry->monteCarlo || entry->data->kind != kind ||
                entry->data->table.empty())
                continue;
            list->item(i)->setSelected(true);
            ++chosen;
        }
    };
    const auto act = [&](const char* name) {
        auto* action = window_.findChild<QAction*>(QString(name) + "Action");
        if (action->isEnabled())
            action->trigger();
        settle();
        return action->isEnabled();
    };

    // Plots: overlaid and subtracted runs, and every kind of axis.
    choose(AnalysisKind::polar, 2);
    if (!act("overlayResults"))
        told_ << QString("of %1 results no two polar plots are there to be overlaid")
                     .arg(list->count());
    keep(window_, "plot-polar-overlay");
    if (auto* decibel = shown<QToolButton>(*tabs->currentWidget(), "decibel"))
        decibel->click();
    settle();
    keep(window_, "plot-polar-decibel");
    act("subtractResults");
    keep(window_, "plot-difference");
    for (const auto& [kind, word] :
         {std::pair(AnalysisKind::range, "range"), std::pair(AnalysisKind::spectrum, "spectrum")}) {
        choose(kind, 1);
        act("showResult");
        for (const char* axis : {"logX", "logY"})
            if (auto* button = shown<QToolButton>(*tabs->currentWidget(), axis);
                button != nullptr && !button->isChecked())
                button->click();
        settle();
        keep(window_, QString("plot-logarithmic-") + word);
    }
    current_ = "axis-limits";
    if (auto* limits = shown<QToolButton>(*tabs->currentWidget(), "axisLimits"))
        limits->click();

    // What is known of a result, and its image with figures.
    current_ = "result-details";
    act("showCommandLine");
    current_ = "result-edit";
    accept_ = false;
    act("editResult");
    closeTabs();
    choose(AnalysisKind::image, 1);
    act("showResult");
    if (auto* histogram = shown<QToolButton>(*tabs->currentWidget(), "showHistogram"))
        histogram->click();
    settle();
    keep(window_, "image-histogram");
    if (auto* windows = shown<QToolButton>(*tabs->currentWidget(), "showWindows")) {
        windows->click();
        settle();
        keep(window_, "image-windows");
        windows->click();
    }
    if (auto* plane = shown<QComboBox>(*tabs->currentWidget(), "plane"); plane != nullptr) {
        plane->setCurrentIndex(plane->count() - 1);
        emit plane->activated(plane->count() - 1);
        settle();
        keep(window_, "image-plane");
    }
    keepFloating();
}

void ScreenshotTaker::keepFloating() {
    auto* tabs = window_.findChild<QTabWidget*>("tabs");
    const QPointF at = tabs->tabBar()->tabRect(tabs->currentIndex()).center();
    QMouseEvent twice(QEvent::MouseButtonDblClick, at, tabs->tabBar()->mapToGlobal(at),
                      Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(tabs->tabBar(), &twice);
    settle();
    for (QWidget* other : QApplication::topLevelWidgets())
        if (other->isVisible() && other->objectName() == "floatingPage") {
            keep(*other, "floating-page");
            other->close();
        }
    settle();
}

void ScreenshotTaker::keepDatabaseDialogs() {
    auto* dock = window_.findChild<DatabaseDock*>();
    dock->show();
    dock->raise();
    dock->findChild<QTabWidget*>("databaseTabs")->setCurrentIndex(0);
    settle();
    accept_ = false;
    for (const char* name :
         {"menuLibrary", "copyFromDatabase", "menuImportMaterial", "menuImportSpectrum"})
        if (auto* action = dock->findChild<QAction*>(name)) {
            current_ = QString("dialog-") + name;
            action->trigger();
        }
    for (const char* name : {"renumberEntry", "removeEntry"})
        if (auto* button = shown<QToolButton>(*dock, name)) {
            current_ = QString("dialog-") + name;
            button->click();
        }
}

void ScreenshotTaker::keepMessages() {
    const Dialogs desktop = Dialogs::ofDesktop();
    const auto keepNext = [this](const QString& name) {
        QTimer::singleShot(300, &window_, [this, name] {
            if (auto* box = QApplication::activeModalWidget()) {
                keep(*box, name);
                box->close();
            }
        });
    };
    keepNext("message");
    desktop.tell(&window_, "The analysis cannot be run",
                 {"ship.flt: no such file; a model that exists is expected"});
    keepNext("question");
    desktop.ask(&window_, "Unsaved changes",
                QString("%1 has changes that are not saved.")
                    .arg(QString::fromStdString(project_.filename().string())),
                {"&Save", "&Discard"});
}

} // namespace smat::gui
