// What bodies see of themselves, wherever they stand.
#include <algorithm>
#include <array>
#include <utility>

#include "irsg/radiance/exchange/LightExchangeMaking.h"

namespace irsg {

void LightExchange::copyPairs(const LightPairs& pairs, std::size_t body,
                              std::vector<std::vector<LightPart>>& to) const {
    const std::uint32_t before = firstReceiver_[body], sendersBefore = firstSender_[body];
    for (std::uint32_t r = 0; r < pairs.receivers(); ++r) {
        const auto [first, last] = pairs.of(r);
        for (const LightPair* pair = first; pair != last; ++pair)
            to[before + r].push_back({before + r, sendersBefore + pair->sender, pair->factor});
    }
}

LightBalance LightExchange::withOwnOf(const Making& making, const LightBalance& common,
                                      const std::vector<const LightBalance*>& ofBodies) const {
    if (bodies_.size() == 1 && making.isAlone(0))
        return *ofBodies.front();
    bool isAnyAlone = false;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        isAnyAlone = isAnyAlone || making.isAlone(b);
    if (!isAnyAlone)
        return common;
    std::vector<BalanceOfBody> all;
    all.reserve(bodies_.size());
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        all.push_back(making.isAlone(b) ? BalanceOfBody{ofBodies[b], true}
                                        : BalanceOfBody{&common, false});
    return joined(all);
}

/// Adds up what the rays of a patch that meet its body bring: at the corners of each cell where
/// they begin, then at the nodes near the patch.
class LightExchange::OwnRays {
  public:
    OwnRays(const LightExchange& exchange, Making& making, std::size_t body, std::uint32_t patch)
        : exchange_(exchange),
          making_(making),
          body_(body),
          patch_(patch),
          number_(exchange.firstReceiver_[body] + patch),
          nodes_(exchange.bodies_[body].light->nodes()),
          scales_(exchange.bodies_[body].light->scalesOf(patch)),
          nearCount_(nodes_.near(patch).size()),
          room_(roomOfThread()),
          suns_(room_.suns),
          leaving_(room_.leaving) {
        room_.sunSets.clear();
        for (std::size_t set = 0; set < making.sunBeside.size() && !making.sunParts.empty(); ++set)
            if (!making.sunBeside[set].empty())
                room_.sunSets.push_back(
                    {set, making.sunBeside[set].data() + exchange.firstCell_[body]});
        const std::size_t passages = exchange.bodies_[body].light->passages().size();
        room_.leavingOf.resize(std::max(room_.leavingOf.size(), passages), none);
        room_.sunOf.resize(
            std::max(room_.sunOf.size(), passages * room_.sunSets.size() * exchange.rows()), none);
    }
    ~OwnRays() {
        for (const Sun& sun : suns_)
            room_.sunOf[sun.number] = none;
        for (const Leaving& leaving : leaving_)
            room_.leavingOf[leaving.passage] = none;
        suns_.clear();
        leaving_.clear();
        room_.atNodes.clear();
    }
    OwnRays(const OwnRays&) = delete;
    OwnRays& operator=(const OwnRays&) = delete;

    void add(const PatchRays::Ray& start, const BodyLight::LightRay& ray, bool isUp) {
        const std::array<float, 3> parts{1.0f - start.u - start.v, start.u, start.v};
        if (ray.passage == 0) {
            hasMet_ = true;
            for (std::size_t c = 0; c < 3; ++c) {
                met_[c] += static_cast<double>(parts[c]);
                metUp_[c] += isUp ? static_cast<double>(parts[c]) : 0.0;
            }
        } else if (!ray.meetsAnything()) {
            Leaving& leaving = leavingOf(ray.passage);
            for (std::size_t c = 0; c < 3; ++c)
                (isUp ? leaving.up : leaving.down)[c] += static_cast<double>(parts[c]);
            return;
        }
        for (std::size_t i = 0; i < room_.sunSets.size(); ++i) {
            const Making::SunBeside& there = room_.sunSets[i].onCells[ray.place.cell];
            const float beside = there.at(ray.place.u, ray.place.v);
            if (beside == 0.0f)
                continue;
            Sun& sun = sunOf(ray.passage, i, there.row);
            for (std::size_t c = 0; c < 3; ++c)
                sun.atCorners[c] += parts[c] * beside;
        }
    }

    /// After all rays of a cell.
    void share(std::uint32_t cell) {
        if (!hasMet_ && room_.sunsOfCell.empty() && room_.leavingOfCell.empty())
            return;
        const std::array<std::uint32_t, 3>& corners = nodes_.mesh().corners(cell);
        for (std::size_t c = 0; c < 3; ++c)
            for (const ExchangeNodes::Share& share : nodes_.sharesOf(corners[c])) {
                const std::size_t near = nodes_.placeNear(patch_, share.node);
                const float scale = share.part * scales_[near];
                const auto wide = static_cast<double>(scale);
                Making::Told& told = making_.told[number_][near];
                told.sky += wide * metUp_[c];
                told.ground += wide * (met_[c] - metUp_[c]);
                for (const std::size_t i : room_.sunsOfCell)
                    room_.atNodes[i * nearCount_ + near] += scale * suns_[i].atCorners[c];
                for (const std::size_t i : room_.leavingOfCell) {
                    (*leaving_[i].atNodes)[near].sky += wide * leaving_[i].up[c];
                    (*leaving_[i].atNodes)[near].ground += wide * leaving_[i].down[c];
                }
            }
        met_ = metUp_ = {};
        hasMet_ = false;
        for (const std::size_t i : room_.sunsOfCell) {
            suns_[i].atCorners = {};
            suns_[i].isOfCell = false;
        }
        for (const std::size_t i : room_.leavingOfCell) {
            leaving_[i].up = leaving_[i].down = {};
            leaving_[i].isOfCell = false;
        }
        room_.sunsOfCell.clear();
        room_.leavingOfCell.clear();
    }

    /// After all cells.
    void tellOfSun() const {
        const auto near = nodes_.near(patch_);
        for (std::size_t i = 0; i < suns_.size(); ++i)
            for (std::size_t n = 0; n < nearCount_; ++n)
                if (const float part = room_.atNodes[i * nearCount_ + n]; part != 0.0f)
                    suns_[i].parts->push_back(
                        {exchange_.firstReceiver_[body_] + near[n].node, suns_[i].row, part});
    }

  private:
    static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
    /// Of the sun on a drawn row, beside means, through sets of materials on both ways.
    struct Sun {
        std::vector<LightPart>* parts;
        std::uint32_t row;
        std::size_t number; ///< by passage, set and row
        std::array<float, 3> atCorners{};
        bool isOfCell = false;
    };
    /// What leaves the body behind a passage.
    struct Leaving {
        std::vector<OutsideLight>* atNodes;
        std::size_t passage;
        std::array<double, 3> up{}, down{};
        bool isOfCell = false;
    };
    struct SunSet {
        std::size_t set;
        const Making::SunBeside* onCells;
    };
    /// Lists that are filled for each patch, and empty between them.
    struct Room {
        std::vector<SunSet> sunSets;
        std::vector<Sun> suns;
        std::vector<float> atNodes; ///< by sun and near node
        std::vector<Leaving> leaving;
        std::vector<std::uint32_t> sunOf, leavingOf; ///< numbers in these lists; else `none`
        std::vector<std::size_t> sunsOfCell, leavingOfCell;
    };
    static Room& roomOfThread() {
        thread_local Room room;
        return room;
    }

    /// Of a passage, of this entity.
    std::vector<OccluderMaterial> materialsOf(std::size_t passage) const {
        std::vector<OccluderMaterial> passed =
            exchange_.bodies_[body_].light->passages().materials(static_cast<int>(passage));
        for (OccluderMaterial& material : passed)
            material.first = making_.casters[body_].entity;
        return passed;
    }
    Leaving& leavingOf(std::size_t passage) {
        std::uint32_t& i = room_.leavingOf[passage];
        if (i == none) {
            i = static_cast<std::uint32_t>(leaving_.size());
            std::vector<OutsideLight>& atNodes =
                making_.found[number_].bySet[materialsOf(passage)].leaving;
            atNodes.resize(nearCount_);
            leaving_.push_back({&atNodes, passage});
        }
        if (!std::exchange(leaving_[i].isOfCell, true))
            room_.leavingOfCell.push_back(i);
        return leaving_[i];
    }
    Sun& sunOf(std::size_t passage, std::size_t set, std::uint32_t row) {
        const std::size_t number = (passage * room_.sunSets.size() + set) * exchange_.rows() + row;
        std::uint32_t& i = room_.sunOf[number];
        if (i == none) {
            i = static_cast<std::uint32_t>(suns_.size());
            suns_.push_back({&making_.sunPartsOf(number_, exchange_.passages_, materialsOf(passage),
                                                 room_.sunSets[set].set),
                             row, number});
            room_.atNodes.resize(suns_.size() * nearCount_);
        }
        if (!std::exchange(suns_[i].isOfCell, true))
            room_.sunsOfCell.push_back(i);
        return suns_[i];
    }

    const LightExchange& exchange_;
    Making& making_;
    std::size_t body_;
    std::uint32_t patch_, number_;
    const ExchangeNodes& nodes_;
    std::span<const float> scales_;
    std::size_t nearCount_;
    Room& room_;
    std::vector<Sun>& suns_;
    std::vector<Leaving>& leaving_;
    std::array<double, 3> met_{}, metUp_{};
    bool hasMet_ = false;
};

void LightExchange::takeOwn(Making& making, std::size_t body, std::uint32_t patch,
                            const PatchRays& starts) const {
    const std::span<const BodyLight::LightRay> rays = bodies_[body].light->raysOf(patch);
    const Vec3 up = making.toMesh[body] * Vec3{0.0, 0.0, 1.0};
    OwnRays own(*this, making, body, patch);
    std::uint32_t next = 0;
    for (const PatchRays::OfCell& cell : starts.cells) {
        for (; next < cell.end; ++next) {
            const PatchRays::Ray& start = starts.rays[next];
            const bool isUp = up.x * static_cast<double>(start.along[0]) +
                                  up.y * static_cast<double>(start.along[1]) +
                                  up.z * static_cast<double>(start.along[2]) >
                              0.0;
            own.add(start, rays[start.number], isUp);
        }
        own.share(cell.cell);
    }
    own.tellOfSun();
}

} // namespace irsg
