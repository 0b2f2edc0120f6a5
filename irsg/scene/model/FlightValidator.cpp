#include "irsg/scene/model/FlightValidator.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace irsg {
namespace {

constexpr std::size_t mostDiagnostics = 50;
constexpr std::size_t deepest = 256;
constexpr double mostFaces = 20e6;

bool isVertex(std::uint16_t opcode) {
    return opcode >= flight::vertexC && opcode <= flight::vertexCT;
}

bool mayContinue(std::uint16_t opcode) {
    return opcode == flight::localVertexPool || opcode == flight::meshPrimitive ||
           opcode == flight::extension || opcode == flight::nameTable;
}

} // namespace

FlightValidator::FlightValidator(FlightFile& file, bool coloursGiven)
    : file_(file), colours_(coloursGiven), coloursGiven_(coloursGiven) {}

void FlightValidator::run() {
    // The first record says that this is OpenFlight at all.
    const FlightRecords records(file_.bytes, file_.path.string(), diagnostics_);
    const auto& all = records.all();
    if (all.empty() || all.front().opcode != flight::header)
        throw InputError({file_.path.string(), "byte 0",
                          file_.bytes.empty() ? "an empty file"
                          : all.empty()       ? "no record"
                                        : "a " + flightRecordName(all.front().opcode) + " record",
                          "an OpenFlight header record"});

    for (const auto& record : all) {
        visit(record);
        if (diagnostics_.size() >= mostDiagnostics)
            throw InputError(diagnostics_);
    }

    // What was opened must have been closed.
    checkPaletteEnd(records.end());
    if (!levels_.empty())
        offend(records.end(), "the end of the file",
               std::to_string(levels_.size()) + " more pop level records: the file is truncated");
    if (current_)
        close(*std::exchange(current_, std::nullopt));
    if (billboards_ > 0)
        file_.remarks.push_back(std::to_string(billboards_) +
                                " billboard faces do not turn towards the sensor");
    if (emptyFaces_ > 0)
        file_.remarks.push_back(std::to_string(emptyFaces_) + " faces have no vertices");
    if (!diagnostics_.empty())
        throw InputError(diagnostics_);
}

void FlightValidator::visit(const FlightRecord& record) {
    // The vertex palette ends where it says, on a record's edge.
    if (!isVertex(record.opcode))
        checkPaletteEnd(record.offset);
    const bool continued = record.fileLength > record.size();
    if (continued && !mayContinue(record.opcode))
        offend(record.offset, "a continued " + flightRecordName(record.opcode) + " record",
               "continuation of mesh, extension and name table records only");

    // What stands between push and pop extension is for other programs.
    if (record.opcode == flight::pushExtension) {
        ++extensionDepth_;
    } else if (record.opcode == flight::popExtension) {
        if (--extensionDepth_ < 0)
            offend(record.offset, "a pop extension record", "a push extension record before it");
        extensionDepth_ = std::max(extensionDepth_, 0);
    } else if (extensionDepth_ > 0) {
        return;
    } else if (!(visitControl(record) || visitPalette(record) || visitAncillary(record) ||
                 visitGeometry(record) || visitNode(record))) {
        remarkOnce(std::to_string(record.opcode),
                   flightRecordName(record.opcode) + " records are not read");
    }
}

bool FlightValidator::visitControl(const FlightRecord& record) {
    switch (record.opcode) {
    case flight::header:
        header(record);
        return true;
    case flight::pushLevel:
        push(record);
        return true;
    case flight::popLevel:
        pop(record);
        return true;
    case flight::pushSubface:
        keep(record);
        if (levels_.empty())
            offend(record.offset, "a push subface record", "a push level record before it");
        else if (++levels_.back().subfaces > static_cast<int>(deepest))
            offend(record.offset, "subfaces nested more than 256 deep", "at most 256");
        return true;
    case flight::popSubface:
        keep(record);
        if (levels_.empty() || --levels_.back().subfaces < 0)
            offend(record.offset, "a pop subface record",
                   "a push subface record before it at the same level");
        return true;
    case flight::continuation:
        offend(record.offset, "a continuation record", "a record before it to continue");
        return true;
    default:
        return false;
    }
}

void FlightValidator::header(const FlightRecord& record) {
    if (record.offset != 0)
        return offend(record.offset, "a second header record", "one header a file");
    if (!atLeast(record, 64))
        return;
    file_.version = record.i32(12);
    const bool known = file_.version == 14 || (file_.version >= 1400 && file_.version < 1700);
    if (!known)
        offend(12, "version " + std::to_string(file_.version), "14, or 1400 to 1699");

    static const std::map<int, double> units = {
        {0, 1.0}, {1, 1000.0}, {4, 0.3048}, {5, 0.0254}, {8, 1852.0}};
    const auto unit = units.find(record.u8(62));
    if (unit == units.end())
        offend(62, "unit " + std::to_string(record.u8(62)),
               "0 (metre), 1 (kilometre), 4 (foot), 5 (inch) or 8 (nautical mile)");
    else
        file_.unit_m = unit->second;
    open(record);
}

void FlightValidator::push(const FlightRecord& record) {
    keep(record);
    if (!current_ || current_->pushed) {
        // The level is opened nevertheless so that its pop finds it.
        offend(record.offset, "a push level record", "a node before it that has no children yet");
        levels_.emplace_back(flight::group, record.offset);
        current_.reset();
        return;
    }
    if (levels_.size() >= deepest)
        offend(record.offset, "more than 256 levels", "at most 256");
    current_->pushed = true;
    levels_.push_back(*std::exchange(current_, std::nullopt));
}

void FlightValidator::pop(const FlightRecord& record) {
    keep(record);
    if (levels_.empty())
        return offend(record.offset, "a pop level record", "a push level record before it");
    if (current_)
        close(*std::exchange(current_, std::nullopt));
    if (levels_.back().subfaces != 0)
        offend(record.offset, "a pop level record", "a pop subface record before it");
    Node node = std::move(levels_.back());
    levels_.pop_back();
    close(std::move(node));
    closed_ = levels_.empty();
}

FlightValidator::Node& FlightValidator::open(const FlightRecord& record,
                                             FlightTreatment treatment) {
    if (current_)
        close(*std::exchange(current_, std::nullopt));
    if (levels_.empty() && record.offset != 0)
        offend(record.offset, "a " + flightRecordName(record.opcode) + " record",
               "a push level record before it");
    keep(record, treatment);
    current_.emplace(record.opcode, record.offset);
    current_->step = file_.steps.size() - 1;

    // Children of a face become children of the node above it; a switch has a bit for each child.
    const auto parent = std::find_if(levels_.rbegin(), levels_.rend(), [](const Node& node) {
        return node.opcode != flight::face && node.opcode != flight::mesh;
    });
    const bool inGraph = record.opcode != flight::vertexList &&
                         record.opcode != flight::morphVertexList &&
                         record.opcode != flight::meshPrimitive;
    if (inGraph && parent != levels_.rend() && ++parent->children == parent->childLimit + 1 &&
        parent->childLimit > 0)
        offend(parent->offset,
               "a switch with masks of " + std::to_string(parent->childLimit) + " bits",
               "a bit for each of its children");
    return *current_;
}

void FlightValidator::close(Node node) {
    if (node.face >= 0) {
        // The light mode of the infrared stream keeps normals exactly where all vertices have one.
        auto& face = file_.faces[static_cast<std::size_t>(node.face)];
        auto& step = file_.steps[node.step];
        const auto mode = static_cast<unsigned char>(file_.bytes[step.lightModeOffset]);
        const bool gouraud = mode == 1 || mode == 3;
        step.lightMode = static_cast<std::uint8_t>((face.normals ? 2 : 0) + (gouraud ? 1 : 0));
        emptyFaces_ += face.vertices == 0;
    }

    if (node.opcode == flight::instanceDefinition) {
        instances_[node.number] = {std::move(node.placements), node.height};
        return;
    }
    if (levels_.empty()) {
        const auto faces = node.placements[-1];
        if (node.opcode == flight::header) {
            for (auto& [index, times] : node.placements)
                if (index >= 0)
                    file_.externals[static_cast<std::size_t>(index)].placements = times;
            file_.placedFaces = faces;
            file_.height = node.height;
        }
        return;
    }
    auto& parent = levels_.back();
    parent.height = std::max(parent.height, node.height + 1);
    for (const auto& [index, times] : node.placements)
        parent.placements[index] += times;
    if (node.placements[-1] > mostFaces || parent.height > 4 * static_cast<int>(deepest))
        offend(node.offset, "instances that multiply without end", "at most 20 million faces");
}

void FlightValidator::keep(const FlightRecord& record, FlightTreatment treatment) {
    if (treatment != FlightTreatment::drop)
        file_.steps.push_back({record.offset, record.fileLength, treatment, 0, 0, {}});
}

bool FlightValidator::atLeast(const FlightRecord& record, std::size_t size) {
    if (record.size() >= size)
        return true;
    offend(record.offset,
           "a " + flightRecordName(record.opcode) + " record of " + std::to_string(record.size()) +
               " bytes",
           "at least " + std::to_string(size));
    return false;
}

void FlightValidator::coordinate(const FlightRecord& record, std::size_t at) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double value = record.f64(at + 8 * axis);
        if (!(std::abs(value) * file_.unit_m <= 1e9))
            offend(record.offset + at + 8 * axis, "coordinate " + std::to_string(value),
                   "a finite number within 1e9 m");
    }
}

void FlightValidator::finite(const FlightRecord& record, std::size_t at, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        if (!std::isfinite(record.f64(at + 8 * i)))
            return offend(record.offset + at + 8 * i,
                          std::to_string(record.f64(at + 8 * i)) + " in a " +
                              flightRecordName(record.opcode) + " record",
                          "a finite number");
}

void FlightValidator::offend(std::size_t offset, const std::string& value,
                             const std::string& expected) {
    diagnostics_.push_back(
        {file_.path.string(), "byte " + std::to_string(offset), value, expected});
}

void FlightValidator::remarkOnce(const std::string& key, const std::string& text) {
    if (remarked_.insert(key).second)
        file_.remarks.push_back(text);
}

} // namespace irsg
