#include "irsg/radiance/LobeAims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "irsg/render/rays/RayVectors.h"

namespace irsg {

namespace {

/// Two spheres stand for one where their cross sections together are at most so much of its own.
constexpr double gainOfDivision = 0.6;

/// Cells of a body, and the sphere about them.
struct Group {
    std::size_t body = 0;
    std::vector<std::uint32_t> cells; // of its mesh
    Vec3 centre_m;
    double radius_m = 0.0;
    int across = 0;       // the longest axis of the box about them
    bool isWhole = false; // its halves would not be smaller

    Group(const ExchangeMesh& mesh, std::size_t of, std::vector<std::uint32_t> own)
        : body(of), cells(std::move(own)) {
        BoundingBox box = BoundingBox::nowhere();
        for (const std::uint32_t cell : cells)
            for (const Vec3& corner : mesh.cornersAt_m(cell))
                box.include(corner);
        centre_m = box.centre();
        for (const std::uint32_t cell : cells)
            for (const Vec3& corner : mesh.cornersAt_m(cell))
                radius_m = std::max(radius_m, plainLength(corner - centre_m));
        const Vec3 size = box.max - box.min;
        across = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    }
    double section_m2() const { return radius_m * radius_m; }
};

double along(const Vec3& v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// The halves of a group at the middle of its longest axis; one is empty where that is no division.
std::array<std::vector<std::uint32_t>, 2> halvesOf(const Group& group, const ExchangeMesh& mesh) {
    std::array<std::vector<std::uint32_t>, 2> halves;
    const double middle = along(group.centre_m, group.across);
    for (const std::uint32_t cell : group.cells) {
        const auto corners = mesh.cornersAt_m(cell);
        const double centre = along(corners[0] + corners[1] + corners[2], group.across) / 3.0;
        halves[centre < middle ? 0 : 1].push_back(cell);
    }
    return halves;
}

/// Divides the largest group into two as long as that gives smaller spheres and there is room.
void divide(std::vector<Group>& groups, const LightExchange& exchange) {
    while (groups.size() < LobeAims::most) {
        Group* largest = nullptr;
        for (Group& group : groups)
            if (!group.isWhole && (largest == nullptr || group.radius_m > largest->radius_m))
                largest = &group;
        if (largest == nullptr)
            return;
        const ExchangeMesh& mesh = exchange.bodies()[largest->body].light->mesh();
        auto halves = halvesOf(*largest, mesh);
        largest->isWhole = true;
        if (halves[0].empty() || halves[1].empty())
            continue;
        Group first(mesh, largest->body, std::move(halves[0]));
        Group second(mesh, largest->body, std::move(halves[1]));
        if (first.section_m2() + second.section_m2() > gainOfDivision * largest->section_m2())
            continue;
        *largest = std::move(first);
        groups.push_back(std::move(second));
    }
}

} // namespace

LobeAims::LobeAims(const LightExchange& exchange, const std::vector<bool>& bright) {
    std::vector<Group> groups;
    for (std::size_t b = 0; b < exchange.bodies().size() && groups.size() < most; ++b) {
        const ExchangeMesh& mesh = exchange.bodies()[b].light->mesh();
        std::vector<std::uint32_t> cells;
        for (std::uint32_t cell = 0; cell < mesh.cells(); ++cell)
            if (mesh.seesAnything(cell) &&
                bright[static_cast<std::size_t>(exchange.rowOfCell(exchange.firstCell(b) + cell))])
                cells.push_back(cell);
        if (!cells.empty())
            groups.emplace_back(mesh, b, std::move(cells));
    }
    divide(groups, exchange);
    if (groups.empty())
        return;
    std::vector<Set> ofSender(exchange.senders(), 0);
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const Group& group = groups[i];
        spheres_.push_back({group.body, group.centre_m, group.radius_m});
        for (const std::uint32_t cell : group.cells)
            exchange.forEachReceiver(exchange.firstCell(group.body) + cell,
                                     [&](std::uint32_t receiver, std::size_t, float) {
                                         ofSender[exchange.senderOf(receiver)] |= Set{1} << i;
                                     });
    }
    seen_.assign(exchange.receivers(), 0);
    const auto take = [&](const LightPairs& pairs) {
        for (std::size_t receiver = 0; receiver < pairs.receivers(); ++receiver) {
            const auto [first, last] = pairs.of(receiver);
            for (const LightPair* pair = first; pair != last; ++pair)
                seen_[receiver] |= ofSender[pair->sender];
        }
    };
    take(exchange.pairs());
    for (const LightThrough& passed : exchange.through())
        take(*passed.balance.pairs);
}

LobeAims::Set LobeAims::seenFrom(const LightExchange& exchange, std::uint32_t cell) const {
    if (seen_.empty())
        return 0;
    Set seen = 0;
    exchange.forEachReceiver(
        cell, [&](std::uint32_t receiver, std::size_t, float) { seen |= seen_[receiver]; });
    return seen;
}

} // namespace irsg
