#include "gui/database/DatabaseEdits.h"

#include <gtest/gtest.h>

#include "irsg/signature/Lint.h"
#include "irsg/signature/MaterialLibrary.h"

namespace smat::gui {
namespace {

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
    const auto& library = irsg::materialLibrary();
    EXPECT_EQ(library.materials.size(), 30U);
    for (const auto& finding : irsg::lint(library)) {
        ADD_FAILURE() << finding.place << ": " << finding.value << ": " << finding.reason;
    }
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
