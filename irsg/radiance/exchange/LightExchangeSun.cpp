#include <algorithm>
#include <cmath>

#include "irsg/core/ParallelFor.h"
#include "irsg/core/StageReport.h"
#include "irsg/radiance/exchange/LightExchangeMaking.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

/// Cells of which each is divided in four to see how much of it the sun lights.
constexpr std::size_t fewCells = 60'000;

} // namespace

/// What falls on cells, and its means over senders.
void LightExchange::takeSun(Making& making) {
    const LightSources& sources = making.sources;
    sun_.assign(senders(), sources.isSunOn ? std::max(sources.sunAlways, 0.0) : 0.0);
    if (!sources.isSunOn || sources.sunAlways >= 0.0)
        return;
    making.sunOnCells.resize(cells_);
    std::vector<double> area_m2(senders());
    StageCount count("sun", cells_);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const ExchangeNodes& nodes = bodies_[b].light->nodes();
        const ExchangeMesh& mesh = nodes.mesh();
        // What sees nothing of its own body, nothing of that sees; others may.
        const auto isSeenByAny = [&](std::uint32_t cell) {
            return mesh.seesAnything(cell) || !making.isAlone(b);
        };
        parallelForSmall(mesh.cells(), [&](std::uint32_t cell) {
            count.add();
            if (isSeenByAny(cell))
                making.sunOnCells[firstCell_[b] + cell] =
                    static_cast<float>(sunOn(making, b, cell));
        });
        for (std::uint32_t cell = 0; cell < mesh.cells(); ++cell) {
            if (!isSeenByAny(cell))
                continue;
            const float sun = making.sunOnCells[firstCell_[b] + cell];
            const double cell_m2 = making.area_m2(bodies_, b, cell);
            for (const std::uint32_t corner : mesh.corners(cell))
                for (const ExchangeNodes::Share& share : nodes.sharesOf(corner)) {
                    const std::uint32_t sender = senderOf_[firstReceiver_[b] + share.node];
                    const double own_m2 = static_cast<double>(share.part) * cell_m2 / 3.0;
                    area_m2[sender] += own_m2;
                    sun_[sender] += own_m2 * static_cast<double>(sun);
                }
        }
    }
    for (std::size_t s = 0; s < senders(); ++s)
        sun_[s] = area_m2[s] > 0.0 ? sun_[s] / area_m2[s] : 0.0;
    takeSunThrough(making);
    std::vector<bool> isKnown;
    for (const double own_m2 : area_m2)
        isKnown.push_back(own_m2 > 0.0);
    sharpenSent(sun_, isKnown);
    for (LightThrough& one : through_)
        sharpenSent(one.sun, isKnown);
    takeSunBeside(making);
}

void LightExchange::takeSunBeside(Making& making) const {
    making.sunBeside.resize(1 + through_.size());
    std::vector<float> means; // by vertex of a body
    for (std::size_t set = 0; set < making.sunBeside.size(); ++set) {
        const std::vector<float>& onCells =
            set == 0 ? making.sunOnCells : through_[set - 1].sunOnCells;
        if (onCells.empty())
            continue;
        const std::vector<double>& sun = set == 0 ? sun_ : through_[set - 1].sun;
        making.sunBeside[set].resize(cells_);
        for (std::size_t b = 0; b < bodies_.size(); ++b) {
            const ExchangeNodes& nodes = bodies_[b].light->nodes();
            means.assign(nodes.mesh().vertices().size(), 0.0f);
            parallelForSmall(means.size(), [&](std::uint32_t vertex) {
                for (const ExchangeNodes::Share& share : nodes.sharesOf(vertex))
                    means[vertex] +=
                        share.part *
                        static_cast<float>(sun[senderOf_[firstReceiver_[b] + share.node]]);
            });
            parallelForSmall(nodes.mesh().cells(), [&](std::uint32_t cell) {
                Making::SunBeside& own = making.sunBeside[set][firstCell_[b] + cell];
                for (std::size_t c = 0; c < 3; ++c)
                    own.atCorners[c] =
                        onCells[firstCell_[b] + cell] - means[nodes.mesh().corners(cell)[c]];
                own.row =
                    static_cast<std::uint32_t>(making.casters[b].rows[nodes.mesh().pieceOf(cell)]);
            });
        }
    }
}

double LightExchange::sunOn(Making& making, std::size_t body, std::uint32_t cell) const {
    const ExchangeMesh& mesh = bodies_[body].light->nodes().mesh();
    const Vec3& towardsSun = making.sources.towardsSun;
    const Vec3 normal = making.normal(bodies_, body, cell);
    const double cosine = dot(making.toWorld[body] * normal, towardsSun);
    if (!(cosine > 0.0) || !making.sources.isSunShadowed)
        return std::max(cosine, 0.0);
    const std::array<Vec3, 3> c = mesh.cornersAt_m(cell);
    const Vec3 middle = (c[0] + c[1] + c[2]) * (1.0 / 3.0);
    const bool isOne = mesh.cells() > fewCells;
    const double each = isOne ? 1.0 : 0.25;
    thread_local std::vector<int> through;
    double lit = 0.0;
    const auto look = [&](const Vec3& place) {
        const Vec3 from_m = making.casters[body].pose.toWorld(place + normal * mesh.lift_m());
        std::vector<OccluderMaterial> passed;
        for (const std::size_t i : making.shading[body]) {
            const SunShadows::Caster& other = making.casters[i];
            through.clear();
            if (!other.mesh->letsPass({making.toMesh[i] * (from_m - other.pose.position_m),
                                       making.toMesh[i] * towardsSun},
                                      other.uses, nullptr, through))
                return;
            for (const int piece : through)
                if (making.isPane(i, static_cast<std::size_t>(piece)))
                    Making::pass(passed, making.paneOf(i, static_cast<std::size_t>(piece)));
        }
        if (passed.empty()) {
            lit += each;
            return;
        }
        auto& known = making.sunThrough[firstCell_[body] + cell];
        auto own = std::ranges::find(known, passed,
                                     &std::pair<std::vector<OccluderMaterial>, float>::first);
        if (own == known.end())
            own = known.insert(known.end(), {passed, 0.0f});
        own->second += static_cast<float>(each * cosine);
    };
    look(middle);
    // The middles of the four triangles between corners and middles of edges.
    for (std::size_t i = 0; i < 3 && !isOne; ++i)
        look(middle * 0.5 + c[i] * 0.5);
    return cosine * lit;
}

} // namespace irsg
