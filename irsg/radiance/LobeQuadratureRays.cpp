#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "irsg/radiance/LobeQuadratureLayers.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

/// The places of a grid about a direction in eye space, and their parts.
std::array<std::pair<std::size_t, double>, 4>
LobeQuadrature::placesAbout(const Tile& own, const SpecularEnvironmentGrid& grid,
                            const Vec3& direction) {
    const double up = std::clamp(product(direction, own.zenith), -1.0, 1.0);
    double fromSun = 0.0;
    if (grid.isByAzimuth()) {
        const Vec3 flat = direction - own.zenith * up;
        const double size = plainLength(flat);
        if (size > 1e-9)
            fromSun = std::acos(std::clamp(product(flat, own.towards) / size, -1.0, 1.0));
    }
    return grid.about(std::asin(up), fromSun);
}

/// Sends rays along the lobes of a layer.
class LobeQuadrature::Following {
  public:
    /// `from`: of the layer; none where nothing stands in any way.
    Following(const LobeQuadrature& lobes, const Tile& tile, const DirectionalLayer& layer,
              const std::optional<SunShadows::Place>& from, OccluderStacks& sets,
              Mirrored& mirrored)
        : tile_(tile),
          layer_(layer),
          from_(from),
          mirrored_(mirrored),
          paths_(sets),
          making_{&lobes.rows_,
                  &lobes.making_.models,
                  &lobes.making_.mirrors,
                  tile.exchange,
                  tile.open ? &*tile.open : nullptr,
                  tile.sun,
                  lobes.making_.isSunSmart},
          aims_(roomForAims()) {
        aims_.clear();
    }

    /// Samples turn facets differently, so that few rays of each do for all (Roberts' sequence, in
    /// two dimensions for those that are aimed and in three for facets).
    double turned(double step) const {
        const double at = step * static_cast<double>(layer_.sample % 65536u);
        return from_ ? at - std::floor(at) : 0.0;
    }
    /// Those of one in `step` of the facets, and those that are aimed.
    void sendAll(std::size_t step);
    /// What was sent, of components.
    const SurfaceModel::Amounts& followed() const { return followed_; }

  private:
    /// A cone about a sphere of LobeAims, eye space.
    struct Aim {
        Vec3 axis;
        double cosine = 1.0, density_per_sr = 0.0;
        std::size_t number = 0;
    };
    static std::vector<Aim>& roomForAims() {
        thread_local std::vector<Aim> room;
        return room;
    }
    void findAims(std::size_t facets);
    /// `ray`: of those that are sent there.
    void sendTo(const Aim& aim, int ray, double facets);
    /// Of a ray that a facet reflects, how much counts beside those that are aimed likewise.
    double shareOf(const SurfaceDirection& facet, const Vec3& direction, double facets) const;
    /// Per solid angle, of directions that facets reflect.
    double density_per_sr(const SurfaceDirection& facet) const {
        return layer_.model.facetDensity_per_sr(facet) / (4.0 * dot(layer_.to, facet));
    }
    void send(const Vec3& direction, const SurfaceModel::Amounts& weights, double turn);

    const Tile& tile_;
    const DirectionalLayer& layer_;
    const std::optional<SunShadows::Place>& from_;
    Mirrored& mirrored_;
    LobePaths paths_;
    LobePaths::Making making_;
    SurfaceModel::Amounts followed_{};
    std::vector<Aim>& aims_;
};

void LobeQuadrature::Following::findAims(std::size_t facets) {
    const GeometrySamples::Place* const at = layer_.layer.place;
    if (tile_.aims == nullptr || !from_ || layer_.model.facets().size() == 1 || at == nullptr ||
        at->cell == GeometrySamples::Place::none)
        return;
    // Nearer ones, and what a lobe meets often, facets find.
    constexpr double nearest = 1.5, often = 16.0, least = 1e-7;
    LobeAims::Set left = tile_.aims->seenFrom(*tile_.exchange, at->cell);
    for (; left != 0; left &= left - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(left));
        const double radius_m = tile_.aims->spheres()[i].radius_m;
        const Vec3 way_m = tile_.aimsAt_m[i] - from_->start_m;
        const double distance_m = plainLength(way_m);
        if (!(distance_m > nearest * radius_m))
            continue;
        const double sine = radius_m / distance_m;
        Aim aim{tile_.open->inEye(way_m * (1.0 / distance_m)), std::sqrt(1.0 - sine * sine), 0.0,
                i};
        const SurfaceDirection axis = layer_.axes.of(aim.axis);
        if (!(axis.z > -sine))
            continue;
        aim.density_per_sr = 1.0 / (2.0 * pi * (1.0 - aim.cosine));
        const double part = density_per_sr(halfway(layer_.to, axis)) / aim.density_per_sr;
        aim.density_per_sr *= layer_.raysOfAim;
        if (part > least && part * static_cast<double>(facets) < often)
            aims_.push_back(aim);
    }
}

double LobeQuadrature::Following::shareOf(const SurfaceDirection& facet, const Vec3& direction,
                                          double facets) const {
    double aimed_per_sr = 0.0;
    for (const Aim& aim : aims_)
        if (product(aim.axis, direction) > aim.cosine)
            aimed_per_sr += aim.density_per_sr;
    if (aimed_per_sr == 0.0)
        return 1.0;
    const double own_per_sr = facets * density_per_sr(facet);
    return own_per_sr / (own_per_sr + aimed_per_sr);
}

void LobeQuadrature::Following::send(const Vec3& direction, const SurfaceModel::Amounts& weights,
                                     double turn) {
    const std::size_t lobes = layer_.lobes(), places = layer_.grid.places().size();
    LobePaths::Found& found = mirrored_.found;
    thread_local LobePaths::Ray ray;
    ray.direction = direction;
    ray.met = SunShadows::Met::nothing;
    ray.panes.clear();
    if (from_)
        ray.met = tile_.open->met(*from_, ray.direction, ray.end, ray.panes);
    if (mirrored_.isBesideTable) {
        if (ray.met == SunShadows::Met::nothing && ray.panes.empty())
            return;
        for (const auto& [place, part] : placesAbout(tile_, layer_.grid, direction))
            LobePaths::add(mirrored_.atmosphere, 0, static_cast<std::uint32_t>(place), weights,
                           -part);
    }
    for (std::size_t k = 0; k < lobes; ++k)
        followed_[k] += weights[k];
    if (LobePaths::goesOn(making_, ray, layer_.layer.row)) {
        paths_.follow(
            making_, ray, layer_.layer.row, weights, turn - std::floor(turn),
            [&](const Vec3& towards, const auto& visit) {
                if (places == 0)
                    return;
                for (const auto& [place, part] : placesAbout(tile_, layer_.grid, towards))
                    visit(place, part);
            },
            found);
        return;
    }
    for (std::size_t k = 0; k < lobes && ray.met == SunShadows::Met::other; ++k)
        found.elsewhere[k] += weights[k];
    const GeometrySamples::Place& at = ray.end.at;
    if (ray.met == SunShadows::Met::surface)
        tile_.exchange->forEachReflected(
            at.cell, at.u, at.v, [&](std::uint32_t number, float part) {
                LobePaths::add(found.surfaces, 0, number, weights, static_cast<double>(part));
            });
    if (ray.met == SunShadows::Met::nothing && places > 0)
        for (const auto& [place, part] : placesAbout(tile_, layer_.grid, ray.direction))
            LobePaths::add(mirrored_.atmosphere, 0, static_cast<std::uint32_t>(place), weights,
                           part);
}

void LobeQuadrature::Following::sendTo(const Aim& aim, int ray, double facets) {
    const auto partOf = [&](double step, double begin) {
        const double at = turned(step) + begin * static_cast<double>(aim.number) +
                          static_cast<double>(ray) / layer_.raysOfAim;
        return at - std::floor(at);
    };
    const double cosine = 1.0 - partOf(0.7548776662466927, 0.6180339887498949) * (1.0 - aim.cosine);
    const double around = 2.0 * pi * partOf(0.5698402909980532, 0.4142135623730950);
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    const SurfaceAxes cone(aim.axis, layer_.along);
    const Vec3 direction = cone.to({sine * std::cos(around), sine * std::sin(around), cosine});
    const SurfaceDirection from = layer_.axes.of(direction);
    if (!(from.z > 0.0))
        return;
    const SurfaceDirection facet = halfway(layer_.to, from);
    SurfaceModel::Amounts sent = layer_.model.facetWeights(layer_.to, facet);
    if (std::ranges::all_of(sent, [](double weight) { return weight == 0.0; }))
        return;
    const double share = shareOf(facet, direction, facets);
    for (double& weight : sent)
        weight *= share;
    send(direction, sent, cosine + around);
}

void LobeQuadrature::Following::sendAll(std::size_t step) {
    const double share = from_ ? turned(0.8191725133961645) : 0.5;
    const double turn = turned(0.6710436067037893);
    const std::size_t facets = layer_.model.facets().size();
    const auto followed = static_cast<double>(facets) / static_cast<double>(step);
    findAims(facets / step);
    for (std::size_t i =
             static_cast<std::size_t>(turned(0.5497004779019703) * static_cast<double>(step));
         i < facets; i += step) {
        const SurfaceDirection facet = layer_.model.facet(i, share, turn);
        SurfaceModel::Amounts sent = layer_.model.facetWeights(layer_.to, facet);
        if (std::ranges::all_of(sent, [](double weight) { return weight == 0.0; }))
            continue;
        const Vec3 direction = layer_.axes.to(irsg::mirrored(layer_.to, facet));
        const double counts = shareOf(facet, direction, followed);
        for (double& weight : sent)
            weight *= counts;
        send(direction, sent, share + 0.7548776662466927 * static_cast<double>(i + 1));
    }
    for (const Aim& aim : aims_)
        for (int ray = 0; ray < layer_.raysOfAim; ++ray)
            sendTo(aim, ray, followed);
}

void LobeQuadrature::follow(const Tile& own, const DirectionalLayer& layer,
                            SunShadows::Neighbours& neighbours, int column, OccluderStacks& sets,
                            Mirrored& mirrored) const {
    const std::size_t places = layer.grid.places().size(), lobes = layer.lobes();
    mirrored.clear();
    const SurfaceDirection mirror{-layer.to.x, -layer.to.y, layer.to.z};
    std::optional<SunShadows::Place> from;
    if (own.open) {
        from = own.open->placeOf(layer.along, layer.layer.row,
                                 static_cast<double>(layer.layer.distance_m), column, neighbours);
        const GeometrySamples::Place* const at = layer.layer.place;
        const bool isKnown = at != nullptr && at->cell != GeometrySamples::Place::none;
        const std::array<float, 3> open =
            isKnown ? own.exchange->openAt(at->cell) : std::array<float, 3>{1.0f, 1.0f, 1.0f};
        constexpr float rounding = 1e-6f;
        mirrored.isOpen = *std::ranges::min_element(open) > 1.0f - rounding &&
                          own.open->isOpen(*from, layer.axes.to(mirror));
        constexpr float mostlyOpen = 1.5f;
        mirrored.isBesideTable = !mirrored.isOpen && places > 0 &&
                                 open[0] + open[1] + open[2] > mostlyOpen &&
                                 LobeQuadratureTable::serves(layer.model);
    } else {
        mirrored.isOpen = true;
    }
    // Where nothing is known of the atmosphere by direction, it counts on the whole; where surfaces
    // are followed, there is none.
    if (mirrored.isOpen && places == 0) {
        mirrored.isOpen = false;
        mirrored.found.elsewhere.fill(own.open ? 0.0 : 1.0);
        return;
    }
    if (mirrored.isOpen && layer.model.facets().size() > 1 &&
        LobeQuadratureTable::serves(layer.model))
        return;

    const bool isFree = mirrored.isOpen;
    mirrored.isOpen = false;
    if (isFree)
        from.reset();
    Following rays(*this, own, layer, from, sets, mirrored);
    const std::size_t facets = layer.model.facets().size();
    const std::size_t step = isFree ? 1 : std::clamp<std::size_t>(layer.step, 1, facets);
    rays.sendAll(step);
    const SurfaceModel::Amounts& followed = rays.followed();
    LobePaths::Found& found = mirrored.found;
    found.join();
    LobePaths::join(mirrored.atmosphere);
    const std::array all{&mirrored.atmosphere, &found.surfaces, &found.atmosphere};
    for (std::size_t k = 0; k < lobes; ++k) {
        // What all facets send: followed ones, or the mean over samples, each of which stands for
        // `step` facets of it.
        const double sent = step == 1 && !mirrored.isBesideTable
                                ? followed[k]
                                : layer.model.sent(k, layer.to.z) * static_cast<double>(facets);
        if (sent == 0.0) { // no facet that stands for others faces the eye
            found.elsewhere[k] = 1.0;
            for (std::vector<LobePaths::Part>* parts : all)
                for (LobePaths::Part& one : *parts)
                    one.weights[k] = 0.0;
            continue;
        }
        // What these are more or less than all sees the mean, so that energy closes; over samples
        // that adds up to nothing.
        const double scale = static_cast<double>(step) / sent;
        found.elsewhere[k] =
            scale * found.elsewhere[k] + (mirrored.isBesideTable ? 0.0 : 1.0 - scale * followed[k]);
        for (std::vector<LobePaths::Part>* parts : all)
            for (LobePaths::Part& one : *parts)
                one.weights[k] *= scale;
    }
}

} // namespace irsg
