#pragma once

#include <optional>
#include <vector>

#include "gui/image/ComparedPair.h"
#include "gui/widgets/Dialogs.h"
#include "gui/widgets/LatestTask.h"
#include "irsg/image/ImageFormat.h"

namespace smat::gui {

/// Opens files as the sides of a compared pair, read off the window's thread. What cannot be read
/// is told, one sentence a file, and what was there stays; where nothing was, the file that can be
/// read is taken.
class ComparisonFiles : public QObject {
    Q_OBJECT

  public:
    ComparisonFiles(const ComparedPair& pair, Dialogs dialogs, QWidget* window);

    /// One or two. One becomes A, or B where A is there and B is not, or `side`.
    void open(const QStringList& files, std::optional<int> side = {});
    /// Asks which file.
    void ask(int side);
    bool isBusy() const { return task_.isBusy(); }

  signals:
    void begun(const QStringList& files);
    void read(const smat::gui::ComparisonSide& a, const smat::gui::ComparisonSide& b);
    /// After all that was begun, before what is wrong is told.
    void ended();
    /// No file could be read and there is nothing to see; it was told.
    void nothingRead();

  private:
    /// Of files that were to be read: a side of each, empty where it cannot be, and why.
    struct Reading {
        std::vector<ComparisonSide> sides;
        QStringList wrong;
    };
    static Reading readingOf(const QStringList& files, const std::vector<irsg::ImageReading>& what);
    void take(Reading reading, int first);

    const ComparedPair& pair_;
    Dialogs dialogs_;
    QWidget* window_;
    LatestTask task_;
};

} // namespace smat::gui
