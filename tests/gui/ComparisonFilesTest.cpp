// Files of a comparison: what is opened, exported and said to smat-batch.
#include <fstream>

#include <QApplication>
#include <QClipboard>
#include <QDropEvent>
#include <QMimeData>
#include <QScrollArea>
#include <QTabWidget>
#include <QToolButton>

#include "gui/plot/PlotLook.h"
#include "irsg/core/Errors.h"
#include "irsg/image/CsvImage.h"
#include "irsg/image/ExrFile.h"
#include "tests/gui/ComparisonFixture.h"

namespace smat::gui {
namespace {

using test::ComparisonTest;

TEST_F(ComparisonTest, ShowsTheCommandBelowTheThresholdsAndCopiesIt) {
    test::keepClipboard();
    window = std::make_unique<ComparisonWindow>(nullptr, people);
    showWindow();
    press(Qt::Key_T);
    const auto* line = window->findChild<QLineEdit*>("commandLine");
    auto* copy = window->findChild<QToolButton*>("copyCommand");
    EXPECT_FALSE(line->isVisible());
    window->setSides(ComparisonSide::of(changed(31, 7, 0.5F), "a.exr"),
                     ComparisonSide::of(scene(), "one's own.exr"));
    EXPECT_TRUE(line->isVisible());
    EXPECT_EQ(line->text(), "smat-batch compare a.exr 'one'\\''s own.exr'");
    type("failAbsolute", "0.25");
    window->panes()->canvas(2)->setSelection(irsg::PixelRectangle{30, 6, 4, 2});
    emit window->panes()->canvas(2)->selectionChanged();
    const QString whole =
        "smat-batch compare a.exr 'one'\\''s own.exr' --fail 0.25 --rectangle 30,6,4,2";
    EXPECT_EQ(line->text(), whole);
    copy->click();
    EXPECT_EQ(QGuiApplication::clipboard()->text(), whole);
    QGuiApplication::clipboard()->clear();
    window->findChild<QAction*>("copyCommandLine")->trigger();
    EXPECT_EQ(QGuiApplication::clipboard()->text(), whole);
    // Below the last threshold; where the window is low they scroll, and are as high as they were.
    for (const QSize& size : {QSize(1200, 860), QSize(900, 620)}) {
        window->resize(size);
        QTest::qWait(30);
        const auto placeOf = [&](const QWidget* widget) {
            return QRect(widget->mapTo(window.get(), QPoint()), widget->size());
        };
        auto* scroll = window->findChild<QScrollArea*>("thresholdsScroll");
        const auto* last = window->findChild<QLineEdit*>("failAllowed");
        EXPECT_GE(last->height(), last->sizeHint().height());
        EXPECT_LE(scroll->widget()->width(), scroll->viewport()->width());
        test::keepScreenshot(*window, "comparison-command-" + std::to_string(size.width()));
        scroll->ensureWidgetVisible(copy);
        EXPECT_GT(placeOf(line).top(), placeOf(last).bottom());
        EXPECT_TRUE(window->rect().contains(placeOf(line)));
        EXPECT_TRUE(window->rect().contains(placeOf(copy)));
    }
}

TEST_F(ComparisonTest, AResultThatIsNotSavedHasNoCommand) {
    const auto image = std::make_shared<const irsg::RadianceImage>(scene());
    window = std::make_unique<ComparisonWindow>(nullptr, people);
    showWindow();
    press(Qt::Key_T);
    window->setSides({image, "1  Image", {}}, {image, "2  Image", "b.exr"});
    EXPECT_EQ(window->commandLine(), "");
    EXPECT_TRUE(text("commandWords").contains("save each result as .exr first"));
    EXPECT_FALSE(window->findChild<QLineEdit*>("commandLine")->isVisible());
    EXPECT_FALSE(window->findChild<QToolButton*>("copyCommand")->isVisible());
    EXPECT_FALSE(window->findChild<QAction*>("copyCommandLine")->isEnabled());
    window->setSides({image, "1  Image", "a.exr"}, {image, "2  Image", "b.exr"});
    EXPECT_EQ(window->findChild<QLineEdit*>("commandLine")->text(),
              "smat-batch compare a.exr b.exr");
    EXPECT_EQ(text("commandWords"), "Equivalent command");
}

TEST_F(ComparisonTest, SwappingTurnsTheSign) {
    open(changed(31, 7, 0.5F), scene());
    press(Qt::Key_S);
    EXPECT_DOUBLE_EQ(window->comparison()->largest.error, -0.5);
    EXPECT_EQ(window->side(0).name, "b.exr");
}

TEST_F(ComparisonTest, OpensFilesByButtonAndByDropAndKeepsWhatThereIs) {
    irsg::writeExr(changed(31, 7, 0.5F), folder / "ours.exr");
    std::string matrix;
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            matrix +=
                std::string(y == 12 && x >= 10 && x < 20 ? "5" : "2") + (x == 39 ? "\n" : ";");
        }
    }
    std::ofstream(folder / "karma.csv") << matrix;
    std::ofstream(folder / "bad.csv") << "1,2\n3,hot\n";

    window = std::make_unique<ComparisonWindow>(nullptr, people);
    showWindow();
    test::keepScreenshot(*window, "comparison-empty");
    chosen = QString::fromStdString((folder / "ours.exr").string());
    window->findChild<QToolButton*>("openA")->click();
    ASSERT_TRUE(settled());
    EXPECT_TRUE(window->panes()->canvas(0)->hasImage());
    chosen = QString::fromStdString((folder / "karma.csv").string());
    window->findChild<QToolButton*>("openB")->click();
    ASSERT_TRUE(settled());
    ASSERT_TRUE(window->comparison());
    EXPECT_EQ(window->comparison()->largest.x, 31);
    EXPECT_DOUBLE_EQ(window->comparison()->largest.error, 0.5);

    chosen = QString::fromStdString((folder / "bad.csv").string());
    window->findChild<QToolButton*>("openA")->click();
    ASSERT_TRUE(settled());
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told[0].contains("line 2"));
    EXPECT_TRUE(window->side(0).name.endsWith("ours.exr"));

    QMimeData files;
    files.setUrls({QUrl::fromLocalFile(QString::fromStdString((folder / "karma.csv").string())),
                   QUrl::fromLocalFile(QString::fromStdString((folder / "ours.exr").string()))});
    QDragEnterEvent enter({20, 20}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window.get(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop({20.0, 20.0}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window.get(), &drop);
    ASSERT_TRUE(settled());
    EXPECT_TRUE(window->side(0).name.endsWith("karma.csv"));
    EXPECT_DOUBLE_EQ(window->comparison()->largest.error, -0.5);
    window->openFiles({"a", "b", "c"});
    EXPECT_EQ(told.size(), 2);
}

TEST_F(ComparisonTest, ExportsTheDifference) {
    test::keepClipboard();
    open(changed(31, 7, 0.5F), scene());
    window->exportTo(folder / "d.exr");
    const auto exr = irsg::readExr(folder / "d.exr");
    EXPECT_EQ(exr.at(31, 7), 0.5F);
    EXPECT_EQ(exr.attributes.at("compare.verdict"), "FAILURE");
    press(Qt::Key_2);
    window->exportTo(folder / "d.csv");
    EXPECT_EQ(irsg::readCsvImage(folder / "d.csv").primary().name, "absolute_difference");
    window->exportTo(folder / "d.png");
    const QImage picture(QString::fromStdString((folder / "d.png").string()));
    EXPECT_TRUE(test::holdsWords(picture, "|A − B| of two images", plotFont(1.1, true)));
    window->copyPicture();
    EXPECT_FALSE(QGuiApplication::clipboard()->image().isNull());
    EXPECT_THROW(window->exportTo("/nowhere/at/all.exr"), irsg::InputError);
}

} // namespace
} // namespace smat::gui
