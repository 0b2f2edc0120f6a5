#include "irsg/geometry/conversion/ModelLoader.h"

#include <algorithm>
#include <memory>
#include <string_view>

#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <sys/mman.h>
#include <unistd.h>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/FoundNames.h"
#include "irsg/core/Utf8.h"
#include "irsg/geometry/conversion/CodedGraph.h"
#include "irsg/geometry/flight/FlightScanner.h"
#include "irsg/geometry/reading/FarOrigin.h"
#include "irsg/geometry/reading/GuardedReading.h"
#include "irsg/geometry/reading/IrCodes.h"
#include "irsg/geometry/reading/OpenableFiles.h"
#include "irsg/geometry/reading/Utf8Names.h"
#include "irsg/geometry/reading/sandbox/AxesCoding.h"
#include "irsg/geometry/reading/sandbox/FlightStreams.h"
#include "irsg/geometry/reading/sandbox/GraphCoding.h"
#include "irsg/geometry/reading/sandbox/ReaderProcess.h"
#include "irsg/geometry/reading/text/ObjReader.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;

/// What a process of its own reads and hands over as bytes.
LoadedGraph loadSandboxed(const fs::path& place, const fs::path& file,
                          const OwnFiles* own = nullptr) {
    try {
        ReaderProcess process;
        const ReaderAnswer answer = process.read(FileKind::model, place, file, own);
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

LoadedGraph loadOurs(const fs::path& file, LoadPurpose purpose) {
    FoundNames names;
    OwnFiles own;
    own.opened = {file};
    // The infrared picture has no use for others.
    own.wantsPictures = purpose == LoadPurpose::visible;
    if (osgDB::getLowerCaseFileExtension(file.string()) == "obj") {
        ObjFiles named = filesOfObj(file);
        own.opened.insert(own.opened.end(), named.libraries.begin(), named.libraries.end());
        if (own.wantsPictures)
            own.pictures = std::move(named.pictures);
    }
    own.names = names.take();
    return loadSandboxed(file, file, &own);
}

/// Pictures that palettes name, found as the plug-in looks for them, and what lies beside them.
OwnFiles ownFilesOf(const FlightScan& scan, LoadPurpose purpose) {
    OwnFiles own;
    own.wantsPictures = purpose == LoadPurpose::visible;
    if (!own.wantsPictures)
        return own;
    const GuardedReading guard;
    FoundNames names;
    for (const FlightFile& file : scan.files) {
        const auto options = GuardedReading::options();
        options->getDatabasePathList().push_back(file.path.parent_path().string());
        for (const std::string& written : file.pictures) {
            const fs::path picture = osgDB::findDataFile(written, options);
            const fs::path attributes = picture.string() + ".attr";
            if (picture.empty() || refusalOf(picture.string(), FileKind::picture))
                continue;
            own.pictures.push_back(picture);
            own.opened.push_back(attributes);
        }
    }
    own.names = names.take();
    return own;
}

LoadedGraph loadFlight(const fs::path& file, LoadPurpose purpose) {
    const auto scan = scanFlight(file);
    const auto faces = scan.faceCounts();
    if (faces.empty())
        throw InputError({file.string(), "byte " + std::to_string(scan.files.front().bytes.size()),
                          "the end of a model without faces", "at least one face"});

    OwnFiles own = ownFilesOf(scan, purpose);
    putFlightStreams(own.contents,
                     scan.streams(purpose == LoadPurpose::visible ? FlightFile::Purpose::visible
                                                                  : FlightFile::Purpose::infrared));
    LoadedGraph loaded = loadSandboxed(file, file, &own);
    loaded.faces = faces;
    loaded.axes = {1.0, ModelAxis::plusZ, std::nullopt,
                   "the format: OpenFlight has z up, and its units are read as metres"};
    std::vector<std::string> remarks;
    for (const auto& scanned : scan.files)
        for (const auto& remark : scanned.remarks)
            remarks.push_back(scanned.path.filename().string() + ": " + remark);
    loaded.remarks.insert(loaded.remarks.begin(), remarks.begin(), remarks.end());

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

LoadedGraph loadByReader(const fs::path& file, LoadPurpose purpose) {
    switch (modelReaderOf(file.string())) {
    case FormatReader::flight:
        return loadFlight(file, purpose);
    case FormatReader::ours:
        return loadOurs(file, purpose);
    case FormatReader::plugin:
    case FormatReader::assimp:
        break;
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
    LoadedGraph loaded = loadByReader(file, purpose);
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
    writeAll(descriptor, bytes, name); // limits of file sizes count in memory as well
    return loadSandboxed("/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(descriptor),
                         name);
}

} // namespace irsg
