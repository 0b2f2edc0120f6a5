#pragma once

#include <string>
#include <vector>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTabWidget>
#include <QUndoStack>

#include "gui/atmosphere/AtmospherePage.h"
#include "gui/atmosphere/AtmosphereRecovery.h"
#include "tests/cli/Program.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui::test {

/// A page of the air, edited as a person does.
class AtmosphereFixture : public WindowFixture {
  protected:
    ~AtmosphereFixture() override {
        // What this test has not saved is nothing to ask the next one about.
        window.reset();
        for (const auto& copy : AtmosphereRecovery::leftBehind({})) {
            RecoverySlot::remove(copy);
        }
    }
    AtmospherePage* shownPage() {
        return dynamic_cast<AtmospherePage*>(
            window->findChild<QTabWidget*>("tabs")->currentWidget());
    }
    AtmospherePage* makeNew() {
        window->activateWindow(); // for the keys of the menus
        trigger("newAir");
        return page = shownPage();
    }
    AtmospherePage* openAtmosphereText(const std::string& text) {
        window->activateWindow();
        smat::test::write(folder / "air.xml", text);
        chosen = QString::fromStdString((folder / "air.xml").string());
        trigger("openProject");
        EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
        return page = shownPage();
    }
    void settle() {
        ASSERT_TRUE(waitUntil([&] { return !page->isBusy(); }));
    }
    /// As a person gives a parameter a value.
    void give(const std::string& name, const std::string& value, bool isFinished = true) {
        if (auto* box = page->findChild<QComboBox*>(QString::fromStdString(name))) {
            const int index = box->findData(std::stoi(value));
            ASSERT_GE(index, 0) << name << value;
            box->setCurrentIndex(index);
            emit box->activated(index);
            return;
        }
        auto* field = page->findChild<QLineEdit*>(QString::fromStdString(name));
        ASSERT_NE(field, nullptr) << name;
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QString::fromStdString(value));
        if (isFinished) {
            QTest::keyClick(field, Qt::Key_Return);
        }
    }
    QString shownValue(const std::string& name) {
        if (auto* box = page->findChild<QComboBox*>(QString::fromStdString(name))) {
            return box->currentData().toString();
        }
        return page->findChild<QLineEdit*>(QString::fromStdString(name))->text();
    }
    QString problems() { return page->findChild<QLabel*>("airProblems")->text(); }
    void saveAs(const char* name) {
        chosen = QString::fromStdString((folder / name).string());
        window->findChild<QAction*>("saveProjectAs")->trigger();
    }
    std::string content(const char* name) { return smat::test::contentOf(folder / name); }
    /// What the command line makes of the same assignments.
    std::string ofCommandLine(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--out", "other.xml"});
        const auto ran = smat::test::smatBatch(arguments, folder);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return content("other.xml");
    }
    QUndoStack& steps() { return workbench.undoStack(); }

    AtmospherePage* page = nullptr;
};

} // namespace smat::gui::test
