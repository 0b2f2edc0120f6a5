#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "irsg/radiance/GeometryBuffer.h"
#include "irsg/radiance/OccluderStacks.h"
#include "irsg/radiance/SceneRadiometry.h"
#include "irsg/radiance/exchange/LightIntegrals.h"
#include "irsg/radiance/exchange/LightResponse.h"
#include "irsg/radiance/exchange/LightSolution.h"
#include "irsg/radiance/exchange/ReceiverSums.h"
#include "irsg/render/sampling/Samples.h"
#include "irsg/render/values/RenderSettings.h"

namespace irsg {

/// How much a material of LightExchange::panes lets through, or the ground reflects, by node.
std::vector<double> passingOf(const OccluderMaterial& pane, const LightExchange& exchange,
                              const SceneRadiometry& radiometry);

/// By column of gas and sender of LightExchange::gasSenders, one column behind the other: what the
/// gas takes away of the light and sends, by node.
std::vector<std::vector<double>> gasSharesOf(const LightExchange& exchange,
                                             const SceneRadiometry& radiometry);

/// The receivers that a row has: those of its surface, or for what lobes reflect of others those
/// that stand for what leaves these.
const std::vector<std::uint32_t>& receiversOf(int row, const SurfaceRows& rows,
                                              const LightExchange& exchange);

/// What inter-reflection changes of the radiance of surfaces: what they lose of sky and ground to
/// what stands before them, and what that sends in its place. At a receiver, in terms of the light
/// of its own row r and the columns c of sources of others (LightSolution), node by node,
///   (rho_r / pi) tau [ pi sum_c S_c G_c - loss_sky E_sky - loss_ground E_ground ].
/// The bracket is linear in geometry's numbers and in the spectra of senders, so that in a band it
/// is a dot product: of the receiver's loss and G with integrals that the receivers of a row share.
class SceneLight {
  public:
    /// All must live as long; `occluderStacks` may grow. Solutions are looked for among
    /// `solutions`.
    SceneLight(std::shared_ptr<const LightExchange> exchange, const SceneRadiometry& radiometry,
               const OccluderStacks& occluderStacks, const RenderSettings& settings,
               LightSolutions& solutions);

    const LightExchange& exchange() const { return *exchange_; }
    int bounces() const { return bounces_; }
    /// Whether light between surfaces changes anything of a drawn row.
    bool matters(int drawn) const;
    /// Forgets what follows from the emission of senders, which has become another.
    void turn();

    /// Radiances at the sensor where factors are 1, W m-2 sr-1: what the row's sky and ground give,
    /// taken away, and what each column gives, knot by knot.
    std::span<const double> integrals(const SurfaceStackId& kind, std::size_t output);
    void prepare(const std::vector<SurfaceStackId>& kinds);
    /// Kinds by what lies before them, not by the numbers that this got: sums that go by it are the
    /// same to the last digit whatever was seen before.
    std::vector<SurfaceStackId> inOrder(const LightSums& sums) const;

    /// What sums of a kind make of the same numbers: of losses, and of columns.
    std::vector<double> contracted(int row, const ReceiverSums& sums, bool withCosine) const;
    /// In-band radiance in the first output at each receiver of a kind's drawn row: what is taken
    /// of that by sky and by ground, and what others give.
    using AtReceiver = std::array<double, 3>;
    const std::vector<AtReceiver>& atReceivers(const SurfaceStackId& kind);
    /// Makes that of several kinds that light matters to, on all cores.
    void prepareAtReceivers(const std::vector<SurfaceStackId>& kinds);
    /// The same where it was asked for before, else null.
    const std::vector<AtReceiver>* findAtReceivers(const SurfaceStackId& kind) const;
    /// Whether sums over a view are better made of in-band radiances at receivers than contracted:
    /// there are fewer outputs than sums of one view.
    bool sumsAtReceivers() const;
    /// Makes what sumAtReceivers asks for of these sums, in all outputs, on all cores.
    void prepareReceivers(const std::vector<const LightSums*>& views);
    /// What sums of a kind make of what receivers send, without and with cosine.
    std::array<double, 2> sumAtReceivers(const SurfaceStackId& kind, std::size_t output,
                                         const ReceiverSums& sums) const;

    /// What falls on receivers of a row, by where it was emitted or first reflected: node by node,
    /// W m-2 um-1 times the unit of the sums.
    struct Falling {
        std::vector<double> lost; ///< of sky and ground, beside what comes through panes
        /// By the sender's drawn row, empty where there is none: of its emission, and of what it
        /// reflects, at a reflectivity of 1.
        std::vector<std::vector<double>> emitted, perReflectivity;
    };
    /// Of what is contracted, for `count` nodes from `first` on.
    Falling fallsOn(int row, std::span<const double> contracted, std::size_t first,
                    std::size_t count) const;

    /// As `contracted`, with a weight of 1 for each receiver of a drawn row.
    std::vector<double> contractedEvenly(int drawn) const;
    /// Adds what others send to what is contracted, for as many nodes as the vector holds.
    void addFromOthers(std::span<const double> contracted, std::size_t first,
                       std::vector<double>& all_W_m2_um) const;
    /// The sources, columns of a node next to each other, W m-2 um-1.
    std::vector<double> sourcesByNode() const;
    /// What falls on receivers of a row beyond what open sky and ground give, by node, W m-2 um-1
    /// times the unit of the sums; without and with their cosine.
    std::array<std::vector<double>, 2> reflectable(int row, const ReceiverSums& sums,
                                                   std::span<const double> sourcesByNode) const;
    /// Sources summed over nodes with the weights of the band, by column of each knot, W m-2.
    std::vector<double> summedSources(std::span<const std::size_t> nodes) const;
    /// Of sets of drawn rows, in nodes `first` to before `last`; made when first asked for.
    const LightResponse& response(const std::vector<std::vector<int>>& reflectors,
                                  std::pair<std::size_t, std::size_t> nodes);

    const LightSolution& solution() const { return *solution_; }
    /// Terms that light is taken away of, of sky and of ground; -1 for none.
    int skyTerm() const { return skyTerm_; }
    int groundTerm() const { return groundTerm_; }

  private:
    /// What reflects less is black.
    static constexpr double leastReflectance_per_sr = 1e-9;
    void findColumns();
    void addPassedColumns();
    void addReflected(int row, std::size_t term, LightPattern pattern);
    void addComponentColumns();
    void findKnots(const RenderSettings& settings);
    void fillSources();
    LightIntegrals integrator() const {
        return {radiometry_,      occluderStacks_, knotsOfNodes_,
                sources_W_m2_um_, skyTerm_,        groundTerm_};
    }
    std::size_t width() const { return integrator().width(); }
    const std::vector<std::uint32_t>& receiversOf(int row) const {
        return irsg::receiversOf(row, radiometry_.rows(), *exchange_);
    }
    /// Of kinds that have the same receivers.
    void fillAtReceivers(const std::vector<std::uint32_t>& receivers,
                         const std::vector<std::span<const double>>& integrals,
                         const std::vector<std::vector<AtReceiver>*>& places) const;
    /// By node.
    const std::vector<double>& lightOn(int drawn, int term) const;
    /// What a node has of a contracted column.
    double partOf(std::span<const double> contracted, std::size_t column, std::size_t node) const;

    std::shared_ptr<const LightExchange> exchange_;
    const SceneRadiometry& radiometry_;
    const OccluderStacks& occluderStacks_;
    int bounces_;
    int skyTerm_ = -1, groundTerm_ = -1, sunTerm_ = -1;
    std::vector<LightColumn> columns_;
    std::vector<LightKnot> knots_;
    LightKnots knotsOfNodes_;
    std::vector<std::vector<double>> sources_W_m2_um_; // by column: pi times its radiance, by node
    std::shared_ptr<const LightSolution> solution_;
    std::map<std::pair<int, int>, std::vector<std::vector<double>>> known_; // by kind and output
    std::vector<double> passing_; // integrals that are not kept
    std::map<std::pair<std::vector<std::vector<int>>, std::pair<std::size_t, std::size_t>>,
             std::unique_ptr<const LightResponse>>
        responses_;
    std::map<std::pair<int, int>, std::vector<AtReceiver>> atReceivers_; // of output 0
    /// In-band radiances of the receivers of a kind that were asked for.
    struct Sent {
        std::vector<char> isKnown;
        std::vector<std::vector<double>> radiance; ///< by output
    };
    std::map<std::pair<int, int>, Sent> sent_;
};

/// Numbers for the receivers of all rows of a radiometry, row by row.
class ReceiverRows {
  public:
    ReceiverRows() = default;
    ReceiverRows(const SurfaceRows& rows, const LightExchange& exchange);
    int numberOf(int row, std::uint32_t local) const {
        return first_[static_cast<std::size_t>(row)] + static_cast<int>(local);
    }
    /// The row of a number, and which of its receivers that is.
    std::pair<int, std::size_t> receiverOf(int number) const;

  private:
    std::vector<int> first_; // by row, and behind the last
};

/// In-band radiance in the first output at the receivers that a field has entries of.
std::vector<double> radiancesOf(const std::vector<SurfaceStackId>& receivers,
                                const ReceiverRows& rows, SceneLight& light);

/// The same between the receivers about a sample's place; nothing where that is not known.
SceneLight::AtReceiver lightAt(const LightExchange& exchange,
                               const std::vector<SceneLight::AtReceiver>& atReceivers,
                               const GeometrySamples::Place& place);

} // namespace irsg
