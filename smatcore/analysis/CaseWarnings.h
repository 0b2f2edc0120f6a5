#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "irsg/render/values/RenderReport.h"
#include "smatcore/data/SceneDescription.h"

namespace smat {

/// Something that a case warns of. Of those of one kind the one with the largest value is told.
struct CaseRemark {
    std::string kind, sentence;
    double value = 0.0;
    bool operator==(const CaseRemark&) const = default;
};
/// What a row of a table warns of: the sentences of its case, each once, joined by semicolons; ""
/// where there are none.
std::string rowWarning(const std::vector<CaseRemark>& remarks);

/// What the cases of a sweep warn of, each sentence once with the cases it holds for: "at 500 m
/// (and 3 more): ...". A sentence that holds for every case so far stands alone. Frames of a
/// scenario say theirs once without the cases, first those with no kind but themselves; {cases} in
/// one stands for how many there are.
class CaseWarnings {
  public:
    enum class Telling { byCase, once };
    explicit CaseWarnings(Telling telling = Telling::byCase) : telling_(telling) {}

    /// Everything added from now on is of this case ("500 m").
    void beginCase(std::string name);
    void add(const std::string& sentence);
    /// Of the sentences of one kind, the one with the largest value is told.
    void addWorst(const std::string& kind, double value, const std::string& sentence);
    /// What was added since beginCase().
    const std::vector<CaseRemark>& remarks() const { return remarks_; }
    /// A case that was done before, with its remarks.
    void addCase(std::string name, const std::vector<CaseRemark>& remarks);

    /// What a report and its numbers say.
    void addReport(const irsg::RenderReport& report, int layersKept);
    /// Objects of a scene that reach out of the frame, whose rest is not in the sums.
    void addObjectsBeyondFrame(const irsg::Scene& scene, const irsg::SensorView& view);

    std::vector<std::string> sentences() const;

  private:
    struct Entry {
        std::string kind, sentence, firstCase;
        double worst = 0.0;
        std::size_t cases = 0, lastCase = 0; ///< the number of the last case, from 1
    };

    std::vector<std::string> sentencesOnce() const;

    Telling telling_;
    std::vector<Entry> entries_;
    std::vector<CaseRemark> remarks_; // of this case
    std::string case_;
    std::size_t count_ = 0;
};

} // namespace smat
