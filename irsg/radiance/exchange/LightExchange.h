#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "irsg/geometry/view/Pose.h"
#include "irsg/radiance/exchange/BodyLight.h"
#include "irsg/radiance/exchange/LightThrough.h"
#include "irsg/radiance/exchange/LightThroughGas.h"
#include "irsg/radiometry/Spectrum.h"
#include "irsg/render/rays/SunShadows.h"

namespace irsg {

/// How light of sky, ground and sun falls on the surfaces of a scene: weights as the factors of
/// RadianceTerms have them.
struct LightSources {
    Vec3 towardsSun; ///< unit, world
    /// How much of sky a surface of a cosine to the zenith sees where nothing is in the way.
    double (*skyOf)(double cosine) = nullptr;
    bool isSkyOn = true, isSunOn = true, isSunShadowed = true;
    double sunAlways = -1.0; ///< factor of the sun whatever the surface, where not negative
    /// Of level ground at altitude 0, where bodies near it shade it and are seen in it; none: they
    /// are not.
    std::optional<Spectrum> groundReflectivity;
};

/// The surfaces of a scene and what they see of each other, of sky, ground and sun, as numbers
/// that know no wavelength. Receivers of all entities follow each other.
class LightExchange {
  public:
    /// How much others may see of a body.
    struct Extent {
        Vec3 centre_m; ///< of a sphere around it, in the world
        double radius_m = 0.0;
        double crossSection_m2 = 0.0; ///< from any side at most
        /// What it emits, as a mean over its area: by output, in any unit that all bodies share.
        std::vector<double> emits;
    };
    struct Body {
        int entity = 0;
        std::shared_ptr<const BodyLight> light;
        Extent extent;
    };
    /// Gas of a body, whose walls a ray passes.
    struct Gas {
        std::size_t body = 0;
        PieceUses walls{0};             ///< its pieces alone, all of them transparent
        std::vector<double> volumes_m3; ///< by piece; that of the smallest counts
        std::vector<IrCodes> codes;     ///< by piece
        Extent extent;                  ///< emits as a black body does
    };
    /// A gas that sends: its drawn row, and its name in columns.
    struct GasSender {
        int entity = 0, row = 0;
        IrCodes codes;
        bool operator==(const GasSender&) const = default;
    };
    /// What a receiver loses of sky and ground to what stands before it.
    using Loss = OutsideLight;

    /// `casters`: as SunShadows has them, of the bodies in their order, and of the terrain behind
    /// them. `error`: of view factors; what is farther away than that is seen is left out.
    /// `hasLobes`: surfaces reflect others along lobes, so that all senders may be seen.
    /// `components`: of directional surfaces, by drawn row: how many lobes and others each has,
    /// where lobes are followed from mirror to mirror; else none.
    LightExchange(std::vector<Body> bodies, const std::vector<SunShadows::Caster>& casters,
                  const LightSources& sources, double error, bool hasLobes = false,
                  const std::vector<std::size_t>& components = {},
                  const std::vector<Gas>& gases = {});
    /// Of bodies that neither light, shade nor hide each other: `ofBodies` has each alone, with the
    /// drawn rows of the scene and no components.
    LightExchange(std::vector<std::shared_ptr<const LightExchange>> ofBodies,
                  const std::vector<SunShadows::Caster>& casters, bool hasLobes = false,
                  const std::vector<std::size_t>& components = {});

    /// That of each body, where it was made of these; else none.
    const std::vector<std::shared_ptr<const LightExchange>>& alone() const { return alone_; }
    std::size_t firstReceiver(std::size_t body) const { return firstReceiver_[body]; }
    std::size_t firstSender(std::size_t body) const { return firstSender_[body]; }
    /// Of receivers, by sender.
    const LightPairs& pairs() const { return *balance_.pairs; }
    /// Of senders, by sender.
    const LightPairs& between() const { return *balance_.between; }
    /// The same through sets of transparent materials, in any order; none without such surfaces.
    const std::vector<LightThrough>& through() const { return through_; }
    /// Those materials: their entities and indices.
    const std::vector<OccluderMaterial>& panes() const { return panes_; }
    const std::optional<Spectrum>& groundReflectivity() const { return groundReflectivity_; }
    /// What gas changes of all that; none without gas. Its columns are among panes(), and what they
    /// emit comes from senders behind all others.
    const std::vector<LightThroughGas>& throughGas() const { return throughGas_; }
    std::size_t firstGasPane() const { return firstGasPane_; }
    const std::vector<GasSender>& gasSenders() const { return gasSenders_; }
    std::size_t sendersWithGas() const { return senders() + gasSenders_.size(); }
    /// Whether no body gets anything of another.
    bool areApart() const { return areApart_; }
    std::size_t receivers() const { return rows_.size(); }
    /// Whether a receiver gets light of others, or less of outside for them.
    bool getsLight(std::size_t receiver) const { return getsLight_[receiver]; }
    std::size_t senders() const { return rowOfSender_.size(); }
    int rowOfSender(std::size_t sender) const { return rowOfSender_[sender]; }
    /// The body of a receiver.
    std::size_t bodyOf(std::size_t receiver) const { return bodyAt(firstReceiver_, receiver); }
    std::size_t bodyOfSender(std::size_t sender) const { return bodyAt(firstSender_, sender); }
    std::size_t bodyOfRow(int row) const { return bodyOf(ofRow(row).front()); }
    /// The drawn row of a receiver, and its number among those of the row.
    int rowOf(std::size_t receiver) const { return rows_[receiver]; }
    std::uint32_t localOf(std::size_t receiver) const { return local_[receiver]; }
    /// The number of a receiver among senders.
    std::uint32_t senderOf(std::size_t receiver) const { return senderOf_[receiver]; }
    /// The drawn row of a cell of a mesh.
    int rowOfCell(std::uint32_t cell) const {
        const std::size_t body = bodyOfCell(cell);
        const ExchangeNodes& nodes = bodies_[body].light->nodes();
        const std::uint32_t corner = nodes.mesh().corners(cell - firstCell_[body])[0];
        return rows_[firstReceiver_[body] + nodes.sharesOf(corner).front().node];
    }
    const std::vector<std::uint32_t>& ofRow(int row) const {
        return ofRow_[static_cast<std::size_t>(row)];
    }
    std::size_t rows() const { return ofRow_.size(); }
    /// Whether any receiver of the row gets light of others.
    bool seesAnything(int row) const { return sees_[static_cast<std::size_t>(row)]; }
    /// Nothing stands before any of them.
    bool changesNothing() const {
        return std::ranges::none_of(sees_, [](bool sees) { return sees; });
    }

    const Loss& loss(std::size_t receiver) const { return losses_[receiver]; }
    /// Sky, ground and sun that falls on a sender, as factors.
    double sky(std::size_t sender) const { return sky_[sender]; }
    double ground(std::size_t sender) const { return ground_[sender]; }
    double sun(std::size_t sender) const { return sun_[sender]; }
    /// What a receiver gets of the sun on others beside the means over senders, by their drawn row
    /// in place of a sender: shadows have edges, and rays meet places. What passes `through()[i]`
    /// has the numbers from (i + 1) * rows() on.
    const LightPairs& sunBesideMean() const { return sunBesideMean_; }
    /// Adds to what receivers have, `width` numbers by receiver, what two means took of it: that of
    /// the places that a node has a part of, and that of the nodes that a place has a part of.
    /// Steps of Landweber's between those that get light; sums over surfaces stay.
    void sharpen(std::vector<float>& values, std::size_t width) const;
    /// Some of the columns that numbers by sender or receiver have.
    struct Columns {
        std::size_t first = 0, count = 0;
    };
    /// The same for senders, of what they reflect, so that means over what is sent are `values`, in
    /// more steps: what is left out here is missing at each reflection. Of those that reflect
    /// anything, and the columns that bodies have.
    void sharpenSent(std::vector<float>& values, std::size_t width,
                     std::span<const Columns> ofBodies) const {
        sharpenSent(values, width, ofBodies, reflects_);
    }
    /// Whether anybody sees it.
    bool isSeen(std::size_t sender) const { return isSeen_[sender]; }
    /// Whether somebody sees it to whom it reflects what comes from others.
    bool reflects(std::size_t sender) const { return reflects_[sender]; }
    /// Part of the hemisphere of a receiver in which others stand.
    double seen(std::size_t receiver) const { return pairs().sumOf(receiver); }

    /// What lobes reflect of a place is what leaves the senders there. These have numbers behind
    /// those of receivers, and behind them one for each drawn row: the sun on it at a radiance of
    /// 1, then the same of the sun through each of through(). Where mirrors are followed, behind
    /// these stands what falls on a place, for the lobes of a mirror there: what senders receive,
    /// then the sun in the air of each body, and through each of through(), then the emission that
    /// each component takes away. Where there is gas, the last are by sender: what gas
    /// changes of what these receive. None without lobes. Cells that stand for them are named as
    /// places of samples are.
    const std::vector<std::uint32_t>& reflected() const { return reflected_; }
    bool areMirrorsFollowed() const { return components_ > 0; }
    std::size_t firstReceived() const { return senders() + (1 + through_.size()) * rows(); }
    std::size_t firstSunOnBodies() const { return firstReceived() + senders(); }
    std::size_t firstComponents() const {
        return firstSunOnBodies() + (1 + through_.size()) * bodies_.size();
    }
    std::size_t firstGasChanges() const {
        return areMirrorsFollowed() ? firstComponents() + components_ : firstReceived();
    }
    /// Number among components of the first one of a drawn row; -1 for a Lambertian one.
    int firstComponentOf(int row) const {
        const auto number = static_cast<std::size_t>(row);
        return number < firstComponentOf_.size() ? firstComponentOf_[number] : -1;
    }
    std::uint32_t cellOfReflected(std::size_t number) const {
        return cells_ + static_cast<std::uint32_t>(number);
    }
    /// Calls visit(number of a reflected one, weight) for what leaves a place.
    template <typename Visit>
    void forEachReflected(std::uint32_t cell, float u, float v, Visit visit) const {
        float beside = sunOnCells_.empty() ? 0.0f : sunOnCells_[cell];
        std::size_t row = 0;
        forEachReceiver(cell, u, v, [&](std::uint32_t receiver, float part) {
            const std::uint32_t sender = senderOf_[receiver];
            visit(sender, part);
            beside -= part * static_cast<float>(sun_[sender]);
            row = static_cast<std::size_t>(rowOfSender_[sender]);
        });
        if (beside != 0.0f && !sunOnCells_.empty())
            visit(static_cast<std::uint32_t>(senders() + row), beside);
        for (std::size_t i = 0; i < through_.size(); ++i) {
            const LightThrough& one = through_[i];
            if (one.sunOnCells.empty())
                continue;
            float more = one.sunOnCells[cell];
            forEachReceiver(cell, u, v, [&](std::uint32_t receiver, float part) {
                more -= part * static_cast<float>(one.sun[senderOf_[receiver]]);
            });
            if (more != 0.0f)
                visit(static_cast<std::uint32_t>(senders() + (i + 1) * rows() + row), more);
        }
    }

    /// Calls visit(number of a reflected one, weight) for what falls on a place, without the sun.
    template <typename Visit>
    void forEachReceived(std::uint32_t cell, float u, float v, Visit visit) const {
        forEachReceiver(cell, u, v, [&](std::uint32_t receiver, float part) {
            visit(static_cast<std::uint32_t>(firstReceived()) + senderOf_[receiver], part);
        });
    }
    /// The same of what gas changes of that.
    template <typename Visit>
    void forEachGasChange(std::uint32_t cell, float u, float v, Visit visit) const {
        if (!throughGas_.empty())
            forEachReceiver(cell, u, v, [&](std::uint32_t receiver, float part) {
                visit(static_cast<std::uint32_t>(firstGasChanges()) + senderOf_[receiver], part);
            });
    }
    /// The same of the sun.
    template <typename Visit>
    void forEachSun(std::uint32_t cell, float u, float v, Visit visit) const {
        float sun = 0.0f;
        forEachReceiver(cell, u, v, [&](std::uint32_t receiver, float part) {
            sun += part * static_cast<float>(sun_[senderOf_[receiver]]);
        });
        const std::size_t body = bodyOfCell(cell);
        for (std::size_t i = 0; i <= through_.size(); ++i) {
            const std::vector<float>& onCells = i == 0 ? sunOnCells_ : through_[i - 1].sunOnCells;
            const float here = !onCells.empty() ? onCells[cell] : i == 0 ? sun : 0.0f;
            if (here != 0.0f)
                visit(static_cast<std::uint32_t>(firstSunOnBodies() + i * bodies_.size() + body),
                      here);
        }
    }

    /// Cells of a body's mesh begin at this number.
    std::uint32_t firstCell(std::size_t body) const { return firstCell_[body]; }
    const std::vector<Body>& bodies() const { return bodies_; }
    /// Calls visit(receiver, part) for the receivers of a place as samples name it: the cell
    /// and the weights of its second and third corner. Parts add up to 1; a receiver may come more
    /// than once.
    template <typename Visit>
    void forEachReceiver(std::uint32_t cell, float u, float v, Visit visit) const {
        const std::array<float, 3> parts{1.0f - u - v, u, v};
        forEachReceiver(cell, [&](std::uint32_t receiver, std::size_t corner, float part) {
            visit(receiver, parts[corner] * part);
        });
    }
    /// Calls visit(receiver, corner, part) for those of its corners, whose parts add up to 1 each.
    template <typename Visit>
    void forEachReceiver(std::uint32_t cell, Visit visit) const {
        if (cell >= cells_) {
            for (std::size_t c = 0; c < 3; ++c)
                visit(reflected_[cell - cells_], c, 1.0f);
            return;
        }
        const std::size_t body = bodyOfCell(cell);
        const ExchangeNodes& nodes = bodies_[body].light->nodes();
        const std::array<std::uint32_t, 3>& corners = nodes.mesh().corners(cell - firstCell_[body]);
        for (std::size_t c = 0; c < 3; ++c)
            for (const ExchangeNodes::Share& share : nodes.sharesOf(corners[c]))
                visit(firstReceiver_[body] + share.node, c, share.part);
    }
    /// Parts of the hemispheres over the corners of a place in which nothing stands.
    std::array<float, 3> openAt(std::uint32_t cell) const {
        const std::size_t body = bodyOfCell(cell), first = firstVertex_[body];
        const std::array<std::uint32_t, 3>& corners =
            bodies_[body].light->nodes().mesh().corners(cell - firstCell_[body]);
        return {openOfVertex_[first + corners[0]], openOfVertex_[first + corners[1]],
                openOfVertex_[first + corners[2]]};
    }

    /// Whether another body is so near, so large or so much brighter that what it sends counts.
    static bool isNear(const Extent& body, const Extent& other, double error);
    /// Whether the ground below a body is so near and bright that what the body takes of its light
    /// counts.
    static bool isNearGround(const Extent& body, double error, const Spectrum& reflectivity);
    /// Whether one may stand in the light of the sun on a body.
    static bool mayShade(const Extent& body, const Extent& other, const Vec3& towardsSun);

  private:
    struct Making;
    class OwnRays;
    void number(const std::vector<SunShadows::Caster>& casters);
    /// The body whose numbers hold this one, from the first number of each.
    static std::size_t bodyAt(const std::vector<std::uint32_t>& first, std::size_t number) {
        return static_cast<std::size_t>(std::ranges::upper_bound(first, number) - first.begin()) -
               1;
    }
    std::size_t bodyOfCell(std::uint32_t cell) const { return bodyAt(firstCell_, cell); }
    void takePairs(Making& making);
    void takeOwn(Making& making, std::size_t body, std::uint32_t patch,
                 const PatchRays& starts) const;
    /// What those of `bodies` who are alone see of each other, each as its own `balance` has it,
    /// and all others as `common` has it.
    LightBalance withOwnOf(const Making& making, const LightBalance& common,
                           const std::vector<const LightBalance*>& ofBodies) const;
    /// Pairs that hold those of a body: null for none, by the body's own numbers or by the scene's.
    struct BalanceOfBody {
        const LightBalance* balance = nullptr;
        bool isOwn = true;
    };
    /// Pairs of all bodies from those of each.
    LightBalance joined(const std::vector<BalanceOfBody>& ofBodies) const;
    /// Adds what a body alone sees through transparent materials; `sunOnRows`: by the number that
    /// `sunBesideMean()` of the body has, the one that it has here.
    void addThrough(std::size_t body, const LightThrough& own,
                    std::vector<std::uint32_t>& sunOnRows);
    /// Adds the pairs of a body to those of the scene.
    void copyPairs(const LightPairs& pairs, std::size_t body,
                   std::vector<std::vector<LightPart>>& to) const;
    void takeWithOthers(Making& making, std::size_t body, std::uint32_t patch) const;
    /// Whether rays from a patch may meet other bodies: their spheres are not below its horizon.
    bool hasOthersAbove(const Making& making, std::size_t body, std::uint32_t patch) const;
    /// Whether a ray from a body, in its axes, meets one of its backs that are not there.
    static bool leavesThroughBack(const Making& making, std::size_t body, Ray ray, double upTo_m);
    void takeSunBeside(Making& making) const;
    /// Tells those who get what a ray brings, by `forEachOwn(add(receiver, part))`, what the sun
    /// gives where it ends beside the mean of the senders there.
    /// `passed`: what it has passed on its way.
    template <typename ForEachOwn>
    void tellOfSun(Making& making, std::uint32_t number,
                   const std::vector<OccluderMaterial>& passed, std::size_t metBody,
                   const ExchangeMesh::Place& met, ForEachOwn forEachOwn) const;
    /// Tells a node near a patch of a ray that leaves behind what it has passed.
    static void leave(Making& making, std::uint32_t number,
                      const std::vector<OccluderMaterial>& passed, std::size_t nearCount,
                      std::size_t near, bool isUp, double part);
    /// Whether rays from a patch may go down.
    bool looksDown(const Making& making, std::size_t body, std::uint32_t patch) const;
    /// Follows a ray that meets the ground at a place near bodies from there on: what it meets, and
    /// what is in the way of sky and sun there.
    void reflectOnGround(Making& making, std::size_t body, std::uint32_t patch,
                         const BodyLight::LightStart& start, std::uint32_t index,
                         std::vector<OccluderMaterial> passed, std::span<const float> scales) const;
    struct GasRays;
    void takeGas(const Making& making, std::span<const Gas> gases);
    /// What rays from a patch find of gas and behind it.
    void sendToGas(const Making& making, std::span<const Gas> gases, std::size_t body,
                   std::uint32_t patch, GasRays& found) const;
    void followThroughGas(const Making& making, std::span<const Gas> gases, std::size_t body,
                          const Ray& ray, GasRays& found) const;
    /// Numbers columns and senders, and adds up what rays have found.
    void gatherGas(std::span<const GasRays> found);
    void takeSun(Making& making);
    /// The same through transparent surfaces.
    void takeSunThrough(const Making& making);
    /// On a cell, as a factor: cosine times how much of it is lit.
    double sunOn(Making& making, std::size_t body, std::uint32_t cell) const;
    /// A number for a set of transparent materials.
    LightThrough& throughOf(const std::vector<OccluderMaterial>& set);
    /// Pairs of what rays find behind transparent surfaces.
    void takeThrough(Making& making, const std::vector<ReceiverRays>& known);
    void addMissing(const std::vector<ReceiverRays>& known);
    /// Sky and ground that leave through them; `weights`: by receiver, of what it sees above and
    /// below the horizon.
    void weighLeaving(std::span<const OutsideLight> weights);
    /// The same behind gas.
    void weighBehindGas(std::span<const OutsideLight> weights);
    /// Sums of the areas of the receivers of each.
    std::vector<double> areasOfSenders_m2() const;
    /// Means over senders of what is known of receivers.
    std::vector<double> meansOverSenders(const std::function<double(std::size_t)>& of) const;
    void takeLight(Making& making);
    /// Of those senders that count.
    void sharpenSent(std::vector<float>& values, std::size_t width,
                     std::span<const Columns> ofBodies, const std::vector<bool>& counts) const;
    void sharpenSent(std::vector<double>& values, const std::vector<bool>& counts) const;
    void takeOpenness();
    void addReflected();
    void numberComponents(const std::vector<std::size_t>& components);
    /// Light that falls on the nodes near a patch.
    void lightSide(Making& making, std::size_t body, std::uint32_t patch) const;

    std::vector<Body> bodies_;
    std::vector<std::uint32_t> firstCell_, firstReceiver_, firstSender_;
    std::uint32_t cells_ = 0; // of all bodies
    std::vector<std::size_t> firstVertex_;
    std::vector<float> openOfVertex_; // parts of hemispheres, of all bodies
    std::vector<int> rows_, rowOfSender_;
    std::vector<std::uint32_t> senderOf_; // by receiver
    std::vector<std::uint32_t> local_;
    std::vector<std::vector<std::uint32_t>> ofRow_;
    std::vector<bool> sees_, isSeen_, getsLight_;
    std::vector<bool> reflects_; // by sender
    std::optional<Spectrum> groundReflectivity_;
    bool hasLobes_, areApart_ = false;
    std::size_t components_ = 0; // of all rows
    std::vector<int> firstComponentOf_;
    std::vector<std::uint32_t> reflected_; // as receivers
    std::vector<float> sunOnCells_;        // as factors, where lobes may meet them
    LightBalance balance_;
    std::vector<OccluderMaterial> panes_;
    std::vector<int> paneOf_; // by sender: number of its material; -1: opaque
    OccluderStacks passages_;
    std::vector<LightThrough> through_; // by passage, without the first
    std::vector<LightThroughGas> throughGas_;
    std::size_t firstGasPane_ = 0;
    std::vector<GasSender> gasSenders_;
    LightPairs sunBesideMean_;
    std::vector<Loss> losses_;
    std::vector<double> sky_, ground_, sun_;
    std::vector<std::shared_ptr<const LightExchange>> alone_; // by body
};

} // namespace irsg
