#include "irsg/signature/EntryFields.h"

#include <set>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include "irsg/core/Errors.h"
#include "irsg/signature/ClampedTables.h"
#include "irsg/signature/EntryJson.h"
#include "irsg/signature/Lint.h"
#include "irsg/signature/SignatureFile.h"

#include "Support.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

using smat::test::TemporaryFolder;
using testing::ElementsAre;

/// A database in which nothing but the entry it is asked for is.
SignatureDatabase holding(const TemperatureEntry& entry) {
    SignatureDatabase database;
    database.spectra["plume core"] = completeDatabase().spectra.at("plume core");
    database.temperatures[3] = entry;
    return database;
}
SignatureDatabase holding(const TemperatureTerms& terms) {
    TemperatureEntry entry;
    entry.terms = terms;
    return holding(entry);
}
SignatureDatabase holding(const ComponentFactor& factor) {
    TemperatureEntry entry;
    entry.mode = EmissionMode::userSpectrum;
    entry.userSpectrum = "plume core";
    entry.factors = {factor};
    return holding(entry);
}
SignatureDatabase holding(const Material& material) {
    SignatureDatabase database;
    database.materials[3] = material;
    return database;
}
SignatureDatabase holding(const UserSpectrum& spectrum) {
    SignatureDatabase database;
    database.spectra[spectrum.name] = spectrum;
    return database;
}

TemperatureTerms sound(const TemperatureTerms& /*kind*/) {
    return TemperatureTerms::ofAmbient();
}
TemperatureEntry sound(const TemperatureEntry& /*kind*/) {
    TemperatureEntry entry;
    entry.terms = TemperatureTerms::ofAmbient();
    return entry;
}
ComponentFactor sound(const ComponentFactor& /*kind*/) {
    return {"H2O", 1.0, {}, {}};
}
Material sound(const Material& /*kind*/) {
    Material material;
    material.emissivity = Spectrum::constant(0.5);
    return material;
}
UserSpectrum sound(const UserSpectrum& /*kind*/) {
    return completeDatabase().spectra.at("plume core");
}

/// Another value than any of the above has.
void change(std::string& text) {
    text = text.empty() || text == "H2O" ? "CO2(T4)" : text + " and more";
}
void change(double& number) {
    number += 0.125;
}
void change(Spectrum& spectrum) {
    spectrum = Spectrum({2.0, 4.0, 14.0}, {0.25, 0.125, 0.5});
}
void change(LookupTable& table) {
    table = LookupTable({0.0, 90.0, 180.0}, {0.5, 1.0, 0.5});
}
void change(EmissionMode& mode) {
    mode = EmissionMode::userSpectrum;
}
void change(ReflectanceTable& table) {
    table = {false, {3.0, 5.0}, {{0, 0, 0, {0.25, 0.5}}, {80, 0, 0, {0.5, 0.75}}}};
}
void change(FactorSelection& selection) {
    selection = FactorSelection::constant;
}
void change(TemperatureTerms& terms) {
    terms.base_K += 1.0;
}
void change(ComponentFactors& factors) {
    factors = {{"H2O", 0.5, {}, {}}};
}

template <typename Entry>
class EveryField : public testing::Test {
  public:
    static std::span<const EntryField<Entry>> fields();
};
template <>
std::span<const EntryField<TemperatureTerms>> EveryField<TemperatureTerms>::fields() {
    return termFields();
}
template <>
std::span<const EntryField<ComponentFactor>> EveryField<ComponentFactor>::fields() {
    return geometryBuffers();
}
template <>
std::span<const EntryField<TemperatureEntry>> EveryField<TemperatureEntry>::fields() {
    return temperatureFields();
}
template <>
std::span<const EntryField<Material>> EveryField<Material>::fields() {
    return materialFields();
}
template <>
std::span<const EntryField<UserSpectrum>> EveryField<UserSpectrum>::fields() {
    return spectrumFields();
}

using Entries =
    testing::Types<TemperatureTerms, ComponentFactor, TemperatureEntry, Material, UserSpectrum>;
TYPED_TEST_SUITE(EveryField, Entries);

TYPED_TEST(EveryField, IsKeptByBothFormsOfTheFileAndSeenByTheHash) {
    const TemporaryFolder folder;
    for (const auto& field : TestFixture::fields()) {
        SCOPED_TRACE(field.key);
        TypeParam entry = sound(TypeParam());
        const SignatureDatabase before = holding(entry);
        std::visit([&](auto member) { change(entry.*member); }, field.member);
        SignatureDatabase database = holding(entry);
        // Of texts that are words, one of them.
        if (const auto text = field.template as<std::string>(); text && field.words) {
            entry.*text = field.words().front();
            database = holding(entry);
        }
        if (std::string(field.key) == "mode") {
            database.temperatures.at(3).userSpectrum = "plume core";
        }
        ASSERT_FALSE(database == before) << "the test changes nothing";

        const auto file = folder / (std::string(field.key) + ".sigdb");
        saveSignatureFile(database, file);
        EXPECT_TRUE(loadSignatureFile(file).database == database);
        EXPECT_TRUE(signatureFromJson(signatureToJson(database), "a.json") == database);
        EXPECT_NE(canonicalEntries(database), canonicalEntries(before));
    }
}

TYPED_TEST(EveryField, HasAKeyAndAColumnOfItsOwnAndMakesNoWarningAsItStands) {
    std::set<std::string> keys;
    std::set<std::string> columns;
    for (const auto& field : TestFixture::fields()) {
        EXPECT_TRUE(keys.insert(field.key).second) << field.key;
        EXPECT_TRUE(columns.insert(field.column).second) << field.column;
        EXPECT_GE(field.since, 1);
    }
    EXPECT_TRUE(lint(holding(sound(TypeParam()))).empty());
}

TYPED_TEST(EveryField, ThatIsANumberIsRefusedOutsideOfItsRange) {
    forEachField<double>(TestFixture::fields(), [&](const auto& field, auto member) {
        for (const double wrong :
             {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity(),
              field.number.least - 1.0, field.number.most + 1.0}) {
            TypeParam entry = sound(TypeParam());
            entry.*member = wrong;
            const auto findings = lint(holding(entry));
            ASSERT_FALSE(findings.empty()) << field.key << " = " << wrong;
            EXPECT_TRUE(findings.front().isError()) << field.key << " = " << wrong;
            EXPECT_TRUE(findings.front().place.ends_with(std::string(".") + field.key))
                << findings.front().place;
        }
    });
}

TYPED_TEST(EveryField, ThatIsATableWarnsWhereItHoldsAnEnd) {
    forEachField<LookupTable>(TestFixture::fields(), [&](const auto& field, auto member) {
        TypeParam entry = sound(TypeParam());
        const EntityState state{.time_s = 2.0,
                                .power = 2.0,
                                .mach = 2.0,
                                .altitude_m = 2.0,
                                .ambient_K = 2.0,
                                .aspectAngle_rad = 2.0};
        const double position = field.table.position(state);
        entry.*member = LookupTable({0.25 * position, 0.5 * position}, {1.0, 1.0});
        const auto held = clampedTables(holding(entry), state);
        ASSERT_EQ(held.size(), 1U) << field.key;
        EXPECT_TRUE(held.front().ends_with(std::string(".") + field.key)) << held.front();
    });
}

int versionOf(const std::filesystem::path& file) {
    SQLite::Database sqlite(file.string());
    return sqlite.execAndGet("PRAGMA user_version").getInt();
}

TEST(EntryFields, OfALaterVersionChangeNothingWhereTheySayNothing) {
    const TemporaryFolder folder;
    const SignatureDatabase silent = completeDatabase();
    EXPECT_EQ(formatVersionOf(silent), 1);
    saveSignatureFile(silent, folder / "a.sigdb");
    EXPECT_EQ(versionOf(folder / "a.sigdb"), 1);
    EXPECT_THAT(signatureToJson(silent), testing::HasSubstr("\"version\": 1"));
    EXPECT_THAT(signatureToJson(silent), testing::Not(testing::HasSubstr("ambient_K\"")));
    SQLite::Database sqlite((folder / "a.sigdb").string());
    EXPECT_THAT(sqlite.execAndGet("SELECT group_concat(sql) FROM sqlite_master").getString(),
                testing::Not(testing::HasSubstr("'ambient_K'")));
}

TEST(EntryFields, OfALaterVersionMakeAFileThatOlderProgramsRefuse) {
    const TemporaryFolder folder;
    SignatureDatabase database = completeDatabase();
    database.temperatures.at(0).terms.ambient = LookupTable({240.0, 300.0}, {-2.0, 3.0});
    EXPECT_EQ(formatVersionOf(database), 2);
    saveSignatureFile(database, folder / "a.sigdb");
    EXPECT_EQ(versionOf(folder / "a.sigdb"), 2);
    EXPECT_TRUE(loadSignatureFile(folder / "a.sigdb").database == database);
    EXPECT_THAT(signatureToJson(database), testing::HasSubstr("\"version\": 2"));

    // Without it, the same file is one of before again.
    saveSignatureFile(completeDatabase(), folder / "a.sigdb");
    EXPECT_EQ(versionOf(folder / "a.sigdb"), 1);
    EXPECT_TRUE(loadSignatureFile(folder / "a.sigdb").database == completeDatabase());
}

TEST(EntryFields, EachVersionIsAskedForByWhatItBrought) {
    const TemporaryFolder folder;
    SignatureDatabase database = completeDatabase();
    UserSpectrum& plume = database.spectra.at("plume core");
    plume.calibrationFactor = 0.9;
    saveSignatureFile(database, folder / "a.sigdb");
    EXPECT_EQ(versionOf(folder / "a.sigdb"), 3);
    EXPECT_EQ(loadSignatureFile(folder / "a.sigdb").database.spectra.at("plume core"), plume);
    EXPECT_THAT(signatureToJson(database), testing::HasSubstr("\"calibrationFactor\": 0.9"));
    plume.calibrationFactor = 1.0;
    EXPECT_EQ(formatVersionOf(database), 1);
    TemperatureEntry entry;
    entry.mode = EmissionMode::userSpectrum;
    entry.userSpectrum = "plume core";
    entry.factors = {{"H2O", 0.5, LookupTable({0.0, 1.0}, {0.2, 0.4}), {}}};
    database = holding(entry);
    EXPECT_EQ(formatVersionOf(database), 1);
    database.temperatures.at(3).factors.front().selection = FactorSelection::constant;
    saveSignatureFile(database, folder / "b.sigdb");
    EXPECT_EQ(versionOf(folder / "b.sigdb"), 5);
    EXPECT_THAT(signatureToJson(database), testing::HasSubstr("\"selection\": \"constant\""));
}

TEST(EntryFields, ASelectionThatNobodyKnowsIsRefusedByItsPlace) {
    TemperatureEntry entry;
    entry.mode = EmissionMode::userSpectrum;
    entry.userSpectrum = "plume core";
    entry.factors = {{"H2O", 0.5, {}, {}, FactorSelection::constant}};
    std::string text = signatureToJson(holding(entry));
    const std::size_t at = text.find("\"selection\": \"constant\"");
    ASSERT_NE(at, std::string::npos);
    text.replace(at + 14, 8, "both");
    try {
        signatureFromJson(text, "a.json");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("temperatures.3.factors[0].selection"));
        EXPECT_THAT(error.what(),
                    testing::HasSubstr("found \"both\", expected 'table' or 'constant'"));
    }
}

TEST(EntryFields, TablesOfReflectanceAreKeptByBothForms) {
    const TemporaryFolder folder;
    SignatureDatabase database = completeDatabase();
    std::vector<ReflectanceTable::Row> rows;
    for (const double incidence_deg : {0.0, 60.0}) {
        for (const double reflection_deg : {0.0, 30.0, 90.0}) {
            for (const double azimuth_deg : {0.0, 180.0}) {
                rows.push_back({incidence_deg, reflection_deg, azimuth_deg, {0.1, 0.2}});
            }
        }
    }
    Material& material = database.materials[77];
    material.surfaceModel = "tabulated";
    material.reflectanceTable = {true, {3.4, 10.6}, rows};
    EXPECT_EQ(formatVersionOf(database), 6);
    saveSignatureFile(database, folder / "a.sigdb");
    EXPECT_TRUE(loadSignatureFile(folder / "a.sigdb").database == database);
    const std::string text = signatureToJson(database);
    EXPECT_TRUE(signatureFromJson(text, "a.json") == database);
    // What is wrong in JSON is told by its place.
    const auto told = [&](const std::string& from, const std::string& to) -> std::string {
        std::string wrong = text;
        wrong.replace(wrong.find(from), from.size(), to);
        try {
            signatureFromJson(wrong, "a.json");
        } catch (const InputError& error) {
            return error.what();
        }
        return "nothing";
    };
    EXPECT_THAT(told("\"brdf\"", "\"btdf\""), testing::HasSubstr("reflectanceTable.kind"));
    EXPECT_THAT(told("[0, 0, 180, 0.1, 0.2]", "[0, 0, 170, 0.1, 0.2]"),
                testing::HasSubstr("every direction"));
    EXPECT_THAT(told("[3.4, 10.6]", "[10.6, 3.4]"), testing::HasSubstr("ascend"));
}

TEST(EntryFields, CelsiusTakenForKelvinIsSuspectedAndRepaired) {
    SignatureDatabase database = completeDatabase();
    database.temperatures.at(-7).terms.ambient = LookupTable({-20.0, 30.0}, {-2.0, 3.0});
    ASSERT_EQ(repairAll(database).size(), 1U);
    EXPECT_EQ(database.temperatures.at(-7).terms.ambient.x(),
              (std::vector{-20.0 + 273.15, 30.0 + 273.15}));
}

TEST(EntryFields, StandInTheDescriptionOfTheFormat) {
    const std::string page =
        readBytes(std::filesystem::path(SMAT_SOURCE_DIR) / "docs" / "formats-sigdb.md");
    const auto expectAll = [&](auto fields) {
        for (const auto& field : fields) {
            EXPECT_THAT(page,
                        testing::AnyOf(testing::HasSubstr("`" + std::string(field.key) + "`"),
                                       testing::HasSubstr("\"" + std::string(field.key) + "\"")));
        }
    };
    expectAll(termFields());
    expectAll(geometryBuffers());
    expectAll(temperatureFields());
    expectAll(materialFields());
    expectAll(spectrumFields());
}

} // namespace
} // namespace irsg
