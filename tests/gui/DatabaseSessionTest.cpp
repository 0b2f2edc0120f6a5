#include "gui/database/DatabaseSession.h"

#include <fstream>

#include <QUndoStack>
#include <gtest/gtest.h>

#include "gui/database/DatabaseEdits.h"
#include "gui/database/MaterialLibrary.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/signature/Lint.h"
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
             copyEntries(materialLibrary(), {{{EntryKind::material, 1}, {EntryKind::material, 50}}},
                         d);
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
    for (const double now_K : {301.0, 302.0, 303.0})
        heat(now_K, "drag");
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
    ASSERT_TRUE(other.hasRecovery());
    EXPECT_EQ(other.value(), before);
    other.recover();
    EXPECT_EQ(other.value(), edited);
    EXPECT_FALSE(other.hasRecovery());
    otherStack.undo();
    EXPECT_EQ(other.value(), before);
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
    EXPECT_FALSE(session.hasRecovery());
    session.open(file);
    EXPECT_EQ(session.value(), before);
    ASSERT_TRUE(session.hasRecovery());
    session.recover();
    EXPECT_EQ(session.value(), edited);
    session.discard();
    session.open(file);
    EXPECT_FALSE(session.hasRecovery()) << "given up is given up";
}

TEST_F(DatabaseSessionTest, ANewDatabaseIsAllUnsaved) {
    session.create(folder / "new.sigdb", before);
    EXPECT_TRUE(session.isDirty());
    session.save();
    EXPECT_EQ(irsg::loadSignatureFile(folder / "new.sigdb").database, before);
}

TEST(DatabaseEditsTest, CopiesBringTheirSpectraUnderTheNamesTheyGet) {
    irsg::SignatureDatabase source, into;
    source.spectra["plume"].name = "plume";
    source.spectra["plume"].notes = "of the source";
    source.temperatures[4] = {"gas", irsg::EmissionMode::userSpectrum, {}, "plume", {}, ""};
    into.spectra["plume"].name = "plume";
    const EntryKey plume{EntryKind::spectrum, 0, "plume"};
    EXPECT_EQ(copyEntries(source,
                          {{{EntryKind::temperature, 4}, {EntryKind::temperature, 9}},
                           {plume, {EntryKind::spectrum, 0, "plume 2"}}},
                          into),
              2);
    EXPECT_EQ(into.temperatures[9].userSpectrum, "plume 2");
    EXPECT_EQ(into.spectra["plume 2"].notes, "of the source");
    EXPECT_EQ(into.spectra["plume 2"].name, "plume 2");
    EXPECT_EQ(into.spectra["plume"].notes, "");

    irsg::SignatureDatabase empty;
    copyEntries(source, {{{EntryKind::temperature, 4}, {EntryKind::temperature, 4}}}, empty);
    EXPECT_TRUE(empty.spectra.contains("plume")) << "brought along";
    EXPECT_EQ(copyEntries(source, {{plume, plume}}, into), 0) << "taken and not to be replaced";
    EXPECT_EQ(copyEntries(source, {{plume, plume, true}}, into), 1);
    EXPECT_EQ(into.spectra["plume"].notes, "of the source");
}

TEST(DatabaseEditsTest, FindsTheEntryThatAPlaceLiesIn) {
    irsg::SignatureDatabase database;
    database.materials[3];
    database.materials[31];
    database.spectra["plume"];
    database.spectra["plume.core"];
    const auto place = [&](const char* text) {
        const auto key = entryAt(database, text);
        return key ? placeOf(*key) : std::string("none");
    };
    EXPECT_EQ(place("materials.31.emissivity at 4 um"), "materials.31");
    EXPECT_EQ(place("materials.3"), "materials.3");
    EXPECT_EQ(place("spectra.plume.core.components"), "spectra.plume.core");
    EXPECT_EQ(place("spectra.plume"), "spectra.plume");
    EXPECT_EQ(place("temperatures.3"), "none");
}

TEST(MaterialLibraryTest, HoldsDocumentedMaterialsThatCloseTheirSum) {
    const auto& library = materialLibrary();
    EXPECT_EQ(library.materials.size(), 30U);
    for (const auto& finding : irsg::lint(library))
        ADD_FAILURE() << finding.place << ": " << finding.value << ": " << finding.reason;
    for (const auto& [index, material] : library.materials) {
        EXPECT_FALSE(material.name.empty()) << index;
        EXPECT_NE(material.notes.find("Origin: "), std::string::npos) << material.name;
        EXPECT_NE(material.notes.find("Uncertainty: "), std::string::npos) << material.name;
        EXPECT_TRUE(material.emissivity.isConstant() || material.emissivity.covers({0.4, 14.0}))
            << material.name;
    }
}

} // namespace
} // namespace smat::gui
