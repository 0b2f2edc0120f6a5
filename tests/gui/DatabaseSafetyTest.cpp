#include <fstream>

#include <QLabel>
#include <QPushButton>
#include <gtest/gtest.h>

#include "gui/database/DatabaseBanner.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/ScalingXml.h"
#include "tests/gui/DatabaseFixture.h"

namespace smat::gui {
namespace {

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Nothing is lost, whatever becomes of the file of the database that the window edits.
class DatabaseSafetyTest : public test::DatabaseFixture {
  protected:
    void SetUp() override {
        DatabaseFixture::SetUp();
        if (!IsSkipped()) {
            openCopy("turboprop4", {{"sensor.width", "64"},
                                    {"sensor.height", "48"},
                                    {"sensor.fov", "3"},
                                    {"camera.range", "900"},
                                    {"target.altitude", "1500"},
                                    {"render.antialiasing", "0"}});
        }
    }
};

TEST_F(DatabaseSafetyTest, TellsWhatCannotBeOpenedAndOffersWhatCanBeDone) {
    const auto file = session().file();
    session().close();
    const std::string good = bytesOf(file);
    std::string newer = good;
    newer[63] = 99; // the schema's version, in the header
    std::string outside = good;
    const auto name = outside.find("grey paint");
    ASSERT_NE(name, std::string::npos);
    outside.replace(name, 4, "GREY");
    const struct {
        const char* damage;
        std::string bytes;
        const char* said;
        bool acceptable;
    } rows[] = {{"newer", newer, "schema version 99", false},
                {"cut", good.substr(0, good.size() / 2), "undamaged", false},
                {"text", "no database at all", "SQLite", false},
                {"outside", outside, "changed outside this program", true}};
    for (const auto& row : rows) {
        std::ofstream(file, std::ios::binary) << row.bytes;
        ASSERT_TRUE(opens(folder / "turboprop4.smat")) << row.damage;
        QTest::qWait(20);
        EXPECT_FALSE(session().isOpen()) << row.damage;
        const QString text = dock().banner()->text();
        EXPECT_TRUE(text.contains(row.said)) << row.damage << ": " << text.toStdString();
        EXPECT_NE(find<QPushButton>("newDatabase"), nullptr);
        EXPECT_NE(find<QPushButton>("chooseDatabase"), nullptr);
        EXPECT_EQ(dock().findChild<QPushButton*>("acceptChanges") != nullptr, row.acceptable)
            << row.damage;
        EXPECT_EQ(bytesOf(file), row.bytes) << row.damage << ": looking changes nothing";
        test::keepScreenshot(*window, std::string("editor-refused-") + row.damage);
    }
    // What another program changed can be taken as it is.
    find<QPushButton>("acceptChanges")->click();
    ASSERT_TRUE(session().isOpen());
    EXPECT_TRUE(session().isDirty()) << "its hashes are those of before";
    dock().files().save();
    EXPECT_EQ(irsg::loadSignatureFile(file).database, session().value());
    told.clear();

    std::filesystem::remove(file);
    session().discard();
    ASSERT_TRUE(opens(folder / "turboprop4.smat"));
    EXPECT_FALSE(session().isOpen());
    EXPECT_TRUE(dock().banner()->text().contains("file not found"))
        << dock().banner()->text().toStdString();
    EXPECT_NE(find<QPushButton>("newDatabase"), nullptr);
    test::keepScreenshot(*window, "editor-missing");
}

TEST_F(DatabaseSafetyTest, OpensAnotherDatabaseThatHasToBeRepaired) {
    const auto own = session().value();
    // What cannot be read changes nothing.
    std::ofstream(folder / "text.sigdb") << "no database";
    chosen = QString::fromStdString((folder / "text.sigdb").string());
    trigger("openDatabase");
    EXPECT_FALSE(told.isEmpty());
    told.clear();
    EXPECT_EQ(session().value(), own);
    // Another program has changed a name: a person is asked.
    std::string bytes = bytesOf(folder / "turboprop4.sigdb");
    const auto name = bytes.find("grey paint");
    ASSERT_NE(name, std::string::npos);
    bytes.replace(name, 4, "GREY");
    std::ofstream(folder / "outside.sigdb", std::ios::binary) << bytes;
    chosen = QString::fromStdString((folder / "outside.sigdb").string());
    trigger("openDatabase");
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_FALSE(session().isOpen());
    find<QPushButton>("acceptChanges")->click();
    ASSERT_TRUE(session().isOpen());
    EXPECT_EQ(session().file(), folder / "outside.sigdb");
    session().discard();
    workbench.undoStack().undo();
    EXPECT_EQ(session().value(), own);
}

TEST_F(DatabaseSafetyTest, EverySaveWritesTheScalingFilesThatAreNotThere) {
    const auto model = folder / "turboprop4.flt";
    const auto temperatures = irsg::scalingFile(model, irsg::ScalingKind::temperature);
    const auto emissivities = irsg::scalingFile(model, irsg::ScalingKind::emissivity);
    std::filesystem::remove(temperatures);
    std::filesystem::remove(emissivities);
    const auto edit = [this](const char* title) {
        session().edit("title", [&](auto& database) { database.title = title; });
    };
    edit("first");
    EXPECT_FALSE(std::filesystem::exists(temperatures)) << "not before it is saved";
    dock().files().save();
    ASSERT_TRUE(std::filesystem::exists(temperatures));
    ASSERT_TRUE(std::filesystem::exists(emissivities));
    EXPECT_EQ(irsg::readScalingFile(temperatures, irsg::ScalingKind::temperature).size(),
              session().value().temperatures.size());

    // A person writes one, and the other is lost.
    std::ofstream(temperatures, std::ios::app) << "<!-- mine -->\n";
    const std::string mine = bytesOf(temperatures);
    std::filesystem::remove(emissivities);
    chosen = QString::fromStdString((folder / "as.sigdb").string());
    trigger("saveDatabaseAs");
    EXPECT_TRUE(std::filesystem::exists(emissivities)) << "saved under another name";
    EXPECT_EQ(bytesOf(temperatures), mine);

    std::filesystem::remove(emissivities);
    auto theirs = session().value();
    theirs.title = "theirs";
    edit("mine");
    irsg::saveSignatureFile(theirs, folder / "as.sigdb");
    onDialog = [](QDialog& dialog) { dialog.findChild<QPushButton*>("answer0")->click(); };
    dock().files().save();
    onDialog = nullptr;
    EXPECT_EQ(irsg::loadSignatureFile(folder / "as.sigdb").database.title, "mine");
    EXPECT_TRUE(std::filesystem::exists(emissivities)) << "saved over another's";
    EXPECT_EQ(bytesOf(temperatures), mine);
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

TEST_F(DatabaseSafetyTest, OffersTheEditsThatAWindowLeft) {
    chooseTab("temperatureTabs", "Equation terms");
    session().edit("x", [](auto& d) { d.title = "left behind"; });
    session().writeRecoveryNow();
    const auto copy = folder / "copy";
    const auto recovery = session().recoveryFile();
    std::filesystem::copy_file(recovery, copy);
    session().discard();
    std::filesystem::copy_file(copy, recovery);
    ASSERT_TRUE(opens(folder / "turboprop4.smat"));
    QTest::qWait(20);
    EXPECT_TRUE(dock().banner()->isVisible());
    test::keepScreenshot(*window, "editor-recovery");
    find<QPushButton>("recover")->click();
    EXPECT_EQ(session().value().title, "left behind");
    EXPECT_FALSE(dock().banner()->isVisible());
}

TEST_F(DatabaseSafetyTest, AsksBeforeUnsavedEditsAreLost) {
    session().edit("x", [](auto& d) { d.title = "edited"; });
    accept = false;
    EXPECT_FALSE(dock().files().mayClose());
    EXPECT_EQ(session().value().title, "edited");
    accept = true;
    onDialog = [](QDialog& dialog) {
        test::keepScreenshot(dialog, "editor-unsaved");
        dialog.findChild<QPushButton*>("answer1")->click();
    };
    EXPECT_TRUE(dock().files().mayClose());
    EXPECT_FALSE(session().isDirty());
    EXPECT_NE(session().value().title, "edited");
    onDialog = nullptr;
}

TEST_F(DatabaseSafetyTest, AsksWhoseVersionStaysWhereAnotherProgramSaved) {
    const auto file = folder / "turboprop4.sigdb";
    auto theirs = session().value();
    theirs.title = "theirs";
    const auto mine = [this](const char* title) {
        session().edit("title", [&](auto& database) { database.title = title; });
    };
    QString question;
    int answer = 0;
    const auto answers = [&](QDialog& dialog) {
        for (const auto* label : dialog.findChildren<QLabel*>()) {
            question += label->text() + " ";
        }
        dialog.findChild<QPushButton*>(QString("answer%1").arg(answer))->click();
    };

    // A person who wants to think about it loses nothing.
    mine("mine");
    irsg::saveSignatureFile(theirs, file);
    accept = false;
    onDialog = [](QDialog&) {};
    dock().files().save();
    EXPECT_EQ(session().value().title, "mine");
    EXPECT_TRUE(session().isDirty());
    EXPECT_EQ(irsg::loadSignatureFile(file).database, theirs);

    accept = true;
    onDialog = answers;
    answer = 0;
    dock().files().save();
    EXPECT_TRUE(question.contains("Another program has changed this file"))
        << question.toStdString();
    EXPECT_EQ(irsg::loadSignatureFile(file).database.title, "mine");
    EXPECT_FALSE(session().isDirty());

    mine("mine again");
    irsg::saveSignatureFile(theirs, file);
    answer = 1;
    dock().files().save();
    EXPECT_EQ(session().value(), theirs);
    EXPECT_EQ(irsg::loadSignatureFile(file).database, theirs);
    EXPECT_FALSE(session().isDirty());
    onDialog = nullptr;
}

} // namespace
} // namespace smat::gui
