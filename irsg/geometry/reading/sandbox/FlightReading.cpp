#include "irsg/geometry/reading/sandbox/FlightReading.h"

#include <algorithm>
#include <sstream>

#include <osg/Group>
#include <osgDB/Registry>

#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/FarOrigin.h"
#include "irsg/geometry/reading/GuardedReading.h"
#include "irsg/geometry/reading/OsgNotices.h"
#include "irsg/geometry/reading/ProxyNodes.h"
#include "irsg/geometry/reading/sandbox/FlightStreams.h"

namespace irsg {

namespace {

/// Blank-separated, or the plug-in finds none of them. Without preserveFace it merges faces of
/// different codes; without the last one it drops the codes.
constexpr const char* flightOptions = "preserveFace preserveObject preserveNonOsgAttrsAsUserData";

FlightScanning flightScanning = nullptr;

class FlightReader {
  public:
    explicit FlightReader(std::vector<FlightStream> streams)
        : streams_(std::move(streams)),
          read_(streams_.size()),
          plugin_(osgDB::Registry::instance()->getReaderWriterForExtension("flt")) {
        if (!plugin_)
            throw InputError({streams_.front().path.string(), "",
                              "an OpenFlight file and no OpenFlight plug-in of OpenSceneGraph",
                              "the plug-in osgdb_openflight"});
    }

    osg::ref_ptr<osg::Node> read(std::size_t which, osg::Referenced* pools) {
        FlightStream& file = streams_[which];
        const osg::ref_ptr<osgDB::Options> options = GuardedReading::options(flightOptions);
        options->getDatabasePathList().push_back(file.path.parent_path().string());
        options->setUserData(pools);
        std::istringstream in(std::move(file.bytes));
        auto result = plugin_->readNode(in, options);
        osg::ref_ptr<osg::Node> node = result.takeNode();
        if (!node)
            throw InputError({file.path.string(), "", "a file that OpenSceneGraph cannot read",
                              "an OpenFlight file"});

        // What was taken from the positions in double, outside what the plug-in keeps.
        if (const auto [x, y, z] = file.origin_m; x != 0.0 || y != 0.0 || z != 0.0)
            moveBack(*node, osg::Vec3d(x, y, z));

        // Each external reference carries the palettes it lends; a file referred to twice is
        // shared.
        for (const auto& proxy : proxiesOf(*node)) {
            const osg::ref_ptr<osg::Referenced> lent = proxy->getUserData();
            proxy->setUserData(nullptr);
            const auto external = std::ranges::find(file.externals, proxy->getFileName(0),
                                                    &std::pair<std::string, std::uint32_t>::first);
            if (external == file.externals.end())
                throw LogicError("a reference to " + proxy->getFileName(0) + " was not scanned");
            auto& child = read_[external->second];
            if (!child)
                child = read(external->second, lent);
            proxy->addChild(child);
        }
        return node;
    }

  private:
    std::vector<FlightStream> streams_;
    std::vector<osg::ref_ptr<osg::Node>> read_;
    osg::ref_ptr<osgDB::ReaderWriter> plugin_;
};

} // namespace

void setFlightScanning(FlightScanning scanning) {
    flightScanning = scanning;
}

std::string scannedFlight(const std::filesystem::path& file, bool withPictures) {
    if (flightScanning == nullptr)
        throw LogicError("no scanner of OpenFlight was set");
    return flightScanning(file, withPictures);
}

LoadedGraph readFlightHere(std::string bytes) {
    OsgNotices notices;
    GuardedReading guard;
    LoadedGraph loaded;
    ByteSource source(bytes);
    FlightReader reader(getFlightStreams(source));
    std::string().swap(bytes);
    loaded.node = reader.read(0, nullptr);
    removeProxies(*loaded.node);
    addNotices(loaded.remarks, notices.take());
    for (auto& refused : guard.take())
        loaded.remarks.push_back(std::move(refused));
    for (auto& removed : removeLateReaders(*loaded.node))
        loaded.remarks.push_back(std::move(removed));
    return loaded;
}

} // namespace irsg
