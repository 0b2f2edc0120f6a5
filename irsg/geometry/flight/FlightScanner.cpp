#include "irsg/geometry/flight/FlightScanner.h"

#include <algorithm>

#include "irsg/core/FileReading.h"
#include "irsg/core/WrittenPath.h"
#include "irsg/geometry/flight/FlightLevels.h"
#include "irsg/geometry/flight/FlightValidator.h"
#include "irsg/geometry/reading/OpenableFiles.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;

constexpr int highest = 1024;
constexpr std::size_t longestChain = 32;

/// The file a reference means, beside the referring file; empty when there is none.
WrittenPath resolve(const std::string& written, const fs::path& referring) {
    WrittenPath found =
        findWrittenOrBeside(referring.parent_path(), written.substr(0, written.find('<')));
    std::error_code ignored;
    if (!fs::is_regular_file(found.file, ignored))
        return {};
    found.file = found.file.lexically_normal();
    return found;
}

class Follower {
  public:
    explicit Follower(FlightScan& scan) : scan_(scan) {}

    struct Extent {
        double faces = 0;
        int height = 0;
    };

    Extent follow(const fs::path& path, bool coloursGiven) {
        // Each file is scanned once; a file above itself would be drawn for ever.
        const auto key = fs::weakly_canonical(path);
        if (const auto known = extents_.find(key); known != extents_.end())
            return known->second;
        if (open_.size() >= longestChain)
            throw InputError(
                {path.string(), "", "a chain of more than 32 external references", "at most 32"});
        scan_.files.push_back(scanFlightBytes(readFile(path, largestModel_B), path, coloursGiven));
        const auto index = scan_.files.size() - 1;
        open_.push_back(key);

        Extent extent{scan_.files[index].placedFaces, scan_.files[index].height};
        const auto externals = scan_.files[index].externals.size();
        for (std::size_t i = 0; i < externals; ++i) {
            const auto child = reference(index, i);
            extent.faces += scan_.files[index].externals[i].placements * child.faces;
            extent.height = std::max(extent.height, scan_.files[index].height + child.height);
        }
        if (extent.faces > mostFaces || extent.height > highest)
            throw InputError({path.string(), "", "external references that multiply without end",
                              "at most 20 million faces and 1024 levels"});
        open_.pop_back();
        extents_[key] = extent;
        return extent;
    }

  private:
    Extent reference(std::size_t index, std::size_t which) {
        const auto path = scan_.files[index].path;
        auto external = scan_.files[index].externals[which];
        const auto position = "byte " + std::to_string(external.offset);
        WrittenPath found = resolve(external.written, path);
        external.file = std::move(found.file);
        if (!found.remark.empty())
            scan_.files[index].remarks.push_back(found.remark);
        if (external.file.empty())
            throw InputError({path.string(), position,
                              "a reference to \"" + external.written + "\", which is missing",
                              "that file beside " + path.filename().string()});
        const auto key = fs::weakly_canonical(external.file);
        if (std::find(open_.begin(), open_.end(), key) != open_.end())
            throw InputError({path.string(), position,
                              "a reference to " + external.file.string() + ", which refers back",
                              "external references without a circle"});
        if (external.written.find('<') != std::string::npos)
            scan_.files[index].remarks.push_back("all of " + external.file.string() +
                                                 " appears, not only the node named in \"" +
                                                 external.written + "\"");
        scan_.files[index].externals[which] = external;
        return follow(external.file, external.givesColours);
    }

    FlightScan& scan_;
    std::vector<fs::path> open_;
    std::map<fs::path, Extent> extents_;
};

} // namespace

FlightFile scanFlightBytes(std::string bytes, const fs::path& name, bool coloursGiven) {
    FlightFile file;
    file.path = name;
    file.bytes = std::move(bytes);
    FlightValidator(file, coloursGiven).run();
    return file;
}

FlightScan scanFlight(const fs::path& file) {
    FlightScan scan;
    Follower(scan).follow(file, false);
    return scan;
}

std::map<IrCodes, int> FlightScan::faceCounts() const {
    std::map<IrCodes, int> counts;
    for (const auto& file : files)
        for (const auto& face : file.faces)
            ++counts[face.codes];
    return counts;
}

const FlightFile& FlightScan::find(const fs::path& path) const {
    const auto found = std::find_if(files.begin(), files.end(),
                                    [&](const FlightFile& file) { return file.path == path; });
    if (found == files.end())
        throw LogicError("no scan of " + path.string());
    return *found;
}

std::vector<FlightStream> FlightScan::streams(FlightFile::Purpose purpose) const {
    std::vector<FlightStream> streams;
    for (const FlightFile& file : files) {
        FlightStream& stream = streams.emplace_back();
        stream.path = file.path;
        stream.bytes = file.stream(purpose);
        stream.origin_m = file.origin();
        for (double& coordinate : stream.origin_m)
            coordinate *= file.unit_m;
        for (const FlightExternal& external : file.externals)
            stream.externals.emplace_back(
                external.written, static_cast<std::uint32_t>(&find(external.file) - files.data()));
    }
    return streams;
}

} // namespace irsg
