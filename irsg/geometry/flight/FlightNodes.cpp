// The nodes of FlightValidator that hold other nodes: groups, switches, instances, other files.
#include "irsg/geometry/flight/FlightValidator.h"

namespace irsg {

bool FlightValidator::visitNode(const FlightRecord& record) {
    switch (record.opcode) {
    case flight::group:
    case flight::object:
        log_.atLeast(record, 12);
        levels_.open(record);
        return true;
    case flight::degreeOfFreedom:
        levels_.open(record);
        if (log_.atLeast(record, 380))
            log_.finite(record, 16, 9 + 36);
        return true;
    case flight::levelOfDetail:
        levels_.open(record);
        if (log_.atLeast(record, 64))
            log_.finite(record, 16, 2), log_.finite(record, 40, 3);
        return true;
    case flight::switchNode:
        switchNode(record);
        return true;
    case flight::instanceDefinition:
    case flight::instanceReference:
        levels_.instance(record);
        return true;
    case flight::externalReference:
        external(record);
        return true;
    case flight::lightSource:
    case flight::lightPoint:
    case flight::indexedLightPoint:
    case flight::lightPointSystem:
        log_.remarkOnce("light",
                        "light sources and light points have no infrared codes: not drawn");
        levels_.open(record, FlightTreatment::asGroup).light = true;
        return true;
    case flight::separatingPlane:
    case flight::extension:
    case flight::roadSegment:
    case flight::roadPath:
    case flight::roadConstruction:
        levels_.open(record, FlightTreatment::asGroup);
        return true;
    case flight::sound:
    case flight::text:
    case flight::clipRegion:
    case flight::curve:
    case flight::continuouslyAdaptiveTerrain:
        log_.remarkOnce(std::to_string(record.opcode),
                        "sounds, texts, clip regions, curves and adaptive "
                        "terrain are not drawn");
        levels_.open(record, FlightTreatment::asGroup).light = true;
        return true;
    default:
        return false;
    }
}

void FlightValidator::switchNode(const FlightRecord& record) {
    auto& node = levels_.open(record);
    if (!log_.atLeast(record, 28))
        return;
    const std::uint32_t present = record.u32(16), masks = record.u32(20), words = record.u32(24);
    if (masks == 0 || words == 0 || masks > record.size() || words > record.size() ||
        std::size_t{masks} * words > (record.size() - 28) / 4)
        return log_.report(record.offset + 20,
                           std::to_string(masks) + " switch masks of " + std::to_string(words) +
                               " words in a record of " + std::to_string(record.size()) + " bytes",
                           "one mask of one word or more, all inside the record");
    if (present >= masks)
        log_.report(record.offset + 16, "switch mask " + std::to_string(present),
                    "below " + std::to_string(masks));
    node.childLimit = 32 * std::size_t{words};
}

void FlightValidator::external(const FlightRecord& record) {
    auto& node = levels_.open(record);
    if (!log_.atLeast(record, 204))
        return;
    const auto path = record.text(4, 200);
    if (path.empty())
        return log_.report(record.offset + 4, "an external reference without a path",
                           "a file name");

    // Bit 0 of the mask keeps the palette of the other file.
    const std::uint32_t mask = record.size() >= 212 ? record.u32(208) : 0xFFFFFFFF;
    const bool own =
        (mask & 0x80000000) != 0 || log_.file().version == 1541 || log_.file().version < 1420;
    node.placements[static_cast<int>(log_.file().externals.size())] = 1;
    log_.file().externals.push_back({record.offset, path, {}, !own && geometry_.hasColours(), 0});
}

} // namespace irsg
