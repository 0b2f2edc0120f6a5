#include "irsg/signature/MaterialCsv.h"

#include "irsg/signature/EntryFields.h"

#include "Support.h"

namespace irsg {
namespace {

using testing::HasSubstr;

Material read(const std::string& text, Material material = {}) {
    const TemporaryFolder folder;
    readMaterialCsv(writeBytes(folder / "a.csv", text), material);
    return material;
}

TEST(MaterialCsv, ReadsWhatIsGivenAndClosesTheSum) {
    struct Row {
        const char* text;
        double emissivity, transmissivity;
    };
    for (const Row& row :
         {Row{"um,emissivity\n3,0.75\n5,0.75\n", 0.75, 0.0},
          Row{"um,transmissivity\n3,0.75\n5,0.75\n", 0.25, 0.75},
          Row{"um,reflectivity\n3,0.25\n5,0.25\n", 0.75, 0.0},
          Row{"um,emissivity,transmissivity\n3,0.5,0.25\n5,0.5,0.25\n", 0.5, 0.25},
          Row{"um,emissivity,reflectivity\n3,0.5,0.25\n5,0.5,0.25\n", 0.5, 0.25},
          Row{"um,transmissivity,reflectivity\n3,0.25,0.25\n5,0.25,0.25\n", 0.5, 0.25},
          Row{"um,reflectivity,emissivity,transmissivity\n3,.25,.5,.25\n5,.25,.5,.25\n", 0.5,
              0.25}}) {
        const Material material = read(row.text);
        EXPECT_EQ(material.emissivity.at(4.0), row.emissivity) << row.text;
        EXPECT_EQ(material.transmissivity.at(4.0), row.transmissivity) << row.text;
        EXPECT_EQ(material.isOpaque(), row.transmissivity == 0.0) << row.text;
        EXPECT_EQ(material.emissivity.outside(), Spectrum::Outside::hold);
    }
}

TEST(MaterialCsv, TakesWavenumbersAndAnyDirectionForOneCurve) {
    const Material over_um = read("um,emissivity\n4,0.5\n5,0.75\n");
    EXPECT_TRUE(read("cm-1,emissivity\n2000,0.75\n2500,0.5\n") == over_um);
    EXPECT_TRUE(read("um,emissivity\n5,0.75\n4,0.5\n") == over_um);
}

TEST(MaterialCsv, TakesIndexAndExtinctionAloneOrBesideEmissivity) {
    Material material;
    material.emissivity = Spectrum::constant(0.3);
    const Material alone = read("um,n,k\n3,1.5,0.1\n5,2.5,4\n", material);
    EXPECT_EQ(alone.emissivity, material.emissivity);
    EXPECT_EQ(alone.refractiveIndex.at(4.0), 2.0);
    EXPECT_EQ(alone.extinction.at(5.0), 4.0);
    const Material both = read("cm-1,k,emissivity,diffuse_reflectivity\n2000,4,0.5,0.2\n"
                               "2500,2,0.75,0.1\n");
    EXPECT_EQ(both.extinction.at(5.0), 4.0);
    EXPECT_EQ(both.emissivity.at(4.0), 0.75);
    EXPECT_EQ(both.diffuseReflectivity.at(5.0), 0.2);
}

TEST(MaterialCsv, TakesTheBlocksOfRefractiveIndexInfo) {
    const Material material = read("wl,n\n3,4.1\n5,5.3\n\nwl,k\n3,29\n4,35\n5,44\n");
    EXPECT_EQ(material.refractiveIndex.at(5.0), 5.3);
    EXPECT_EQ(material.extinction.at(4.0), 35.0);
    EXPECT_EQ(material.emissivity, Spectrum::constant(1.0));
    const auto told = [](const std::string& text) -> std::string {
        try {
            read(text);
        } catch (const InputError& error) {
            return error.what();
        }
        return "nothing";
    };
    EXPECT_THAT(told("wl,n\n3,4.1\n2,5.3\n"), HasSubstr("line 3, column 1"));
    EXPECT_THAT(told("wl,n\n3,x\n"), HasSubstr("line 2, column 2"));
    EXPECT_THAT(told("wl,q\n3,4\n"), HasSubstr("'n' or 'k'"));
    EXPECT_THAT(told("wl,n\n3\n"), HasSubstr("line 2"));
    EXPECT_THAT(told("um,n\n3,-4\n5,1\n"), HasSubstr("at least 0"));
}

TEST(MaterialCsv, TakesATableOfReflectanceAsAModel) {
    const TemporaryFolder folder;
    SignatureDatabase database;
    database.materials[4].name = "coat";
    const auto file =
        writeBytes(folder / "coat.csv", std::string("incidence_deg,3,5\n0,0.2,0.4\n90,1,1\n"));
    const Material material = importedReflectance(file, database, 4);
    EXPECT_EQ(material.name, "coat");
    EXPECT_EQ(material.surfaceModel, "tabulated");
    EXPECT_NEAR(material.emissivity.at(4.0), 0.7, 1e-9);
    EXPECT_EQ(importedReflectance(file, database, 5).name, "coat");
}

TEST(MaterialCsv, KeepsNameAndN) {
    Material material;
    material.name = "paint";
    material.nAngleFactor = 0.25;
    const Material after = read("um,emissivity\n4,0.5\n5,0.75\n", material);
    EXPECT_EQ(after.name, "paint");
    EXPECT_EQ(after.nAngleFactor, 0.25);
}

TEST(MaterialCsv, HasAColumnForEverySpectrumOfAMaterial) {
    const TemporaryFolder folder;
    Material all;
    forEachField<Spectrum>(materialFields(), [&](const auto& field, auto member) {
        SCOPED_TRACE(field.key);
        Material material;
        material.emissivity = Spectrum::constant(0.25);
        material.*member = all.*member = Spectrum({3.0, 5.0}, {0.5, 0.25});
        writeMaterialCsv(material, folder / "a.csv");
        Material back;
        readMaterialCsv(folder / "a.csv", back);
        EXPECT_EQ((back.*member).wavelengths_um(), (material.*member).wavelengths_um());
        EXPECT_EQ((back.*member).values(), (material.*member).values());
    });
    writeMaterialCsv(all, folder / "a.csv");
    EXPECT_THAT(readBytes(folder / "a.csv"),
                testing::StartsWith("um,emissivity,transmissivity,reflectivity,n,k,"
                                    "diffuse_reflectivity,volume_reflectivity\n3,0.5,"));
}

TEST(MaterialCsv, ComesBackFromWhatItWrites) {
    const TemporaryFolder folder;
    for (const auto& [index, material] : completeDatabase().materials) {
        writeMaterialCsv(material, folder / "a.csv");
        Material back = material;
        readMaterialCsv(folder / "a.csv", back);
        for (const double wavelength_um : {2.0, 3.3, 4.9, 12.0}) {
            EXPECT_NEAR(back.emissivity.at(wavelength_um), material.emissivity.at(wavelength_um),
                        1e-15);
            EXPECT_NEAR(back.transmissivity.at(wavelength_um),
                        material.transmissivity.at(wavelength_um), 1e-15);
        }
    }
}

struct Bad {
    const char* name;
    const char* text;
    const char* position;
    const char* value;
    const char* expected;
};
void PrintTo(const Bad& row, std::ostream* out) {
    *out << row.name;
}

class BadMaterialCsv : public testing::TestWithParam<Bad> {};

TEST_P(BadMaterialCsv, IsRefusedWithItsPlaceAndChangesNothing) {
    const TemporaryFolder folder;
    const auto file = writeBytes(folder / "bad.csv", GetParam().text);
    Material material = completeDatabase().materials.at(3);
    const auto diagnostics = refusalOf([&] { readMaterialCsv(file, material); });
    ASSERT_FALSE(diagnostics.empty());
    EXPECT_EQ(diagnostics[0].file, file.string());
    EXPECT_EQ(diagnostics[0].position, GetParam().position);
    EXPECT_THAT(diagnostics[0].value, HasSubstr(GetParam().value));
    EXPECT_THAT(diagnostics[0].expected, HasSubstr(GetParam().expected));
    EXPECT_TRUE(material == completeDatabase().materials.at(3));
}

INSTANTIATE_TEST_SUITE_P(
    MaterialCsv, BadMaterialCsv,
    testing::Values(
        Bad{"UnknownProperty", "um,absorptance\n3,1\n4,1\n", "line 1, column 2", "absorptance",
            "'emissivity', 'transmissivity', 'reflectivity', 'n', 'k', 'diffuse_reflectivity' or "
            "'volume_reflectivity'"},
        Bad{"PropertyTwice", "um,emissivity,emissivity\n3,1,1\n4,1,1\n", "line 1, column 3",
            "emissivity", "each name once"},
        Bad{"UnknownAxis", "nm,emissivity\n3,1\n4,1\n", "line 1, column 1", "nm", "'um' or 'cm-1'"},
        Bad{"Percent", "um,emissivity\n3,90\n4,92\n", "line 2, column 2", "90", "not percent"},
        Bad{"Negative", "um,emissivity\n3,0.5\n4,-0.1\n", "line 3, column 2", "-0.1", "0 to 1"},
        Bad{"SumAboveOne", "um,emissivity,transmissivity\n3,0.5,0.5\n4,0.6,0.5\n", "line 3",
            "emissivity + transmissivity = 1.1", "at most 1"},
        Bad{"ReflectivityThatDoesNotClose",
            "um,emissivity,transmissivity,reflectivity\n3,0.5,0.2,0.3\n4,0.5,0.2,0.2\n", "line 3",
            "= 0.9", "a sum of 1"},
        Bad{"ReflectivityTooLarge", "um,emissivity,reflectivity\n3,0.5,0.5\n4,0.5,0.6\n", "line 3",
            "emissivity + reflectivity = 1.1", "at most 1"},
        Bad{"Unsorted", "um,emissivity\n3,1\n5,1\n4,1\n", "line 4, column 1", "4", "ascending"},
        Bad{"DoubledWavelength", "um,emissivity\n3,1\n3,1\n", "line 3, column 1", "3", "ascending"},
        Bad{"MissingCell", "um,emissivity\n3,\n4,1\n", "line 2, column 2", "nothing", "finite"},
        Bad{"NotANumber", "um,emissivity\n3,nan\n4,1\n", "line 2, column 2", "nan", "finite"},
        Bad{"DecimalCommaInQuotes", "um,emissivity\n3,\"0,5\"\n4,1\n", "line 2, column 2", "0,5",
            "decimal point"},
        Bad{"DecimalCommas", "um,emissivity\n3,0,0,5\n4,0,0,5\n", "line 2", "4 cells",
            "decimal points"},
        Bad{"Semicolons", "um;emissivity\n3,0;0,5\n", "line 1", "um;emissivity",
            "separated by commas"},
        Bad{"NoNames", "3,0.5\n4,0.5\n5,0.5\n", "line 1, column 2", "0.5", "row of names"}),
    [](const auto& row) { return row.param.name; });

} // namespace
} // namespace irsg
