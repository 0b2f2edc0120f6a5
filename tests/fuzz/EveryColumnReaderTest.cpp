#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/SpectraAtmosphere.h"
#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/atmosphere/import/ModtranCsv.h"
#include "irsg/core/ColumnWords.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/Remarks.h"
#include "irsg/gas/PlumePoints.h"
#include "irsg/gas/PlumeTable.h"
#include "irsg/image/CsvImage.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/SpectralHead.h"
#include "irsg/signature/MaterialCsv.h"
#include "irsg/signature/ReflectanceCsv.h"
#include "irsg/signature/SpectrumCsv.h"
#include "smatcore/data/ResultTable.h"
#include "smatcore/simulate/Trajectory.h"
#include "tests/fuzz/SeedTexts.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/WalkedReaders.h"

namespace smat {
namespace {

using test::ownFolder;
using test::writtenFile;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using File = const std::filesystem::path&;

/// All numbers that a reader took, as one text.
class Digest {
  public:
    Digest& add(double value) {
        text_ << irsg::numberText(value) << ' ';
        return *this;
    }
    Digest& add(const std::string& word) {
        text_ << word << ' ';
        return *this;
    }
    template <typename Values>
    Digest& addAll(const Values& values) {
        for (const auto value : values) {
            add(static_cast<double>(value));
        }
        return *this;
    }
    Digest& add(const irsg::Spectrum& spectrum) {
        return addAll(spectrum.wavelengths_um()).addAll(spectrum.values());
    }
    std::string text() const { return text_.str(); }

  private:
    std::ostringstream text_;
};

/// A reader of columns: a plain text that it reads, and what it took of it.
struct ColumnReader {
    const char* name;
    std::string text;
    std::function<std::string(File)> read;
    std::set<std::string> lacks = {}; ///< forms that it need not read
};
void PrintTo(const ColumnReader& reader, std::ostream* out) {
    *out << reader.name;
}

/// The rows of its text, by cells; comments are lines of one cell.
std::vector<std::vector<std::string>> rowsOf(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        rows.emplace_back();
        if (line.starts_with('#')) {
            rows.back().push_back(line);
            continue;
        }
        std::istringstream cells(line + ",");
        for (std::string cell; std::getline(cells, cell, ',');) {
            rows.back().push_back(cell);
        }
    }
    return rows;
}

struct Way {
    std::string separator = ",";
    bool hasDecimalCommas = false, isQuoted = false, hasD = false, isPadded = false;
    std::string lineEnd = "\n", before = {};
    std::string group = {}; ///< between thousands
};

/// The whole part of a number in groups of three digits.
std::string grouped(std::string number, const std::string& sign) {
    const std::size_t whole = std::min(number.find_first_of(".,eE"), number.size());
    for (std::size_t at = whole; at > 3; at -= 3) {
        number.insert(at - 3, sign);
    }
    return number;
}

std::string written(const std::string& text, const Way& way) {
    const auto rows = rowsOf(text);
    std::size_t width = 0;
    for (const auto& row : rows) {
        width = std::max(width, row.size());
    }
    std::string result = way.before;
    for (const auto& row : rows) {
        const bool isComment = row.size() == 1 && row.front().starts_with('#');
        for (std::size_t i = 0; i < row.size(); ++i) {
            std::string cell = row[i];
            const bool isNumber = irsg::parseNumber(cell).has_value();
            if (isNumber && way.hasD && cell.find('e') == std::string::npos) {
                cell += "D+00";
            }
            if (isNumber && way.hasDecimalCommas) {
                std::ranges::replace(cell, '.', ',');
            }
            if (isNumber && !way.group.empty() &&
                (way.group != "." || cell.find(',') != cell.npos)) {
                cell = grouped(cell, way.group);
            }
            if (way.isQuoted && !isComment) {
                cell = "\"" + cell + "\"";
            }
            result += (i > 0 ? way.separator : "") + cell;
        }
        for (std::size_t i = row.size(); way.isPadded && i < width; ++i) {
            result += way.separator;
        }
        result += way.lineEnd;
    }
    return result;
}

std::string asUtf16(const std::string& text) {
    std::string bytes = "\xFF\xFE";
    for (const char c : text) {
        bytes += c;
        bytes += '\0';
    }
    return bytes;
}

struct Form {
    const char* name;
    std::function<std::string(const std::string&)> write;
    const char* remark = nullptr; ///< words of what is said; null: nothing
};

const std::vector<Form>& forms() {
    static const auto as = [](const Way& way) {
        return [way](const std::string& text) { return written(text, way); };
    };
    static const std::vector<Form> all = {
        {"plain", as({})},
        {"semicolons", as({.separator = ";"}), "semicolons"},
        {"semicolons and decimal commas", as({.separator = ";", .hasDecimalCommas = true}),
         "semicolons, decimal commas"},
        {"tabs", as({.separator = "\t"}), "tabs"},
        {"tabs and decimal commas", as({.separator = "\t", .hasDecimalCommas = true}),
         "tabs, decimal commas"},
        {"vertical bars", as({.separator = "|"}), "vertical bars"},
        {"vertical bars and decimal commas", as({.separator = " | ", .hasDecimalCommas = true}),
         "vertical bars, decimal commas"},
        {"blanks", as({.separator = "  "}), "blanks"},
        {"blanks and decimal commas", as({.separator = " ", .hasDecimalCommas = true}),
         "blanks, decimal commas"},
        {"quotes", as({.isQuoted = true})},
        {"quoted decimal commas", as({.hasDecimalCommas = true, .isQuoted = true}),
         "commas, decimal commas"},
        {"quotes and semicolons",
         as({.separator = ";", .hasDecimalCommas = true, .isQuoted = true}),
         "semicolons, decimal commas"},
        {"D exponents", as({.hasD = true})},
        {"D exponents and decimal commas",
         as({.separator = ";", .hasDecimalCommas = true, .hasD = true}), "decimal commas"},
        {"CR line ends", as({.lineEnd = "\r"})},
        {"CR and LF", as({.lineEnd = "\r\n"})},
        {"a byte order mark", as({.before = "\xEF\xBB\xBF"})},
        {"UTF-16", [](const std::string& text) { return asUtf16(text); }},
        {"Latin-1", as({.before = "# gemessen in K\xf6ln\n"}), "Latin-1"},
        {"thousands with blanks", as({.separator = ";", .hasDecimalCommas = true, .group = " "}),
         "semicolons"},
        {"thousands with blanks that do not break",
         as({.separator = "\t", .hasDecimalCommas = true, .group = "\u202f"}), "tabs"},
        {"thousands with apostrophes", as({.separator = ";", .group = "'"}), "semicolons"},
        {"thousands with points before decimal commas",
         as({.separator = ";", .hasDecimalCommas = true, .group = "."}), "semicolons"},
        {"rows made equally wide", as({.isPadded = true})},
        {"sep=;", as({.separator = ";", .hasDecimalCommas = true, .before = "sep=;\n"}),
         "semicolons"},
        {"head lines",
         as({.separator = ";",
             .hasDecimalCommas = true,
             .before = "Instrument;invented\nSerial number;none\n;;\n"}),
         "head lines"},
    };
    return all;
}

std::string factorsOf(File file, irsg::FactorAxis axis) {
    irsg::UserSpectrum spectrum;
    spectrum.components = {{"CO2", {{3.0, 5.0}, {1.0, 1.0}}}, {"soot", {{3.0, 5.0}, {1.0, 1.0}}}};
    irsg::ComponentFactors factors;
    irsg::readFactorCsv(file, axis, false, spectrum, factors);
    Digest digest;
    for (const auto& factor : factors) {
        digest.add(factor.component);
        for (const double position : {0.5, 3.25, 110.5}) {
            digest.add(
                (axis == irsg::FactorAxis::time_s ? factor.time : factor.angle).at(position));
        }
    }
    return digest.text();
}

std::string levelsOf(File file) {
    const auto above = irsg::Profile::model(irsg::ModelAtmosphere::usStandard1976);
    Digest digest;
    const auto air = irsg::Profile::fromRadiosonde(file, above);
    for (const auto& level : air.levels()) {
        digest.add(level.altitude_m).add(level.temperature_K).addAll(level.moleFraction);
    }
    return digest.text();
}

const std::vector<ColumnReader>& readers() {
    static const std::vector<ColumnReader> all = {
        {"image", "1.25,2.5,3.75,4.5\n5.5,6.25,7.5,8.75\n9.5,10.25,11.5,12.75\n",
         [](File file) {
             const irsg::RadianceImage image = irsg::readCsvImage(file);
             return Digest().add(image.width()).addAll(image.primary().values).text();
         }},
        {"response", "wavelength [um],response\n3.25,0.125\n4.5,1\n5.5,0.25\n",
         [](File file) { return Digest().add(irsg::Band::fromCsv(file).response()).text(); }},
        {"spectrum", "# unit: W m-2 sr-1 um-1\num,CO2,soot\n3.5,1.25,2.5\n4.5,0.5,1.75\n",
         [](File file) {
             Digest digest;
             for (const auto& component : irsg::readSpectrumCsv(file).components) {
                 digest.add(component.name).add(component.radiance);
             }
             return digest.text();
         }},
        {"factors", "time [s],CO2,soot\n0.5,1.25,2.5\n1010.5,0.5,1.75\n",
         [](File file) { return factorsOf(file, irsg::FactorAxis::time_s); }},
        {"factors over angle", "angle [deg],CO2,soot\n0.5,1.25,2.5\n110.5,0.5,1.75\n",
         [](File file) { return factorsOf(file, irsg::FactorAxis::angle_deg); }},
        {"material",
         "um,emissivity,transmissivity,reflectivity\n3.5,0.75,0.125,0.125\n4.5,0.5,0.25,0.25\n",
         [](File file) {
             irsg::Material material;
             irsg::readMaterialCsv(file, material);
             return Digest().add(material.emissivity).add(material.transmissivity).text();
         }},
        {"indices", "wl,n,k\n3.5,1.75,0.125\n4.5,1.5,0.25\n",
         [](File file) {
             irsg::Material material;
             irsg::readMaterialCsv(file, material);
             return Digest().add(material.refractiveIndex).add(material.extinction).text();
         }},
        {"reflectance", "incidence_deg,3.5,10.5\n0.5,0.25,0.375\n60.5,0.5,0.625\n",
         [](File file) {
             const auto table = irsg::readReflectanceTable(file);
             Digest digest;
             digest.addAll(table.wavelengths_um());
             for (const auto& row : table.rows()) {
                 digest.add(row.incidence_deg).addAll(row.values);
             }
             return digest.text();
         }},
        {"air",
         "# air_temperature [K]: 290\nwavelength [um],extinction [km-1]\n2.5,0.125\n4.5,0.375\n"
         "14.5,0.25\n",
         [](File file) {
             const auto air = irsg::BeerLambert::fromCsv(file).parameters();
             return Digest().add(air.airTemperature_K).add(air.extinction_per_m).text();
         }},
        {"spectra of air", test::radiativeText(),
         [](File file) {
             const auto air = irsg::SpectraAtmosphere::fromCsv(file).parameters();
             Digest digest;
             for (const auto& [property, spectrum] : air.spectra) {
                 digest.add(spectrum);
             }
             return digest.add(air.targetAltitude_m.value_or(-1.0)).text();
         }},
        {"sounding",
         "altitude [m],pressure [hPa],temperature [K],relative_humidity [%]\n"
         "0,1013.25,288.5,50.5\n1000.5,898.75,281.5,40.25\n2000.5,795,275.25,30.5\n",
         levelsOf},
        {"sounding with dew points",
         "altitude [m],pressure [hPa],temperature [C],dew_point [C]\n"
         "0,1013.25,15.5,5.5\n1000.5,898.75,8.5,1.25\n2000.5,795,2.25,-3.5\n",
         levelsOf},
        {"plume",
         "x [m],r [m],T [K],p [atm],CO2,soot [ppmv]\n0,0,1200.5,1,0.125,0.5\n"
         "0,0.5,900.5,1,0.0625,0.25\n1.5,0,1000.5,1,0.25,1.5\n1.5,0.5,800.25,1,0.03125,0\n",
         [](File file) {
             const auto plume = irsg::PlumeTable::read(file);
             Digest digest;
             for (std::size_t x = 0; x < 2; ++x) {
                 for (std::size_t r = 0; r < 2; ++r) {
                     irsg::GasLayer gas = plume.node(x, r);
                     digest.add(gas.temperature_K).add(gas.pressure_atm);
                     digest.add(gas.fraction(irsg::HotGas::CO2)).add(gas.soot_ppmv);
                 }
             }
             return digest.addAll(plume.x_m()).addAll(plume.r_m()).text();
         }},
        {"plume points",
         "x [m],y [m],z [m],T [K],p [atm],CO2,soot [ppmv]\n0,0,0,1200.5,1,0.125,0.5\n"
         "0,0,1.5,900.5,1,0.0625,0.25\n0,1.5,0,1000.5,1,0.25,1.5\n0,1.5,1.5,800.25,1,0.03125,0\n"
         "2.5,0,0,1100.5,1,0.125,0.5\n2.5,0,1.5,850.5,1,0.0625,0.25\n"
         "2.5,1.5,0,950.5,1,0.25,1.5\n2.5,1.5,1.5,750.25,1,0.03125,0\n",
         [](File file) {
             const auto field = irsg::readPlumePoints(irsg::CsvTable::read(file));
             Digest digest;
             for (const irsg::PlumeField::Node& node : field.nodes()) {
                 irsg::GasLayer gas = node.gas();
                 digest.add(gas.temperature_K).add(gas.pressure_atm);
                 digest.add(gas.fraction(irsg::HotGas::CO2)).add(gas.soot_ppmv);
             }
             return digest.addAll(field.axes_m()[0]).addAll(field.axes_m()[2]).text();
         }},
        {"MODTRAN",
         test::modtranCsvText(),
         [](File file) {
             Digest digest;
             for (const auto& run : irsg::readModtranCsv(file)) {
                 digest.addAll(run.wavenumbers_per_cm).addAll(run.transmittance);
             }
             return digest.text();
         },
         {"head lines"}},
        {"trajectory",
         "t [s],x [m],y [m],z [m],yaw [deg],pitch [deg],roll [deg],mach\n"
         "0,0.5,1.5,1100.25,0,0,0,0.5\n1.5,10.5,0,1100.5,5.25,0,0,0.75\n",
         [](File file) {
             Digest digest;
             for (const auto& row : TrajectoryTable::read(file).rows) {
                 digest.addAll(row);
             }
             return digest.text();
         }},
        {"results", "# command: polar\nangle [deg],intensity [W sr-1]\n0,1.25\n90.5,2.75\n",
         [](File file) {
             Digest digest;
             const ResultTable table = ResultTable::load(file);
             for (const auto& column : table.columns()) {
                 digest.add(column.header()).addAll(column.values);
             }
             return digest.text();
         }},
    };
    return all;
}

class EveryColumnReader : public testing::TestWithParam<ColumnReader> {};

TEST_P(EveryColumnReader, TakesTheSameNumbersFromEveryFormAndSaysWhatItTook) {
    const ColumnReader& reader = GetParam();
    const auto file = ownFolder() / "columns.csv";
    const std::string expected = reader.read(writtenFile(file, reader.text));
    std::size_t read = 0;
    for (const Form& form : forms()) {
        if (reader.lacks.contains(form.name)) {
            continue;
        }
        SCOPED_TRACE(form.name);
        writtenFile(file, form.write(reader.text));
        const irsg::CollectedRemarks remarks;
        try {
            EXPECT_EQ(reader.read(file), expected);
            ++read;
        } catch (const irsg::InputError& error) {
            ADD_FAILURE() << error.what();
        }
        if (form.remark == nullptr) {
            EXPECT_THAT(remarks.sentences(), IsEmpty());
        } else {
            EXPECT_THAT(remarks.sentences(), Contains(HasSubstr(form.remark)));
        }
    }
    EXPECT_EQ(read, forms().size() - reader.lacks.size());
}

TEST_P(EveryColumnReader, RefusesNumbersOfTwoDecimalSignsByLineAndValue) {
    const ColumnReader& reader = GetParam();
    // One value in the last row with a point, all others with commas.
    std::string text = written(reader.text, {.separator = ";", .hasDecimalCommas = true});
    const std::size_t row = text.find_last_of('\n', text.size() - 2) + 1;
    const std::size_t cell = text.find(';', row) + 1;
    ASSERT_NE(cell, 0U);
    text.replace(cell, text.find_first_of(";\n", cell) - cell, "0.5");
    const auto file = writtenFile(ownFolder() / "columns.csv", text);
    const std::size_t line = static_cast<std::size_t>(std::ranges::count(reader.text, '\n'));
    try {
        reader.read(file);
        ADD_FAILURE() << "accepted";
    } catch (const irsg::InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("line " + std::to_string(line)));
    }
}

/// The places of heads in a text: cells of its row of names, and keys of its comments.
struct HeadPlace {
    std::size_t begin = 0;
    std::string head;
};
std::vector<HeadPlace> headsOf(const std::string& text) {
    std::vector<HeadPlace> heads;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin);
        if (text[begin] == '#') {
            const std::size_t colon = text.find(':', begin);
            heads.push_back({begin + 2, text.substr(begin + 2, colon - begin - 2)});
        } else {
            for (std::size_t cell = begin; cell <= end;) {
                const std::size_t comma = std::min(text.find(',', cell), end);
                heads.push_back({cell, text.substr(cell, comma - cell)});
                cell = comma + 1;
            }
            return heads;
        }
        begin = end + 1;
    }
    return heads;
}

struct OtherHead {
    std::string head, word; ///< word: the row of a table that it comes from
};

/// A head in every other word for its name, and every other spelling of its unit.
std::vector<OtherHead> otherHeads(const std::string& head) {
    const irsg::ColumnHead meant = irsg::columnHead(head);
    std::vector<OtherHead> others;
    for (const auto& [word, name] : irsg::columnWords()) {
        if (name == meant.name) {
            const std::string unit = meant.unit.empty() ? "" : " [" + meant.unit + "]";
            others.push_back({std::string(word) + unit, std::string(word)});
        }
    }
    for (const auto& [spelling, unit] : irsg::columnUnits()) {
        // Names of components have none.
        if (unit != meant.unit || (unit.empty() && meant.name != "mach")) {
            continue;
        }
        for (const char* form : {" [", " (", " in "}) {
            const std::string close = form[1] == '[' ? "]" : form[1] == '(' ? ")" : "";
            if (!close.empty() || !unit.empty()) {
                others.push_back(
                    {meant.name + form + std::string(spelling) + close, std::string(spelling)});
            }
        }
    }
    return others;
}

TEST(EveryColumnReaderOf, OtherWordsAndSpellingsOfUnitsTakesTheSameNumbers) {
    const auto file = ownFolder() / "columns.csv";
    std::set<std::string> walked;
    for (const ColumnReader& reader : readers()) {
        const std::string expected = reader.read(writtenFile(file, reader.text));
        for (const HeadPlace& place : headsOf(reader.text)) {
            for (const OtherHead& other : otherHeads(place.head)) {
                std::string text = reader.text;
                text.replace(place.begin, place.head.size(), other.head);
                SCOPED_TRACE(std::string(reader.name) + ": " + other.head);
                writtenFile(file, text);
                try {
                    // Results keep the names that their file has.
                    EXPECT_TRUE(reader.read(file) == expected ||
                                std::string(reader.name) == "results");
                    walked.insert(other.word);
                } catch (const irsg::InputError& error) {
                    ADD_FAILURE() << error.what();
                }
            }
        }
    }
    // Each row of the tables is one of a reader's, and stands on the page.
    const std::string page =
        irsg::readFile(std::filesystem::path(SMAT_SOURCE_DIR) / "docs/formats-images.md");
    const auto stands = [&](std::string_view word) {
        return page.find("`" + std::string(word) + "`") != page.npos;
    };
    for (const irsg::ColumnWord& word : irsg::columnWords()) {
        EXPECT_TRUE(walked.contains(std::string(word.word)) && stands(word.word)) << word.word;
    }
    const std::set<std::string_view> others = {"nm", "angstrom", "m-1"}; // other numbers
    for (const irsg::ColumnUnit& unit : irsg::columnUnits()) {
        EXPECT_TRUE(walked.contains(std::string(unit.spelling)) || others.contains(unit.unit))
            << unit.spelling;
        EXPECT_TRUE(stands(unit.spelling)) << unit.spelling;
    }
    test::expectWalked("words at heads of columns that stand for others",
                       irsg::columnWords().size());
    test::expectWalked("spellings of units at heads of columns", irsg::columnUnits().size());
}

/// A text whose wavelengths are those of another unit.
std::string inUnit(const std::string& text, std::size_t column, const std::string& head,
                   double factor) {
    std::string result;
    bool isBehindHead = false;
    for (auto& row : rowsOf(text)) {
        const bool isComment = row.size() == 1 && row.front().starts_with('#');
        if (!isComment) {
            row[column] =
                isBehindHead ? irsg::numberText(factor * *irsg::parseNumber(row[column])) : head;
        }
        isBehindHead = isBehindHead || !isComment;
        for (std::size_t i = 0; i < row.size(); ++i) {
            result += (i > 0 ? "," : "") + row[i];
        }
        result += "\n";
    }
    return result;
}

TEST(EveryColumnReaderOf, SpectraTakesNanometresAndAngstroms) {
    const auto file = ownFolder() / "columns.csv";
    std::size_t count = 0;
    for (const ColumnReader& reader : readers()) {
        std::size_t column = 0;
        for (const HeadPlace& place : headsOf(reader.text)) {
            const auto axis = irsg::spectralHead(place.head);
            const bool isComment = place.begin >= 2 && reader.text[place.begin - 2] == '#';
            if (axis && axis->axis == irsg::SpectralAxis::wavelength) {
                ++count;
                const std::string expected = reader.read(writtenFile(file, reader.text));
                for (const auto& [head, factor] :
                     {std::pair("nm", 1e3), std::pair("Wellenl\u00e4nge [nm]", 1e3),
                      std::pair("\u00c5", 1e4), std::pair("wavelength [\u212b]", 1e4),
                      std::pair("Wavelength (Angstrom)", 1e4),
                      std::pair("longueur d'onde (\u00e5ngstr\u00f6m)", 1e4)}) {
                    SCOPED_TRACE(std::string(reader.name) + ": " + head);
                    writtenFile(file, inUnit(reader.text, column, head, factor));
                    try {
                        EXPECT_EQ(reader.read(file), expected);
                    } catch (const irsg::InputError& error) {
                        ADD_FAILURE() << error.what();
                    }
                }
            }
            column += isComment ? 0 : 1;
        }
    }
    EXPECT_EQ(count, 5U) << "response, spectrum, material, air, spectra of air";
}

TEST(WalkedReaders, OfColumnsAreAsManyAsThePageHas) {
    test::expectWalked("separators, decimal signs, quotes, exponents, head lines",
                       readers().size());
    test::expectWalked("forms of columns that each of them reads", forms().size());
}

INSTANTIATE_TEST_SUITE_P(Of, EveryColumnReader, testing::ValuesIn(readers()), [](const auto& row) {
    std::string name = row.param.name;
    std::erase(name, ' ');
    return name;
});

} // namespace
} // namespace smat
