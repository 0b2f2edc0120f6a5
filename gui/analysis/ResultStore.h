#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <QDateTime>
#include <QObject>

#include "gui/widgets/LatestTask.h"
#include "smatcore/results/ResultDocument.h"

namespace smat::gui {

/// A result that is open: made since the start of the program, or kept with the project.
struct ResultEntry {
    using Origin = ResultDocument::Origin;

    int id = 0;
    QString title = {}; ///< "1  Polar plot", or what the user called it
    QString notes = {};
    /// Copies of the entry share it: an image is large.
    std::shared_ptr<const AnalysisData> data = std::make_shared<const AnalysisData>();
    /// Of a Monte Carlo run, whose analysis `data` is; else null.
    std::shared_ptr<const MonteCarloData> monteCarlo = {};
    Origin origin = Origin::run;
    QDateTime madeAt = {};
    std::filesystem::path file = {}; ///< it was opened from, or that holds all of it
    std::string document = {};       ///< its stem in the folder of the project; empty: not kept yet
    bool wordsChanged = false;       ///< title or notes, since it was kept

    /// What it was asked is known in full.
    bool canRunAgain() const { return origin == Origin::run; }
    bool isImage() const { return !data->image.empty(); }
    std::shared_ptr<const irsg::RadianceImage> image() const { return {data, &data->image}; }
    /// What it is a result of: of a Monte Carlo run, `data` has the analysis that it repeated.
    AnalysisKind kind() const;
    /// Something of it would be lost.
    bool isUnsaved() const { return document.empty() ? file.empty() : wordsChanged; }
};

/// The results that are open, in the order they came. Those of a project are kept in the folder
/// beside it (ResultFolder): read when it is opened, written when it is saved.
class ResultStore : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    const std::vector<ResultEntry>& entries() const { return entries_; }
    /// Null where there is none.
    const ResultEntry* find(int id) const;

    int add(std::shared_ptr<const AnalysisData> data);
    /// `quietly` where its page shows it already.
    int add(std::shared_ptr<const MonteCarloData> run, bool quietly = false);
    /// Reads a result file (see loadResult) and adds it with its provenance. Throws
    /// irsg::InputError.
    int open(const std::filesystem::path& file);
    /// Adds first minus second. Throws irsg::InputError where the two do not fit. LogicError for an
    /// unknown result.
    int addDifference(int first, int second);
    /// Adds what a tool computed, a table over some axis.
    int addTable(const QString& title, const ResultTable& table, bool quietly = false);
    /// An empty title is no title: nothing happens.
    void rename(int id, const QString& title);
    void annotate(int id, const QString& notes);
    /// It was written to this file, with all that it has.
    void noteSaved(int id, const std::filesystem::path& file);
    /// Takes it off the list; one that is kept with the project goes from there when that is saved.
    void remove(int id);

    /// Lets go of all that is open.
    void clear();
    /// Reads, off this thread, those kept beside a project; an empty path is a project without a
    /// file. `folder` is the name of the folder where the project names one, whose absence is then
    /// told.
    void openProject(const std::filesystem::path& projectFile, const std::string& folder);
    /// While those of a project are being read.
    bool isReading() const { return reading_.isBusy(); }
    /// How many are not kept, with those that were taken off the list and still lie there.
    int unsavedCount() const;
    /// Whether a folder of that name beside a project has, or will have, any result.
    bool holdsAny(const std::filesystem::path& projectFile, const std::string& folder) const;
    /// Writes what is not kept yet beside the project, into a folder of that name. Throws
    /// irsg::InputError for what cannot be written; the others are kept.
    void saveWith(const std::filesystem::path& projectFile, const std::string& folder);

  signals:
    void added(int id);
    /// The same of one that nobody needs to be shown now: read again with its project, or on the
    /// page that asked for it.
    void addedQuietly(int id);
    void renamed(int id);
    void removed(int id);
    /// unsavedCount() may have another answer.
    void unsavedChanged();
    /// Results of the project that cannot be read or are gone, a sentence each.
    void problems(const QStringList& sentences);

  private:
    struct Read;
    int keep(ResultEntry entry, bool quietly = false);
    ResultEntry* edit(int id);
    void restore(const std::filesystem::path& folder, const Read& read);

    std::vector<ResultEntry> entries_;
    int nextId_ = 1;
    std::filesystem::path folder_;     ///< where the documents lie
    std::vector<std::string> removed_; ///< documents that go when the project is saved
    LatestTask reading_;
};

/// Everything there is to say about a result, as lines "key: value": how it was made, its figures
/// and its notes.
QStringList describe(const ResultEntry& entry);
/// "complete", "partial", "opened from polar.csv", "difference".
QString stateOf(const ResultEntry& entry);
/// "0.42 s", "3 min 20 s", "1 h 5 min".
QString durationText(double seconds);

} // namespace smat::gui
