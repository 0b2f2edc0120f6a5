#include "irsg/geometry/reading/sandbox/PluginReading.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <osg/Group>
#include <osgDB/FileNameUtils>
#include <osgDB/Registry>

#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/GuardedReading.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/OsgNotices.h"
#include "irsg/geometry/reading/OwnPlugins.h"
#include "irsg/geometry/reading/ProxyNodes.h"
#include "irsg/geometry/reading/sandbox/AskingProgram.h"
#include "irsg/geometry/reading/sandbox/CompletenessCheck.h"
#include "irsg/geometry/reading/sandbox/FlightReading.h"
#include "irsg/geometry/reading/text/ModelText.h"
#include "irsg/geometry/reading/text/OurModels.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

osgDB::ReaderWriter& readerOf(const fs::path& file, FileKind kind) {
    const auto extension = osgDB::getLowerCaseFileExtension(file.string());
    auto* reader = osgDB::Registry::instance()->getReaderWriterForExtension(extension);
    if (!reader)
        throw InputError(
            {file.string(), "",
             "a file of type \"." + extension + "\" and no plug-in of OpenSceneGraph for it",
             expectationOf(kind)});
    return *reader;
}

AssimpReading assimpReading = nullptr;

LoadedGraph readByAssimp(const fs::path& place, const fs::path& file) {
    if (!assimpReading)
        throw InputError({file.string(), "",
                          "a file of type \"." + osgDB::getLowerCaseFileExtension(file.string()) +
                              "\" and a build without Assimp, which would read it",
                          "a build with Assimp (package libassimp-dev), or another format"});
    GuardedReading guard;
    LoadedGraph loaded = assimpReading(place, file);
    for (auto& refused : guard.take())
        loaded.remarks.push_back(std::move(refused));
    return loaded;
}

/// Calls what reads, and gives what it says in place of a result where it fails.
template <typename Read>
std::string complaintOf(const Read& read) {
    try {
        return read();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return error.what();
    }
}

[[noreturn]] void refuse(const fs::path& file, FileKind kind, const std::string& complaint) {
    const bool model = kind == FileKind::model;
    throw InputError({file.string(), "",
                      std::string(model ? "a file that OpenSceneGraph cannot read as a model"
                                        : "a file that cannot be read as a picture") +
                          (complaint.empty() ? "" : " (" + complaint + ")"),
                      std::string(model ? "a whole model file" : "a whole picture") + " of type ." +
                          osgDB::getLowerCaseFileExtension(file.string())});
}

/// Of formats in which all models are alike, without a word for it.
FileAxes usualAxes(const fs::path& file) {
    if (osgDB::getLowerCaseFileExtension(file.string()) != "ac")
        return {};
    return {.unit_m = {},
            .up = ModelAxis::plusY,
            .front = {},
            .reason = "the custom of .ac: y up and, in aircraft of FlightGear, the nose along -x",
            .usualFront = ModelAxis::minusX};
}

} // namespace

void setAssimpReading(AssimpReading reading) {
    assimpReading = reading;
}

void preparePlugins() {
    preferOwnPlugins();
}

LoadedGraph readOurHere(const fs::path& file) {
    if (!arePicturesWanted())
        return readOurModel(file, {});
    return readOurModel(file, arePicturesApart() ? pictureFromApart : readPictureHere);
}

LoadedGraph readModelHere(const fs::path& place, const fs::path& file) {
    if (modelReaderOf(file.string()) == FormatReader::flight)
        return readFlightHere(takeContents());
    if (modelReaderOf(file.string()) == FormatReader::ours)
        return readOurHere(file);
    const std::vector<std::string> counted = checkCompleteness(place, file);
    if (modelReaderOf(file.string()) == FormatReader::assimp &&
        (assimpReading || !hasPlugin(file.string())))
        return readByAssimp(place, file);
    OsgNotices notices;
    GuardedReading guard;
    LoadedGraph loaded;
    auto& reader = readerOf(file, FileKind::model);
    std::string complaint = complaintOf([&] {
        const auto options = GuardedReading::options();
        options->getDatabasePathList().push_back(file.parent_path().string());
        // A text is read from what was made of it, other bytes where they lie.
        const bool text = hasTextForm(osgDB::getLowerCaseFileExtension(file.string()));
        std::ifstream stream;
        std::istringstream words;
        if (text)
            words.str(readModelBytes(place, file));
        else if (place != file)
            stream.open(place, std::ios::binary);
        auto result = text            ? reader.readNode(words, options)
                      : place == file ? reader.readNode(file.string(), options)
                                      : reader.readNode(stream, options);
        loaded.node = result.takeNode();
        return result.message();
    });
    const auto lines = notices.take();
    if (!loaded.node) {
        for (const auto& said : {lines, guard.take()})
            for (const auto& line : said)
                complaint += (complaint.empty() ? "" : "; ") + line;
        refuse(file, FileKind::model, complaint);
    }
    loaded.axes = usualAxes(file);
    loaded.remarks = counted;
    addNotices(loaded.remarks, lines);
    const std::vector<std::string> refusals = guard.take();
    loaded.remarks.insert(loaded.remarks.end(), refusals.begin(), refusals.end());
    for (auto& removed : removeLateReaders(*loaded.node))
        loaded.remarks.push_back(std::move(removed));

    // What is there and was refused has its remark, which names it: it is not missing.
    const auto isRefused = [&](const std::string& name) {
        return std::ranges::any_of(refusals, [&](const std::string& refusal) {
            return refusal.find(fs::path(name).filename().string()) != refusal.npos;
        });
    };
    for (const auto& proxy : proxiesOf(*loaded.node))
        for (unsigned int i = 0; i < proxy->getNumFileNames(); ++i)
            if (i < proxy->getNumChildren() || !isRefused(proxy->getFileName(i)))
                loaded.remarks.push_back(
                    "refers to " + proxy->getFileName(i) +
                    (i >= proxy->getNumChildren() ? ", which is missing"
                     : modelReaderOf(proxy->getFileName(i)) == FormatReader::plugin
                         ? ", which is read without being validated"
                         : ", which is read as well"));
    if (dynamic_cast<osg::ProxyNode*>(loaded.node.get())) {
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(loaded.node);
        loaded.node = root;
    }
    removeProxies(*loaded.node);
    return loaded;
}

osg::ref_ptr<osg::Image> readPictureHere(const fs::path& file) {
    OsgNotices notices;
    const GuardedReading guard;
    auto& reader = readerOf(file, FileKind::picture);
    osg::ref_ptr<osg::Image> image;
    const std::string complaint = complaintOf([&] {
        auto result = reader.readImage(file.string(), GuardedReading::options());
        image = result.takeImage();
        return result.message();
    });
    if (!image || !image->valid())
        refuse(file, FileKind::picture, complaint);
    return image;
}

} // namespace irsg
