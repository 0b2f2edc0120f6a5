#include "smatcore/analysis/CaseWarnings.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "irsg/core/AppendUnique.h"
#include "smatcore/analysis/CaseChecks.h"

namespace smat {

namespace {

/// A sentence with the number of its cases in its place.
std::string counted(std::string sentence, std::size_t cases) {
    const std::string word = "{cases}";
    if (const std::size_t at = sentence.find(word); at != std::string::npos)
        sentence.replace(at, word.size(), std::to_string(cases));
    return sentence;
}

/// A sentence without its number of percent or pixels, and that number: cases whose sentences
/// differ in it alone are told together, with the largest.
std::pair<std::string, double> kindOf(const std::string& sentence) {
    for (const std::string_view unit : {" %", " pixels"}) {
        const std::size_t end = sentence.find(unit);
        if (end == std::string::npos || end == 0)
            continue;
        const std::size_t before = sentence.find_last_not_of("0123456789.", end - 1);
        const std::size_t begin = before == std::string::npos ? 0 : before + 1;
        double value = 0.0;
        const char* const last = sentence.data() + end;
        if (std::from_chars(sentence.data() + begin, last, value).ptr == last && begin < end)
            return {sentence.substr(0, begin) + sentence.substr(end), value};
    }
    return {sentence, 0.0};
}

} // namespace

std::string rowWarning(const std::vector<CaseRemark>& remarks) {
    std::vector<std::string> sentences;
    for (const CaseRemark& remark : remarks)
        irsg::appendUnique(sentences, {counted(remark.sentence, 1)});
    return fmt::format("{}", fmt::join(sentences, "; "));
}

void CaseWarnings::beginCase(std::string name) {
    case_ = std::move(name);
    remarks_.clear();
    ++count_;
}

void CaseWarnings::addCase(std::string name, const std::vector<CaseRemark>& remarks) {
    beginCase(std::move(name));
    for (const CaseRemark& remark : remarks)
        addWorst(remark.kind, remark.value, remark.sentence);
}

void CaseWarnings::add(const std::string& sentence) {
    addWorst(sentence, 0.0, sentence);
}

void CaseWarnings::addWorst(const std::string& kind, double value, const std::string& sentence) {
    remarks_.push_back({kind, sentence, value});
    auto entry = std::find_if(entries_.begin(), entries_.end(),
                              [&](const Entry& one) { return one.kind == kind; });
    if (entry == entries_.end())
        entry = entries_.insert(entry, {kind, sentence, case_, value});
    if (value > entry->worst) {
        entry->worst = value;
        entry->sentence = sentence;
    }
    if (entry->lastCase != count_) {
        entry->lastCase = count_;
        ++entry->cases;
    }
}

void CaseWarnings::addReport(const irsg::RenderReport& report, int layersKept) {
    for (const std::string& sentence : report.warnings) {
        const auto [kind, value] = kindOf(sentence);
        addWorst(kind, value, sentence);
    }
    const bool isBehindHorizon =
        std::ranges::any_of(report.warnings, [](const std::string& sentence) {
            return sentence.ends_with("is behind the horizon");
        });
    if (!(report.all.coveredPixels > 0.0) && !isBehindHorizon) {
        add("no sample hits the target: it is out of the frame, behind terrain, too small for the "
            "sampling, or the camera is inside it");
    }
    if (report.layersLeftOver > 0) {
        addWorst("layers", report.layersLeftOver,
                 fmt::format("up to {} samples of a drawing have more than {} transparent layers, "
                             "the rest of which is left out; see render.layers",
                             report.layersLeftOver, layersKept));
    }
}

void CaseWarnings::addObjectsBeyondFrame(const irsg::Scene& scene, const irsg::SensorView& view) {
    for (const irsg::Entity& entity : scene.entities)
        if (reachesBeyondFrame(entity, entity.pose, view.viewpoint, view.sensor))
            add(beyondFrameWarning(entity.name));
}

std::vector<std::string> CaseWarnings::sentencesOnce() const {
    std::vector<Entry> entries = entries_;
    const auto isOfKind = [](const Entry& entry) { return entry.kind != entry.sentence; };
    std::ranges::stable_sort(entries, {}, [&](const Entry& entry) {
        return isOfKind(entry) ? entry.kind : std::string();
    });
    std::vector<std::string> all;
    for (Entry& entry : entries)
        all.push_back(isOfKind(entry) ? counted(entry.sentence, entry.cases) : entry.sentence);
    return all;
}

std::vector<std::string> CaseWarnings::sentences() const {
    if (telling_ == Telling::once)
        return sentencesOnce();
    std::vector<std::string> all;
    for (const Entry& entry : entries_) {
        if (entry.cases == count_) {
            all.push_back(entry.sentence);
        } else {
            const std::string more =
                entry.cases > 1 ? fmt::format(" (and {} more)", entry.cases - 1) : "";
            all.push_back(fmt::format("at {}{}: {}", entry.firstCase, more, entry.sentence));
        }
    }
    return all;
}

} // namespace smat
