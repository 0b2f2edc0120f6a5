#include "gui/database/DatabaseSession.h"

#include <csignal>
#include <fstream>

#include <sys/resource.h>

#include <QUndoStack>
#include <gtest/gtest.h>

#include "gui/database/DatabaseEdits.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/MaterialLibrary.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/SampleProject.h"

namespace smat::gui {
namespace {

namespace fs = std::filesystem;

class DatabaseSessionTest : public ::testing::Test {
  protected:
    DatabaseSessionTest() {
        fs::copy_file(fs::path(SMAT_SOURCE_DIR) / "samples/ship/ship.sigdb", file);
        fs::permissions(file, fs::perms::owner_write, fs::perm_options::add);
        session.open(file);
        before = session.value();
    }
    void heat(double base_K, const QString& key = {}) {
        session.edit(
            "Set T0", [&](auto& d) { d.temperatures.begin()->second.terms.base_K = base_K; }, key);
    }

    fs::path folder = test::freshFolder("session");
    fs::path file = folder / "ship.sigdb";
    QUndoStack stack;
    DatabaseSession session{stack};
    irsg::SignatureDatabase before;
};

TEST_F(DatabaseSessionTest, EditsSavesAndReadsBackEqual) {
    heat(412.5);
    EXPECT_TRUE(session.isDirty());
    EXPECT_EQ(irsg::loadSignatureFile(file).database, before) << "not before it is saved";
    session.save();
    EXPECT_FALSE(session.isDirty());
    EXPECT_EQ(irsg::loadSignatureFile(file).database, session.value());
    EXPECT_EQ(session.value().temperatures.begin()->second.terms.base_K, 412.5);
    EXPECT_FALSE(fs::exists(file.string() + ".lock"));
}

TEST_F(DatabaseSessionTest, EveryKindOfStepIsExactInBothDirections) {
    const int material = before.materials.begin()->first;
    const int temperature = before.temperatures.begin()->first;
    const std::string spectrum = before.spectra.begin()->first;
    const std::vector<std::pair<const char*, DatabaseSession::Edit>> steps = {
        {"title", [](auto& d) { d.title = "another"; }},
        {"notes", [](auto& d) { d.notes = "of another"; }},
        {"name", [&](auto& d) { d.materials[material].name = "x"; }},
        {"emissivity",
         [&](auto& d) { d.materials[material].emissivity = irsg::Spectrum::constant(0.3); }},
        {"N", [&](auto& d) { d.materials[material].nAngleFactor = 2.5; }},
        {"terms",
         [&](auto& d) {
             d.temperatures[temperature].terms.power = {{0, 1}, {0, 50}};
         }},
        {"mode",
         [&](auto& d) {
             auto& mode = d.temperatures[temperature].mode;
             mode = mode == irsg::EmissionMode::temperature ? irsg::EmissionMode::userSpectrum
                                                            : irsg::EmissionMode::temperature;
         }},
        {"distance", [&](auto& d) { d.spectra[spectrum].referenceDistance_m = 77; }},
        {"duplicate",
         [&](auto& d) {
             duplicateEntry(d, {EntryKind::material, material}, {EntryKind::material, 901});
         }},
        {"renumber",
         [&](auto& d) {
             renumberEntry(d, {EntryKind::temperature, temperature}, {EntryKind::temperature, -7});
         }},
        {"rename",
         [&](auto& d) {
             renumberEntry(d, {EntryKind::spectrum, 0, spectrum}, {EntryKind::spectrum, 0, "new"});
         }},
        {"delete",
         [&](auto& d) {
             removeEntry(d, {EntryKind::material, material});
         }},
        {"copy", [&](auto& d) {
             copyEntries(irsg::materialLibrary(),
                         {{{EntryKind::material, 1}, {EntryKind::material, 50}}}, d);
         }}};
    std::vector<irsg::SignatureDatabase> states = {before};
    for (const auto& [name, step] : steps) {
        session.edit(name, step);
        EXPECT_FALSE(session.value() == states.back()) << name;
        states.push_back(session.value());
    }
    ASSERT_EQ(stack.count(), static_cast<int>(steps.size()));
    for (std::size_t i = steps.size(); i-- > 0;) {
        EXPECT_EQ(stack.undoText(), steps[i].first);
        stack.undo();
        EXPECT_EQ(session.value(), states[i]) << steps[i].first;
    }
    EXPECT_FALSE(session.isDirty());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        stack.redo();
        EXPECT_EQ(session.value(), states[i + 1]) << steps[i].first;
    }
}

TEST_F(DatabaseSessionTest, AGestureIsOneStepAndTheNextOneAnother) {
    for (const double now_K : {301.0, 302.0, 303.0}) {
        heat(now_K, "drag");
    }
    EXPECT_EQ(stack.count(), 1);
    session.endGesture();
    heat(304.0, "drag");
    EXPECT_EQ(stack.count(), 2);
    stack.undo();
    EXPECT_EQ(session.value().temperatures.begin()->second.terms.base_K, 303.0);
    stack.undo();
    EXPECT_EQ(session.value(), before);
}

TEST_F(DatabaseSessionTest, AGestureThatComesBackIsNoStep) {
    const double rest_K = before.temperatures.begin()->second.terms.base_K;
    heat(rest_K + 5.0, "drag");
    heat(rest_K, "drag");
    EXPECT_EQ(stack.count(), 0);
    EXPECT_FALSE(session.isDirty());
}

TEST_F(DatabaseSessionTest, KeepsARecoveryCopyBesideTheFileAndNeverOverIt) {
    heat(512.0);
    session.writeRecoveryNow();
    EXPECT_EQ(session.recoveryFile(), fs::path(file.string() + ".recovery"));
    ASSERT_TRUE(fs::exists(session.recoveryFile()));
    EXPECT_EQ(irsg::loadSignatureFile(file).database, before);
    const auto edited = session.value();
    const auto copy = folder / "kept";
    fs::copy_file(session.recoveryFile(), copy);
    session.save();
    EXPECT_FALSE(fs::exists(file.string() + ".recovery")) << "gone when all is saved";

    // A window that died left its copy.
    fs::copy_file(copy, file.string() + ".recovery");
    irsg::saveSignatureFile(before, file);
    QUndoStack otherStack;
    DatabaseSession other(otherStack);
    other.open(file);
    ASSERT_EQ(other.recoveries(), 1U);
    EXPECT_EQ(other.value(), before);
    other.recover();
    EXPECT_EQ(other.value(), edited);
    EXPECT_EQ(other.recoveries(), 0U);
    otherStack.undo();
    EXPECT_EQ(other.value(), before);
}

TEST_F(DatabaseSessionTest, TakesOneOfSeveralRecoveryCopiesAndKeepsTheOthers) {
    // Two windows that were killed with edits of the same file.
    const auto left = [this](const char* name, const char* title, int hoursAgo) {
        auto draft = before;
        draft.title = title;
        const fs::path copy = file.string() + name;
        std::ofstream(copy) << irsg::draftToJson(draft);
        fs::last_write_time(copy, fs::file_time_type::clock::now() - std::chrono::hours(hoursAgo));
        return copy;
    };
    const fs::path older = left(".recovery", "older", 2);
    const fs::path newer = left(".recovery-17", "newer", 1);
    session.reload();
    ASSERT_EQ(session.recoveries(), 2U);
    session.recover();
    EXPECT_EQ(session.value().title, "newer");
    EXPECT_FALSE(fs::exists(newer));
    ASSERT_TRUE(fs::exists(older)) << "nobody has looked at it yet";
    EXPECT_TRUE(fs::exists(session.recoveryFile())) << "and its edits have a copy at every moment";
    EXPECT_NE(session.recoveryFile(), older);

    session.save();
    ASSERT_EQ(session.recoveries(), 1U);
    session.recover();
    EXPECT_EQ(session.value().title, "older");
    stack.undo();
    EXPECT_EQ(session.value().title, "newer");
    EXPECT_FALSE(fs::exists(older));

    // Giving one up leaves the others, too.
    left(".recovery", "older", 2);
    left(".recovery-17", "newer", 1);
    session.reload();
    session.discardRecovery();
    EXPECT_FALSE(fs::exists(newer));
    EXPECT_TRUE(fs::exists(older));
    session.discardRecovery();
    EXPECT_EQ(session.recoveries(), 0U);
}

TEST_F(DatabaseSessionTest, SaysThatACopyOfTheEditsCannotBeWritten) {
    // Something else lies in its place.
    const fs::path place = file.string() + ".recovery";
    fs::create_directory(place);
    heat(355.0);
    int told = 0;
    QObject::connect(&session, &DatabaseSession::stateChanged, [&] { ++told; });
    session.writeRecoveryNow();
    EXPECT_FALSE(session.recoveryProblem().isEmpty());
    EXPECT_EQ(told, 1);
    fs::remove(place);
    session.writeRecoveryNow();
    EXPECT_TRUE(session.recoveryProblem().isEmpty());
    EXPECT_EQ(told, 2);
    EXPECT_TRUE(fs::exists(place));
}

TEST_F(DatabaseSessionTest, ADiskThatIsFullLosesNothing) {
    // A limit on the size of files stands for the disk.
    struct Limit {
        rlimit before{};
        Limit() {
            signal(SIGXFSZ, SIG_IGN);
            getrlimit(RLIMIT_FSIZE, &before);
            const rlimit none{0, before.rlim_max};
            setrlimit(RLIMIT_FSIZE, &none);
        }
        ~Limit() {
            setrlimit(RLIMIT_FSIZE, &before);
            signal(SIGXFSZ, SIG_DFL);
        }
    };
    heat(355.0);
    session.writeRecoveryNow();
    const auto first = session.value();
    heat(366.0);
    const auto edited = session.value();
    std::string said;
    QString problem;
    {
        const Limit full;
        try {
            session.save();
        } catch (const irsg::InputError& error) {
            said = error.what();
        }
        session.writeRecoveryNow();
        problem = session.recoveryProblem();
    }
    EXPECT_NE(said.find("the old file is unchanged"), std::string::npos) << said;
    EXPECT_FALSE(problem.isEmpty());
    EXPECT_TRUE(session.isDirty());
    EXPECT_EQ(session.value(), edited);
    EXPECT_EQ(irsg::loadSignatureFile(file).database, before);
    std::ifstream copy(session.recoveryFile());
    const std::string kept{std::istreambuf_iterator<char>(copy), {}};
    EXPECT_EQ(irsg::signatureFromJson(kept), first) << "the copy before is as it was";

    session.save();
    EXPECT_EQ(irsg::loadSignatureFile(file).database, edited);
    EXPECT_TRUE(session.recoveryProblem().isEmpty());
}

TEST_F(DatabaseSessionTest, ADraftWithLintErrorsIsRecoveredToo) {
    session.edit("wrong", [](auto& d) {
        d.materials.begin()->second.emissivity = irsg::Spectrum::constant(1.7);
    });
    session.writeRecoveryNow();
    const auto draft = session.value();
    const auto copy = folder / "kept";
    fs::copy_file(session.recoveryFile(), copy);
    EXPECT_THROW(session.save(), irsg::InputError);
    EXPECT_EQ(session.value(), draft);
    EXPECT_EQ(irsg::loadSignatureFile(file).database, before);
    session.discard();
    EXPECT_EQ(session.value(), before);
    EXPECT_FALSE(fs::exists(file.string() + ".recovery"));

    fs::copy_file(copy, file.string() + ".recovery");
    session.reload();
    session.recover();
    EXPECT_EQ(session.value(), draft);
}

TEST_F(DatabaseSessionTest, TwoWindowsOfOneFileDoNotOverwriteEachOther) {
    QUndoStack otherStack;
    DatabaseSession other(otherStack);
    other.open(file);
    heat(350.0);
    EXPECT_EQ(session.access(), DatabaseSession::Access::edit);
    other.edit("too", [](auto& d) { d.title = "the other's"; });
    EXPECT_EQ(other.access(), DatabaseSession::Access::openElsewhere);
    EXPECT_FALSE(other.accessNote().isEmpty());
    EXPECT_THROW(other.save(), irsg::InputError);
    session.writeRecoveryNow();
    other.writeRecoveryNow();
    EXPECT_NE(session.recoveryFile(), other.recoveryFile());

    session.save();
    EXPECT_TRUE(other.isChangedOnDisk());
    EXPECT_THROW(other.save(), irsg::InputError) << "it has not seen what is there now";
    EXPECT_EQ(irsg::loadSignatureFile(file).database, session.value());
    other.saveAs(folder / "other.sigdb");
    EXPECT_EQ(irsg::loadSignatureFile(folder / "other.sigdb").database.title, "the other's");
    EXPECT_FALSE(other.isDirty());
}

TEST_F(DatabaseSessionTest, SeesThatAnotherProgramChangedTheFile) {
    auto changed = before;
    changed.title = "changed by another program";
    QStringList seen;
    QObject::connect(&session, &DatabaseSession::changedOnDisk, [&] { seen << "changed"; });
    irsg::saveSignatureFile(changed, file);
    EXPECT_TRUE(session.isChangedOnDisk());
    EXPECT_TRUE(test::waitUntil([&] { return !seen.isEmpty(); }, 5.0));
    heat(333.0);
    EXPECT_THROW(session.save(), irsg::InputError);
    EXPECT_EQ(irsg::loadSignatureFile(file).database, changed);
    session.overwrite();
    EXPECT_EQ(irsg::loadSignatureFile(file).database, session.value());
    EXPECT_FALSE(session.isChangedOnDisk());
}

TEST_F(DatabaseSessionTest, AChangeThatTheClockDoesNotTellIsSeenByTheSaveItself) {
    // Another program saves the same number of bytes and puts the time of the file back.
    session.overwrite(); // now the file is as this version writes it
    const auto time = fs::last_write_time(file);
    auto changed = before;
    changed.title = std::string(before.title.rbegin(), before.title.rend());
    ASSERT_NE(changed.title, before.title);
    irsg::saveSignatureFile(changed, file);
    fs::last_write_time(file, time);
    ASSERT_FALSE(session.isChangedOnDisk()) << "time and size are as they were";
    heat(333.0);
    const auto edited = session.value();
    EXPECT_THROW(session.save(), irsg::InputError);
    EXPECT_EQ(irsg::loadSignatureFile(file).database, changed) << "nothing is lost there";
    EXPECT_EQ(session.value(), edited) << "nor here";
    EXPECT_TRUE(session.isDirty());
    session.overwrite();
    EXPECT_EQ(irsg::loadSignatureFile(file).database, edited);
}

TEST_F(DatabaseSessionTest, ANewDatabaseIsNotPutOverAFileThatAppearedMeanwhile) {
    session.create(folder / "new.sigdb", before);
    auto other = before;
    other.title = "another window's";
    irsg::saveSignatureFile(other, folder / "new.sigdb");
    EXPECT_THROW(session.save(), irsg::InputError);
    EXPECT_EQ(irsg::loadSignatureFile(folder / "new.sigdb").database, other);
    EXPECT_TRUE(session.isDirty());
    session.discard();
}

TEST_F(DatabaseSessionTest, AWriteProtectedFileIsSavedUnderAnotherName) {
    fs::permissions(file, fs::perms::owner_read | fs::perms::group_read);
    session.reload();
    EXPECT_EQ(session.access(), DatabaseSession::Access::readOnly);
    heat(345.0);
    EXPECT_THROW(session.save(), irsg::InputError);
    session.saveAs(folder / "mine.sigdb");
    EXPECT_EQ(session.access(), DatabaseSession::Access::edit);
    EXPECT_EQ(irsg::loadSignatureFile(file).database, before);
    EXPECT_EQ(irsg::loadSignatureFile(folder / "mine.sigdb").database, session.value());
}

TEST_F(DatabaseSessionTest, WhatCannotBeOpenedLeavesTheOneThatIs) {
    heat(345.0);
    const auto edited = session.value();
    std::ofstream(folder / "text.sigdb") << "no database";
    std::ofstream(folder / "empty.sigdb");
    std::string bytes;
    {
        std::ifstream stream(file, std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(stream), {});
    }
    std::string newer = bytes;
    newer[63] = 99; // user_version of the header, big-endian
    std::ofstream(folder / "newer.sigdb", std::ios::binary) << newer;
    std::ofstream(folder / "cut.sigdb", std::ios::binary) << bytes.substr(0, bytes.size() / 2);
    for (const char* name : {"none", "text", "empty", "newer", "cut"}) {
        EXPECT_THROW(session.open(folder / (name + std::string(".sigdb"))), irsg::InputError)
            << name;
        EXPECT_EQ(session.value(), edited) << name;
        EXPECT_EQ(session.file(), file) << name;
    }
    stack.undo();
    EXPECT_EQ(session.value(), before);
}

TEST_F(DatabaseSessionTest, StepsOfAnotherDatabaseDoNothing) {
    heat(345.0);
    session.reload();
    stack.undo();
    EXPECT_EQ(session.value(), before);
    EXPECT_EQ(stack.count(), 0);
}

TEST_F(DatabaseSessionTest, LeavingWithUnsavedEditsKeepsThemForTheNextTime) {
    heat(345.0);
    const auto edited = session.value();
    fs::copy_file(file, folder / "other.sigdb");
    session.open(folder / "other.sigdb");
    EXPECT_EQ(session.recoveries(), 0U);
    session.open(file);
    EXPECT_EQ(session.value(), before);
    ASSERT_EQ(session.recoveries(), 1U);
    session.recover();
    EXPECT_EQ(session.value(), edited);
    session.discard();
    session.open(file);
    EXPECT_EQ(session.recoveries(), 0U) << "given up is given up";
}

TEST_F(DatabaseSessionTest, ANewDatabaseIsAllUnsaved) {
    session.create(folder / "new.sigdb", before);
    EXPECT_TRUE(session.isDirty());
    session.save();
    EXPECT_EQ(irsg::loadSignatureFile(folder / "new.sigdb").database, before);
}

} // namespace
} // namespace smat::gui
