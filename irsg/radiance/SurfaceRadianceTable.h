#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "irsg/radiance/GeometryBuffer.h"
#include "irsg/radiance/OccluderStacks.h"
#include "irsg/radiance/SceneRadiometry.h"

namespace irsg {

/// What one kind of surface sends through what lies before it, in one of the outputs of a sampling.
/// A sum of factors F makes of it: constant F_coverage + sum of perFactor[f] F_f.
struct SurfaceStackRadiance {
    std::span<const double> perFactor; ///< W m-2 sr-1 at each drawn factor of 1
    double constant = 0.0;             ///< whatever the factors are
    double hidden = 0.0;               ///< of the background at the field's centre, that it hides
    double opacity = 0.0;              ///< the same as a part of that background
};

/// The only place where factors meet radiances: products of all transmissivities in front of a
/// surface with its terms, node by node, summed over the outputs of the sampling last. In-band
/// radiances, spectra, images and sums over objects are reductions of it. Kinds are evaluated once
/// each, when they are first asked for; `prepare` does it for many of them, on all cores.
///
/// A kind is a set of sums over nodes, one for each group of terms: weight times what lies in front
/// times what the surface makes of light, times the air of the row. The first three are one vector
/// for all rows of a surface. Each part of the emission has groups of its own, so that factors of
/// measured spectra change without a sum over nodes.
class SurfaceRadianceTable {
  public:
    /// `radiometry` and `occluderStacks` must live as long; `occluderStacks` may grow.
    SurfaceRadianceTable(const SceneRadiometry& radiometry, const OccluderStacks& occluderStacks);

    /// Spectral radiance behind the objects at the field's centre, by node; 0 at first. Another one
    /// leaves what surfaces send as it is.
    void setBackground(SharedValues background);
    /// Tells of drawn rows whose factors of emission have become others.
    void turn(const std::vector<int>& drawn);
    /// Tells that what the air itself sends along the way has become other.
    void seeAlong() { ++path_; }
    /// Of the background in an output, W m-2 sr-1.
    double background_W_m2_sr(std::size_t output = 0) const { return inBand_[output]; }

    std::size_t outputs() const { return outputs_; }
    std::size_t factorCount() const { return factorCount_; }

    void prepare(const std::vector<SurfaceStackId>& kinds);
    bool isPrepared(const SurfaceStackId& kind) const;
    /// LogicError for a kind that was not prepared.
    SurfaceStackRadiance of(const SurfaceStackId& kind, std::size_t output = 0) const {
        return inOutputs(kind).at(output);
    }

    /// A kind in all outputs, found once; valid until the next `prepare`.
    class InOutputs {
      public:
        SurfaceStackRadiance at(std::size_t output) const {
            const double* sent = sent_ + output * (factorCount_ + 1);
            const double* hidden = hidden_ + 2 * output;
            return {{sent, factorCount_}, sent[factorCount_], hidden[0], hidden[1]};
        }

      private:
        friend class SurfaceRadianceTable;
        const double *sent_ = nullptr, *hidden_ = nullptr;
        std::size_t factorCount_ = 0;
    };
    InOutputs inOutputs(const SurfaceStackId& kind) const;

    /// In an output: one value for each term at factor 1 (truth layers).
    std::vector<double> terms(const SurfaceStackId& kind, std::size_t output = 0) const;
    /// By node, first and before last: weight times what the materials in front let through; see
    /// SceneRadiometry::fillPassed.
    std::vector<double> passed(int stack, std::pair<std::size_t, std::size_t> nodes,
                               bool throughAir = false, int drawn = -1) const;

  private:
    /// What passes all that is in front, by node; the second of what passes the air as well, empty
    /// where that is the same.
    struct Passed {
        std::vector<double> plain, throughAir;
        const std::vector<double>& of(bool passesAtmosphere) const {
            return passesAtmosphere && !throughAir.empty() ? throughAir : plain;
        }
    };
    Passed passedBy(int stack, int drawn = -1) const;
    bool hasGas(int stack) const;
    /// Terms of the radiance that one sum over nodes serves: they share their drawn factor, their
    /// part of the emission and the air that they pass.
    struct TermGroup {
        std::size_t slot = 0;          ///< a drawn factor, or behind them for what has none
        int part = -1;                 ///< of the emission; none
        bool passesAtmosphere = false; ///< multiplied with the transmittance of the row
        int pathLight = -1; ///< with the light of this term, where it differs between rows
        std::vector<std::pair<std::size_t, double>> terms; ///< that it sums, and their signs
    };
    /// Where a kind's numbers lie, output by output.
    struct Place {
        bool isKnown = false, isCombined = false;
        std::size_t path = 0; ///< number of the path whose light its groups hold
        std::size_t groupSums = 0, sent = 0;
    };
    /// The same for what is the same in all rows of a surface.
    struct HiddenPlace {
        bool isKnown = false, hasRoom = false;
        std::size_t at = 0;
    };
    /// What is to be evaluated of a surface behind a front.
    struct Work {
        std::vector<int> rows, rowsOfPath; ///< of all groups, and of those of the path alone
        bool hidden = false;
    };

    /// Per factor, then constant.
    std::size_t valuesOfKind() const { return factorCount_ + 1; }
    std::vector<TermGroup> termGroupsOf(int drawn) const;
    HiddenPlace& hiddenPlaceOf(int stack, int drawn);
    /// Gives new kinds their places, and lists what they need, by front and drawn row.
    std::map<std::pair<int, int>, Work> plan(const std::vector<SurfaceStackId>& kinds);
    /// Of one of the drawn rows that the kind stands for: adds to what others of them have.
    void evaluate(int stack, int kindOf, int drawn, const Work& work, const Passed& passed);
    /// The same for its groups of terms in some rows, or for those of the path alone.
    void addSums(int stack, int drawn, const std::vector<int>& rows, bool ofPath,
                 const Passed& passed);
    /// Adds a block of nodes to the sums of rows of a surface, group by group.
    void addBlock(int drawn, const std::vector<int>& rows, bool ofPath, const Passed& passed,
                  std::size_t begin, std::size_t count, std::vector<double>& sums) const;
    void fillGroup(int drawn, const TermGroup& group, const double* passed, std::size_t begin,
                   std::size_t count, double* values) const;
    void evaluateHidden(int drawn, const std::vector<double>& passed, double* into) const;
    void combine(const SurfaceStackId& kind);
    Place& placeOf(const SurfaceStackId& kind);

    const SceneRadiometry& radiometry_;
    const OccluderStacks& occluderStacks_;
    std::size_t outputs_, factorCount_;
    std::vector<std::vector<TermGroup>> termGroups_;     // by drawn row
    SharedValues background_;                            // by node
    std::vector<double> inBand_, area_um_;               // by output
    std::size_t path_ = 0;                               // how often it has become other
    std::vector<std::vector<Place>> places_;             // [front][row]
    std::vector<std::vector<HiddenPlace>> hiddenPlaces_; // [front][drawn row]
    /// Sums of groups of terms; what their sum sends; of the background its in-band radiance and
    /// part.
    std::vector<double> groupSums_, sent_, hidden_;
};

} // namespace irsg
