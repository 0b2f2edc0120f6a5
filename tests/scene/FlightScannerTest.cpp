#include "irsg/geometry/flight/FlightScanner.h"

#include <cstdio>
#include <functional>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/geometry/model/Model.h"
#include "tests/support/FlightBytes.h"

using namespace irsg;
using namespace irsg::test;
namespace fs = std::filesystem;
using testing::HasSubstr;

namespace {

const fs::path data = fs::path(SMAT_SOURCE_DIR) / "tests/data/models";

/// Temperature and material code of every face, in the order the oracle prints them.
std::vector<IrCodes> oracleCodes(const fs::path& file) {
    const auto tool = sharedModels() / "tools/parse_flt_ir.py";
    const auto command = "python3 -c \"import json,subprocess,sys\n"
                         "out=subprocess.run(['python3','" +
                         tool.string() + "','-r','--json','" + file.string() +
                         "'],capture_output=True).stdout\n"
                         "for f in json.loads(out):\n"
                         "  for g in f['faces']: print(g['irc'],g['irm'])\"";
    std::vector<IrCodes> codes;
    FILE* pipe = popen(command.c_str(), "r");
    for (IrCodes pair;
         pipe && std::fscanf(pipe, "%d %d", &pair.temperature, &pair.material) == 2;) {
        codes.push_back(pair);
    }
    if (pipe) {
        pclose(pipe);
    }
    return codes;
}

std::vector<IrCodes> scannedCodes(const FlightScan& scan) {
    std::vector<IrCodes> codes;
    for (const auto& file : scan.files) {
        for (const auto& face : file.faces) {
            codes.push_back(face.codes);
        }
    }
    return codes;
}

struct BadFile {
    const char* name;
    std::function<void(SquareFile&)> damage;
    std::function<std::string(const SquareFile&)> position;
    const char* says;
};

std::function<std::string(const SquareFile&)> at(std::string SquareFile::*part,
                                                 std::size_t within = 0) {
    return [=](const SquareFile& file) { return file.positionOf(part, within); };
}

void PrintTo(const BadFile& file, std::ostream* out) {
    *out << file.name;
}

class BadFlight : public testing::TestWithParam<BadFile> {};

} // namespace

TEST(FlightScanner, ReadsTheCodesOfAFaceWithItsPlaceAndType) {
    SquareFile file;
    file.temperature = -5;
    file.material = std::numeric_limits<int>::max();
    file.drawType = 1;
    file.flags = 0x10000000 | 0x04000000;
    file.remake();
    const auto scan = scanFlightBytes(file.bytes(), "square.flt");
    ASSERT_EQ(scan.faces.size(), 1u);
    const auto& face = scan.faces.front();
    EXPECT_EQ(face.codes, (IrCodes{-5, std::numeric_limits<int>::max()}));
    EXPECT_EQ(face.id, "face");
    EXPECT_EQ(face.drawType, 1);
    EXPECT_TRUE(face.hidden);
    EXPECT_TRUE(face.normals);
    EXPECT_EQ(face.vertices, 4);
    EXPECT_EQ(face.offset, file.offsetOf(&SquareFile::face));
}

TEST(FlightScanner, ReadsTheCodesOfAMeshFourBytesFartherOn) {
    SquareFile file;
    file.face = meshRecords();
    file.pushFace = file.list = file.popFace = "";
    const auto scan = scanFlightBytes(file.bytes(), "mesh.flt");
    ASSERT_EQ(scan.faces.size(), 1u);
    EXPECT_TRUE(scan.faces.front().mesh);
    EXPECT_EQ(scan.faces.front().codes, (IrCodes{7, 8}));
}

TEST(FlightScanner, TakesTheLongIdForTheShortOne) {
    SquareFile file;
    file.face += record(flight::longId, "a name of some length" + zeros(1));
    EXPECT_EQ(scanFlightBytes(file.bytes(), "x.flt").faces.front().id, "a name of some length");
}

TEST(FlightScanner, KnowsTheUnitsOfLength) {
    for (const auto& [code, metres] :
         {std::pair{0, 1.0}, {1, 1000.0}, {4, 0.3048}, {5, 0.0254}, {8, 1852.0}}) {
        SquareFile file;
        file.unit = code;
        file.remake();
        EXPECT_DOUBLE_EQ(scanFlightBytes(file.bytes(), "x.flt").unit_m, metres);
    }
}

TEST(FlightScanner, AcceptsZeroPaddingAndAPopOfTheOtherByteOrderAtTheEnd) {
    SquareFile padded;
    padded.trailer = zeros(777);
    EXPECT_EQ(scanFlightBytes(padded.bytes(), "x.flt").faces.size(), 1u);
    SquareFile swapped;
    swapped.pop = std::string("\x0B\x00\x04\x00", 4);
    EXPECT_EQ(scanFlightBytes(swapped.bytes(), "x.flt").faces.size(), 1u);
}

TEST(FlightScanner, LeavesOutAVertexThatPointsBetweenThoseOfThePalette) {
    SquareFile file;
    file.list = record(flight::vertexList, i32(8) + i32(80) + i32(120) + i32(176));
    const auto scan = scanFlightBytes(file.bytes(), "x.flt");
    EXPECT_EQ(scan.faces.front().vertices, 3);
    ASSERT_EQ(scan.remarks.size(), 1u);
    EXPECT_THAT(scan.remarks.front(), HasSubstr("between the vertices"));
}

TEST(FlightScanner, KeepsTheRecordsOfAnUndamagedFileInTheVisibleStream) {
    const SquareFile file;
    const auto scan = scanFlightBytes(file.bytes(), "x.flt");
    EXPECT_EQ(scan.stream(FlightFile::Purpose::visible), file.bytes());
    EXPECT_EQ(scan.stream(FlightFile::Purpose::infrared), file.bytes());
}

TEST(FlightScanner, SetsTheLightModeOfTheInfraredStreamByTheNormals) {
    SquareFile unlit;
    unlit.lightMode = 1;
    unlit.remake();
    const auto place = unlit.offsetOf(&SquareFile::face) + 48;
    EXPECT_EQ(scanFlightBytes(unlit.bytes(), "x.flt").stream(FlightFile::Purpose::infrared)[place],
              3);

    SquareFile bare; // vertices without normals: 40 bytes each
    bare.vertices = "";
    for (int i = 0; i < 4; ++i) {
        bare.vertices +=
            record(flight::vertexC, zeros(4) + f64(i % 3) + f64(i / 2) + f64(0) + zeros(8));
    }
    bare.palette = record(flight::vertexPalette, i32(8 + 4 * 40));
    bare.list = record(flight::vertexList, i32(8) + i32(48) + i32(88) + i32(128));
    EXPECT_EQ(scanFlightBytes(bare.bytes(), "x.flt")
                  .stream(FlightFile::Purpose::infrared)[bare.offsetOf(&SquareFile::face) + 48],
              0);
}

TEST(FlightScanner, FollowsReferencesOnceEachWithEitherSlash) {
    const auto scan = scanFlight(data / "tricky_1640.flt");
    ASSERT_EQ(scan.files.size(), 2u);
    EXPECT_EQ(scan.files[1].path, data / "sub/part.flt");
    EXPECT_EQ(scan.files[0].externals.size(), 2u);
    EXPECT_EQ(scan.faceCounts().at({501, 601}), 1);
}

TEST(FlightScanner, FollowsReferencesInOtherUpperAndLowerCaseAndSaysSo) {
    const TemporaryFolder folder;
    folder.write("part.flt", SquareFile().bytes());
    SquareFile file;
    file.group = record(flight::externalReference, "PART.FLT" + zeros(192 + 12)) + file.group;
    const auto scan = scanFlight(folder.write("a.flt", file.bytes()));
    ASSERT_EQ(scan.files.size(), 2u);
    EXPECT_EQ(scan.files[1].path.filename(), "part.flt");
    EXPECT_THAT(scan.files[0].remarks, testing::Contains("the name PART.FLT is read as part.flt"));
}

TEST(FlightScanner, RefusesAReferenceThatLeadsNowhereNamingBothFiles) {
    const TemporaryFolder folder;
    SquareFile file;
    file.group = record(flight::externalReference, "lost.flt" + zeros(192 + 12)) + file.group;
    const auto path = folder.write("a.flt", file.bytes());
    try {
        scanFlight(path);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("a.flt"));
        EXPECT_THAT(error.what(), HasSubstr("lost.flt"));
        EXPECT_EQ(error.diagnostics().front().position, file.positionOf(&SquareFile::group));
    }
}

TEST(FlightScanner, RefusesReferencesInACircle) {
    const TemporaryFolder folder;
    const auto refer = [](const std::string& name) {
        SquareFile file;
        file.group =
            record(flight::externalReference, name + zeros(200 - name.size() + 12)) + file.group;
        return file.bytes();
    };
    folder.write("b.flt", refer("a.flt"));
    const auto path = folder.write("a.flt", refer("b.flt"));
    try {
        scanFlight(path);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("refers back"));
    }
}

TEST(FlightScanner, ReadsLevelsThatNoNodeOpens) {
    using Change = void (*)(SquareFile&);
    const struct {
        const char* name;
        Change change;
        const char* levels;
    } rows[] = {
        {"header, push, push, group",
         [](SquareFile& f) {
             f.push += f.push;
             f.pop += f.pop;
         },
         "1 levels"},
        {"three above an object",
         [](SquareFile& f) {
             f.pushGroup += f.push + f.push + f.push;
             f.popGroup += f.pop + f.pop + f.pop;
         },
         "3 levels"},
        {"between a face and its vertices",
         [](SquareFile& f) {
             f.pushFace += f.push;
             f.popFace += f.pop;
         },
         "1 levels"},
        {"a second one behind a node's own",
         [](SquareFile& f) {
             f.face = f.face + f.pushFace + f.list + f.popFace + f.push + f.face;
             f.popFace += f.pop;
         },
         "1 levels"},
        {"an empty one", [](SquareFile& f) { f.popFace += f.push + f.pop; }, "1 levels"},
        {"within a switch of one child",
         [](SquareFile& f) {
             f.group = record(flight::switchNode,
                              "switch" + zeros(2) + zeros(4) + i32(0) + i32(1) + i32(1) + i32(1));
             f.pushGroup += f.push;
             f.popGroup += f.pop;
         },
         "1 levels"},
    };
    const TemporaryFolder folder;
    for (const auto& row : rows) {
        SquareFile file;
        row.change(file);
        const auto path = folder.write("a.flt", file.bytes());
        const auto scan = scanFlight(path);
        EXPECT_THAT(scan.files.front().remarks, testing::Contains(HasSubstr(row.levels)))
            << row.name;
        const auto model = Model::load(path);
        const double faces = static_cast<double>(scan.files.front().faces.size());
        EXPECT_EQ(model->codes().at({1, 2}).faces, static_cast<int>(faces)) << row.name;
        EXPECT_NEAR(model->codes().at({1, 2}).area_m2, faces, 1e-6) << row.name;
    }
}

TEST(FlightScanner, RefusesInstancesThatMultiplyWithoutEnd) {
    SquareFile file;
    const auto push = record(flight::pushLevel), pop = record(flight::popLevel);
    const auto refer = [](int n) { return record(flight::instanceReference, i16(0) + i16(n)); };
    std::string chain = record(flight::instanceDefinition, i16(0) + i16(0)) + push + file.face +
                        push + file.list + pop + pop;
    for (int i = 1; i < 30; ++i) {
        chain += record(flight::instanceDefinition, i16(0) + i16(i)) + push + refer(i - 1) +
                 refer(i - 1) + pop;
    }
    file.group = chain + refer(29) + file.group;
    try {
        scanFlightBytes(file.bytes(), "bomb.flt");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("multiply"));
    }
}

TEST(FlightScanner, ReportsEveryDiagnosticOfAFile) {
    SquareFile file;
    file.drawType = 7;
    file.unit = 3;
    file.remake();
    file.list = record(flight::vertexList, i32(8) + i32(9999) + i32(120));
    try {
        scanFlightBytes(file.bytes(), "three.flt");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().size(), 3u);
    }
}

TEST(FlightScanner, ReportsTheCodesOfTheOracleOnEveryModel) {
    if (sharedModels().empty()) {
        GTEST_SKIP() << "the models and the oracle are not beside the checkout";
    }
    if (oracleCodes(data / "tricky_1420.flt").empty()) {
        GTEST_SKIP() << "there is no python3 to run the oracle";
    }
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(sharedModels())) {
        if (entry.path().extension() != ".flt") {
            continue;
        }
        SCOPED_TRACE(entry.path().string());
        EXPECT_EQ(scannedCodes(scanFlight(entry.path())), oracleCodes(entry.path()));
        ++files;
    }
    EXPECT_GE(files, 15);
}

TEST_P(BadFlight, IsRefusedWithTheByte) {
    SquareFile file;
    GetParam().damage(file);
    try {
        scanFlightBytes(file.bytes(), "bad.flt");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().front().file, "bad.flt");
        EXPECT_EQ(error.diagnostics().front().position, GetParam().position(file));
        EXPECT_THAT(error.what(), HasSubstr(GetParam().says));
    }
}

namespace {

using F = SquareFile;

void asMesh(F& f, const std::string& records) {
    f.face = records;
    f.pushFace = f.list = f.popFace = "";
}

std::string vertex(double x, std::size_t length = 56) {
    auto bytes = record(flight::vertexCN,
                        zeros(4) + f64(x) + f64(0) + f64(0) + f32(0) + f32(0) + f32(1) + zeros(12));
    bytes[3] = static_cast<char>(length);
    return bytes.substr(0, length);
}

std::string matrix(float value, float last = 1.0f) {
    std::string payload;
    for (int i = 0; i < 16; ++i) {
        payload += f32(i == 15 ? last : i % 5 == 0 ? value : 0.0f);
    }
    return record(flight::matrix, payload);
}

std::string switchRecord(int present, std::int64_t masks, std::int64_t words, int stored) {
    return record(flight::switchNode, zeros(12) + i32(present) + i32(masks) + i32(words) +
                                          zeros(static_cast<std::size_t>(4 * stored)));
}

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

} // namespace

INSTANTIATE_TEST_SUITE_P(
    Table, BadFlight,
    testing::Values(
        BadFile{"Empty", [](F& f) { f = F(); f.header = f.colours = f.palette = f.vertices = f.push = f.group = f.pushGroup = f.object = f.pushObject = f.face = f.pushFace = f.list = f.popFace = f.popObject = f.popGroup = f.pop = ""; },
                [](const F&) { return std::string("byte 0"); }, "an empty file"},
        BadFile{"NoHeader", [](F& f) { f.header = ""; }, [](const F&) { return std::string("byte 0"); }, "header record"},
        BadFile{"SecondHeader", [](F& f) { f.colours = f.header; }, at(&F::colours), "second header"},
        BadFile{"ShortHeader", [](F& f) { f.header = record(flight::header, zeros(20)); }, at(&F::header), "at least 64"},
        BadFile{"OldVersion", [](F& f) { f.version = 13; f.remake(); }, at(&F::header, 12), "version 13"},
        BadFile{"NoVersion", [](F& f) { f.version = 99999; f.remake(); }, at(&F::header, 12), "version 99999"},
        BadFile{"UnknownUnit", [](F& f) { f.unit = 2; f.remake(); }, at(&F::header, 62), "unit 2"},
        BadFile{"LengthBelowHeader", [](F& f) { f.group = i16(2) + i16(3) + zeros(40); }, at(&F::group), "length of at least 4"},
        BadFile{"LengthBeyondEnd", [](F& f) { f.pop = i16(2) + i16(400); }, at(&F::pop), "bytes left in the file"},
        BadFile{"TruncatedHeaderOfRecord", [](F& f) { f.pop = std::string("\0\x0b", 2); }, at(&F::pop), "truncated"},
        BadFile{"PopMissing", [](F& f) { f.pop = ""; }, at(&F::trailer), "1 more pop level"},
        BadFile{"PopsMissing", [](F& f) { f.pop = f.popGroup = f.popObject = ""; }, at(&F::trailer), "3 more pop level"},
        BadFile{"PopFirst", [](F& f) { f.push = record(flight::popLevel); }, at(&F::push), "push level record before"},
        BadFile{"NodeOutside", [](F& f) { f.colours += f.group; }, [](const F& f) { return "byte " + std::to_string(f.offsetOf(&F::colours) + f.colours.size() - f.group.size()); }, "push level record before it"},
        BadFile{"TooDeep", [](F& f) { for (int i = 0; i < 300; ++i) { f.pushObject += f.group + f.push; f.popObject += f.pop; } }, [](const F& f) { return "byte " + std::to_string(f.offsetOf(&F::pushObject) + 4 + 253 * 48 + 44); }, "256 levels"},
        BadFile{"SubfacePopAlone", [](F& f) { f.popFace += record(flight::popSubface); }, at(&F::popFace, 4), "push subface"},
        BadFile{"SubfaceNotClosed", [](F& f) { f.popFace += record(flight::pushSubface); }, at(&F::popObject), "pop subface"},
        BadFile{"ExtensionPopAlone", [](F& f) { f.popFace += record(flight::popExtension); }, at(&F::popFace, 4), "push extension"},
        BadFile{"ContinuedFace", [](F& f) { f.face += record(flight::continuation, zeros(8)); }, at(&F::face), "continuation of mesh"},
        BadFile{"ColourPaletteShort", [](F& f) { f.colours = record(flight::colourPalette, zeros(100)); }, at(&F::colours), "at least 136"},
        BadFile{"IndexedColourWithoutPalette", [](F& f) { f.colours = ""; f.flags = 0; f.remake(); }, at(&F::face), "no palette"},
        BadFile{"PaletteLongerThanFile", [](F& f) { f.palette = record(flight::vertexPalette, i32(0x7FFFFFFF)); }, at(&F::palette, 4), "vertex palette of 2147483647"},
        BadFile{"PaletteTooShort", [](F& f) { f.palette = record(flight::vertexPalette, i32(8 + 56)); }, [](const F& f) { return f.positionOf(&F::vertices, 56); }, "outside the vertex palette"},
        BadFile{"PaletteTooLong", [](F& f) { f.palette = record(flight::vertexPalette, i32(8 + 5 * 56)); }, at(&F::palette, 4), "where its vertices end"},
        BadFile{"PaletteMissing", [](F& f) { f.palette = f.vertices = ""; }, at(&F::list), "vertex palette before it"},
        BadFile{"VertexWithoutPalette", [](F& f) { f.palette = ""; }, at(&F::vertices), "outside the vertex palette"},
        BadFile{"VertexShort", [](F& f) { f.vertices = vertex(0, 40); f.palette = record(flight::vertexPalette, i32(48)); }, at(&F::vertices), "at least 48"},
        BadFile{"VertexNaN", [](F& f) { f.vertices.replace(8, 8, f64(notANumber)); }, at(&F::vertices, 8), "nan"},
        BadFile{"VertexInfinite", [](F& f) { f.vertices.replace(16, 8, f64(-HUGE_VAL)); }, at(&F::vertices, 16), "inf"},
        BadFile{"VertexFarAway", [](F& f) { f.unit = 1; f.size = 2e6; f.remake(); }, at(&F::vertices, 56 + 8), "within 1e9 m"},
        BadFile{"OffsetOutside", [](F& f) { f.list = record(flight::vertexList, i32(8) + i32(232) + i32(64)); }, at(&F::list, 8), "vertex offset 232"},
        BadFile{"ListOddLength", [](F& f) { f.list = record(flight::vertexList, i32(8) + i16(0)); }, at(&F::list), "multiple of 4"},
        BadFile{"ListUnderGroup", [](F& f) { f.object = f.list + f.object; }, at(&F::object), "face above it"},
        BadFile{"FaceShort", [](F& f) { f.face = record(flight::face, zeros(40)); }, at(&F::face), "at least 64"},
        BadFile{"DrawType", [](F& f) { f.drawType = 5; f.remake(); }, at(&F::face, 18), "draw type 5"},
        BadFile{"OldVertex", [](F& f) { f.list = record(8, zeros(16)); }, at(&F::list), "before 14"},
        BadFile{"PoolWithoutMesh", [](F& f) { f.group += record(flight::localVertexPool, i32(0) + i32(0x80000000)); }, at(&F::group, 44), "mesh directly before it"},
        BadFile{"PoolCount", [](F& f) { asMesh(f, meshRecords(5)); }, at(&F::face, 84 + 4), "5 vertices of 36 bytes"},
        BadFile{"PoolCountHuge", [](F& f) { asMesh(f, meshRecords(0xFFFFFFFF)); }, at(&F::face, 84 + 4), "4294967295 vertices"},
        BadFile{"PoolWithoutPositions", [](F& f) { asMesh(f, meshRecords(4, 0x10000000)); }, at(&F::face, 84 + 8), "without positions"},
        BadFile{"PoolColoursWithoutPalette", [](F& f) { f.colours = ""; asMesh(f, meshRecords(3, 0xD0000000)); }, at(&F::face, 84), "no palette"},
        BadFile{"PrimitiveType", [](F& f) { asMesh(f, meshRecords(4, 0x90000000, primitiveRecord(9, 2, 3, {0, 1, 2}))); }, [](const F& f) { return f.positionOf(&F::face, 84 + 156 + 4 + 4); }, "primitive type 9"},
        BadFile{"PrimitiveIndexSize", [](F& f) { asMesh(f, meshRecords(4, 0x90000000, primitiveRecord(1, 3, 3, {0, 1, 2}))); }, [](const F& f) { return f.positionOf(&F::face, 84 + 156 + 4 + 6); }, "indices of 3 bytes"},
        BadFile{"PrimitiveCount", [](F& f) { asMesh(f, meshRecords(4, 0x90000000, primitiveRecord(1, 2, 4, {0, 1, 2}))); }, [](const F& f) { return f.positionOf(&F::face, 84 + 156 + 4 + 8); }, "4 indices"},
        BadFile{"PrimitiveIndex", [](F& f) { asMesh(f, meshRecords(4, 0x90000000, primitiveRecord(1, 2, 3, {0, 1, 4}))); }, [](const F& f) { return f.positionOf(&F::face, 84 + 156 + 4 + 16); }, "vertex index 4"},
        BadFile{"PrimitiveWithoutMesh", [](F& f) { f.list = primitiveRecord(1, 2, 3, {0, 1, 2}); }, at(&F::list), "mesh with a local vertex pool"},
        BadFile{"MatrixNaN", [](F& f) { f.group += matrix(std::numeric_limits<float>::quiet_NaN()); }, at(&F::group, 44 + 4), "in a matrix"},
        BadFile{"MatrixPerspective", [](F& f) { f.group += matrix(1, 2); }, [](const F& f) { return f.positionOf(&F::group, 44 + 4 + 60); }, "perspective"},
        BadFile{"ReplicateNegative", [](F& f) { f.group += record(flight::replicate, i16(-1) + i16(0)); }, at(&F::group, 44 + 4), "-1 replications"},
        BadFile{"LodNaN", [](F& f) { f.group = record(flight::levelOfDetail, zeros(12) + f64(notANumber) + zeros(64)); }, at(&F::group, 16), "level of detail"},
        BadFile{"DofInfinite", [](F& f) { f.group = record(flight::degreeOfFreedom, zeros(12) + zeros(72) + f64(HUGE_VAL) + zeros(300)); }, at(&F::group, 88), "degree of freedom"},
        BadFile{"SwitchMaskMissing", [](F& f) { f.group = switchRecord(0, 2, 1, 1); }, at(&F::group, 20), "2 switch masks"},
        BadFile{"SwitchMasksOverflow", [](F& f) { f.group = switchRecord(0, 0x10000, 0x10000, 1); }, at(&F::group, 20), "inside the record"},
        BadFile{"SwitchPresentMask", [](F& f) { f.group = switchRecord(3, 1, 1, 1); }, at(&F::group, 16), "switch mask 3"},
        BadFile{"SwitchTooManyChildren", [](F& f) { f.group = switchRecord(0, 1, 1, 1); for (int i = 0; i < 33; ++i){ f.pushGroup += f.object;
} }, at(&F::group), "bit for each"},
        BadFile{"InstanceUndefined", [](F& f) { f.object = record(flight::instanceReference, i16(0) + i16(4)) + f.object; }, at(&F::object, 6), "reference to instance 4"},
        BadFile{"ReferenceEmpty", [](F& f) { f.object = record(flight::externalReference, zeros(212)) + f.object; }, at(&F::object, 4), "without a path"}),
    [](const auto& info) { return std::string(info.param.name); });
