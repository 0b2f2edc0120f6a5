#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <QDateTime>
#include <QObject>

#include "smatcore/analysis/AnalysisData.h"

namespace smat::gui {

/// A result of this session.
struct ResultEntry {
    enum class Origin {
        run,        ///< of an analysis of this session
        file,       ///< opened again from a file
        difference, ///< of two others
        tool        ///< what a tool computed
    };

    int id = 0;
    QString title = {}; ///< "1  Polar plot", or what the user called it
    /// Copies of the entry share it: an image is large.
    std::shared_ptr<const AnalysisData> data = std::make_shared<const AnalysisData>();
    Origin origin = Origin::run;
    QDateTime madeAt = {};
    std::filesystem::path file = {}; ///< it was opened from, or that holds all of it

    /// What it was asked is known in full.
    bool canRunAgain() const { return origin == Origin::run; }
    bool isImage() const { return !data->image.empty(); }
    std::shared_ptr<const irsg::RadianceImage> image() const { return {data, &data->image}; }
};

/// The results of a session in the order they came.
class ResultStore : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    const std::vector<ResultEntry>& entries() const { return entries_; }
    /// Null where there is none.
    const ResultEntry* find(int id) const;

    int add(std::shared_ptr<const AnalysisData> data);
    /// Reads a result file (see loadResult) and adds it with its provenance. Throws
    /// irsg::InputError.
    int open(const std::filesystem::path& file);
    /// Adds first minus second. Throws irsg::InputError where the two do not fit. LogicError for an
    /// unknown result.
    int addDifference(int first, int second);
    /// Adds what a tool computed, a table over some axis.
    int addTable(const QString& title, const ResultTable& table);
    /// An empty title is no title: nothing happens.
    void rename(int id, const QString& title);
    /// It was written to this file, with all that it has.
    void noteSaved(int id, const std::filesystem::path& file);
    void remove(int id);

  signals:
    void added(int id);
    void renamed(int id);
    void removed(int id);

  private:
    int keep(ResultEntry entry);

    std::vector<ResultEntry> entries_;
    int nextId_ = 1;
};

/// Everything there is to say about a result, as lines "key: value": how it was made, its figures
/// and its notes.
QStringList describe(const ResultEntry& entry);
/// "complete", "partial", "opened from polar.csv", "difference".
QString stateOf(const ResultEntry& entry);
/// "0.42 s", "3 min 20 s", "1 h 5 min".
QString durationText(double seconds);

} // namespace smat::gui
