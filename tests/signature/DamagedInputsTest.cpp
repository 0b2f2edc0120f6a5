#include <functional>
#include <map>

#include <SQLiteCpp/SQLiteCpp.h>

#include "irsg/radiometry/Planck.h"
#include "irsg/signature/Lint.h"
#include "irsg/signature/MaterialCsv.h"
#include "irsg/signature/SignatureFile.h"
#include "irsg/signature/SpectrumCsv.h"

#include "Support.h"

/// What people, spreadsheets and disks do to databases and tables: each kind of damage, made from
/// the samples, must be refused or found by lint.
namespace irsg {
namespace {

namespace fs = std::filesystem;

const fs::path samples = fs::path(SMAT_SOURCE_DIR) / "samples";

/// The first place of `from` in a text is replaced; a damage that does nothing is a mistake here.
std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string replacedAll(const std::string& text, char from, const std::string& to) {
    std::string result;
    for (const char c : text) {
        result += c == from ? to : std::string(1, c);
    }
    return result;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines = {""};
    for (const char c : text) {
        c == '\n' ? lines.emplace_back() : lines.back() += c;
    }
    lines.pop_back();
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += line + "\n";
    }
    return text;
}

/// The numbers of one column of a table under its line of names, each passed through `f`.
std::string mapped(const std::string& text, std::size_t column,
                   const std::function<double(double)>& f) {
    std::vector<std::string> lines = linesOf(text);
    for (std::string& line : lines) {
        std::vector<std::string> cells = {""};
        for (const char c : line) {
            c == ',' ? cells.emplace_back() : cells.back() += c;
        }
        if (line.starts_with("#") || column >= cells.size()) {
            continue;
        }
        try {
            cells[column] = numberText(f(std::stod(cells[column])));
        } catch (const std::invalid_argument&) {
            continue;
        }
        line.clear();
        for (const std::string& cell : cells) {
            line += (line.empty() ? "" : ",") + cell;
        }
    }
    return joined(lines);
}

/// A sample's spectrum as a table, with its unit.
const std::string& spectrumText() {
    static const std::string text = readBytes(samples / "turboprop4" / "plume core.csv");
    return text;
}
/// The same over um, as this program writes it.
const std::string& micrometreText() {
    static const std::string text = [] {
        const TemporaryFolder folder;
        writeSpectrumCsv(signatureFromJson(readBytes(samples / "turboprop4" / "signature.json"))
                             .spectra.at("plume core"),
                         folder / "a.csv");
        return readBytes(folder / "a.csv");
    }();
    return text;
}
/// A black body of 600 K over wavenumbers with three digits, as report table 18 has one.
const std::string& blackbodyText() {
    static const std::string text = [] {
        std::string made = "# unit: W cm-2 sr-1 (cm-1)-1\ncm-1,BB(T1)\n";
        for (int wavenumber_per_cm = 1900; wavenumber_per_cm <= 3300; wavenumber_per_cm += 50) {
            const double wavelength_um = 1e4 / wavenumber_per_cm;
            char line[64];
            std::snprintf(line, sizeof line, "%d,%.2e\n", wavenumber_per_cm,
                          planckRadiance_W_m2_sr_um(wavelength_um, 600.0) * wavelength_um *
                              wavelength_um * 1e-8);
            made += line;
        }
        return made;
    }();
    return text;
}
const std::string& materialText() {
    static const std::string text = readBytes(samples / "ship" / "gas.csv");
    return text;
}
const std::string timeText = ",CO2,H2O\n0,1,1\n10,0.5,0.75\n20,1,1\n";
const std::string angleText = ",CO2,H2O\n0,1,1\n90,0.5,0.75\n180,0.25,0.5\n";
const std::string& jsonText() {
    static const std::string text = readBytes(samples / "turboprop4" / "signature.json");
    return text;
}
const std::string& databaseBytes() {
    static const std::string bytes = readBytes(samples / "turboprop4" / "turboprop4.sigdb");
    return bytes;
}

/// A plume takes the place of one that entries name; a spectrum is one more.
enum class Kind { database, json, plume, spectrum, material, time, angle };

/// Reads a file of a kind as an import would and lints what it gives: what is wrong, or nothing.
std::string complaintAbout(Kind kind, const fs::path& file) {
    try {
        SignatureDatabase database;
        if (kind == Kind::database) {
            database = loadSignatureFile(file).database;
        } else if (kind == Kind::json) {
            database = signatureFromJson(readBytes(file), file.string());
        } else {
            database = signatureFromJson(jsonText());
            if (kind == Kind::spectrum || kind == Kind::plume) {
                UserSpectrum spectrum = readSpectrumCsv(file);
                spectrum.name = kind == Kind::plume ? "plume core" : "imported";
                database.spectra[spectrum.name] = spectrum;
            } else if (kind == Kind::material) {
                readMaterialCsv(file, database.materials.begin()->second);
            } else {
                for (auto& [index, entry] : database.temperatures) {
                    if (entry.mode == EmissionMode::userSpectrum) {
                        readFactorCsv(
                            file, kind == Kind::time ? FactorAxis::time_s : FactorAxis::angle_deg,
                            kind == Kind::time, database.spectra.at(entry.userSpectrum),
                            entry.factors);
                    }
                }
            }
        }
        const auto findings = lint(database);
        return findings.empty() ? ""
                                : "found: " + findings[0].place + ": " + findings[0].value + "; " +
                                      findings[0].remedy;
    } catch (const InputError& error) {
        const Diagnostic& first = error.diagnostics().front();
        return "refused: " + first.position + ": " + first.value + ", expected " + first.expected;
    }
}

/// A database file that another program changed by SQL.
std::string changedBySql(const std::string& sql) {
    const TemporaryFolder folder;
    const fs::path file = writeBytes(folder / "a.sigdb", databaseBytes());
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec(sql);
    return readBytes(file);
}

struct Damage {
    const char* name;
    Kind kind;
    std::function<std::string()> make;
};

double celsius(double kelvin) {
    return kelvin - 273.15;
}

const Damage damages[] = {
    // Tables of spectra.
    {"SpectrumWithoutUnit", Kind::plume, [] { return replaced(spectrumText(), "# unit", "#"); }},
    {"SpectrumOfUnknownUnit", Kind::spectrum,
     [] { return replaced(blackbodyText(), "W cm-2", "BTU cm-2"); }},
    {"SpectrumInSquareMetresCalledSquareCentimetres", Kind::spectrum,
     [] { return mapped(blackbodyText(), 1, [](double v) { return v * 1e4; }); }},
    {"SpectrumInSquareCentimetresCalledSquareMetres", Kind::spectrum,
     [] { return replaced(blackbodyText(), "W cm-2", "W m-2"); }},
    {"SpectrumPerWavenumberCalledPerMicrometre", Kind::spectrum,
     [] { return replaced(blackbodyText(), "(cm-1)-1", "um-1"); }},
    {"SpectrumOverWavenumbersCalledMicrometres", Kind::spectrum,
     [] { return replaced(blackbodyText(), "cm-1,BB", "um,BB"); }},
    {"SpectrumOverNanometresCalledMicrometres", Kind::plume,
     [] { return mapped(micrometreText(), 0, [](double x) { return 1e3 * x; }); }},
    {"SpectrumOverElectronvolts", Kind::spectrum,
     [] { return replaced(blackbodyText(), "cm-1,BB", "eV,BB"); }},
    {"SpectrumWithASemicolonAmongCommas", Kind::spectrum,
     [] { return replaced(blackbodyText(), linesOf(blackbodyText())[4], "2050;0.001"); }},
    {"SpectrumWithDecimalCommas", Kind::spectrum,
     [] { return replacedAll(blackbodyText(), '.', ","); }},
    {"SpectrumWithTabsForPoints", Kind::spectrum,
     [] { return replacedAll(blackbodyText(), '.', "\t"); }},
    {"SpectrumInSixteenBitsWithoutAMark", Kind::spectrum,
     [] {
         std::string wide;
         for (const char c : blackbodyText()) {
             wide += c;
             wide += '\0';
         }
         return wide;
     }},
    {"SpectrumWithAMissingCell", Kind::spectrum,
     [] { return replaced(blackbodyText(), linesOf(blackbodyText())[4], "2050,"); }},
    {"SpectrumWithNotANumber", Kind::spectrum,
     [] { return replaced(blackbodyText(), linesOf(blackbodyText())[4], "2050,NaN"); }},
    {"SpectrumWithASpreadsheetError", Kind::spectrum,
     [] { return replaced(blackbodyText(), linesOf(blackbodyText())[4], "2050,#DIV/0!"); }},
    {"SpectrumWithADoubledWavelength", Kind::plume,
     [] {
         auto lines = linesOf(spectrumText());
         lines.insert(lines.begin() + 10, lines[10]);
         return joined(lines);
     }},
    {"SpectrumUnsorted", Kind::plume,
     [] {
         auto lines = linesOf(spectrumText());
         std::swap(lines[10], lines[20]);
         return joined(lines);
     }},
    {"SpectrumWithoutNames", Kind::spectrum,
     [] {
         auto lines = linesOf(blackbodyText());
         std::erase_if(lines, [](const std::string& line) { return line.starts_with("cm-1"); });
         return joined(lines);
     }},
    {"SpectrumWithSwappedHeads", Kind::spectrum,
     [] { return replaced(blackbodyText(), "cm-1,BB(T1)", "BB(T1),cm-1"); }},
    {"SpectrumWithOneNameTwice", Kind::plume,
     [] { return replaced(spectrumText(), "cm-1,CO2,H2O", "cm-1,CO2,CO2"); }},
    {"SpectrumCutOffInARow", Kind::plume,
     [] { return spectrumText().substr(0, spectrumText().rfind(',')); }},
    {"SpectrumWithNegativeWavelengths", Kind::plume,
     [] { return mapped(spectrumText(), 0, [](double x) { return x - 2200.0; }); }},
    {"SpectrumWithNegativeRadiance", Kind::plume,
     [] { return mapped(spectrumText(), 1, [](double v) { return -v; }); }},
    {"SpectrumOfAnotherComponent", Kind::plume,
     [] { return replaced(spectrumText(), "cm-1,CO2", "cm-1,carbon dioxide"); }},
    // Tables of surfaces.
    {"MaterialInPercent", Kind::material,
     [] { return mapped(materialText(), 1, [](double v) { return 100.0 * v; }); }},
    {"MaterialBelowZero", Kind::material,
     [] { return mapped(materialText(), 1, [](double v) { return v - 0.99; }); }},
    {"MaterialWithReflectivityThatDoesNotClose", Kind::material,
     [] { return "um,emissivity,transmissivity,reflectivity\n3,0.5,0.2,0.3\n5,0.5,0.2,0.31\n"; }},
    {"MaterialWithASumAboveOne", Kind::material,
     [] { return "um,emissivity,transmissivity\n3,0.5,0.2\n5,0.9,0.2\n"; }},
    {"MaterialOverWavenumbersCalledMicrometres", Kind::material,
     [] { return "um,emissivity\n2000,0.5\n3333,0.9\n"; }},
    {"MaterialOverNanometres", Kind::material,
     [] { return replaced(materialText(), "um,", "nm,"); }},
    {"MaterialOfAnUnknownProperty", Kind::material,
     [] { return replaced(materialText(), "transmissivity\n", "absorptance\n"); }},
    // Tables of factors.
    {"TimesUnsorted", Kind::time, [] { return replaced(timeText, "\n10,", "\n30,"); }},
    {"TimesThatDoNotClose", Kind::time, [] { return replaced(timeText, "\n20,1,1", "\n20,2,1"); }},
    {"TimesWithANegativeFactor", Kind::time, [] { return replaced(timeText, "0.75", "-0.75"); }},
    {"AnglesOfAFullTurn", Kind::angle, [] { return replaced(angleText, "\n180,", "\n360,"); }},
    {"AnglesInRadians", Kind::angle,
     [] { return mapped(angleText, 0, [](double v) { return v * 3.14159265 / 180.0; }); }},
    {"AnglesOfAnUnknownComponent", Kind::angle, [] { return replaced(angleText, "CO2", "CO"); }},
    {"AnglesWithACornerFilled", Kind::angle, [] { return "deg" + angleText; }},
    // JSON by hand.
    {"JsonCutOff", Kind::json, [] { return jsonText().substr(0, jsonText().size() / 2); }},
    {"JsonWithAMisspeltKey", Kind::json,
     [] { return replaced(jsonText(), "\"emissivity\"", "\"emisivity\""); }},
    {"JsonWithAnIndexTwice", Kind::json,
     [] { return replaced(jsonText(), "\"2\": {", "\"1\": {"); }},
    {"JsonInCelsius", Kind::json,
     [] {
         SignatureDatabase database = signatureFromJson(jsonText());
         database.temperatures[1].terms.base_K = celsius(310.0);
         database.temperatures[1].terms.ambientFactor = 0.0;
         return signatureToJson(database);
     }},
    {"JsonWithEmissivityAboveOne", Kind::json,
     [] {
         const std::size_t at = jsonText().find("\"emissivity\": 0.");
         EXPECT_NE(at, std::string::npos);
         return std::string(jsonText()).replace(at, 16, "\"emissivity\": 9.");
     }},
    {"JsonInLatin1", Kind::json,
     [] { return replaced(jsonText(), "\"title\": \"", "\"title\": \"\xe9"); }},
    {"JsonOfANewerVersion", Kind::json,
     [] { return replaced(jsonText(), "\"version\": 1", "\"version\": 2"); }},
    // Files of the database.
    {"DatabaseCutOff", Kind::database,
     [] { return databaseBytes().substr(0, databaseBytes().size() * 2 / 3); }},
    {"DatabaseWithABadSector", Kind::database,
     [] {
         std::string bytes = databaseBytes();
         return bytes.replace(bytes.size() / 2, 512, std::string(512, '\0'));
     }},
    {"DatabaseChangedByAnotherProgram", Kind::database,
     [] { return changedBySql("UPDATE temperature SET base_K = base_K + 1 WHERE id = 1"); }},
    {"DatabaseWithANodeDeleted", Kind::database,
     [] { return changedBySql("DELETE FROM user_spectrum_node WHERE node = 7"); }},
    {"DatabaseWithAnEntryRemoved", Kind::database,
     [] { return changedBySql("DELETE FROM material WHERE id = 2"); }},
};

std::string extensionOf(Kind kind) {
    return kind == Kind::database ? ".sigdb" : kind == Kind::json ? ".json" : ".csv";
}

TEST(DamagedInputs, AreFoundInAtLeastFortyEightOfFiftyCases) {
    const TemporaryFolder folder;
    ASSERT_GE(std::size(damages), 50U);
    int found = 0;
    std::string table = "| damage | what is said |\n|---|---|\n";
    for (const Damage& damage : damages) {
        const fs::path file =
            writeBytes(folder / (damage.name + extensionOf(damage.kind)), damage.make());
        const std::string complaint = complaintAbout(damage.kind, file);
        found += !complaint.empty();
        table += std::string("| ") + damage.name + " | " +
                 (complaint.empty() ? "**nothing**" : complaint) + " |\n";
    }
    RecordProperty("found", found);
    EXPECT_GE(found, static_cast<int>(std::size(damages)) - 2) << table;
    writeBytes(fs::path(SMAT_BINARY_DIR) / "damaged-inputs.md", table);
}

TEST(DamagedInputs, AreToldFromGoodOnes) {
    const TemporaryFolder folder;
    const auto complaint = [&](Kind kind, const std::string& content) {
        return complaintAbout(kind, writeBytes(folder / ("good" + extensionOf(kind)), content));
    };
    EXPECT_EQ(complaint(Kind::database, databaseBytes()), "");
    EXPECT_EQ(complaint(Kind::json, jsonText()), "");
    EXPECT_EQ(complaint(Kind::plume, spectrumText()), "");
    EXPECT_EQ(complaint(Kind::material, materialText()), "");
    EXPECT_EQ(complaint(Kind::time, timeText), "");
    EXPECT_EQ(complaint(Kind::angle, angleText), "");
}

TEST(DamagedInputs, OfNoConsequenceAreReadAsTheyAreMeant) {
    const TemporaryFolder folder;
    const UserSpectrum good = readSpectrumCsv(writeBytes(folder / "a.csv", spectrumText()));
    const std::string harmless[] = {
        "\xEF\xBB\xBF" + spectrumText(),           // byte order mark
        replacedAll(spectrumText(), '\n', "\r\n"), // of another system
        replaced(spectrumText(), "cm-1,CO2,H2O", "\"cm-1\", \"CO2\" ,H2O"),
        spectrumText() + "\n,,\n\n", // empty rows of a spreadsheet
    };
    for (const std::string& text : harmless) {
        EXPECT_TRUE(readSpectrumCsv(writeBytes(folder / "a.csv", text)) == good);
    }
}

} // namespace
} // namespace irsg
