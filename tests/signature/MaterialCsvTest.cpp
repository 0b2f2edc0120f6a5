#include "irsg/signature/MaterialCsv.h"

#include "irsg/core/Remarks.h"

#include "irsg/signature/DispersionFormula.h"
#include "irsg/signature/EntryFields.h"

#include "Support.h"

namespace irsg {
namespace {

using testing::Contains;
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
    EXPECT_THAT(told("wl,n\n3,4.1\n5,5.3\nwl,n\n3,1\n5,2\n"), HasSubstr("line 4, column 2"));
    EXPECT_THAT(told("wl,n,n\n3,4.1,4\n"), HasSubstr("line 1, column 3"));
    for (const char* n : {"0", "-1", "1e300"}) {
        EXPECT_THAT(told(std::string("wl,n\n3,") + n + "\n"), HasSubstr("line 2, column 2")) << n;
        EXPECT_THAT(told(std::string("um,n\n3,1\n4,") + n + "\n"), HasSubstr("line 3, column 2"))
            << n;
    }
    EXPECT_THAT(told("um,n\n3,-4\n5,1\n"), HasSubstr("above 0"));
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

TEST(MaterialCsv, SpectraOfLibrariesAndInstrumentsAreOnePaint) {
    const std::filesystem::path strangers =
        std::filesystem::path(SMAT_SOURCE_DIR) / "tests/data/strangers/material-forms";
    const struct {
        const char* file;
        double at3_um, at10_um; ///< emissivity
        const char* remark;
    } rows[] = {
        {"ecostress.spectrum.txt", 0.85, 0.93, "ECOSTRESS, 'Invented grey paint'"},
        {"usgs.asc", 0.85, 0.93, "USGS"},
        {"jcamp.jdx", 0.8664, 0.924, "JCAMP-DX, 'invented paint'"},
        {"dirsig.ems", 0.85, 0.93, "DIRSIG .ems"},
        {"excel_bom_semicolon.csv", 0.85, 0.93, "semicolons, decimal commas"},
        {"over1.csv", 1.0, 0.9788889, "1 value outside of 0 to 1 (line 3, column 2: 1.003)"}};
    for (const auto& row : rows) {
        SCOPED_TRACE(row.file);
        Material material;
        const CollectedRemarks remarks;
        readMaterialCsv(strangers / row.file, material);
        EXPECT_NEAR(material.emissivity.at(3.0), row.at3_um, 2e-3);
        EXPECT_NEAR(material.emissivity.at(10.0), row.at10_um, 2e-3);
        EXPECT_THAT(testing::PrintToString(remarks.sentences()), HasSubstr(row.remark));
    }
}

TEST(MaterialCsv, RefractiveIndicesGiveANewMaterialTheEmissivityOfItsFlatFace) {
    const std::filesystem::path file =
        std::filesystem::path(SMAT_SOURCE_DIR) / "tests/data/strangers/material-forms/rii.yml";
    const Material material = importedMaterial(file, SignatureDatabase(), 3);
    EXPECT_EQ(material.refractiveIndex.at(4.0), 1.45);
    EXPECT_EQ(material.extinction.at(8.0), 0.40);
    // ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2) at 8 um.
    EXPECT_NEAR(material.emissivity.at(8.0), 1.0 - (0.04 + 0.16) / (4.84 + 0.16), 1e-12);
}

TEST(MaterialCsv, FormulasOfRefractiveIndicesAreReadAsCurves) {
    const TemporaryFolder folder;
    const std::string sellmeier =
        "# zinc selenide\nDATA:\n  - type: formula 2\n    wavelength_range: 0.54 18.2\n    "
        "coefficients: 0 4.2980149 0.0368879 0.62776557 0.14347626 2.8955633 2208.4920\n";
    Material material;
    {
        const CollectedRemarks remarks;
        readMaterialCsv(writeBytes(folder / "a.yml", sellmeier), material);
        EXPECT_THAT(remarks.sentences(), Contains(HasSubstr("formula 2")));
        EXPECT_THAT(remarks.sentences(), Contains(HasSubstr("k is 0")));
    }
    // Tatian 1984: 2.4028 at 10.6 um.
    EXPECT_NEAR(material.refractiveIndex.at(10.6), 2.4028, 2e-4);
    EXPECT_EQ(material.extinction.at(10.6), 0.0);
    // Straight pieces follow the formula.
    for (int i = 0; i < 1289; ++i) {
        const double wavelength_um = 0.54 + 0.0137 * i;
        const std::vector<double> c = {0,          4.2980149, 0.0368879, 0.62776557,
                                       0.14347626, 2.8955633, 2208.4920};
        const double n = dispersionIndex(2, c, wavelength_um);
        ASSERT_NEAR(material.refractiveIndex.at(wavelength_um), n, 2e-5 * n) << wavelength_um;
    }
    EXPECT_LT(material.refractiveIndex.size(), 500U);
    // A table of k beside it, before or behind it.
    const std::string table = "  - type: tabulated k\n    data: |\n        3 0.25\n        5 0.5\n";
    for (const std::string& text :
         {sellmeier + table, "DATA:\n" + table + sellmeier.substr(sellmeier.find("  - "))}) {
        Material both;
        readMaterialCsv(writeBytes(folder / "b.yml", text), both);
        EXPECT_EQ(both.extinction.at(4.0), 0.375);
        EXPECT_EQ(both.refractiveIndex, material.refractiveIndex);
    }
}

TEST(MaterialCsv, JcampIsReadInItsPackedForms) {
    const TemporaryFolder folder;
    const std::string head = "##TITLE=x\n##JCAMP-DX=4.24\n##XUNITS=1/CM\n##YUNITS=TRANSMITTANCE\n"
                             "##XFACTOR=1\n##YFACTOR=0.01\n##FIRSTX=2000\n##LASTX=2500\n"
                             "##NPOINTS=6\n##FIRSTY=0.1\n##XYDATA=(X++(Y..Y))\n";
    const std::pair<const char*, const char*> rows[] = {
        {"AFFN", "2000 10 12 12 12 9 -0\n"}, {"PAC", "2000+10+12+12+12+9+0\n"},
        {"SQZ", "2000A0A2A2A2I@\n"},         {"DIF", "2000A0K%%lr\n2500@\n"},
        {"DIFDUP", "2000A0K%Tlr\n"},         {"lines", "2000 10 12 12 $$ note\n2300 12 9 0\n"}};
    for (const auto& [name, data] : rows) {
        SCOPED_TRACE(name);
        Material material;
        readMaterialCsv(writeBytes(folder / "a.jdx", head + data + "##END=\n"), material);
        EXPECT_NEAR(material.transmissivity.at(5.0), 0.10, 1e-12);
        EXPECT_NEAR(material.transmissivity.at(1e4 / 2300.0), 0.12, 1e-12);
        EXPECT_NEAR(material.transmissivity.at(1e4 / 2400.0), 0.09, 1e-12);
        EXPECT_NEAR(material.transmissivity.at(4.0), 0.0, 1e-12);
    }
    const std::pair<std::string, const char*> bad[] = {
        {head + "2000 10 12\n##END=\n", "2 ordinates, expected 6"},
        {"##TITLE=x\n##XUNITS=1/CM\n##YUNITS=ABSORBANCE\n##FIRSTX=1\n##LASTX=2\n"
         "##XYDATA=(X++(Y..Y))\n1 1 2\n",
         "line 3: found 'ABSORBANCE'"},
        {"##TITLE=x\n##NTUPLES=y\n", "NTUPLES"},
        {head + "2000A0K%%lr\n2500A\n", "the check value 1"}};
    for (const auto& [text, says] : bad) {
        Material material;
        const auto file = writeBytes(folder / "b.jdx", text);
        const auto diagnostics = refusalOf([&] { readMaterialCsv(file, material); });
        ASSERT_FALSE(diagnostics.empty()) << says;
        EXPECT_THAT(diagnostics[0].message(), HasSubstr(says));
    }
}

TEST(MaterialCsv, LibrariesThatHoldNoSpectrumAreRefusedByName) {
    const TemporaryFolder folder;
    const std::pair<std::string, const char*> rows[] = {
        {"DATA:\n  - type: formula 10\n    coefficients: 0 1 2\n", "line 2: found 'formula 10'"},
        {"DATA:\n  - type: formula 1\n    coefficients: 0 1 2\n", "line 2: found formula 1"},
        {"DATA:\n  - type: formula 1\n    wavelength_range: 5 3\n    coefficients: 0 1 2\n",
         "wavelength_range of two ascending"},
        {"DATA:\n  - type: formula 1\n    wavelength_range: 3 5\n", "line 2: found 0 coefficients"},
        {"DATA:\n  - type: formula 8\n    wavelength_range: 3 5\n    coefficients: 0 1 2 3 4\n",
         "line 4: found 5 coefficients, expected 1 to 4 for formula 8"},
        {"DATA:\n  - type: formula 1\n    wavelength_range: 3 5\n    coefficients: 0 one 2\n",
         "line 4: found '0 one 2', expected numbers"},
        {"DATA:\n  - type: formula 2\n    wavelength_range: 3 5\n    coefficients: 0 0.5 16.2\n",
         "line 4: found no n at 3.288 um"}, // near a pole
        {"DATA:\n  - type: formula 3\n    wavelength_range: 3 5\n    coefficients: -2\n",
         "line 4: found no n at 3 um"},
        {"DATA:\n  - type: formula 3\n    wavelength_range: 3 5\n    coefficients: 2\n"
         "  - type: tabulated n\n    data: |\n        3 1.5\n        5 1.5\n",
         "line 5: found n again"},
        {"DATA:\n  - type: tabulated nk\n    data: |\n        2 1.5\n", "line 4: found 2 numbers"},
        {"splib07a Record=1: x\n 0.1\n 0.2\n 0.3\n", "wavelengths are in another file"},
        {"Name: x\nX Units: Wavelength (furlongs)\nY Units: Reflectance\n\n1 2\n2 3\n",
         "line 2: found 'Wavelength (furlongs)'"},
        {"Name: x\nX Units: Wavelength (micrometers)\nY Units: Reflectance (percent)\n\n1 200\n"
         "2 3\n",
         "line 5: found 2, expected a value from 0 to 1"},
        {"1\n1.0\nCURVE_BEGIN\n3 0.8\nCURVE_END\n", "1 rows of numbers"}};
    for (const auto& [text, says] : rows) {
        Material material;
        const auto file = writeBytes(folder / "b.txt", text);
        const auto diagnostics = refusalOf([&] { readMaterialCsv(file, material); });
        ASSERT_FALSE(diagnostics.empty()) << says;
        EXPECT_THAT(diagnostics[0].message(), HasSubstr(says));
    }
}

TEST(MaterialCsv, HeadsOfPercentAndOtherWordsAreTheSameColumns) {
    const TemporaryFolder folder;
    for (const char* text :
         {"wavelength [nm],Reflectance (%)\n3000,15\n5000,10\n", "um,reflectance\n3,0.15\n5,0.1\n",
          "Wavelength (um)\tEmittance [%]\n5\t90\n3\t85\n",
          "cm-1,emissivity\n2000,0.9\n3333.3333,0.85\n",
          "# head wavelength\nwavelength [um],emissivity\n3,0.85\n5,0.9\n",
          "Wellenl\u00e4nge [\u00b5m];Emissionsgrad\n3;0,85\n5;0,9\n",
          "Wellenl\xe4nge [\xb5m];Reflexionsgrad in Prozent\n3;15\n5;10\n",
          "Wellenzahl [cm-1]\tEmissivit\u00e4t\n2000\t0,9\n3333,3333\t0,85\n",
          "longueur d'onde (nm);facteur de r\u00e9flexion (%)\n3000;15\n5000;10\n",
          "Longueur d\u2019onde [\u00c5];\u00e9missivit\u00e9\n30 000;0,85\n50 000;0,9\n"}) {
        Material material;
        readMaterialCsv(writeBytes(folder / "a.csv", text), material);
        EXPECT_NEAR(material.emissivity.at(3.0), 0.85, 1e-6) << text;
        EXPECT_NEAR(material.emissivity.at(5.0), 0.90, 1e-6) << text;
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
        Bad{"UnknownAxis", "eV,emissivity\n3,1\n4,1\n", "line 1, column 1", "eV", "'um', 'nm'"},
        Bad{"BeyondTheTolerance", "um,emissivity\n3,1.006\n4,1\n", "line 2, column 2", "1.006",
            "0 to 1"},
        Bad{"BelowTheTolerance", "um;emissivity\n3,5;-0,006\n4;1\n", "line 2, column 2", "-0,006",
            "0 to 1"},
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
        Bad{"ThousandsInQuotes", "um,emissivity\n3,\"0,500\"\n4,\"0,600\"\n", "line 2", "0,500",
            "numbers without commas"},
        Bad{"DecimalCommas", "um,emissivity\n3,0,0,5\n4,0,0,5\n", "line 2", "4 cells",
            "decimal points"},
        Bad{"OneRow", "um;emissivity\n3,0;0,5\n", "", "2 rows", "at least 2 rows"},
        Bad{"NoNames", "3,0.5\n4,0.5\n5,0.5\n", "line 1, column 2", "0.5", "row of names"}),
    [](const auto& row) { return row.param.name; });

} // namespace
} // namespace irsg
