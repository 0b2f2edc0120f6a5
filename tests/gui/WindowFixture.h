#pragma once

#include <deque>
#include <functional>
#include <memory>

#include <QAction>
#include <QDialog>
#include <QTest>
#include <gtest/gtest.h>

#include "gui/MainWindow.h"
#include "gui/view/SceneView.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/SampleProject.h"

namespace smat::gui::test {

/// The real window; this test stands in for the person in front of it.
class WindowFixture : public ::testing::Test {
  protected:
    void SetUp() override {
        if (lacksGl()) {
            GTEST_SKIP() << "this desktop gives no OpenGL context";
        }
    }
    WindowFixture() {
        Dialogs dialogs;
        dialogs.openFile = [this](QWidget*, const QString&, const QStringList&) { return chosen; };
        dialogs.saveFile = [this](QWidget*, const QString&, const QStringList&, const QString&) {
            return chosen;
        };
        dialogs.tell = [this](QWidget*, const QString&, const QStringList& sentences) {
            told += sentences;
        };
        dialogs.ask = [this](QWidget*, const QString& title, const QString&, const QStringList&) {
            asked << title;
            if (answers.empty()) {
                return answer;
            }
            const int next = answers.front();
            answers.pop_front();
            return next;
        };
        dialogs.run = [this](QDialog& dialog) {
            dialog.show();
            QTest::qWait(20);
            if (onDialog) {
                onDialog(dialog);
            }
            return accept;
        };
        people = dialogs;
        makeWindow();
    }
    void makeWindow() {
        window = std::make_unique<MainWindow>(workbench, people);
        window->resize(1360, 840);
        window->show();
        QTest::qWait(50);
    }
    void openSample() {
        chosen = QString::fromStdString(writeSampleProject(folder).string());
        window->findChild<QAction*>("openProject")->trigger();
        ASSERT_TRUE(waitForModel());
        QTest::qWait(50);
        ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
        ASSERT_TRUE(workbench.hasProject());
    }
    /// Opens a file and waits until its models are shown, or told of.
    bool opens(const std::filesystem::path& file) { return window->open(file) && waitForModel(); }
    /// A project of a sample, without light between its surfaces, in the test's own folder.
    std::filesystem::path own(const std::string& name) {
        Project project = loadProject(std::filesystem::path(SMAT_SOURCE_DIR) / "samples" / name /
                                      (name + ".smat"));
        for (ProjectModel& model : project.models) {
            model.file = std::filesystem::absolute(project.resolve(model.file));
            model.database = std::filesystem::absolute(project.resolve(model.database));
        }
        project.settings.set("render.bounces", "0");
        const auto file = folder / (name + ".smat");
        saveProject(project, file);
        return file;
    }
    bool waitForModel() {
        return waitUntil([this] { return !window->isLoadingModel(); });
    }
    void trigger(const char* action) { window->findChild<QAction*>(action)->trigger(); }
    void runAnalysis(const char* word) {
        window->findChild<QAction*>(QString("new-") + word)->trigger();
        ASSERT_TRUE(waitUntil([this] { return !workbench.isRunning(); }));
        QTest::qWait(50);
        ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    }
    AnalysisData runDirectly(const AnalysisData& asked) {
        SceneBuilder builder;
        AnalysisGenerator generator(openRenderDoor(), [&](const Project& p, const Settings& s) {
            return builder.build(p, s);
        });
        AnalysisData data = asked;
        data.state = AnalysisState::notRun;
        data.image = {};
        data.table = {};
        generator.run(data);
        return data;
    }

    std::filesystem::path folder = freshFolder("window");
    Workbench workbench;
    Dialogs people;
    QString chosen;
    QStringList told;
    QStringList asked;       ///< titles of the questions
    std::deque<int> answers; ///< to the questions in turn; after the last, and without any:
    int answer = -1;
    bool accept = true;
    std::function<void(QDialog&)> onDialog;
    std::unique_ptr<MainWindow> window;
};

} // namespace smat::gui::test
