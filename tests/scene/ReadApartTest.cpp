// Models and pictures are read in the reading process, those of formats that we read ourselves too.
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/landlock.h>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/NodeVisitor>
#include <osg/Texture2D>
#include <osgDB/FileNameUtils>
#include <osgDB/Registry>
#include <osgDB/WriteFile>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/flight/FlightScanner.h"
#include "irsg/geometry/reading/IrCodes.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/sandbox/FlightReading.h"
#include "irsg/geometry/reading/sandbox/ReaderMessages.h"
#include "irsg/geometry/reading/sandbox/ReaderProcess.h"
#include "irsg/geometry/reading/text/OurModels.h"
#include "tests/support/FlightBytes.h"
#include "tests/support/Refusal.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;
using smat::test::refusalOf;
using test::SquareFile;
using test::TemporaryFolder;
using testing::AllOf;
using testing::AnyOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const char* const triangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n";

/// Models of formats that are short to write, one of each way of reading.
const std::pair<const char*, std::string> models[] = {
    {"flt", SquareFile().bytes()},
    {"obj", std::string(triangle) + "f 1 2 3\n"},
    {"stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
            "endloop\nendfacet\nendsolid a\n"},
    {"ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
            "end_header\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n"},
    {"dxf", "0\nSECTION\n2\nENTITIES\n0\n3DFACE\n8\na\n10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n"
            "12\n1\n22\n1\n32\n0\n13\n1\n23\n1\n33\n0\n0\nENDSEC\n0\nEOF\n"},
    {"osgt", "#Ascii Scene\n#Version 162\n#Generator OpenSceneGraph 3.6.5\n\nosg::Group {\n"
             "  UniqueID 1 \n}\n"},
    {"ac", "AC3Db\nMATERIAL \"a\" rgb 1 0 0 amb 1 0 0 emis 0 0 0 spec 0 0 0 shi 1 trans 0\n"
           "OBJECT world\nkids 1\nOBJECT poly\nnumvert 3\n0 0 0\n1 0 0\n1 1 0\nnumsurf 1\n"
           "SURF 0x0\nmat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\nkids 0\n"}};

/// Says in this process that it reads models and pictures, and counts who asks.
class Witness : public osgDB::ReaderWriter {
  public:
    Witness() {
        for (const FileKind kind : {FileKind::model, FileKind::picture}) {
            for (const FileFormat& format : formatsOf(kind)) {
                supportsExtension(format.extension, "counted");
            }
        }
        osgDB::Registry::instance()->getReaderWriterList().insert(
            osgDB::Registry::instance()->getReaderWriterList().begin(), this);
    }
    const char* className() const override { return "Witness"; }
    ReadResult readNode(const std::string&, const Options*) const override { return saw(); }
    ReadResult readNode(std::istream&, const Options*) const override { return saw(); }
    ReadResult readImage(const std::string&, const Options*) const override { return saw(); }
    ReadResult readImage(std::istream&, const Options*) const override { return saw(); }
    mutable int asked = 0;

  private:
    ReadResult saw() const {
        ++asked;
        return ReadResult::FILE_NOT_HANDLED;
    }
};

/// Grows with every process of ours that came to its end.
long workOfChildren() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return usage.ru_minflt;
}

bool hasLandlock() {
    return syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) > 0;
}

/// A grey picture of 2 x 2.
const std::string picture = std::string("P5\n2 2\n255\n") + "\x40\x80\xc0\xff";

/// What is left of a graph once it has been handed over, as text.
class Normalized : public osg::NodeVisitor {
  public:
    explicit Normalized(osg::Node& graph) : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {
        setNodeMaskOverride(~0u);
        graph.accept(*this);
        osg::ref_ptr<osgDB::Options> options = new osgDB::Options;
        options->setPluginStringData("fileType", "Ascii");
        auto* writer = osgDB::Registry::instance()->getReaderWriterForExtension("osgt");
        std::ostringstream out;
        EXPECT_TRUE(writer->writeNode(graph, out, options).success());
        text = std::move(out).str();
    }
    void apply(osg::Node& node) override {
        const auto codes = declaredCodes(node);
        const auto said = static_cast<const osg::Node&>(node).getDescriptions();
        node.setUserDataContainer(nullptr);
        if (codes) {
            setCodes(node, *codes);
        }
        if (!said.empty()) {
            node.setDescriptions(said);
        }
        if (osg::Geometry* geometry = node.asGeometry()) {
            geometry->setUseVertexBufferObjects(false);
            geometry->setUseVertexBufferObjects(true);
        }
        if (osg::StateSet* state = node.getStateSet()) {
            state->setDataVariance(osg::Object::UNSPECIFIED);
        }
        traverse(node);
    }
    std::string text;
};

std::vector<fs::path> flightFiles() {
    std::vector<fs::path> files;
    std::vector<fs::path> folders = {fs::path(SMAT_SOURCE_DIR) / "samples",
                                     fs::path(SMAT_SOURCE_DIR) / "tests/data/models"};
    if (const fs::path shared = test::sharedModels(); !shared.empty()) {
        folders.push_back(shared);
    }
    for (const fs::path& folder : folders) {
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (entry.path().extension() == ".flt") {
                files.push_back(entry.path());
            }
        }
    }
    return files;
}

} // namespace

TEST(ReadApart, IsEveryModelOfEveryWayOfReading) {
    const TemporaryFolder folder;
    const osg::ref_ptr<Witness> witness = new Witness;
    for (const auto& [kind, bytes] : models) {
        const auto file = folder.write("a." + std::string(kind), bytes);
        const long before = workOfChildren();
        for (const LoadPurpose purpose : {LoadPurpose::infrared, LoadPurpose::visible}) {
            EXPECT_NO_THROW(loadGraph(file, purpose)) << kind;
        }
        EXPECT_GT(workOfChildren(), before) << kind << " is read in this process";
    }
    EXPECT_EQ(witness->asked, 0) << "a plug-in was asked in this process";
    osgDB::Registry::instance()->removeReaderWriter(witness);

    // The table has each way of reading, and those that stood outside before.
    std::vector<std::string> kinds;
    for (const auto& [kind, bytes] : models) {
        kinds.emplace_back(kind);
    }
    for (const FileFormat& format : formatsOf(FileKind::model)) {
        if (format.reader == FormatReader::ours || format.reader == FormatReader::flight) {
            EXPECT_THAT(kinds, Contains(format.extension));
        }
    }
    EXPECT_THAT(kinds, AllOf(Contains("obj"), Contains("flt")));
}

TEST(ReadApart, OpensNoFileBesideAModelThatTheModelDoesNotName) {
    if (!hasLandlock()) {
        GTEST_SKIP() << "this kernel has no Landlock";
    }
    const TemporaryFolder folder;
    const auto file = folder.write("a.obj", "mtllib a.mtl\n" + std::string(triangle) +
                                                "usemtl a\nf 1/1 2/2 3/3\n");
    const auto library = folder.write("a.mtl", "newmtl a\nmap_Kd a.pgm\n");
    const auto painted = folder.write("a.pgm", picture);
    // A reader that has gone over to another side would look for these with or without leave.
    OwnFiles own;
    own.names = {{folder.path(), "a.mtl", {library, ""}}, {folder.path(), "a.pgm", {painted, ""}}};
    own.opened = {file};
    const auto answerOf = [&] {
        ReaderProcess process;
        return std::string(process.read(FileKind::model, file, {}, &own).bytes());
    };
    EXPECT_THAT(answerOf(), AllOf(HasSubstr("a.mtl"), HasSubstr("Permission denied")));
    own.opened = {file, library};
    EXPECT_THAT(refusalOf(answerOf),
                AllOf(HasSubstr(file.string()), HasSubstr("asks for " + painted.string() +
                                                          ", which the model does not name")));
    own.pictures = {painted};
    EXPECT_THAT(answerOf(), Not(HasSubstr("Permission denied")));

    // What a loaded model names is opened, and nothing is remarked.
    EXPECT_THAT(loadGraph(file, LoadPurpose::visible).remarks,
                Each(Not(AnyOf(HasSubstr("a.mtl"), HasSubstr("a.pgm")))));
}

TEST(ReadApart, EqualsWhatOpenFlightGivesHere) {
    int compared = 0;
    for (const fs::path& file : flightFiles()) {
        for (const LoadPurpose purpose : {LoadPurpose::infrared, LoadPurpose::visible}) {
            SCOPED_TRACE(file);
            const bool visible = purpose == LoadPurpose::visible;
            FlightScan scan;
            if (refusalOf([&] { scan = scanFlight(file); }) != "nothing was refused") {
                continue;
            }
            ByteSink bytes;
            putFlightStreams(bytes, scan.streams(visible ? FlightFile::Purpose::visible
                                                         : FlightFile::Purpose::infrared));
            const auto here = readFlightHere(bytes.take());
            const auto apart = loadGraphAsIs(file, purpose);
            EXPECT_EQ(polygonCounts(*apart.node), polygonCounts(*here.node));
            EXPECT_EQ(Normalized(*apart.node).text, Normalized(*here.node).text);
            EXPECT_THAT(apart.remarks, Each(Not(HasSubstr("left out: "))));
            ++compared;
        }
    }
    EXPECT_GE(compared, 10);
}

TEST(ReadApart, EqualsWhatOurReadersGiveHere) {
    const TemporaryFolder folder;
    folder.write("a.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\nd 0.5\n");
    std::vector<fs::path> files = {
        folder.write("far.obj", "mtllib a.mtl\nmtllib lost.mtl\no one\nv 1e6 2e6 3e6\n"
                                "v 1000001 2e6 3e6\nv 1000001 2000001 3e6\nv 1e6 2000001 "
                                "3e6\nusemtl a\nf 1 2 3 4\ng two\nusemtl b\n"
                                "f 4 3 2 1\nl 1 2\nusemtl c\nf 1 2 3\n")};
    for (const auto& [kind, bytes] : models) {
        if (modelReaderOf("a." + std::string(kind)) == FormatReader::ours) {
            files.push_back(folder.write("a." + std::string(kind), bytes));
        }
    }
    for (const auto& entry :
         fs::directory_iterator(fs::path(SMAT_SOURCE_DIR) / "tests/data/strangers")) {
        if (entry.is_regular_file() && modelReaderOf(entry.path().string()) == FormatReader::ours) {
            files.push_back(entry.path());
        }
    }
    for (const fs::path& file : files) {
        SCOPED_TRACE(file);
        const auto here = readOurModel(file, {});
        const auto apart = loadGraphAsIs(file, LoadPurpose::infrared);
        EXPECT_EQ(Normalized(*apart.node).text, Normalized(*here.node).text);
        EXPECT_EQ(apart.axes, here.axes);
        for (const std::string& remark : here.remarks) {
            EXPECT_THAT(apart.remarks, Contains(remark));
        }
    }
    EXPECT_GE(files.size(), 10u);
}

TEST(ReadApart, HandsOverPicturesAndSaysWhichCannotBeRead) {
    const TemporaryFolder folder;
    fs::create_directories(folder / "models");
    fs::create_directories(folder / "Textures");
    folder.write("Textures/a.pgm", picture);
    folder.write("models/broken.pgm", "P5\n2000 2000\n255\nshort");
    // The palette of a face's texture, and one that no face has.
    const auto palette = [](const std::string& name, int number) {
        return test::record(flight::texturePalette, name + test::zeros(200 - name.size()) +
                                                        test::i32(number) + test::zeros(8));
    };
    SquareFile square;
    square.colours += palette("..\\TEXTURES\\A.pgm", 0) + palette("broken.pgm", 1) +
                      palette("lost.pgm", 2) + palette("evil.lua", 3);
    square.face.replace(28, 2, std::string(2, '\0'));
    const std::pair<const char*, std::string> files[] = {
        {"a.flt", square.bytes()},
        {"a.obj", "mtllib a.mtl\n" + std::string(triangle) +
                      "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/3 2/2\n"}};
    folder.write("models/a.mtl",
                 "newmtl a\nmap_Kd ..\\TEXTURES\\A.pgm\nnewmtl b\nmap_Kd broken.pgm\n"
                 "newmtl c\nmap_Kd lost.pgm\nnewmtl d\nmap_Kd evil.lua\n");
    for (const auto& [name, bytes] : files) {
        SCOPED_TRACE(name);
        const auto file = folder.write("models/" + std::string(name), bytes);
        const auto loaded = loadGraph(file, LoadPurpose::visible);
        EXPECT_THAT(loaded.remarks, Contains(AllOf(HasSubstr("broken.pgm"),
                                                   HasSubstr("expected a whole picture"))));
        EXPECT_THAT(loaded.remarks, Contains(HasSubstr("lost.pgm")));
        EXPECT_THAT(loaded.remarks, Contains(HasSubstr("evil.lua")));
        EXPECT_THAT(loaded.remarks, Contains(HasSubstr("is read as ../Textures/a.pgm")));
        EXPECT_THAT(Normalized(*loaded.node).text, HasSubstr("Textures/a.pgm"));
        // The infrared picture opens none.
        EXPECT_THAT(loadGraph(file, LoadPurpose::infrared).remarks,
                    Each(Not(HasSubstr("broken.pgm"))));
    }
}

TEST(ReadApart, SaysWhereDamageIs) {
    const TemporaryFolder folder;
    const auto object = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 x\nf 1 2 9\n");
    EXPECT_THAT(refusalOf([&] { loadGraph(object, LoadPurpose::visible); }),
                AllOf(HasSubstr(object.string()), HasSubstr("line 3"), HasSubstr("\"x\""),
                      HasSubstr("a finite number"), HasSubstr("line 4")));
    const std::string whole = SquareFile().bytes();
    const auto cut = folder.write("a.flt", whole.substr(0, whole.size() - 30));
    EXPECT_THAT(refusalOf([&] { loadGraph(cut, LoadPurpose::visible); }),
                AllOf(HasSubstr(cut.string()), HasSubstr("byte "), HasSubstr("expected")));
}

TEST(ReadApart, SaysThatItsProcessWasEnded) {
    const TemporaryFolder folder;
    std::string text = triangle;
    while (text.size() < 40'000'000) {
        text += "f 1 2 3\n";
    }
    const auto file = folder.write("a.obj", text);
    std::jthread ending([](const std::stop_token& stop) {
        // The only child of this process is the one that reads.
        while (!stop.stop_requested()) {
            for (const auto& task : fs::directory_iterator("/proc/self/task")) {
                std::ifstream children(task.path() / "children");
                for (pid_t child = 0; children >> child;) {
                    std::ifstream name("/proc/" + std::to_string(child) + "/comm");
                    std::string comm;
                    if (name >> comm && comm == "irsg-reader") {
                        kill(child, SIGKILL);
                    }
                }
            }
            usleep(2000);
        }
    });
    EXPECT_THAT(refusalOf([&] { loadGraph(file, LoadPurpose::visible); }),
                AllOf(HasSubstr(file.string()), HasSubstr("the reader of this program crashes"),
                      HasSubstr("Killed"), HasSubstr("expected a whole model")));
}

TEST(ReadApart, AnswersNoQuestionOfAnotherBuild) {
    int ends[2];
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    const std::string program = std::string(SMAT_BINARY_DIR) + "/bin/irsg-reader";
    const pid_t reader = fork();
    if (reader == 0) {
        dup2(ends[1], STDIN_FILENO);
        execl(program.c_str(), "irsg-reader", nullptr);
        _exit(127);
    }
    close(ends[1]);
    QuestionHead head;
    ++head.version;
    EXPECT_EQ(write(ends[0], &head, sizeof head), static_cast<ssize_t>(sizeof head));
    int status = 0;
    EXPECT_EQ(waitpid(reader, &status, 0), reader);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), otherVersion);
    close(ends[0]);
}

} // namespace irsg
