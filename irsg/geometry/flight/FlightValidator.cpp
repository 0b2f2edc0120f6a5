#include "irsg/geometry/flight/FlightValidator.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace irsg {
namespace {

constexpr std::size_t mostFlightDiagnostics = 50;

bool mayContinue(std::uint16_t opcode) {
    return opcode == flight::localVertexPool || opcode == flight::meshPrimitive ||
           opcode == flight::extension || opcode == flight::nameTable;
}

} // namespace

FlightValidator::FlightValidator(FlightFile& file, bool coloursGiven)
    : log_(file), levels_(log_), palette_(log_), geometry_(log_, levels_, palette_, coloursGiven) {}

void FlightValidator::run() {
    // The first record says that this is OpenFlight at all.
    const FlightRecords records(log_.file().bytes, log_.file().path.string(), log_.diagnostics());
    const auto& all = records.all();
    if (all.empty() || all.front().opcode != flight::header)
        throw InputError({log_.file().path.string(), "byte 0",
                          log_.file().bytes.empty() ? "an empty file"
                          : all.empty()             ? "no record"
                                        : "a " + flightRecordName(all.front().opcode) + " record",
                          "an OpenFlight header record"});

    for (const auto& record : all) {
        visit(record);
        if (log_.diagnostics().size() >= mostFlightDiagnostics)
            throw InputError(log_.diagnostics());
    }

    palette_.endAt(records.end());
    geometry_.finish();
    levels_.finish(records.end());
    if (!log_.diagnostics().empty())
        throw InputError(log_.diagnostics());
}

void FlightValidator::visit(const FlightRecord& record) {
    // The vertex palette ends where it says, on a record's edge.
    if (!FlightVertexPalette::isVertex(record.opcode))
        palette_.endAt(record.offset);
    const bool continued = record.fileLength > record.size();
    if (continued && !mayContinue(record.opcode))
        log_.report(record.offset, "a continued " + flightRecordName(record.opcode) + " record",
                    "continuation of mesh, extension and name table records only");

    // What stands between push and pop extension is for other programs.
    if (record.opcode == flight::pushExtension) {
        ++extensionDepth_;
    } else if (record.opcode == flight::popExtension) {
        if (--extensionDepth_ < 0)
            log_.report(record.offset, "a pop extension record",
                        "a push extension record before it");
        extensionDepth_ = std::max(extensionDepth_, 0);
    } else if (extensionDepth_ > 0) {
        return;
    } else if (!(visitControl(record) || visitPalette(record) || visitAncillary(record) ||
                 geometry_.visit(record) || visitNode(record))) {
        log_.remarkOnce(std::to_string(record.opcode),
                        flightRecordName(record.opcode) + " records are not read");
    }
}

bool FlightValidator::visitControl(const FlightRecord& record) {
    switch (record.opcode) {
    case flight::header:
        header(record);
        return true;
    case flight::pushLevel:
        levels_.push(record);
        return true;
    case flight::popLevel:
        levels_.pop(record);
        return true;
    case flight::pushSubface:
        levels_.pushSubface(record);
        return true;
    case flight::popSubface:
        levels_.popSubface(record);
        return true;
    case flight::continuation:
        log_.report(record.offset, "a continuation record", "a record before it to continue");
        return true;
    default:
        return false;
    }
}

void FlightValidator::header(const FlightRecord& record) {
    if (record.offset != 0)
        return log_.report(record.offset, "a second header record", "one header a file");
    if (!log_.atLeast(record, 64))
        return;
    log_.file().version = record.i32(12);
    const bool known =
        log_.file().version == 14 || (log_.file().version >= 1400 && log_.file().version < 1700);
    if (!known)
        log_.report(12, "version " + std::to_string(log_.file().version), "14, or 1400 to 1699");

    static const std::map<int, double> units = {
        {0, 1.0}, {1, 1000.0}, {4, 0.3048}, {5, 0.0254}, {8, 1852.0}};
    const auto unit = units.find(record.u8(62));
    if (unit == units.end())
        log_.report(62, "unit " + std::to_string(record.u8(62)),
                    "0 (metre), 1 (kilometre), 4 (foot), 5 (inch) or 8 (nautical mile)");
    else
        log_.file().unit_m = unit->second;
    levels_.open(record);
}

bool FlightValidator::visitPalette(const FlightRecord& record) {
    switch (record.opcode) {
    case flight::colourPalette:
        if (log_.atLeast(record, 136)) {
            log_.keep(record);
            geometry_.setColours();
        }
        return true;
    case flight::vertexPalette:
        palette_.begin(record);
        return true;
    case flight::vertexC:
    case flight::vertexCN:
    case flight::vertexCNT:
    case flight::vertexCT:
        palette_.vertex(record);
        return true;
    case flight::texturePalette:
        if (log_.atLeast(record, 208)) {
            log_.keep(record, FlightTreatment::appearance);
            log_.file().pictures.push_back(record.text(4, 200));
        }
        return true;
    case flight::materialPalette:
        if (log_.atLeast(record, 80))
            log_.keep(record, FlightTreatment::appearance);
        return true;
    case flight::oldMaterialPalette:
        log_.keep(record, FlightTreatment::appearance);
        return true;
    case 83: // eyepoints, linkage, sounds, line styles, light sources, texture mappings, names
    case 90:
    case 93:
    case 97:
    case 102:
    case 112:
    case flight::nameTable:
    case 128: // appearance and animation of light points, shaders, extended materials
    case 129:
        return true;
    default:
        return record.opcode >= 133 && record.opcode <= 149;
    }
}

bool FlightValidator::visitAncillary(const FlightRecord& record) {
    switch (record.opcode) {
    case flight::longId:
        log_.keep(record);
        if (const auto* const node = levels_.current(); node != nullptr && node->face >= 0)
            log_.file().faces[static_cast<std::size_t>(node->face)].id =
                record.text(4, record.size() - 4);
        return true;
    case flight::comment:
        log_.keep(record, FlightTreatment::appearance);
        return true;
    case flight::matrix:
        matrix(record);
        return true;
    case flight::replicate:
        replicate(record);
        return true;
    case flight::multitexture:
    case flight::uvList:
        if (log_.atLeast(record, 8))
            log_.keep(record, FlightTreatment::appearance);
        return true;
    case 132:
        log_.remarkOnce("132", "sets of switches have names, which are not kept");
        return true;
    case 50: // vector, bounding volumes, the separate steps of a matrix
    case 74:
    case 94:
    case 116:
    case 119:
    case flight::pushAttribute:
    case flight::popAttribute:
        return true;
    default:
        return (record.opcode >= 40 && record.opcode <= 48) || record.opcode == 51 ||
               (record.opcode >= 76 && record.opcode <= 82) ||
               (record.opcode >= 105 && record.opcode <= 110);
    }
}

void FlightValidator::matrix(const FlightRecord& record) {
    if (!log_.atLeast(record, 68))
        return;
    for (std::size_t i = 0; i < 16; ++i)
        if (!(std::abs(record.f32(4 + 4 * i)) <= 1e9f))
            return log_.report(record.offset + 4 + 4 * i,
                               std::to_string(record.f32(4 + 4 * i)) + " in a matrix",
                               "a finite number within 1e9");
    for (std::size_t row = 0; row < 4; ++row)
        if (std::abs(record.f32(4 + 16 * row + 12) - (row == 3 ? 1.0f : 0.0f)) > 1e-5f)
            return log_.report(record.offset + 4 + 16 * row + 12, "a matrix with perspective",
                               "0, 0, 0, 1 in its last column");
    const FlightLevels::Node* const node = levels_.current();
    if (node == nullptr || node->opcode == flight::header ||
        node->opcode == flight::instanceReference || node->pushed)
        log_.remarkOnce("matrix", "the matrix at byte " + std::to_string(record.offset) +
                                      " belongs to no node that can be placed and is not used");
    log_.keep(record);
}

void FlightValidator::replicate(const FlightRecord& record) {
    if (!log_.atLeast(record, 6))
        return;
    if (record.i16(4) < 0)
        return log_.report(record.offset + 4, std::to_string(record.i16(4)) + " replications",
                           "0 or more");
    if (record.i16(4) > 0)
        log_.remark("of the part replicated " + std::to_string(record.i16(4)) + " times at byte " +
                    std::to_string(record.offset) + " only the first copy appears");
    log_.keep(record);
}

} // namespace irsg
