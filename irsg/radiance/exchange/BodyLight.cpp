#include "irsg/radiance/exchange/BodyLight.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "irsg/core/ParallelFor.h"
#include "irsg/core/StageReport.h"

namespace irsg {

/// Facets as a sensor meets them, and with all their backs.
struct BodyLight::Uses {
    const PieceUses& own;
    PieceUses withBacks = own.withBacks();
};

namespace {

/// Where a ray began, and where it went.
struct RayStart {
    explicit RayStart(const BodyLight::LightStart& start)
        : place(start.from.place),
          along{static_cast<float>(start.ray.direction.x),
                static_cast<float>(start.ray.direction.y),
                static_cast<float>(start.ray.direction.z)} {}

    ExchangeMesh::Place place;
    std::array<float, 3> along;
};

PatchRays byCells(const std::vector<RayStart>& starts) {
    PatchRays made;
    std::vector<std::uint32_t> order(starts.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return starts[i].place.cell; });
    made.rays.reserve(starts.size());
    for (const std::uint32_t i : order) {
        const RayStart& start = starts[i];
        made.rays.push_back({i, start.place.u, start.place.v, start.along});
        if (made.cells.empty() || made.cells.back().cell != start.place.cell)
            made.cells.push_back({start.place.cell, 0});
        made.cells.back().end = static_cast<std::uint32_t>(made.rays.size());
    }
    made.cells.shrink_to_fit();
    return made;
}

} // namespace

/// What a patch has sent.
struct BodyLight::Sending {
    /// How many rays meet the body, their directions, and how many meet each of some halves of its
    /// pieces, of which any two are told apart: in a cavity all rays meet something.
    static constexpr std::size_t halves = 4;
    using Moments = std::array<double, 4 + halves>;

    std::uint32_t sent = 0;
    std::vector<LightRay> hits;
    std::vector<RayStart> starts; ///< of hits
    std::vector<double> weights;  ///< by near node: its parts of the places where rays begin
    Moments moments{}, ofFirstHalf{};

    /// The variances of a single ray's moments: of all of them, and the greatest. Never 0, however
    /// few rays have met anything so far.
    struct Variance {
        double sum = 0.0, most = 0.0;
    };
    Variance variance() const {
        Variance variance;
        const double met = (moments[0] + 1.0) / (sent + 2.0);
        for (std::size_t i = 0; i < moments.size(); ++i) {
            const double mean = moments[i] / sent;
            const bool isDirection = i > 0 && i < 4;
            // A third of the squares of the coordinates of directions that go everywhere.
            const double square = isDirection ? met / 3.0 : (moments[i] + 1.0) / (sent + 2.0);
            const double own = std::max(square - mean * mean, 0.5 / sent);
            variance.sum += own;
            variance.most = std::max(variance.most, own);
        }
        return variance;
    }
    /// Squares of what the halves of the rays differ by, of all moments.
    double squareOfDifference() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < moments.size(); ++i)
            sum += std::pow((2.0 * ofFirstHalf[i] - moments[i]) / sent, 2.0);
        return sum;
    }
};

/// What the mean of some rays is off by, as a part of what single ones are: by what the halves of
/// all patches that have sent as many differ by. The halves of one may be equal by chance, and the
/// rays that such a patch did not send would be missed, always on the same side.
class BodyLight::Errors {
  public:
    void add(const Sending& sending) {
        Pool& pool = pools_[sending.sent];
        pool.differences += sending.squareOfDifference();
        pool.variances += sending.variance().sum;
    }
    /// Square of the error of the part of its hemisphere that it sees.
    double squareOf(const Sending& sending) const {
        const auto pool = pools_.find(sending.sent);
        return pool == pools_.end()
                   ? 0.0
                   : pool->second.differences / pool->second.variances * sending.variance().most;
    }

  private:
    struct Pool {
        double differences = 0.0, variances = 0.0;
    };
    std::map<std::uint32_t, Pool> pools_; // by rays sent
};

BodyLight::Rays::Rays(const ExchangeNodes& nodes, std::uint32_t patch)
    : nodes_(nodes), patch_(patch), points_(patch) {}

BodyLight::LightStart BodyLight::Rays::at(std::uint32_t index) const {
    const LightPoint point = points_.at(index);
    LightStart start{nodes_.start(patch_, point[0], point[1], point[2]), {}};
    start.ray = {start.from.at_m, cosineDirection(start.from.normal, point[3], point[4])};
    return start;
}

std::shared_ptr<const TurnedBody> BodyLight::turned() const {
    const std::lock_guard lock(turning_);
    if (!std::exchange(wasAskedForRays_, true))
        return atHand_ ? std::exchange(atHand_, nullptr) : raysByCells();
    if (turned_)
        return turned_;
    std::shared_ptr<TurnedBody> made = raysByCells();
    made->areas_m2.resize(mesh().cells());
    made->normals.resize(mesh().cells());
    parallelForSmall(mesh().cells(), [&](std::uint32_t cell) {
        made->areas_m2[cell] = mesh().area_m2(cell);
        made->normals[cell] = mesh().normal(cell);
    });
    return turned_ = std::move(made);
}

std::shared_ptr<TurnedBody> BodyLight::raysByCells() const {
    auto made = std::make_shared<TurnedBody>();
    made->rays.resize(sent_.size());
    parallelForSmall(sent_.size(), [&](std::uint32_t patch) {
        std::vector<RayStart> starts;
        const Rays rays(*nodes_, patch);
        const std::span<const LightRay> all = raysOf(patch);
        for (std::size_t i = 0; i < all.size(); ++i)
            starts.push_back(i > 0 && all[i].index == all[i - 1].index
                                 ? starts.back()
                                 : RayStart(rays.at(all[i].index)));
        made->rays[patch] = byCells(starts);
    });
    return made;
}

void BodyLight::forgetRays() const {
    const std::lock_guard lock(turning_);
    atHand_ = nullptr;
    wasAskedForRays_ = true;
}

BodyLight::BodyLight(std::shared_ptr<const ExchangeNodes> nodes, const PieceUses& uses,
                     double error)
    : nodes_(std::move(nodes)) {
    std::vector<Sending> sendings(nodes_->nodes());
    // Small nodes need fewer rays each: what a view sums is off by less than any of them.
    const double perSender = static_cast<double>(nodes_->nodes()) /
                             static_cast<double>(std::max<std::size_t>(nodes_->senders(), 1));
    refine(sendings, Uses{uses},
           error * std::max(std::sqrt(perSender),
                            1.0 / std::sqrt(std::sqrt(0.5 * nodes_->fineness()))));
    gather(sendings, uses);
}

void BodyLight::refine(std::vector<Sending>& sendings, const Uses& uses, double error) {
    std::vector<std::uint32_t> active;
    for (std::uint32_t patch = 0; patch < sendings.size(); ++patch)
        if (nodes_->patchArea_m2(patch) > 0.0 && nodes_->seesAnything(patch))
            active.push_back(patch);
    // Spaces inside are left with the first few rays: their light is hardly ever seen.
    std::vector<std::uint32_t> all;
    double area_m2 = 0.0;
    for (const std::uint32_t patch : active)
        if (!nodes_->isInside(patch)) {
            all.push_back(patch);
            area_m2 += nodes_->patchArea_m2(patch);
        }
    const std::vector<std::uint32_t> fewest = fewestOf(active);
    // A node has the mean of the patches near it, whose errors know nothing of each other.
    Errors errors;
    const auto partsOfError_m2 = [&](std::uint32_t patch) {
        double sum_m2 = 0.0;
        for (const ExchangeNodes::Near& near : nodes_->near(patch))
            if (near.area_m2 > 0.0f) // cells may have none
                sum_m2 +=
                    std::pow(static_cast<double>(near.area_m2), 2.0) / nodes_->areaOf_m2(near.node);
        return sum_m2 * errors.squareOf(sendings[patch]);
    };
    for (int round = 1; !active.empty(); ++round) {
        StageCount count("view factors, round " + std::to_string(round), active.size());
        parallelForSmall(active.size(), [&](std::uint32_t i) {
            Sending& sending = sendings[active[i]];
            send(sending, active[i], uses, std::max(fewest[active[i]], 2 * sending.sent));
            count.add();
        });
        errors = {};
        for (const std::uint32_t patch : all)
            errors.add(sendings[patch]);
        double squares_m2 = 0.0;
        allSent_ = 0;
        for (const std::uint32_t patch : all) {
            squares_m2 += partsOfError_m2(patch);
            allSent_ += sendings[patch].sent;
        }
        error_ = area_m2 > 0.0 ? std::sqrt(squares_m2 / area_m2) : 0.0;
        if (error_ <= error)
            return;
        std::erase_if(active, [&](std::uint32_t patch) {
            return sendings[patch].sent >= mostRays || nodes_->isInside(patch) ||
                   partsOfError_m2(patch) <= error * error * nodes_->patchArea_m2(patch);
        });
        // Where there is no room for all, those come first that matter most.
        std::ranges::stable_sort(active, std::greater<>(), partsOfError_m2);
        std::size_t next = allSent_;
        std::erase_if(active, [&](std::uint32_t patch) {
            const bool fits = next + sendings[patch].sent <= mostSent;
            next += fits ? sendings[patch].sent : 0;
            return !fits;
        });
        isLimited_ = active.empty();
    }
}

/// Where patches are few each sends more. Small pieces are seldom met by the rays of others, and
/// may be the hottest: their own rays have to tell.
std::vector<std::uint32_t> BodyLight::fewestOf(const std::vector<std::uint32_t>& active) const {
    constexpr double smallPiece = 0.01; // of all that sees anything
    constexpr std::size_t raysOfFew = 500'000, mostOfFew = 1024;
    // So many cost little beside all others: a few small ones may send more of them.
    constexpr std::size_t raysOfFewSmall = 16'384;
    std::vector<double> ofPiece_m2(mesh().rays().pieces());
    double all_m2 = 0.0;
    for (const std::uint32_t patch : active) {
        ofPiece_m2[static_cast<std::size_t>(nodes_->pieceOf(patch))] += nodes_->patchArea_m2(patch);
        all_m2 += nodes_->patchArea_m2(patch);
    }
    const auto isSmall = [&](std::uint32_t patch) {
        return !nodes_->isInside(patch) &&
               ofPiece_m2[static_cast<std::size_t>(nodes_->pieceOf(patch))] < smallPiece * all_m2;
    };
    const auto small = static_cast<std::size_t>(std::ranges::count_if(active, isSmall));
    const auto shareOf = [&](std::size_t rays, std::size_t patches, std::size_t most) {
        return static_cast<std::uint32_t>(std::bit_floor(
            std::clamp<std::size_t>(rays / std::max<std::size_t>(patches, 1), fewestRays, most)));
    };
    std::vector<std::uint32_t> fewest(nodes_->nodes(),
                                      shareOf(raysOfFew, active.size(), mostOfFew));
    for (const std::uint32_t patch : active)
        if (nodes_->isInside(patch))
            fewest[patch] = fewestInside;
        else if (isSmall(patch))
            fewest[patch] = std::max({fewest[patch], shareOf(raysOfFew, small, mostOfFew),
                                      shareOf(raysOfFewSmall, small, raysOfFewSmall)});
    return fewest;
}

void BodyLight::send(Sending& sending, std::uint32_t patch, const Uses& uses,
                     std::uint32_t wanted) const {
    const Rays rays(*nodes_, patch);
    const PieceUse& use = uses.own[static_cast<std::size_t>(nodes_->pieceOf(patch))];
    const bool isGas = use.transparent && use.pane == 0;
    RayHit hit;
    std::vector<RayHit> through;
    sending.weights.resize(nodes_->near(patch).size());
    const auto sendUpTo = [&](std::uint32_t end) {
        for (; sending.sent < end; ++sending.sent) {
            const LightStart start = rays.at(sending.sent);
            for (const ExchangeNodes::Share& own :
                 ExchangeNodes::OfPlace(*nodes_, start.from.place))
                sending.weights[nodes_->placeNear(patch, own.node)] +=
                    static_cast<double>(own.part);
            bool isMet = mesh().rays().meet(start.ray, uses.withBacks, 0.0, hit, through);
            double back_m = std::numeric_limits<double>::infinity();
            if (isMet && uses.own.isCulled(hit)) {
                // A wall of two facets, one for each side, has no back to go out through.
                back_m = hit.distance_m + mesh().lift_m();
                isMet = mesh().rays().meet(start.ray, uses.own, 0.0, hit, through);
            }
            const auto index = static_cast<std::uint16_t>(sending.sent);
            const std::size_t before = sending.hits.size();
            const auto add = [&](const RayHit& one) {
                const ExchangeMesh::Place place = mesh().placeOf(one);
                if (place.cell == ExchangeMesh::none)
                    return false;
                if (sending.hits.size() == before) {
                    sending.moments[0] += 1.0;
                    sending.moments[1] += start.ray.direction.x;
                    sending.moments[2] += start.ray.direction.y;
                    sending.moments[3] += start.ray.direction.z;
                    for (std::size_t i = 0; i < Sending::halves; ++i)
                        sending.moments[4 + i] += (one.piece >> i) % 2;
                }
                sending.hits.push_back({index, isGas || one.distance_m > back_m, 0,
                                        static_cast<float>(one.distance_m), place});
                sending.starts.emplace_back(start);
                return true;
            };
            sortPassed(uses.own, through);
            for (const RayHit& passed : through)
                add(passed);
            if (!(isMet && add(hit)) && sending.hits.size() > before) {
                sending.hits.push_back(
                    {index, false, 0, std::numeric_limits<float>::infinity(), {}});
                sending.starts.emplace_back(start);
            }
        }
    };
    sendUpTo(wanted / 2);
    sending.ofFirstHalf = sending.moments;
    sendUpTo(wanted);
}

void BodyLight::sortPassed(const PieceUses& uses, std::vector<RayHit>& through) {
    std::erase_if(through, [&](const RayHit& one) {
        return uses[static_cast<std::size_t>(one.piece)].pane == 0;
    });
    if (through.empty())
        return;
    std::ranges::sort(through, [](const RayHit& a, const RayHit& b) {
        return std::tie(a.distance_m, a.piece, a.facet) < std::tie(b.distance_m, b.piece, b.facet);
    });
    through.resize(std::min(through.size(), mostPassed));
}

void BodyLight::numberPassages(Sending& sending, const PieceUses& uses) {
    if (!uses.areAnyPanes())
        return;
    std::vector<LightRay>& hits = sending.hits;
    std::size_t kept = 0;
    int passed = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        LightRay ray = hits[i];
        const bool isFirst = kept == 0 || hits[kept - 1].index != ray.index;
        passed = isFirst ? 0 : passed;
        ray.passage = static_cast<std::uint8_t>(passed);
        if (ray.meetsAnything()) {
            const PieceUse& use = uses[mesh().pieceOf(ray.place.cell)];
            if (use.pane > 0) {
                const int behind = passages_.behind(passed, {0, use.pane - 1});
                if (behind > static_cast<int>(mostPassages))
                    continue;
                passed = behind;
            }
        } else if (isFirst) {
            continue;
        }
        sending.starts[kept] = sending.starts[i];
        hits[kept++] = ray;
    }
    hits.resize(kept);
    sending.starts.erase(sending.starts.begin() + static_cast<std::ptrdiff_t>(kept),
                         sending.starts.end());
}

void BodyLight::gather(std::vector<Sending>& sendings, const PieceUses& uses) {
    // The surface that a receiver's numbers come from: nodes that no ray has begun near are not
    // known there.
    std::vector<double> known_m2(nodes_->nodes(), 0.0);
    raysFrom_.assign(nodes_->nodes(), 0.0);
    for (std::uint32_t patch = 0; patch < sendings.size(); ++patch) {
        const auto near = nodes_->near(patch);
        for (std::size_t i = 0; i < near.size(); ++i) {
            const std::uint32_t receiver = near[i].node;
            if (sendings[patch].sent == 0 || sendings[patch].weights[i] > 0.0)
                known_m2[receiver] += static_cast<double>(near[i].area_m2);
            if (sendings[patch].sent > 0)
                raysFrom_[receiver] += sendings[patch].weights[i];
        }
    }
    first_.push_back(0);
    firstScale_.push_back(0);
    std::size_t hits = 0;
    for (const Sending& sending : sendings)
        hits += sending.hits.size();
    rays_.reserve(hits);
    for (std::uint32_t patch = 0; patch < sendings.size(); ++patch) {
        Sending& sending = sendings[patch];
        numberPassages(sending, uses);
        sent_.push_back(sending.sent);
        rays_.insert(rays_.end(), sending.hits.begin(), sending.hits.end());
        sending.hits = {};
        first_.push_back(rays_.size());
        const auto near = nodes_->near(patch);
        for (std::size_t i = 0; i < near.size() && sending.sent > 0; ++i) {
            const double whole_m2 = sending.weights[i] * known_m2[near[i].node];
            scales_.push_back(whole_m2 > 0.0 ? near[i].area_m2 / static_cast<float>(whole_m2)
                                             : 0.0f);
        }
        firstScale_.push_back(scales_.size());
    }
    using Lists = std::vector<std::vector<LightPart>>; // by patch
    const std::size_t passages = std::min(passages_.size(), mostPassages + 1);
    std::vector<Lists> parts(passages, Lists(sendings.size())), oneWay = parts;
    auto atHand = std::make_shared<TurnedBody>();
    atHand->rays.resize(sendings.size());
    StageCount count("balance", sendings.size());
    parallelForSmall(sendings.size(), [&](std::uint32_t patch) {
        count.add();
        const std::vector<RayStart> starts = std::move(sendings[patch].starts);
        const std::span<const LightRay> rays = raysOf(patch);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const LightRay& ray = rays[i];
            if (!ray.meetsAnything())
                continue;
            const auto senders = ExchangeNodes::OfPlace(*nodes_, ray.place).ofSenders(*nodes_);
            for (const ExchangeNodes::Share& own :
                 ExchangeNodes::OfPlace(*nodes_, starts[i].place)) {
                const float scale = own.part * scalesOf(patch)[nodes_->placeNear(patch, own.node)];
                for (const ExchangeNodes::Share& sender : senders)
                    (ray.isOneWay ? oneWay : parts)[ray.passage][patch].push_back(
                        {own.node, sender.node, scale * sender.part});
            }
        }
        for (std::size_t passage = 0; passage < passages; ++passage) {
            mergeParts(parts[passage][patch]);
            mergeParts(oneWay[passage][patch]);
        }
        atHand->rays[patch] = byCells(starts);
    });
    atHand_ = std::move(atHand);
    std::vector<ReceiverRays> receivers;
    for (std::uint32_t r = 0; r < nodes_->nodes(); ++r)
        receivers.push_back({nodes_->areaOf_m2(r), raysFrom_[r]});
    for (std::size_t passage = 0; passage < passages; ++passage)
        balances_.push_back(
            balancedOfSenders(LightPairs(nodes_->nodes(), std::move(parts[passage])),
                              LightPairs(nodes_->nodes(), std::move(oneWay[passage])), receivers,
                              nodes_->senderOfAll(), nodes_->senders()));
}

} // namespace irsg
