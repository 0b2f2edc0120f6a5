#include "irsg/geometry/conversion/ModelLoader.h"

#include <algorithm>
#include <memory>
#include <sstream>
#include <string_view>

#include <osg/Group>
#include <osgDB/FileNameUtils>
#include <osgDB/Registry>
#include <sys/mman.h>
#include <unistd.h>

#include "irsg/core/Errors.h"
#include "irsg/core/Utf8.h"
#include "irsg/geometry/conversion/CodedGraph.h"
#include "irsg/geometry/flight/FlightScanner.h"
#include "irsg/geometry/reading/FarOrigin.h"
#include "irsg/geometry/reading/GuardedReading.h"
#include "irsg/geometry/reading/IrCodes.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/OsgNotices.h"
#include "irsg/geometry/reading/OwnPlugins.h"
#include "irsg/geometry/reading/ProxyNodes.h"
#include "irsg/geometry/reading/Utf8Names.h"
#include "irsg/geometry/reading/sandbox/AxesCoding.h"
#include "irsg/geometry/reading/sandbox/Bytes.h"
#include "irsg/geometry/reading/sandbox/GraphCoding.h"
#include "irsg/geometry/reading/sandbox/SandboxedPictures.h"
#include "irsg/geometry/reading/text/OurModels.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;

/// Blank-separated, or the plug-in finds none of them. Without preserveFace it merges faces of
/// different codes; without the last one it drops the codes.
constexpr const char* flightOptions = "preserveFace preserveObject preserveNonOsgAttrsAsUserData";

osg::ref_ptr<osgDB::Options> privateOptions(const fs::path& folder) {
    osg::ref_ptr<osgDB::Options> options = GuardedReading::options(flightOptions);
    options->getDatabasePathList().push_back(folder.string());
    return options;
}

void say(std::vector<std::string>& remarks, GuardedReading& guard, osg::Node& graph) {
    for (auto& refused : guard.take())
        remarks.push_back(std::move(refused));
    for (auto& removed : removeLateReaders(graph))
        remarks.push_back(std::move(removed));
}

/// The files of one scan, handed to the plug-in as validated bytes.
class FlightReader {
  public:
    FlightReader(const FlightScan& scan, LoadPurpose purpose)
        : scan_(scan),
          purpose_(purpose == LoadPurpose::visible ? FlightFile::Purpose::visible
                                                   : FlightFile::Purpose::infrared) {
        preferOwnPlugins();
        plugin_ = osgDB::Registry::instance()->getReaderWriterForExtension("flt");
        if (!plugin_)
            throw InputError({scan.files.front().path.string(), "",
                              "an OpenFlight file and no OpenFlight plug-in of OpenSceneGraph",
                              "the plug-in osgdb_openflight"});
    }

    osg::ref_ptr<osg::Node> read(const fs::path& path, osg::Referenced* pools) {
        const auto& file = scan_.find(path);
        std::istringstream in(file.stream(purpose_));
        const auto options = privateOptions(path.parent_path());
        options->setUserData(pools);
        auto result = plugin_->readNode(in, options);
        osg::ref_ptr<osg::Node> node = result.takeNode();
        if (!node)
            throw InputError({path.string(), "", "a file that OpenSceneGraph cannot read",
                              "an OpenFlight file"});

        // What was taken from the positions in double, outside what the plug-in keeps.
        if (const auto [x, y, z] = file.origin(); x != 0.0 || y != 0.0 || z != 0.0)
            moveBack(*node, osg::Vec3d(x, y, z) * file.unit_m);

        // Each external reference carries the palettes it lends; a file referred to twice is
        // shared.
        for (const auto& proxy : proxiesOf(*node)) {
            const osg::ref_ptr<osg::Referenced> lent = proxy->getUserData();
            proxy->setUserData(nullptr);
            const auto external = std::find_if(
                file.externals.begin(), file.externals.end(),
                [&](const FlightExternal& e) { return e.written == proxy->getFileName(0); });
            if (external == file.externals.end())
                throw LogicError("a reference to " + proxy->getFileName(0) + " was not scanned");
            auto& child = read_[external->file];
            if (!child)
                child = read(external->file, lent);
            proxy->addChild(child);
        }
        return node;
    }

  private:
    const FlightScan& scan_;
    FlightFile::Purpose purpose_;
    osg::ref_ptr<osgDB::ReaderWriter> plugin_;
    std::map<fs::path, osg::ref_ptr<osg::Node>> read_;
};

LoadedGraph loadFlight(const fs::path& file, LoadPurpose purpose) {
    const auto scan = scanFlight(file);
    LoadedGraph loaded;
    loaded.faces = scan.faceCounts();
    loaded.axes = {1.0, ModelAxis::plusZ, std::nullopt,
                   "the format: OpenFlight has z up, and its units are read as metres"};
    for (const auto& scanned : scan.files)
        for (const auto& remark : scanned.remarks)
            loaded.remarks.push_back(scanned.path.filename().string() + ": " + remark);
    if (loaded.faces.empty())
        throw InputError({file.string(), "byte " + std::to_string(scan.files.front().bytes.size()),
                          "the end of a model without faces", "at least one face"});

    const std::scoped_lock lock(osgRegistryMutex());
    OsgNotices notices;
    GuardedReading guard;
    loaded.node = FlightReader(scan, purpose).read(scan.files.front().path, nullptr);
    removeProxies(*loaded.node);
    addNotices(loaded.remarks, notices.take());
    say(loaded.remarks, guard, *loaded.node);

    // A plug-in that drops the codes would paint everything with code 0.
    const auto counts = polygonCounts(*loaded.node);
    const auto anyCode = [](const auto& entry) { return entry.first != IrCodes{}; };
    for (const auto& [codes, count] : counts)
        if (!loaded.faces.contains(codes))
            throw LogicError("the OpenFlight plug-in changed codes of " + file.string());
    if (std::any_of(loaded.faces.begin(), loaded.faces.end(), anyCode) && !counts.empty() &&
        counts.begin()->second > 0 && std::none_of(counts.begin(), counts.end(), anyCode))
        loaded.remarks.push_back("no face with a code other than 0 is drawn");
    return loaded;
}

/// What a process of its own reads and hands over as bytes.
LoadedGraph loadSandboxed(const fs::path& place, const fs::path& file) {
    try {
        ReaderProcess process;
        const ReaderAnswer answer = process.read(FileKind::model, place, file);
        process.dismiss();
        ByteSource source(answer.bytes());
        LoadedGraph loaded;
        loaded.remarks.resize(source.getCount(8));
        for (std::string& remark : loaded.remarks)
            remark = source.getText();
        loaded.axes = getAxes(source);
        loaded.node = getGraph(source, file.string(), loaded.remarks);
        return loaded;
    } catch (const DamagedBytes& damage) {
        throw InputError({file.string(), "",
                          "a file at which the reader of " + readerNameOf(file.string()) +
                              " gives " + damage.what(),
                          "a whole model"});
    }
}

LoadedGraph loadOfType(const std::string& extension, const fs::path& file, LoadPurpose purpose) {
    if (extension == "flt")
        return loadFlight(file, purpose);
    if (modelReaderOf(file.string()) == FormatReader::ours) {
        // The infrared picture has no use for others.
        ReaderProcess process;
        return readOurModel(
            file, purpose == LoadPurpose::visible
                      ? [&](const fs::path& name) { return readPictureSandboxed(process, name); }
                      : PictureReading());
    }
    return loadSandboxed(file, file);
}

} // namespace

std::mutex& osgRegistryMutex() {
    static std::mutex mutex;
    return mutex;
}

LoadPurpose purposeOf(const ModelOptions& options) {
    return options.cutsTextureAlpha ? LoadPurpose::visible : LoadPurpose::infrared;
}

LoadedGraph loadGraphAsIs(const fs::path& file, LoadPurpose purpose) {
    const auto refusal = refusalOf(file.string(), FileKind::model);
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored))
        throw InputError({file.string(), "",
                          "no such file" + (refusal ? " (" + *refusal + ")" : std::string()),
                          refusal ? expectationOf(FileKind::model) : "a model file"});
    if (refusal)
        throw InputError({file.string(), "", *refusal, expectationOf(FileKind::model)});
    LoadedGraph loaded = loadOfType(osgDB::getLowerCaseFileExtension(file.string()), file, purpose);
    if (const auto& unit = loaded.axes.spokenUnit; unit && !loaded.axes.unit_m)
        loaded.remarks.push_back("a comment or a name in the file mentions a unit (\"" +
                                 unit->words +
                                 "\"): numbers are metres nevertheless, unless a unit is set");
    if (auto remark = remarkOfRounding(*loaded.node))
        loaded.remarks.push_back(std::move(*remark));
    if (const int names = nameInUtf8(*loaded.node); names > 0)
        loaded.remarks.push_back(std::to_string(names) + (names == 1 ? " name is" : " names are") +
                                 " not in UTF-8 and read as Latin-1");
    for (std::string& remark : loaded.remarks)
        remark = utf8Text(remark);
    return loaded;
}

LoadedGraph loadGraph(const fs::path& file, LoadPurpose purpose) {
    return withCodes(loadGraphAsIs(file, purpose), readModelCodes(file), file);
}

LoadedGraph withCodes(LoadedGraph loaded, const ModelCodes& codes, const fs::path& file) {
    if (codes.empty())
        return loaded;
    for (std::string& remark : giveCodes(loaded.node, codes, file.string()))
        loaded.remarks.push_back(std::move(remark));
    loaded.faces.clear();
    return loaded;
}

LoadedGraph loadWritten(const std::string& bytes, const fs::path& name) {
    const int descriptor = memfd_create("model", MFD_CLOEXEC);
    const std::unique_ptr<const int, void (*)(const int*)> closing(&descriptor,
                                                                   [](const int* d) { close(*d); });
    for (std::string_view rest = bytes; !rest.empty();) {
        const ssize_t count = write(descriptor, rest.data(), rest.size());
        if (count <= 0)
            throw LogicError("there is no memory for a copy of " + name.string());
        rest.remove_prefix(static_cast<std::size_t>(count));
    }
    return loadSandboxed("/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(descriptor),
                         name);
}

} // namespace irsg
