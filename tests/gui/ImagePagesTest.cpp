#include <fstream>

#include <QDropEvent>
#include <QLabel>
#include <QListWidget>
#include <QMimeData>
#include <QRegularExpression>
#include <QTabWidget>

#include "gui/analysis/ResultPage.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/ImageView.h"
#include "irsg/image/ApparentTemperature.h"
#include "irsg/image/ExrFile.h"
#include "irsg/image/ImageFormat.h"
#include "tests/gui/ResultTables.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

/// An image of one plane in a format that is read and not written, as its program writes it.
void writeForeign(const irsg::RadianceImage& image, const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    const std::vector<float>& values = image.primary().values;
    const std::string size = std::to_string(image.width()) + " " + std::to_string(image.height());
    std::filesystem::path bytesFile = file;
    std::string head;
    std::vector<float> stored = values;
    if (extension == ".asc" || extension == ".grd") {
        std::ofstream text(file);
        text << "ncols " << image.width() << "\nnrows " << image.height() << "\n";
        for (const float value : values) {
            text << value << "\n";
        }
        return;
    }
    if (extension == ".pfm") {
        head = "Pf\n" + size + "\n-1\n";
        stored.clear();
        for (int y = image.height() - 1; y >= 0; --y) {
            for (int x = 0; x < image.width(); ++x) {
                stored.push_back(image.at(x, y));
            }
        }
    } else if (extension == ".npy") {
        const std::string dictionary = "{'descr': '<f4', 'fortran_order': False, 'shape': (" +
                                       std::to_string(image.height()) + ", " +
                                       std::to_string(image.width()) + "), }\n";
        head = std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(dictionary.size()) +
               std::string(1, '\0') + dictionary;
    } else {
        std::filesystem::path header = file;
        std::ofstream(header.replace_extension(".hdr"))
            << "ENVI\nsamples = " << image.width() << "\nlines = " << image.height()
            << "\nbands = 1\ndata type = 4\n";
        if (extension == ".hdr") {
            bytesFile.replace_extension(".img");
        }
    }
    std::ofstream(bytesFile, std::ios::binary)
        << head
        << std::string(reinterpret_cast<const char*>(stored.data()), stored.size() * sizeof(float));
}

class ImagePages : public test::WindowFixture {
  protected:
    QString written(const char* name, float value) {
        irsg::RadianceImage image(20, 10);
        for (float& pixel : image.primary().values) {
            pixel = value;
        }
        image.attributes["band.name"] = "3-5 um";
        image.attributes["band.min_um"] = "3";
        image.attributes["band.max_um"] = "5";
        irsg::writeExr(image, folder / name);
        return QString::fromStdString((folder / name).string());
    }
    void drop(const QStringList& files) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& file : files) {
            urls << QUrl::fromLocalFile(file);
        }
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
    for (int i = 0; i < 2; ++i) {
        runAnalysis("image");
    }
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
    for (const int i : {0, 1}) {
        EXPECT_EQ(page->side(i).image.get(), &results[static_cast<std::size_t>(i)].data->image);
    }
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
        for (const int row : rows) {
            list->item(row)->setSelected(true);
        }
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

TEST_F(ImagePages, TwoDroppedTablesOfResultsAreResultsAndOverlaid) {
    const ResultTable range = test::rangeTable(), polar = test::polarTable();
    range.save(folder / "near.csv");
    range.save(folder / "far.csv");
    polar.save(folder / "round.csv");
    const auto at = [this](const char* name) {
        return QString::fromStdString((folder / name).string());
    };
    drop({at("near.csv"), at("far.csv")});
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_TRUE(window->findChildren<ComparisonWindow*>().isEmpty());
    ASSERT_EQ(workbench.results().size(), 2U);
    ASSERT_NE(window->currentPage(), nullptr);
    EXPECT_EQ(window->currentPage()->resultIds(),
              (QList<int>{workbench.results()[0].id, workbench.results()[1].id}));

    // Two that do not go on one plot are shown one by one.
    drop({at("near.csv"), at("round.csv")});
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    ASSERT_EQ(workbench.results().size(), 4U);
    EXPECT_EQ(window->currentPage()->resultIds(), QList<int>{workbench.results()[3].id});
    // An image and a table are each what they are.
    std::ofstream(folder / "matrix.csv") << "1,2,3\n4,5,6\n";
    drop({at("matrix.csv"), at("near.csv")});
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    ASSERT_EQ(workbench.results().size(), 6U);
    EXPECT_TRUE(workbench.results()[4].isImage());
    EXPECT_FALSE(workbench.results()[5].isImage());
}

TEST_F(ImagePages, TwoDroppedMatricesAreComparedWhateverTheirNames) {
    for (const auto& [first, second] :
         {std::pair("a.csv", "b.csv"), {"a.txt", "b.dat"}, {"c.csv", "d.txt"}}) {
        std::ofstream(folder / first) << "1 2 3\n4 5 6\n";
        std::ofstream(folder / second) << "1;2;3\n4;5;8\n";
        drop({QString::fromStdString((folder / first).string()),
              QString::fromStdString((folder / second).string())});
        auto* page = qobject_cast<ComparisonWindow*>(tabs()->currentWidget());
        ASSERT_NE(page, nullptr) << first;
        ASSERT_TRUE(test::waitUntil([&] { return page->comparison().has_value(); }));
        EXPECT_DOUBLE_EQ(page->comparison()->largest.error, -2.0);
    }
}

TEST_F(ImagePages, AComparisonWithoutAReadableFileLeavesNoTab) {
    std::ofstream(folder / "bad.exr") << "no image";
    test::rangeTable().save(folder / "table.csv");
    const int before = tabs()->count();
    window->compareImages({QString::fromStdString((folder / "bad.exr").string()),
                           QString::fromStdString((folder / "table.csv").string())});
    EXPECT_EQ(tabs()->count(), before + 1);
    ASSERT_TRUE(test::waitUntil([&] { return tabs()->count() == before; }, 10.0));
    ASSERT_EQ(told.size(), 2) << told.join('\n').toStdString();
    EXPECT_TRUE(told[0].contains("bad.exr"));
    EXPECT_TRUE(told[1].contains("table.csv, line 1: an image is needed instead of a table of "
                                 "results (columns range [m],"))
        << told[1].toStdString();

    // The one that can be read stays to be compared with another.
    told.clear();
    auto* page = window->compareImages(
        {QString::fromStdString((folder / "bad.exr").string()), written("good.exr", 1.0F)});
    ASSERT_TRUE(test::waitUntil([&] { return !told.isEmpty(); }, 10.0));
    EXPECT_EQ(told.size(), 1);
    QTest::qWait(20);
    EXPECT_EQ(tabs()->currentWidget(), page);
    EXPECT_TRUE(page->side(1).name.endsWith("good.exr"));
    EXPECT_EQ(page->side(0).image, nullptr);
}

TEST_F(ImagePages, FileOpenTakesImagesMatricesResultsAndProjects) {
    std::ofstream(folder / "karma.txt") << "1\t2\t3\n4\t5\t6\n";
    test::rangeTable().save(folder / "range.json");
    const auto open = [this](const std::string& name) {
        chosen = QString::fromStdString((folder / name).string());
        trigger("openProject");
    };
    const auto shown = [this] { return qobject_cast<ImageView*>(tabs()->currentWidget()); };
    open("karma.txt");
    ASSERT_TRUE(test::waitUntil([&] { return shown() != nullptr; }, 10.0));
    EXPECT_EQ(shown()->image().primary().values, (std::vector<float>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(tabs()->tabText(tabs()->currentIndex()), "karma.txt");
    written("one.exr", 2.0F);
    open("one.exr");
    ASSERT_TRUE(test::waitUntil(
        [&] { return tabs()->tabText(tabs()->currentIndex()) == "one.exr"; }, 10.0));
    open("range.json");
    ASSERT_EQ(workbench.results().size(), 1U);
    EXPECT_EQ(window->currentPage()->resultIds(), QList<int>{workbench.results()[0].id});
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();

    std::ofstream(folder / "letter.txt") << "Dear reader,\nthis is none.\n";
    open("letter.txt");
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told[0].contains("letter.txt, line 1")) << told[0].toStdString();
    told.clear();
    openSample();
}

TEST_F(ImagePages, EveryFormatThatIsReadCanBeOpenedDroppedAndNamedAtTheStart) {
    irsg::RadianceImage image(3, 2);
    image.primary().values = {1, 2, 3, 4, 5, 6};
    const auto written = [&](const std::string& stem, const std::string& extension) {
        const auto file = folder / (stem + extension);
        const irsg::ImageFormat* const format = irsg::readableImageFormatOf(file);
        if (format->write != nullptr) {
            format->write(image, file, {});
        } else {
            writeForeign(image, file);
        }
        return QString::fromStdString(file.string());
    };
    const auto seen = [&](const std::string& name) {
        return test::waitUntil(
            [&] {
                const auto* view = qobject_cast<ImageView*>(tabs()->currentWidget());
                return view != nullptr &&
                       view->image().primary().values == image.primary().values &&
                       tabs()->tabText(tabs()->currentIndex()) == QString::fromStdString(name);
            },
            10.0);
    };
    const std::vector<std::string> extensions = irsg::readableImageExtensions();
    ASSERT_GE(extensions.size(), 6U);
    for (const std::string& extension : extensions) {
        // A .csv of its own comes back as a result.
        const std::size_t results = workbench.results().size() + (extension == ".csv" ? 1 : 0);
        const auto isThere = [&](const std::string& stem) {
            return extension == ".csv" ? workbench.results().back().isImage()
                                       : seen(stem + extension);
        };
        chosen = written("chosen", extension);
        trigger("openProject");
        ASSERT_EQ(workbench.results().size(), results) << extension;
        EXPECT_TRUE(isThere("chosen")) << extension;
        if (extension != ".csv") {
            drop({written("dropped", extension)});
            EXPECT_TRUE(isThere("dropped")) << extension;
            EXPECT_TRUE(window->begin(written("argument", extension).toStdString()));
            EXPECT_TRUE(isThere("argument")) << extension;
        }
        drop({written("a", extension), written("b", extension)});
        EXPECT_NE(qobject_cast<ComparisonWindow*>(tabs()->currentWidget()), nullptr) << extension;
        ASSERT_TRUE(told.isEmpty()) << extension << told.join('\n').toStdString();
    }
}

TEST_F(ImagePages, TheDialogOfFileOpenOffersEveryFormatThatIsRead) {
    QStringList offered;
    people.openFile = [&](QWidget*, const QString&, const QStringList& filters) {
        offered = filters;
        return QString();
    };
    window.reset();
    makeWindow();
    trigger("openProject");
    const QString tip = window->findChild<QAction*>("openResultAction")->toolTip();
    for (const std::string& extension : irsg::readableImageExtensions()) {
        const QString text = QString::fromStdString(extension);
        // All, results and images.
        EXPECT_GE(offered.filter(QRegularExpression("\\*\\" + text + "\\b")).size(), 3)
            << extension;
        EXPECT_TRUE(tip.contains(text)) << extension;
    }
}

TEST_F(ImagePages, OfSeveralPartsOrPagesThePersonChoosesOne) {
    const std::string strangers = std::string(SMAT_SOURCE_DIR) + "/tests/data/strangers/";
    QStringList offered;
    people.ask = [&](QWidget*, const QString&, const QString&, const QStringList& answers) {
        offered = answers;
        return 0;
    };
    window.reset();
    makeWindow();
    drop({QString::fromStdString(strangers + "multipart-exr/depth-first.exr")});
    EXPECT_EQ(offered.size(), 2);
    EXPECT_TRUE(offered.join('|').contains("'radiance': Y")) << offered.join('|').toStdString();
    const auto shown = [this] { return qobject_cast<ImageView*>(tabs()->currentWidget()); };
    ASSERT_TRUE(test::waitUntil([&] { return shown() != nullptr; }, 10.0));
    EXPECT_EQ(shown()->image().primary().name, "Z"); // the one that was chosen
    const QString pages = QString::fromStdString(strangers + "multipage-tiff/two.tif");
    drop({pages, QString::fromStdString(strangers + "multipage-tiff/one.tif")});
    EXPECT_TRUE(offered.join('|').contains("page 2")) << offered.join('|').toStdString();
    const auto page = qobject_cast<ComparisonWindow*>(tabs()->currentWidget());
    ASSERT_NE(page, nullptr);
    ASSERT_TRUE(test::waitUntil([&] { return page->comparison().has_value(); }));
    EXPECT_EQ(page->comparison()->meanAbsoluteError, 0.0);
}

TEST_F(ImagePages, AMatrixIsDroppedToBeSeenAndOpenedAsAResult) {
    std::ofstream(folder / "karma.dat") << "1 2 3\n4 5 6\n";
    const QString file = QString::fromStdString((folder / "karma.dat").string());
    drop({file});
    ASSERT_TRUE(test::waitUntil(
        [&] { return qobject_cast<ImageView*>(tabs()->currentWidget()) != nullptr; }, 10.0));
    EXPECT_TRUE(workbench.results().empty());
    chosen = file;
    trigger("openResultAction");
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    ASSERT_EQ(workbench.results().size(), 1U);
    EXPECT_EQ(workbench.results()[0].image()->at(2, 1), 6.0F);
}

TEST_F(ImagePages, AnImageThatCannotBeReadIsToldAndOpensNothing) {
    const int before = tabs()->count();
    for (const char* name : {"bad.exr", "bad.tif"}) {
        told.clear();
        std::ofstream(folder / name) << "no image";
        drop({QString::fromStdString((folder / name).string())});
        ASSERT_TRUE(test::waitUntil([&] { return !told.isEmpty(); }, 10.0)) << name;
        EXPECT_TRUE(told[0].contains(name)) << told[0].toStdString();
        EXPECT_EQ(tabs()->count(), before);
    }
}

} // namespace
} // namespace smat::gui
