#include "irsg/geometry/reading/GuardedReading.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <osg/ImageStream>
#include <osg/NodeVisitor>
#include <osg/PagedLOD>
#include <osg/ScriptEngine>
#include <osg/Texture>
#include <osgDB/Callbacks>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

#include "irsg/core/Errors.h"
#include "irsg/core/WrittenPath.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/sandbox/AskingProgram.h"
#include "irsg/geometry/reading/sandbox/FlightReading.h"
#include "irsg/geometry/reading/sandbox/PluginReading.h"
#include "irsg/geometry/reading/sandbox/ReadingLimits.h"

namespace irsg {

namespace {

thread_local GuardedReading* reading = nullptr;

using Result = osgDB::ReaderWriter::ReadResult;

} // namespace

void noteRefusal(const std::string& remark) {
    if (reading && std::ranges::find(reading->refused_, remark) == reading->refused_.end())
        reading->refused_.push_back(remark);
}

namespace {

bool mayOpen(const std::string& name, std::initializer_list<FileKind> kinds) {
    std::string why, expected;
    for (const FileKind kind : kinds) {
        const auto refusal = refusalOf(name, kind);
        if (!refusal)
            return true;
        if (why.empty()) {
            why = *refusal;
            expected = expectationOf(kind);
        }
    }
    noteRefusal(
        "refers to " + name + ", which is not opened: " +
        (why.empty() ? "no kind of file that belongs to a model" : why + ", expected " + expected));
    return false;
}

/// Stands before every read by name: of the thread that reads guarded where it belongs to the
/// registry, of all threads where it belongs to options.
class ReadGuard : public osgDB::ReadFileCallback {
  public:
    ReadGuard(bool always, osgDB::ReadFileCallback* next) : always_(always), next_(next) {}

    Result openArchive(const std::string& name, osgDB::ReaderWriter::ArchiveStatus status,
                       unsigned int hint, const osgDB::Options* options) override {
        if (!passes(name, {}))
            return Result::FILE_NOT_HANDLED;
        return next_ ? next_->openArchive(name, status, hint, options)
                     : ReadFileCallback::openArchive(name, status, hint, options);
    }
    Result readObject(const std::string& name, const osgDB::Options* options) override {
        if (!passes(name, {FileKind::model, FileKind::picture, FileKind::attributes}))
            return Result::FILE_NOT_HANDLED;
        return next_ ? next_->readObject(name, options)
                     : ReadFileCallback::readObject(name, options);
    }
    Result readImage(const std::string& name, const osgDB::Options* options) override {
        if (!passes(name, {FileKind::picture}))
            return Result::FILE_NOT_HANDLED;
        const std::string file = osgDB::findDataFile(name, options);
        if (arePicturesApart())
            return file.empty() ? Result(Result::FILE_NOT_FOUND) : readApart(file);
        noteSize(file);
        return next_ ? next_->readImage(name, options) : ReadFileCallback::readImage(name, options);
    }
    Result readHeightField(const std::string& name, const osgDB::Options* options) override {
        if (!passes(name, {}))
            return Result::FILE_NOT_HANDLED;
        return next_ ? next_->readHeightField(name, options)
                     : ReadFileCallback::readHeightField(name, options);
    }
    Result readNode(const std::string& name, const osgDB::Options* options) override {
        if (!passes(name, {FileKind::model}))
            return Result::FILE_NOT_HANDLED;
        const std::string file = osgDB::findDataFile(name, options);
        noteSize(file);
        if (const auto graph = readOurs(file)) {
            for (const std::string& remark : graph->remarks)
                noteRefusal(remark);
            return graph->node.get();
        }
        if (modelReaderOf(file) == FormatReader::flight && !file.empty())
            return Result::ERROR_IN_READING_FILE; // refused by the scan, which has said why
        return next_ ? next_->readNode(name, options) : ReadFileCallback::readNode(name, options);
    }
    Result readShader(const std::string& name, const osgDB::Options* options) override {
        if (!passes(name, {}))
            return Result::FILE_NOT_HANDLED;
        return next_ ? next_->readShader(name, options)
                     : ReadFileCallback::readShader(name, options);
    }
    Result readScript(const std::string& name, const osgDB::Options* options) override {
        if (!passes(name, {}))
            return Result::FILE_NOT_HANDLED;
        return next_ ? next_->readScript(name, options)
                     : ReadFileCallback::readScript(name, options);
    }

  private:
    bool isGuarded() const { return always_ || reading; }
    bool passes(const std::string& name, std::initializer_list<FileKind> kinds) const {
        if (!isGuarded())
            return true;
        if (!mayOpen(name, kinds))
            return false;
        if (!isReader())
            noteRefusal("refers to " + name + ", which a reading process alone opens");
        return isReader();
    }
    static void noteSize(const std::string& file) {
        std::error_code failure;
        const std::uintmax_t size = std::filesystem::file_size(file, failure);
        if (isReader() && !failure)
            allowMore(size);
    }
    /// Formats that no plug-in reads, or none before our scan of all records.
    static std::optional<LoadedGraph> readOurs(const std::string& file) {
        const FormatReader reader = modelReaderOf(file);
        if (reader == FormatReader::plugin || file.empty())
            return std::nullopt;
        try {
            if (reader == FormatReader::flight)
                return readFlightHere(scannedFlight(file, arePicturesWanted()));
            if (reader == FormatReader::assimp)
                return readModelHere(file, file);
            return readOurHere(file);
        } catch (const InputError& error) {
            noteRefusal(error.what());
            return std::nullopt;
        }
    }
    static Result readApart(const std::string& file) {
        try {
            const auto image = pictureFromApart(file);
            image->setFileName(file);
            return image;
        } catch (const InputError& error) {
            noteRefusal(error.what());
            return Result::ERROR_IN_READING_FILE;
        }
    }

    bool always_;
    osg::ref_ptr<osgDB::ReadFileCallback> next_;
};

/// Stands before every plug-in that is loaded. Some readers load one by an extension that is
/// written inside a file, and ask it directly.
class LibraryGuard : public osgDB::FindFileCallback {
  public:
    explicit LibraryGuard(osgDB::FindFileCallback* next) : next_(next) {}

    std::string findDataFile(const std::string& name, const osgDB::Options* options,
                             osgDB::CaseSensitivity sensitivity) override {
        const std::string found = next_
                                      ? next_->findDataFile(name, options, sensitivity)
                                      : FindFileCallback::findDataFile(name, options, sensitivity);
        if (!found.empty() || !reading || options == nullptr)
            return found;
        // Plug-ins of every format look for what their files name here.
        for (const std::string& folder : options->getDatabasePathList()) {
            const WrittenPath written = findWrittenOrBeside(folder, name);
            if (written.file.empty())
                continue;
            if (!written.remark.empty())
                noteRefusal(written.remark);
            return written.file.string();
        }
        return found;
    }
    std::string findLibraryFile(const std::string& name, const osgDB::Options* options,
                                osgDB::CaseSensitivity sensitivity) override {
        // Where nothing is found the loader tries the bare name, which begins in the working
        // folder: a place where no library can be is the only answer it takes for a no.
        static const std::string nowhere = "/dev/null/none";
        if (reading && !mayLoadLibrary(name)) {
            if (!isAnotherNameOfNodeKit(name, options))
                noteRefusal("asks for the plug-in " + name +
                            ", which is not loaded: it reads none of the formats that are opened");
            return nowhere;
        }
        const std::string found =
            next_ ? next_->findLibraryFile(name, options, sensitivity)
                  : FindFileCallback::findLibraryFile(name, options, sensitivity);
        return reading && !std::filesystem::path(found).is_absolute() ? nowhere : found;
    }

  private:
    /// The classes of a node kit are looked for in several libraries, last in one that is named
    /// like a plug-in and that there need not be: who reads a joint of osgSim asks for none.
    bool isAnotherNameOfNodeKit(const std::string& name, const osgDB::Options* options) {
        constexpr std::string_view plugin = "osgdb_osg";
        const auto begin = name.find(plugin);
        if (begin == name.npos)
            return false;
        std::string serializers = name;
        serializers.insert(begin + std::string_view("osgdb_").size(), "serializers_");
        return !FindFileCallback::findLibraryFile(serializers, options, osgDB::CASE_SENSITIVE)
                    .empty();
    }

    osg::ref_ptr<osgDB::FindFileCallback> next_;
};

class LateReaderRemoval : public osg::NodeVisitor {
  public:
    LateReaderRemoval() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }

    void apply(osg::Node& node) override {
        removeFrom(node);
        if (node.getStateSet())
            removeFrom(*node.getStateSet());
        traverse(node);
    }
    void apply(osg::PagedLOD& node) override {
        for (unsigned int i = 0; i < node.getNumFileNames(); ++i) {
            if (!node.getFileName(i).empty() && i >= node.getNumChildren())
                remarks.insert("refers to the page " + node.getFileName(i) +
                               ", which is left out: pages are not read");
            node.setFileName(i, "");
        }
        node.setDisableExternalChildrenPaging(true);
        apply(static_cast<osg::Node&>(node));
    }

    std::set<std::string> remarks;

  private:
    void removeFrom(osg::Node& node) {
        using Get = osg::Callback* (osg::Node::*)();
        using Set = void (osg::Node::*)(osg::Callback*);
        const std::pair<Get, Set> places[] = {
            {&osg::Node::getUpdateCallback, &osg::Node::setUpdateCallback},
            {&osg::Node::getEventCallback, &osg::Node::setEventCallback},
            {&osg::Node::getCullCallback, &osg::Node::setCullCallback}};
        for (const auto& [get, set] : places)
            for (osg::ref_ptr<osg::Callback> callback = (node.*get)(); callback;
                 callback = callback->getNestedCallback())
                if (dynamic_cast<osg::ScriptNodeCallback*>(callback.get())) {
                    remarks.insert("node '" + node.getName() +
                                   "' has a script, which is removed and not run");
                    (node.*set)(nullptr);
                    break;
                }
    }
    void removeFrom(osg::StateSet& state) {
        if (!seen_.insert(&state).second)
            return;
        for (unsigned int unit = 0; unit < state.getNumTextureAttributeLists(); ++unit) {
            auto* texture = dynamic_cast<osg::Texture*>(
                state.getTextureAttribute(unit, osg::StateAttribute::TEXTURE));
            for (unsigned int i = 0; texture && i < texture->getNumImages(); ++i)
                if (dynamic_cast<osg::ImageStream*>(texture->getImage(i))) {
                    remarks.insert("a texture is the stream of pictures '" +
                                   texture->getImage(i)->getFileName() + "', which is left out");
                    texture->setImage(i, nullptr);
                }
        }
    }

    std::set<const osg::StateSet*> seen_;
};

void standGuard() {
    static std::once_flag once;
    std::call_once(once, [] {
        auto* registry = osgDB::Registry::instance();
        registry->setReadFileCallback(new ReadGuard(false, registry->getReadFileCallback()));
        registry->setFindFileCallback(new LibraryGuard(registry->getFindFileCallback()));
    });
}

} // namespace

GuardedReading::GuardedReading() : outer_(reading) {
    standGuard();
    reading = this;
}

GuardedReading::~GuardedReading() {
    reading = outer_;
}

osg::ref_ptr<osgDB::Options> GuardedReading::options(const std::string& text) {
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options(text);
    options->setObjectCacheHint(osgDB::Options::CACHE_NONE);
    options->setReadFileCallback(
        new ReadGuard(true, osgDB::Registry::instance()->getReadFileCallback()));
    return options;
}

std::vector<std::string> GuardedReading::take() {
    return std::exchange(refused_, {});
}

std::vector<std::string> removeLateReaders(osg::Node& graph) {
    LateReaderRemoval removal;
    graph.accept(removal);
    return {removal.remarks.begin(), removal.remarks.end()};
}

} // namespace irsg
