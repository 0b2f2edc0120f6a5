// What a pixel is made of, by a click in the window.
#include <cmath>

#include <QApplication>
#include <QClipboard>
#include <QElapsedTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <gtest/gtest.h>

#include "gui/analysis/ResultPage.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageView.h"
#include "irsg/image/ExrFile.h"
#include "irsg/render/rays/RaysBuilt.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class PixelPanelTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        if (!IsSkipped() && !irsg::areRaysBuilt()) {
            GTEST_SKIP() << irsg::whyNoRays();
        }
    }
    ImageView* shownImage() {
        QWidget* page = window->findChild<QTabWidget*>("tabs")->currentWidget();
        if (auto* result = qobject_cast<ResultPage*>(page)) {
            return result->imageView();
        }
        return qobject_cast<ImageView*>(page);
    }
    static bool waitFor(const PixelPanel& panel) {
        return test::waitUntil([&] { return !panel.isBusy(); }, 60.0);
    }
    static void click(ImageView& view, const QPoint& pixel) {
        const QPointF at = view.canvas()->widgetPoint(QPointF(pixel) + QPointF(0.5, 0.5));
        QTest::mouseClick(view.canvas(), Qt::LeftButton, Qt::NoModifier, at.toPoint());
    }
    /// A project of a sample with a small picture, in a folder of the test.
    std::filesystem::path small(const std::string& name) {
        Project project = loadProject(std::filesystem::path(SMAT_SOURCE_DIR) / "samples" / name /
                                      (name + ".smat"));
        for (ProjectModel& model : project.models) {
            model.file = std::filesystem::absolute(project.resolve(model.file));
            model.database = std::filesystem::absolute(project.resolve(model.database));
        }
        project.settings.set("sensor.width", "64");
        project.settings.set("sensor.height", "48");
        const auto file = folder / (name + ".smat");
        saveProject(project, file);
        return file;
    }
};

TEST_F(PixelPanelTest, SaysOfAComputedImageWhatTheCommandSays) {
    ASSERT_TRUE(opens(small("sphere")));
    runAnalysis("image");
    ImageView* view = shownImage();
    ASSERT_NE(view, nullptr);
    auto* button = view->findChild<QToolButton*>("explainPixels");
    ASSERT_TRUE(button->isVisible());
    // Without the button a click explains nothing.
    click(*view, {32, 24});
    EXPECT_FALSE(view->pixelPanel()->answer());
    button->click();
    PixelPanel& panel = *view->pixelPanel();
    ASSERT_TRUE(panel.isVisible());
    ASSERT_TRUE(waitFor(panel));

    QElapsedTimer clock;
    clock.start();
    click(*view, {32, 24});
    ASSERT_TRUE(waitFor(panel));
    ASSERT_TRUE(panel.answer()) << panel.problem().toStdString();
    const ExplainedPixel& answer = *panel.answer();
    EXPECT_EQ(answer.computed.x, 32);
    EXPECT_EQ(answer.computed.y, 24);
    ASSERT_FALSE(answer.computed.surfaces.empty());
    EXPECT_LT(std::abs(answer.relative()), 1e-5);
    EXPECT_EQ(answer.drawn_W_m2_sr, *answer.inImage_W_m2_sr);
    EXPECT_EQ(answer.drawn_W_m2_sr, static_cast<double>(view->image().at(32, 24)));
    RecordProperty("ms", static_cast<int>(clock.elapsed()));

    // Surfaces, background and sum; every number of the terms is in the table.
    auto* tree = panel.findChild<QTreeWidget*>("pixelTerms");
    ASSERT_EQ(tree->topLevelItemCount(), static_cast<int>(answer.computed.surfaces.size()) + 2);
    const auto& terms = answer.computed.surfaces.front().terms;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const auto* row = tree->topLevelItem(0)->child(static_cast<int>(i));
        EXPECT_EQ(row->text(0).toStdString(), terms[i].name);
        EXPECT_EQ(row->text(3), QString::number(terms[i].radiance_W_m2_sr, 'g', 7));
    }
    panel.findChild<QToolButton*>("copyExplanation")->click();
    const QString copied = QApplication::clipboard()->text();
    EXPECT_TRUE(copied.contains("pixel 32,24 (0,0 is the top left)")) << copied.toStdString();
    EXPECT_TRUE(copied.contains("thermal"));
    test::keepScreenshot(*window, "explain-pixel");

    // By keys, and of a corner, where there is background alone.
    view->canvas()->setCursorPixel(QPoint(0, 0));
    QTest::keyClick(view->canvas(), Qt::Key_Return);
    ASSERT_TRUE(waitFor(panel));
    ASSERT_TRUE(panel.answer());
    EXPECT_TRUE(panel.answer()->computed.surfaces.empty());
}

TEST_F(PixelPanelTest, ExplainsAnOpenedImageWhoseProjectIsThereAndSaysElseWhyNot) {
    const auto project = small("sphere");
    ASSERT_TRUE(opens(project));
    runAnalysis("image");
    const auto file = folder / "sphere.exr";
    saveResult(*workbench.results().back().data, file);
    const irsg::RadianceImage image = workbench.results().back().data->image;
    const auto explainFile = [&](const std::filesystem::path& which) {
        chosen = QString::fromStdString(which.string());
        window->findChild<QAction*>("openProject")->trigger();
        auto* tabs = window->findChild<QTabWidget*>("tabs");
        EXPECT_TRUE(test::waitUntil(
            [&] {
                return tabs->tabText(tabs->currentIndex())
                           .contains(QString::fromStdString(which.filename().string())) &&
                       shownImage() != nullptr;
            },
            20.0));
        ImageView* view = shownImage();
        view->findChild<QToolButton*>("explainPixels")->click();
        click(*view, {32, 24});
        EXPECT_TRUE(waitFor(*view->pixelPanel()));
        return view;
    };
    {
        ImageView* view = explainFile(file);
        ASSERT_TRUE(view->pixelPanel()->answer()) << view->pixelPanel()->problem().toStdString();
        EXPECT_EQ(view->pixelPanel()->answer()->drawn_W_m2_sr,
                  static_cast<double>(image.at(32, 24)));
    }
    // Of a project that is nowhere.
    irsg::RadianceImage strange = image;
    strange.attributes["project"] = "elsewhere.smat";
    irsg::writeExr(strange, folder / "strange.exr");
    ImageView* view = explainFile(folder / "strange.exr");
    EXPECT_FALSE(view->pixelPanel()->answer());
    EXPECT_TRUE(view->pixelPanel()->problem().contains("elsewhere.smat"))
        << view->pixelPanel()->problem().toStdString();
}

} // namespace
} // namespace smat::gui
