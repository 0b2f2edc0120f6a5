#include "irsg/scene/model/ModelLoader.h"

#include <algorithm>
#include <sstream>

#include <osg/Group>
#include <osg/NodeVisitor>
#include <osg/ProxyNode>
#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>
#include <osgDB/Registry>

#include "irsg/scene/model/FlightScanner.h"
#include "irsg/scene/model/GuardedReading.h"
#include "irsg/scene/model/IrCodes.h"
#include "irsg/scene/model/OpenableFiles.h"
#include "irsg/scene/model/OsgNotices.h"

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

/// What OpenSceneGraph printed, the first lines of it.
void say(std::vector<std::string>& remarks, const std::vector<std::string>& lines) {
    constexpr std::size_t most = 8;
    for (std::size_t i = 0; i < std::min(most, lines.size()); ++i)
        remarks.push_back("OpenSceneGraph: " + lines[i]);
    if (lines.size() > most)
        remarks.push_back("OpenSceneGraph: " + std::to_string(lines.size() - most) +
                          " more lines like these");
}

void say(std::vector<std::string>& remarks, GuardedReading& guard, osg::Node& graph) {
    for (auto& refused : guard.take())
        remarks.push_back(std::move(refused));
    for (auto& removed : removeLateReaders(graph))
        remarks.push_back(std::move(removed));
}

class ProxyCollector : public osg::NodeVisitor {
  public:
    ProxyCollector() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }
    void apply(osg::ProxyNode& node) override {
        if (std::find(found.begin(), found.end(), &node) == found.end())
            found.push_back(&node);
        traverse(node);
    }
    std::vector<osg::ref_ptr<osg::ProxyNode>> found;
};

/// Replaces each proxy node by a plain group with its children: written to a file, a proxy would
/// read its own file again and without the codes.
void removeProxies(osg::Node& graph) {
    ProxyCollector proxies;
    graph.accept(proxies);
    for (const auto& proxy : proxies.found) {
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->setName(proxy->getName());
        group->setStateSet(proxy->getStateSet());
        group->setNodeMask(proxy->getNodeMask());
        for (unsigned int i = 0; i < proxy->getNumChildren(); ++i)
            group->addChild(proxy->getChild(i));
        while (proxy->getNumParents() > 0)
            proxy->getParent(0)->replaceChild(proxy, group);
    }
}

/// The files of one scan, handed to the plug-in as validated bytes.
class FlightReader {
  public:
    FlightReader(const FlightScan& scan, LoadPurpose purpose)
        : scan_(scan),
          purpose_(purpose == LoadPurpose::visible ? FlightFile::Purpose::visible
                                                   : FlightFile::Purpose::infrared),
          plugin_(osgDB::Registry::instance()->getReaderWriterForExtension("flt")) {
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

        // Each external reference carries the palettes it lends; a file referred to twice is
        // shared.
        ProxyCollector proxies;
        node->accept(proxies);
        for (const auto& proxy : proxies.found) {
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
    say(loaded.remarks, notices.take());
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

LoadedGraph loadOther(const fs::path& file) {
    const auto extension = osgDB::getLowerCaseFileExtension(file.string());

    const std::scoped_lock lock(osgRegistryMutex());
    OsgNotices notices;
    GuardedReading guard;
    LoadedGraph loaded;
    std::string complaint;
    auto* reader = osgDB::Registry::instance()->getReaderWriterForExtension(extension);
    if (!reader)
        throw InputError(
            {file.string(), "",
             "a file of type \"." + extension + "\" and no plug-in of OpenSceneGraph for it",
             expectationOf(FileKind::model)});
    try {
        auto result = reader->readNode(file.string(), privateOptions(file.parent_path()));
        complaint = result.message();
        loaded.node = result.takeNode();
    } catch (const std::exception& error) {
        complaint = error.what();
    }
    const auto lines = notices.take();
    if (!loaded.node) {
        for (const auto& said : {lines, guard.take()})
            for (const auto& line : said)
                complaint += (complaint.empty() ? "" : "; ") + line;
        throw InputError({file.string(), "",
                          "a file that OpenSceneGraph cannot read as a model" +
                              (complaint.empty() ? "" : " (" + complaint + ")"),
                          "a whole model file of type ." + extension});
    }
    say(loaded.remarks, lines);
    say(loaded.remarks, guard, *loaded.node);

    ProxyCollector proxies;
    loaded.node->accept(proxies);
    for (const auto& proxy : proxies.found)
        for (unsigned int i = 0; i < proxy->getNumFileNames(); ++i)
            loaded.remarks.push_back("refers to " + proxy->getFileName(i) +
                                     (i < proxy->getNumChildren()
                                          ? ", which is read without being validated"
                                          : ", which is missing"));
    if (dynamic_cast<osg::ProxyNode*>(loaded.node.get())) {
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(loaded.node);
        loaded.node = root;
    }
    removeProxies(*loaded.node);
    return loaded;
}

} // namespace

std::mutex& osgRegistryMutex() {
    static std::mutex mutex;
    return mutex;
}

LoadedGraph loadGraph(const fs::path& file, LoadPurpose purpose) {
    const auto refusal = refusalOf(file.string(), FileKind::model);
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored))
        throw InputError({file.string(), "",
                          "no such file" + (refusal ? " (" + *refusal + ")" : std::string()),
                          refusal ? expectationOf(FileKind::model) : "a model file"});
    if (refusal)
        throw InputError({file.string(), "", *refusal, expectationOf(FileKind::model)});
    return osgDB::getLowerCaseFileExtension(file.string()) == "flt" ? loadFlight(file, purpose)
                                                                    : loadOther(file);
}

} // namespace irsg
