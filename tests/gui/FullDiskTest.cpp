#include <map>

#include <QListWidget>

#include "gui/analysis/ResultPage.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/ImageView.h"
#include "gui/view/ModelPage.h"
#include "gui/widgets/Exportable.h"
#include "irsg/core/Errors.h"
#include "smatcore/support/TextFile.h"
#include "tests/gui/ResultTables.h"
#include "tests/gui/SmallDisk.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

const std::string older = "what was there before";

/// Names and contents of all files of a disk, hidden ones as well.
std::map<std::string, std::string> contentsOf(const test::SmallDisk& disk) {
    std::map<std::string, std::string> contents;
    for (const auto& entry : std::filesystem::directory_iterator(disk.place())) {
        contents[entry.path().filename().string()] = readTextFile(entry.path());
    }
    return contents;
}

/// ".exr" of "OpenEXR image (*.exr)".
std::string suffixOf(const QString& filter) {
    return filter.section('*', -1).chopped(1).toStdString();
}

/// That the disk is full, as the system, the terminal or the window calls it.
bool saysWhy(const std::string& sentence) {
    return sentence.find("No space left on device") != std::string::npos ||
           sentence.find("a full disk") != std::string::npos ||
           sentence.find("the disk is full") != std::string::npos;
}

/// What writes a file, on a disk that has no room for it and then on one that has.
class FullDiskTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        if (!disk.isThere()) {
            GTEST_SKIP() << "a small disk can be mounted by root alone";
        }
    }
    /// Every file that a page offers to write.
    void tryAll(const Exportable& page, const std::string& name) {
        const QStringList filters = page.exportFilters();
        ASSERT_FALSE(filters.isEmpty()) << name;
        for (const QString& filter : filters) {
            tryOne(name + suffixOf(filter), [&](const auto& file) { page.exportTo(file); });
        }
    }
    void tryOne(const std::string& name,
                const std::function<void(const std::filesystem::path&)>& write) {
        SCOPED_TRACE(name);
        writeTextFile(disk / name, older);
        disk.fill();
        const auto before = contentsOf(disk);
        try {
            write(disk / name);
            ADD_FAILURE() << "nothing was said";
        } catch (const irsg::InputError& error) {
            EXPECT_EQ(error.diagnostics().size(), 1U);
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
            EXPECT_TRUE(saysWhy(error.what())) << error.what();
        }
        EXPECT_EQ(contentsOf(disk), before);
        disk.empty();
        write(disk / name);
        EXPECT_NE(readTextFile(disk / name), older);
        for (const auto& entry : std::filesystem::directory_iterator(disk.place())) {
            std::filesystem::remove(entry);
        }
    }

    test::SmallDisk disk{"small-disk"};
};

TEST_F(FullDiskTest, LeavesOlderPicturesAndValuesOfImagesWhole) {
    irsg::RadianceImage image(20, 10);
    image.primary().values[7] = 3.0F;
    const auto shared = std::make_shared<const irsg::RadianceImage>(image);
    ImageView view;
    view.setImage(shared);
    tryAll(view, "image");
    irsg::RadianceImage other = image;
    other.primary().values[7] = 2.0F;
    const ComparisonWindow compared({shared, "a", "a"}, ComparisonSide::of(other, "b"));
    tryAll(compared, "difference");
}

TEST_F(FullDiskTest, LeavesOlderPlotsWhole) {
    for (const auto& [name, table] :
         {std::pair("polar", test::polarTable()), {"range", test::rangeTable()}}) {
        AnalysisData data;
        data.table = table;
        ResultEntry entry;
        entry.title = name;
        entry.data = std::make_shared<const AnalysisData>(data);
        tryAll(ResultPage({entry}, people), name);
        ResultEntry second = entry;
        second.id = 2;
        tryAll(ResultPage({entry, second}, people), std::string(name) + "-overlay");
    }
}

TEST_F(FullDiskTest, LeavesOlderPicturesOfTheModelWhole) {
    openSample();
    window->resize(700, 560);
    auto* page = window->findChild<ModelPage*>("modelPage");
    tryAll(*page, "visible");
    page->view()->setDisplay(ViewDisplay::infrared);
    ASSERT_TRUE(test::waitUntil(
        [&] {
            const auto* picture = page->view()->shownPicture();
            return picture != nullptr && !picture->coarse && page->view()->isUpToDate();
        },
        20.0));
    ASSERT_EQ(page->exportFilters().size(), 4);
    // The values may be more than the whole disk holds.
    tryOne("infrared.png", [&](const auto& file) { page->exportTo(file); });
    for (const char* name : {"infrared.exr", "infrared.csv", "infrared.tif"}) {
        writeTextFile(disk / name, older);
        disk.fill();
        const auto before = contentsOf(disk);
        EXPECT_THROW(page->exportTo(disk / name), irsg::InputError) << name;
        EXPECT_EQ(contentsOf(disk), before) << name;
        disk.empty();
    }
}

TEST_F(FullDiskTest, LeavesOlderResultsWholeAndSaysSo) {
    openSample();
    workbench.set("sensor.width", "24");
    workbench.set("sensor.height", "20");
    workbench.set("polar.step", "45");
    auto* list = window->findChild<QListWidget*>("resultList");
    for (const AnalysisKind kind : allAnalysisKinds()) {
        runAnalysis(name(kind).c_str());
        const AnalysisData data = *workbench.results().back().data;
        for (const std::string& extension : resultExtensions(kind)) {
            tryOne(name(kind) + extension, [&](const auto& file) { saveResult(data, file); });
        }
    }
    // By the menu: one sentence, and the file that was there.
    const auto file = disk / "range.csv";
    writeTextFile(file, older);
    disk.fill();
    list->clearSelection();
    list->setCurrentRow(list->count() - 1);
    chosen = QString::fromStdString(file.string());
    if (workbench.results().back().isImage()) {
        chosen.replace(".csv", ".exr");
    }
    trigger("saveResultAction");
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(saysWhy(told.front().toStdString())) << told.front().toStdString();
    EXPECT_EQ(readTextFile(file), older);
}

} // namespace
} // namespace smat::gui
