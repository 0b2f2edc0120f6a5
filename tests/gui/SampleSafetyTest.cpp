#include <map>

#include <QPushButton>
#include <QToolButton>

#include "gui/database/DatabaseDock.h"
#include "gui/project/ProjectFiles.h"
#include "gui/start/DataFolder.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

namespace fs = std::filesystem;

/// The window of a program whose samples lie in a folder of this test.
class SampleSafetyTest : public test::WindowFixture {
  protected:
    SampleSafetyTest() {
        fs::create_directories(data / "samples");
        fs::copy(fs::path(SMAT_SOURCE_DIR) / "samples/ship", data / "samples/ship",
                 fs::copy_options::recursive);
        // A save writes them beside the model where they are absent.
        fs::remove(data / "samples/ship/ship(temperaturesScalings).xml");
        fs::remove(data / "samples/ship/ship(emissivitiesScalings).xml");
        qputenv("SMAT_DATA", data.string().c_str());
        makeWindow();
        before = contents();
    }
    ~SampleSafetyTest() override { qunsetenv("SMAT_DATA"); }
    void openIt() {
        ASSERT_TRUE(opens(data / "samples/ship/ship.smat"));
        ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    }
    std::map<std::string, std::string> contents() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(data)) {
            all[entry.path().string()] =
                entry.is_regular_file() ? irsg::readFile(entry.path()) : std::string();
        }
        return all;
    }
    void expectUntouched() const {
        const auto now = contents();
        for (const auto& [file, bytes] : now) {
            ASSERT_TRUE(before.contains(file)) << file << " is new";
            EXPECT_TRUE(before.at(file) == bytes) << file << " was changed";
        }
        EXPECT_EQ(now.size(), before.size());
    }

    fs::path data = test::freshFolder("sample-data");
    std::map<std::string, std::string> before;
};

TEST_F(SampleSafetyTest, SavingASampleAsksForAPlace) {
    openIt();
    workbench.set("camera.azimuth", "7");
    chosen.clear();
    trigger("saveProject");
    EXPECT_TRUE(workbench.isModified()) << "nobody named a place";
    expectUntouched();

    chosen = QString::fromStdString((folder / "mine.smat").string());
    trigger("saveProject");
    EXPECT_FALSE(workbench.isModified());
    EXPECT_EQ(workbench.project().file, folder / "mine.smat");
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    expectUntouched();
    // It finds its model from there, and is a project like any other.
    makeWindow();
    ASSERT_TRUE(opens(folder / "mine.smat"));
    EXPECT_EQ(workbench.settings().text("camera.azimuth"), "7");
    workbench.set("camera.azimuth", "8");
    chosen.clear();
    trigger("saveProject");
    EXPECT_FALSE(workbench.isModified());
}

TEST_F(SampleSafetyTest, APlaceAmongTheSamplesIsRefused) {
    openIt();
    workbench.set("camera.azimuth", "7");
    for (const char* name : {"ship.smat", "other.smat"}) {
        told.clear();
        chosen = QString::fromStdString((data / "samples/ship" / name).string());
        trigger("saveProjectAs");
        EXPECT_TRUE(told.join(' ').contains("samples")) << told.join('\n').toStdString();
    }
    EXPECT_TRUE(workbench.isModified());
    expectUntouched();
}

TEST_F(SampleSafetyTest, SavingTheDatabaseOfASampleAsksForAPlaceAndTheProjectTakesIt) {
    openIt();
    const int index = workbench.database().value().temperatures.begin()->first;
    workbench.database().edit("Rename", [&](irsg::SignatureDatabase& database) {
        database.temperatures.at(index).name = "deck of mine";
    });
    workbench.database().writeRecoveryNow();
    EXPECT_TRUE(workbench.database().recoveryProblem().isEmpty())
        << workbench.database().recoveryProblem().toStdString();
    expectUntouched();
    chosen.clear();
    trigger("saveDatabase");
    EXPECT_TRUE(workbench.database().isDirty());
    chosen = QString::fromStdString((folder / "mine.sigdb").string());
    trigger("saveDatabase");
    EXPECT_FALSE(workbench.database().isDirty());
    EXPECT_EQ(workbench.database().file(), folder / "mine.sigdb");
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    expectUntouched();
}

TEST_F(SampleSafetyTest, NoWriterOfTheWindowTouchesThem) {
    openIt();
    trigger("monteCarlo");
    QTest::qWait(30);
    auto* write = window->findChild<QPushButton*>("writeScalingFiles");
    ASSERT_NE(write, nullptr);
    write->click();
    EXPECT_TRUE(told.join(' ').contains("belongs to the samples") &&
                told.join(' ').contains("Save project as"))
        << told.join('\n').toStdString();
    expectUntouched();
    // One rule for whatever writes.
    for (const char* name : {"new.csv", "ship.flt", "ship(temperaturesScalings).xml"}) {
        const fs::path file = data / "samples/ship" / name;
        EXPECT_THROW(irsg::writeFileDurably(file, "x"), irsg::InputError) << name;
        EXPECT_THROW(irsg::checkWritable(file), irsg::InputError) << name;
    }
    expectUntouched();
    irsg::writeFileDurably(folder / "own.csv", "x");
    EXPECT_EQ(irsg::readFile(folder / "own.csv"), "x");
}

TEST_F(SampleSafetyTest, WhatACrashLeavesOfASampleIsOfferedWithIt) {
    openIt();
    workbench.set("camera.azimuth", "7");
    window->files().recovery().writeNow();
    expectUntouched();
    const fs::path copy = RecoveryCopy::pathFor(workbench.project().file);
    ASSERT_TRUE(fs::exists(copy)) << copy;
    const fs::path kept = folder / "kept";
    fs::copy_file(copy, kept);
    answer = 1;
    ASSERT_TRUE(window->close());
    window.reset();
    fs::copy_file(kept, copy, fs::copy_options::overwrite_existing);

    makeWindow();
    asked.clear();
    answers = {1, 0}; // gives up what this window still has, and takes the copy
    ASSERT_TRUE(opens(data / "samples/ship/ship.smat"));
    EXPECT_EQ(asked.back(), "Recover unsaved changes");
    EXPECT_EQ(workbench.settings().text("camera.azimuth"), "7");
    EXPECT_EQ(workbench.project().file, data / "samples/ship/ship.smat");
    EXPECT_TRUE(fs::exists(workbench.project().resolve(workbench.project().models.front().file)));
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    expectUntouched();
}

} // namespace
} // namespace smat::gui
