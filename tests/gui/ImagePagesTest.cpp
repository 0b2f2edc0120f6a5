#include <fstream>

#include <QDropEvent>
#include <QLabel>
#include <QListWidget>
#include <QMimeData>
#include <QTabWidget>

#include "gui/image/ComparisonWindow.h"
#include "gui/image/ImageView.h"
#include "irsg/image/ApparentTemperature.h"
#include "irsg/image/ExrFile.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class ImagePages : public test::WindowFixture {
  protected:
    QString written(const char* name, float value) {
        irsg::RadianceImage image(20, 10);
        for (float& pixel : image.primary().values)
            pixel = value;
        image.attributes["band.name"] = "3-5 um";
        image.attributes["band.min_um"] = "3";
        image.attributes["band.max_um"] = "5";
        irsg::writeExr(image, folder / name);
        return QString::fromStdString((folder / name).string());
    }
    void drop(const QStringList& files) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& file : files)
            urls << QUrl::fromLocalFile(file);
        data.setUrls(urls);
        QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.get(), &enter);
        QDropEvent event({200.0, 200.0}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.get(), &event);
    }
    QTabWidget* tabs() { return window->findChild<QTabWidget*>("tabs"); }
};

TEST_F(ImagePages, TheToolsMenuOpensAComparison) {
    window->findChild<QAction*>("compareImages")->trigger();
    EXPECT_NE(qobject_cast<ComparisonWindow*>(tabs()->currentWidget()), nullptr);
}

TEST_F(ImagePages, TwoDroppedImagesAreComparedAndNameTheirTab) {
    drop({written("one.exr", 2.0F), written("two.exr", 1.0F)});
    auto* page = qobject_cast<ComparisonWindow*>(tabs()->currentWidget());
    ASSERT_NE(page, nullptr);
    ASSERT_TRUE(test::waitUntil([&] { return page->comparison().has_value(); }));
    EXPECT_DOUBLE_EQ(page->comparison()->meanError, 1.0);
    EXPECT_EQ(tabs()->tabText(tabs()->currentIndex()), "one.exr | two.exr");
    test::keepScreenshot(*window, "window-comparison");
    chosen = QString::fromStdString((folder / "difference.exr").string());
    window->findChild<QAction*>("exportShown")->trigger();
    EXPECT_EQ(irsg::readExr(folder / "difference.exr").at(3, 3), 1.0F);
}

TEST_F(ImagePages, TwoResultsThatAreImagesAreCompared) {
    openSample();
    for (int i = 0; i < 2; ++i)
        runAnalysis("image");
    const auto& results = workbench.results();
    ASSERT_EQ(results.size(), 2u);
    auto* page = window->compareResults(results[0].id, results[1].id);
    ASSERT_NE(page, nullptr);
    ASSERT_TRUE(page->comparison());
    EXPECT_EQ(page->comparison()->verdict, irsg::Verdict::pass);
    EXPECT_TRUE(page->comparison()->totalIsIntensity);
    EXPECT_EQ(tabs()->currentWidget(), page);
    EXPECT_EQ(window->compareResults(results[0].id, 4711), nullptr);
    // Large as they may be, neither is copied.
    for (const int i : {0, 1})
        EXPECT_EQ(page->side(i).image.get(), &results[static_cast<std::size_t>(i)].data->image);
}

TEST_F(ImagePages, TheDifferenceOfTwoImageResultsIsAComparison) {
    openSample();
    runAnalysis("image");
    workbench.set("sensor.band", "8-12");
    runAnalysis("image");
    runAnalysis("polar");
    auto* list = window->findChild<QListWidget*>("resultList");
    auto* difference = window->findChild<QAction*>("subtractResultsAction");
    const auto choose = [&](const QList<int>& rows) {
        list->clearSelection();
        for (const int row : rows)
            list->item(row)->setSelected(true);
    };
    choose({0, 2}); // an image and a plot have no difference
    EXPECT_FALSE(difference->isEnabled());
    choose({0});
    EXPECT_FALSE(difference->isEnabled());
    choose({0, 1});
    ASSERT_TRUE(difference->isEnabled());
    difference->trigger();

    auto* page = qobject_cast<ComparisonWindow*>(tabs()->currentWidget());
    ASSERT_NE(page, nullptr);
    const auto& results = workbench.results();
    ASSERT_EQ(results.size(), 3U); // nothing was added to them
    for (const int i : {0, 1}) {
        EXPECT_EQ(page->side(i).name, results[static_cast<std::size_t>(i)].title);
        EXPECT_EQ(page->side(i).image->primary().values,
                  results[static_cast<std::size_t>(i)].data->image.primary().values);
    }
    ASSERT_TRUE(test::waitUntil([&] { return !page->isBusy(); }));
    ASSERT_TRUE(page->comparison());
    EXPECT_NE(page->comparison()->meanError, 0.0);
}

TEST_F(ImagePages, ADroppedImageIsATabWithItsTemperatures) {
    drop({written("one.exr", 2.0F)});
    ASSERT_TRUE(test::waitUntil(
        [&] { return qobject_cast<ImageView*>(tabs()->currentWidget()) != nullptr; }, 10.0));
    auto* view = qobject_cast<ImageView*>(tabs()->currentWidget());
    EXPECT_NE(view->image().find(irsg::apparentTemperatureChannel), nullptr);
    EXPECT_EQ(tabs()->tabText(tabs()->currentIndex()), "one.exr");
}

TEST_F(ImagePages, AnImageThatCannotBeReadIsToldAndOpensNothing) {
    std::ofstream(folder / "bad.exr") << "no image";
    const int before = tabs()->count();
    drop({QString::fromStdString((folder / "bad.exr").string())});
    ASSERT_TRUE(test::waitUntil([&] { return !told.isEmpty(); }, 10.0));
    EXPECT_TRUE(told[0].contains("bad.exr"));
    EXPECT_EQ(tabs()->count(), before);
}

} // namespace
} // namespace smat::gui
