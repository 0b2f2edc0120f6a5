#include "irsg/geometry/flight/FlightLevels.h"

#include <algorithm>
#include <utility>

namespace irsg {
namespace {

constexpr std::size_t deepest = 256;

} // namespace

FlightLevels::Node& FlightLevels::open(const FlightRecord& record, FlightTreatment treatment) {
    closeCurrent();
    if (levels_.empty() && record.offset != 0)
        log_.report(record.offset, "a " + flightRecordName(record.opcode) + " record",
                    "a push level record before it");
    log_.keep(record, treatment);
    current_.emplace(record.opcode, record.offset);
    current_->step = log_.file().steps.size() - 1;

    // Children of a face become children of the node above it; a switch has a bit for each child.
    const auto parent = std::find_if(levels_.rbegin(), levels_.rend(), [](const Node& node) {
        return node.opcode != flight::face && node.opcode != flight::mesh && !node.anonymous;
    });
    const bool inGraph = record.opcode != flight::vertexList &&
                         record.opcode != flight::morphVertexList &&
                         record.opcode != flight::meshPrimitive;
    if (inGraph && parent != levels_.rend() && ++parent->children == parent->childLimit + 1 &&
        parent->childLimit > 0)
        log_.report(parent->offset,
                    "a switch with masks of " + std::to_string(parent->childLimit) + " bits",
                    "a bit for each of its children");
    return *current_;
}

void FlightLevels::push(const FlightRecord& record) {
    if (levels_.size() >= deepest)
        log_.report(record.offset, "more than 256 levels", "at most 256");
    if (!current_ || current_->pushed) {
        if (levels_.empty())
            log_.report(record.offset, "a push level record",
                        "a node before it that has no children yet");
        closeCurrent();
        // What is in a level without a node belongs to the node above, as if it were not there.
        log_.keep(record, FlightTreatment::drop);
        levels_.emplace_back(flight::group, record.offset).anonymous = true;
        ++anonymous_;
        return;
    }
    log_.keep(record);
    current_->pushed = true;
    levels_.push_back(*std::exchange(current_, std::nullopt));
}

FlightLevels::Node* FlightLevels::parent() {
    const auto node = std::find_if(levels_.rbegin(), levels_.rend(),
                                   [](const Node& each) { return !each.anonymous; });
    return node == levels_.rend() ? nullptr : &*node;
}

void FlightLevels::pop(const FlightRecord& record) {
    const bool anonymous = !levels_.empty() && levels_.back().anonymous;
    log_.keep(record, anonymous ? FlightTreatment::drop : FlightTreatment::keep);
    if (levels_.empty())
        return log_.report(record.offset, "a pop level record", "a push level record before it");
    closeCurrent();
    if (levels_.back().subfaces != 0)
        log_.report(record.offset, "a pop level record", "a pop subface record before it");
    Node node = std::move(levels_.back());
    levels_.pop_back();
    close(std::move(node));
}

void FlightLevels::pushSubface(const FlightRecord& record) {
    log_.keep(record);
    if (levels_.empty())
        log_.report(record.offset, "a push subface record", "a push level record before it");
    else if (++levels_.back().subfaces > static_cast<int>(deepest))
        log_.report(record.offset, "subfaces nested more than 256 deep", "at most 256");
}

void FlightLevels::popSubface(const FlightRecord& record) {
    log_.keep(record);
    if (levels_.empty() || --levels_.back().subfaces < 0)
        log_.report(record.offset, "a pop subface record",
                    "a push subface record before it at the same level");
}

void FlightLevels::instance(const FlightRecord& record) {
    auto& node = open(record);
    if (!log_.atLeast(record, 8))
        return;
    node.number = record.u16(6);
    if (record.opcode == flight::instanceDefinition)
        return;
    const auto found = instances_.find(node.number);
    if (found == instances_.end())
        return log_.report(record.offset + 6,
                           "a reference to instance " + std::to_string(node.number),
                           "its definition before it");
    node.placements = found->second.placements;
    node.height = found->second.height + 1;
}

void FlightLevels::finish(std::size_t end) {
    if (!levels_.empty())
        log_.report(end, "the end of the file",
                    std::to_string(levels_.size()) +
                        " more pop level records: the file is truncated");
    closeCurrent();
    if (anonymous_ > 0)
        log_.remark(std::to_string(anonymous_) + " levels have no node of their own: what is in "
                                                 "them belongs to the node above");
    if (emptyFaces_ > 0)
        log_.remark(std::to_string(emptyFaces_) + " faces have no vertices");
}

void FlightLevels::closeCurrent() {
    if (current_)
        close(*std::exchange(current_, std::nullopt));
}

void FlightLevels::close(Node node) {
    if (node.face >= 0) {
        // The light mode of the infrared stream keeps normals exactly where all vertices have one.
        auto& face = log_.file().faces[static_cast<std::size_t>(node.face)];
        auto& step = log_.file().steps[node.step];
        const auto mode = static_cast<unsigned char>(log_.file().bytes[step.lightModeOffset]);
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
                    log_.file().externals[static_cast<std::size_t>(index)].placements = times;
            log_.file().placedFaces = faces;
            log_.file().height = node.height;
        }
        return;
    }
    auto& parent = levels_.back();
    parent.height = std::max(parent.height, node.height + 1);
    for (const auto& [index, times] : node.placements)
        parent.placements[index] += times;
    if (node.placements[-1] > mostFaces || parent.height > 4 * static_cast<int>(deepest))
        log_.report(node.offset, "instances that multiply without end", "at most 20 million faces");
}

} // namespace irsg
