// What the chapter says of the command and of whole files.
#include "gui/database/DatabaseBanner.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

using irsg::SignatureDatabase;
using irsg::Spectrum;

class SignatureFilesWalkTest : public test::GuideFixture {
  protected:
    void SetUp() override {
        GuideFixture::SetUp();
        if (!IsSkipped()) {
            openCopy("turboprop4", {{"sensor.width", "64"}, {"sensor.height", "48"}});
        }
    }
};

TEST_F(SignatureFilesWalkTest, TheCommandAndWhatItRepairs) {
    test::GuideWalk walk("signature-checks", "");
    for (const char* name : {"ship.flt", "ship.sigdb"}) {
        std::filesystem::copy_file(std::filesystem::path(SMAT_SOURCE_DIR) / "samples/ship" / name,
                                   folder / name);
    }
    walk.note("The editor checks as you type, and so does the command line:");
    terminal("smat-batch project new ship.smat ship.flt");
    for (const char* line : {"smat-batch db lint ship.sigdb the database alone",
                             "smat-batch db lint ship.sigdb --model ship.flt and the codes",
                             "smat-batch db lint ship.sigdb --band 3-5 and the band",
                             "smat-batch db lint ship.sigdb --project ship.smat model, bands"}) {
        walk.step(line);
        const std::string text = line;
        terminal(text.substr(0, std::min({text.find(" the database"), text.find(" and the"),
                                          text.find(" model,")})));
    }
    walk.step("smat-batch db lint ship.sigdb --repair --out repaired.sigdb");
    terminal("smat-batch db lint ship.sigdb --repair --out repaired.sigdb");

    walk.step("Exit codes: 0 nothing found, 1 warnings alone, 2 errors. --json gives every finding "
              "with place, value, reason and repair. A JSON form of a database can be checked");
    SignatureDatabase database = irsg::loadSignatureFile(folder / "ship.sigdb").database;
    auto& first = database.temperatures.begin()->second;
    first.mode = irsg::EmissionMode::temperature;
    first.terms = {};
    first.terms.base_K = 27.0;
    const auto asJson = [&](const char* name) {
        smat::test::write(folder / name, irsg::signatureToJson(database));
    };
    asJson("celsius.json");
    terminal("smat-batch db lint celsius.json", 1);
    const auto json = terminal("smat-batch db lint celsius.json --json", 1);
    for (const char* key : {"\"place\"", "\"value\"", "\"reason\"", "\"re"}) {
        EXPECT_NE(json.out.find(key), std::string::npos) << key << json.out;
    }
    terminal("smat-batch db lint celsius.json --repair --out kelvin.sigdb");
    EXPECT_NEAR(irsg::loadSignatureFile(folder / "kelvin.sigdb")
                    .database.temperatures.begin()
                    ->second.terms.base_K,
                300.15, 1e-9);
    database.materials.begin()->second.emissivity = Spectrum::constant(0.5);
    std::string wrong = irsg::signatureToJson(database);
    const std::string right = "\"emissivity\": 0.5";
    ASSERT_NE(wrong.find(right), std::string::npos);
    smat::test::write(folder / "wrong.json",
                      wrong.replace(wrong.find(right), right.size(), "\"emissivity\": -3"));
    terminal("smat-batch db lint wrong.json", 2);

    walk.step("Errors are physically impossible; a database with one is not saved, and only the "
              "editor opens it, for repair.");
    session().edit("Spoil it", [](SignatureDatabase& value) {
        value.materials.at(1).emissivity = Spectrum::constant(-3.0);
    });
    act("saveDatabase");
    EXPECT_TRUE(session().isDirty());
    EXPECT_NE(irsg::loadSignatureFile(session().file()).database, session().value());
    told.clear();
    workbench.database().discard();
}

TEST_F(SignatureFilesWalkTest, Files) {
    test::GuideWalk walk("signature-checks", "Files");
    const auto file = folder / "turboprop4.sigdb";
    const std::string good = smat::test::contentOf(file);
    session().close();
    const auto says = [&](const std::string& bytes, const char* words) {
        smat::test::write(file, bytes);
        ASSERT_TRUE(opens(folder / "turboprop4.smat"));
        QTest::qWait(20);
        EXPECT_TRUE(dock().banner()->text().contains(words))
            << dock().banner()->text().toStdString();
    };
    walk.step(
        "content changed outside this program | an entry no longer matches its hash: another "
        "program edited it, or the disk did | look at the entries named; --accept-changes takes "
        "them");
    std::string outside = good;
    outside.replace(outside.find("grey paint"), 4, "GREY");
    says(outside, "changed outside this program");
    const auto refused = terminal("smat-batch db lint turboprop4.sigdb", 2);
    EXPECT_NE((refused.out + refused.err).find("changed outside this program"), std::string::npos);
    terminal("smat-batch db lint turboprop4.sigdb --accept-changes");
    get<QPushButton>("acceptChanges", &dock())->click();
    EXPECT_TRUE(session().isOpen());
    session().discard();

    walk.step(
        "another content than was opened here | another window or program saved the file in the "
        "meantime");
    says(good, "");
    auto theirs = session().value();
    theirs.title = "theirs";
    session().edit("title", [](auto& database) { database.title = "mine"; });
    irsg::saveSignatureFile(theirs, file);
    QString question;
    onDialog = [&](QDialog& dialog) {
        for (const auto* label : dialog.findChildren<QLabel*>()) {
            question += label->text();
        }
        dialog.reject();
    };
    accept = false;
    dock().files().save();
    accept = true;
    onDialog = nullptr;
    EXPECT_FALSE(question.isEmpty());
    EXPECT_EQ(irsg::loadSignatureFile(file).database.title, "theirs") << "nothing was lost";
    session().discard();

    // Made by tests of the library, where a disk can be filled and a file locked: what is said of
    // each has the words of the row.
    walk.note("a database that another program has locked | it is being saved, or was left open");
    walk.note("a full disk | the save was undone; the file is as it was");
    walk.note("a file or folder that cannot be written | read-only for you | save elsewhere");
    walk.step("a higher schema version than expected | made by a newer version of this program | "
              "use that one");
    std::string newer = good;
    newer[63] = 99; // in the header of the file
    says(newer, "schema version 99");
    walk.step("an undamaged database is expected | bytes of the file were lost | restore a copy; "
              "smat-batch db export keeps one as text under version control");
    says(good.substr(0, good.size() / 2), "undamaged");
    smat::test::write(file, good);
    terminal("smat-batch db export turboprop4.sigdb copy.json");
    EXPECT_GT(std::filesystem::file_size(folder / "copy.json"), 1000U);
    walk.note("tests/signature/DamagedInputsTest.cpp makes 50 kinds of damage from the samples");
}

} // namespace
} // namespace smat::gui
