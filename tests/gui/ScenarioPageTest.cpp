#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFocusEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QSlider>
#include <QTableWidget>
#include <QToolButton>

#include "gui/image/ColorBar.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageView.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/scenario/PlanView.h"
#include "gui/workbench/RecentFiles.h"
#include "irsg/image/ExrFile.h"
#include "tests/cli/Program.h"
#include "tests/gui/ScenarioFixture.h"

namespace smat::gui {
namespace {

class ScenarioPageTest : public test::ScenarioFixture {
  protected:
    static QString cell(ScenarioPage& page, int row, int column) {
        return page.findChild<QTableWidget*>("entitiesNow")->item(row, column)->text();
    }
    static void press(ScenarioPage& page, Qt::Key key) {
        QTest::keyClick(page.findChild<QSlider*>("timeSlider"), key);
    }
    /// Orders frames of the whole scenario into the folder "frames".
    void beginFrames(ScenarioPage& page) {
        onDialog = [this](QDialog& dialog) {
            dialog.findChild<QLineEdit*>("folder")->setText(
                QString::fromStdString((folder / "frames").string()));
        };
        page.findChild<QToolButton*>("runScenario")->click();
    }
    /// False where they do not come.
    bool writeFrames(ScenarioPage& page) {
        beginFrames(page);
        return test::waitUntil([this] { return !workbench.isRunning(); });
    }
};

TEST_F(ScenarioPageTest, EveryPictureEqualsTheFrameOfSmatBatch) {
    ScenarioPage* page = openScenario();
    ASSERT_NE(page, nullptr);
    const auto ran = smat::test::smatBatch({"simulate", "pass.json", "--out", "out"}, folder);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    int frames = 0;
    for (const std::size_t sensor : {0U, 1U}) {
        page->showSensor(sensor);
        for (std::size_t step = 0; step < page->timeLine().times_s().size(); ++step) {
            page->timeLine().setStep(step);
            ASSERT_TRUE(settles(*page));
            const ScenarioPicture& picture = page->picture();
            ASSERT_EQ(picture.moment.step, step);
            ASSERT_EQ(picture.moment.sensor, sensor);
            ASSERT_NE(picture.image, nullptr);
            char name[40];
            std::snprintf(name, sizeof name, "frame_%06zu.exr", step);
            irsg::RadianceImage ofBatch =
                irsg::readExr(folder / "out" / (sensor == 0 ? "mwir" : "lwir") / name);
            ofBatch.attributes.erase("command");
            const irsg::RadianceImage ofTile = *picture.image;
            irsg::writeExr(ofTile, folder / "window.exr");
            irsg::writeExr(ofBatch, folder / "batch.exr");
            EXPECT_TRUE(smat::test::contentOf(folder / "window.exr") ==
                        smat::test::contentOf(folder / "batch.exr"))
                << name;
            ++frames;
        }
    }
    EXPECT_EQ(frames, 18);
}

TEST_F(ScenarioPageTest, KeysStepAndPlayTheLineOfTime) {
    ScenarioPage* page = openScenario();
    ASSERT_NE(page, nullptr);
    TimeLine& line = page->timeLine();
    press(*page, Qt::Key_Right);
    press(*page, Qt::Key_Right);
    EXPECT_EQ(line.step(), 2U);
    press(*page, Qt::Key_Left);
    EXPECT_EQ(line.step(), 1U);
    press(*page, Qt::Key_End);
    EXPECT_EQ(line.time_s(), 2.0);
    press(*page, Qt::Key_Home);
    EXPECT_EQ(line.step(), 0U);
    page->findChild<QComboBox*>("speed")->setCurrentIndex(1);
    std::vector<std::size_t> seen;
    QObject::connect(&line, &TimeLine::stepChanged, page, [&] { seen.push_back(line.step()); });
    press(*page, Qt::Key_Space);
    EXPECT_TRUE(line.isPlaying());
    QFocusEvent left(QEvent::FocusOut);
    QApplication::sendEvent(page->findChild<QLineEdit*>("time"), &left);
    EXPECT_TRUE(line.isPlaying()) << "nobody wrote into the field of time";
    ASSERT_TRUE(test::waitUntil([&] { return !line.isPlaying(); }));
    EXPECT_EQ(seen, (std::vector<std::size_t>{1, 2, 3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(page->picture().moment.step, 8U);
    // In real time it takes as long as the scenario, whatever the number of pictures.
    page->findChild<QComboBox*>("speed")->setCurrentIndex(0);
    QElapsedTimer clock;
    clock.start();
    page->findChild<QToolButton*>("play")->click();
    ASSERT_TRUE(test::waitUntil([&] { return !line.isPlaying(); }));
    EXPECT_EQ(line.step(), 8U);
    EXPECT_GE(clock.elapsed(), 1990);
}

TEST_F(ScenarioPageTest, TheTableFollowsTheTime) {
    ScenarioPage* page = openScenario();
    ASSERT_NE(page, nullptr);
    EXPECT_EQ(cell(*page, 0, 0), "mover");
    EXPECT_EQ(cell(*page, 0, 5), "0.2");
    press(*page, Qt::Key_End);
    ASSERT_TRUE(settles(*page));
    EXPECT_EQ(cell(*page, 0, 5), "1");
    EXPECT_EQ(cell(*page, 0, 7), "52");
    EXPECT_NEAR(cell(*page, 0, 1).toDouble(), 100.2, 0.1);
    EXPECT_GT(cell(*page, 0, 2).section(' ', 0, 0).toDouble(), 0.0);
    EXPECT_GT(cell(*page, 1, 4).toDouble(), 1.0);
}

TEST_F(ScenarioPageTest, ScrubbingShowsTheLastStepAndBlocksNothing) {
    ScenarioPage* page = openScenario();
    ASSERT_NE(page, nullptr);
    int drawn = 0;
    auto* pictures = page->findChild<ScenarioPictures*>();
    QObject::connect(pictures, &ScenarioPictures::drawn, page, [&] { ++drawn; });
    auto* slider = page->findChild<QSlider*>("timeSlider");
    for (int round = 0; round < 20; ++round) {
        slider->setValue(round % 2 == 0 ? 8 : 3);
    }
    ASSERT_TRUE(settles(*page));
    EXPECT_EQ(page->picture().moment.step, 3U);
    EXPECT_LE(drawn, 3); // the one under way and the last
}

TEST_F(ScenarioPageTest, AScenarioIsRememberedAndOpenedOnce) {
    ScenarioPage* page = openScenario();
    ASSERT_NE(page, nullptr);
    EXPECT_EQ(recentFiles().front(), QString::fromStdString((folder / "pass.json").string()));
    trigger("openProject");
    EXPECT_EQ(shownPage(), page);
    EXPECT_EQ(window->findChildren<ScenarioPage*>().size(), 1);
    // A fault is told with its place, and nothing is opened.
    write("bad.json", R"({"version": 1, "dt_s": 1, "end_s": "x", "entities": [], "sensors": []})");
    chosen = QString::fromStdString((folder / "bad.json").string());
    trigger("openProject");
    EXPECT_TRUE(told.join('\n').contains("end_s")) << told.join('\n').toStdString();
    EXPECT_EQ(window->findChildren<ScenarioPage*>().size(), 1);
}

TEST_F(ScenarioPageTest, TheSampleOpensFromTheStartPageWithItsColours) {
    window->findChild<QToolButton*>("sample-flyby")->click();
    ScenarioPage* page = shownPage();
    ASSERT_NE(page, nullptr);
    page->timeLine().setStep(10);
    ASSERT_TRUE(settles(*page));
    ASSERT_NE(page->picture().image, nullptr);
    EXPECT_EQ(page->imageView().colorMap().name(), "ironbow");
    EXPECT_EQ(page->imageView().colorBar()->limits().low, 0.8);
    EXPECT_EQ(page->imageView().colorBar()->limits().high, 3.0);
    test::keepScreenshot(*window, "scenario");
    page->findChild<QTabWidget*>("scenarioPanels")->setCurrentIndex(1);
    QTest::qWait(50);
    test::keepScreenshot(*window, "scenario-plan");
    page->showSensor(1);
    ASSERT_TRUE(settles(*page));
    EXPECT_EQ(page->imageView().colorBar()->limits().high, 36.0);
    window->resize(1900, 1000);
    QTest::qWait(100);
    test::keepScreenshot(*window, "scenario-wide");
}

/// All files below a folder, by their names in it.
std::map<std::string, std::string> filesIn(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files[entry.path().lexically_relative(folder).string()] =
                smat::test::contentOf(entry.path());
        }
    }
    return files;
}

TEST_F(ScenarioPageTest, WhatTheWindowWritesEqualsSmatBatchByteForByte) {
    ScenarioPage* page = openScenario();
    ASSERT_NE(page, nullptr);
    const std::filesystem::path out = folder / "frames";
    std::string command;
    onDialog = [&](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("folder")->setText(QString::fromStdString(out.string()));
        dialog.findChild<QCheckBox*>("form.png")->setChecked(true);
        dialog.findChild<QCheckBox*>("form.tif")->setChecked(true);
        command = dialog.findChild<QLineEdit*>("commandLine")->text().toStdString();
        test::keepScreenshot(dialog, "scenario-run");
    };
    page->findChild<QToolButton*>("runScenario")->click();
    ASSERT_TRUE(test::waitUntil([&] { return !workbench.isRunning(); }));
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    const auto ofTile = filesIn(out);
    std::filesystem::remove_all(out);
    std::istringstream words(command);
    std::vector<std::string> arguments;
    for (std::string word; words >> word;) {
        arguments.push_back(word);
    }
    arguments.erase(arguments.begin());
    const auto ran = smat::test::smatBatch(arguments, folder);
    ASSERT_EQ(ran.exitCode, 0) << command << ran.err;
    const auto ofBatch = filesIn(out);
    EXPECT_EQ(ofBatch.size(), 2U * (9U * 3U + 2U));
    ASSERT_EQ(ofTile.size(), ofBatch.size());
    for (const auto& [name, content] : ofBatch) {
        EXPECT_TRUE(ofTile.at(name) == content) << name;
    }
}

TEST_F(ScenarioPageTest, AFilmStripShowsTheFramesAndACurveTheTable) {
    ScenarioPage* page = openScenario();
    ASSERT_NE(page, nullptr);
    ASSERT_TRUE(writeFrames(*page));
    auto* strip = page->findChild<QListWidget*>("filmStrip");
    ASSERT_EQ(strip->count(), 9);
    EXPECT_EQ(strip->item(3)->text(), "0.75 s");
    strip->setCurrentRow(6);
    ASSERT_TRUE(settles(*page));
    EXPECT_EQ(page->picture().moment.step, 6U);
    auto* plot = page->findChild<CartesianPlot*>();
    // All of it is in sight in a window of 1360 x 840.
    QTest::qWait(50);
    EXPECT_GE(plot->visibleRegion().boundingRect().height(), plot->height());
    EXPECT_GE(plot->height(), 120);
    EXPECT_EQ(strip->viewport()->visibleRegion().boundingRect(), strip->viewport()->rect());
    // The picture that is chosen has the colours of the others.
    const QIcon thumbnail = strip->item(6)->icon();
    EXPECT_EQ(thumbnail.pixmap(112, 84, QIcon::Selected).toImage(),
              thumbnail.pixmap(112, 84, QIcon::Normal).toImage());
    ASSERT_EQ(plot->data().curves.size(), 2U);
    EXPECT_EQ(plot->data().curves.front().x.size(), 9U);
    EXPECT_EQ(plot->data().curves.front().x.back(), 2.0);
    test::keepScreenshot(*window, "scenario-frames");
    // The other sensor has a strip and curves of its own.
    const double first = plot->data().curves.front().y[4];
    page->showSensor(1);
    EXPECT_EQ(strip->count(), 9);
    EXPECT_NE(plot->data().curves.front().y[4], first);
}

TEST_F(ScenarioPageTest, AFilmOfTheFramesIsThatOfSmatBatch) {
    ScenarioPage* page = openScenario();
    ASSERT_NE(page, nullptr);
    auto* film = page->findChild<QToolButton*>("exportFilm");
    EXPECT_FALSE(film->isVisible());
    ASSERT_TRUE(writeFrames(*page));
    ASSERT_TRUE(film->isVisible());
    // Without ffmpeg only numbered pictures are offered, and the others say why not.
    const QByteArray path = qgetenv("PATH");
    const auto offered = [&](const char* name) {
        emit film->menu()->aboutToShow();
        return film->menu()->findChild<QAction*>(name);
    };
    std::filesystem::create_directories(folder / "bin");
    qputenv("PATH", QByteArray::fromStdString((folder / "bin").string()));
    EXPECT_FALSE(offered("filmMp4")->isEnabled());
    EXPECT_TRUE(offered("filmGif")->text().contains("needs the program ffmpeg"));
    EXPECT_TRUE(offered("filmPng")->isEnabled());
    // With one (it stands for ffmpeg) there are films.
    write("bin/ffmpeg", "#!/bin/sh\nfor film; do :; done\ncat \"$(dirname \"$film\")\"/0*.png > "
                        "\"$film\"\n");
    std::filesystem::permissions(folder / "bin/ffmpeg", std::filesystem::perms::owner_all);
    qputenv("PATH", QByteArray::fromStdString((folder / "bin").string()) + ":" + path);
    const auto* words = page->findChild<QLabel*>("framesWords");
    const auto exported = [&](const char* name, const char* file, const char* wrote) {
        chosen = QString::fromStdString((folder / file).string());
        offered(name)->trigger();
        EXPECT_FALSE(film->isEnabled());
        EXPECT_TRUE(test::waitUntil([&] { return film->isEnabled(); }));
        EXPECT_TRUE(words->text().contains(wrote)) << words->text().toStdString();
    };
    exported("filmMp4", "own", "Wrote the film"); // the extension is added
    page->showSensor(1);
    exported("filmPng", "own.png", "Wrote the pictures");
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    test::keepScreenshot(*window, "scenario-film");
    const auto ran = smat::test::smatBatch(
        {"simulate", "pass.json", "--out", "out", "--sensor", "mwir", "--film", "batch.mp4"},
        folder);
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_GT(smat::test::contentOf(folder / "batch.mp4").size(), 1000U);
    EXPECT_TRUE(smat::test::contentOf(folder / "batch.mp4") ==
                smat::test::contentOf(folder / "own.mp4"));
    EXPECT_TRUE(std::filesystem::exists(folder / "own-000008.png"));
    // What ffmpeg refuses is told with its own words.
    write("bin/ffmpeg", "#!/bin/sh\necho 'no such encoder' >&2\nexit 1\n");
    chosen = QString::fromStdString((folder / "other.gif").string());
    offered("filmGif")->trigger();
    EXPECT_TRUE(test::waitUntil([&] { return film->isEnabled(); }));
    EXPECT_TRUE(told.join('\n').contains("no such encoder")) << told.join('\n').toStdString();
    qputenv("PATH", path);
}

TEST_F(ScenarioPageTest, AFilmTellsHowFarItIsAndCanBeCancelled) {
    ScenarioPage* page = openScenario();
    ASSERT_NE(page, nullptr);
    ASSERT_TRUE(writeFrames(*page));
    // What stands for ffmpeg has begun when it says so, and never ends.
    const QByteArray path = qgetenv("PATH");
    std::filesystem::create_directories(folder / "bin");
    write("bin/ffmpeg",
          "#!/bin/sh\ntouch '" + (folder / "begun").string() + "'\nexec sleep 1000\n");
    std::filesystem::permissions(folder / "bin/ffmpeg", std::filesystem::perms::owner_all);
    qputenv("PATH", QByteArray::fromStdString((folder / "bin").string()) + ":" + path);
    auto* film = page->findChild<QToolButton*>("exportFilm");
    emit film->menu()->aboutToShow();
    chosen = QString::fromStdString((folder / "own.mp4").string());
    std::vector<std::string> told;
    QObject::connect(&workbench, &Workbench::jobProgressed, page,
                     [&](const Progress& now) { told.push_back(now.what); });
    film->menu()->findChild<QAction*>("filmMp4")->trigger();
    ASSERT_TRUE(test::waitUntil([&] { return std::filesystem::exists(folder / "begun"); }));
    auto* bar = window->findChild<QWidget*>("jobBar");
    ASSERT_TRUE(test::waitUntil([&] { return !told.empty() && told.back() == "mwir: encoding"; }));
    EXPECT_TRUE(bar->isVisible());
    EXPECT_EQ(bar->findChild<QLabel*>("jobTitle")->text(), "Film: own.mp4");
    EXPECT_EQ(told.front(), "mwir: frame 1 of 9");
    EXPECT_FALSE(film->isEnabled());
    test::keepScreenshot(*window, "scenario-film-progress");
    bar->findChild<QToolButton*>("cancelJob")->click();
    EXPECT_TRUE(test::waitUntil([&] { return film->isEnabled(); }));
    EXPECT_TRUE(test::waitUntil([&] { return !workbench.jobs().isWorking(); }));
    EXPECT_FALSE(bar->isVisible());
    EXPECT_FALSE(std::filesystem::exists(folder / "own.mp4"));
    EXPECT_TRUE(
        page->findChild<QLabel*>("framesWords")->text().contains("no film, since it was stopped"))
        << page->findChild<QLabel*>("framesWords")->text().toStdString();
    EXPECT_TRUE(this->told.isEmpty()) << this->told.join('\n').toStdString();
    qputenv("PATH", path);
}

TEST_F(ScenarioPageTest, ACancelledRunKeepsItsFrames) {
    ScenarioPage* page = openScenario();
    ASSERT_NE(page, nullptr);
    beginFrames(*page);
    const auto frame = [&](int number) {
        return folder / "frames/lwir" / ("frame_00000" + std::to_string(number) + ".exr");
    };
    ASSERT_TRUE(test::waitUntil([&] { return std::filesystem::exists(frame(1)); }));
    workbench.cancel();
    ASSERT_TRUE(test::waitUntil([&] { return !workbench.jobs().isWorking(); }));
    QTest::qWait(50);
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_FALSE(std::filesystem::exists(frame(8)));
    EXPECT_NE(smat::test::contentOf(folder / "frames/lwir.csv").find("# state: partial"),
              std::string::npos);
    const auto* strip = page->findChild<QListWidget*>("filmStrip");
    EXPECT_GE(strip->count(), 2);
    EXPECT_LT(strip->count(), 9);
}

} // namespace
} // namespace smat::gui
