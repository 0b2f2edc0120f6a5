#pragma once

#include <vector>

#include <QObject>

#include "gui/widgets/Dialogs.h"
#include "gui/widgets/LatestTask.h"
#include "smatcore/project/Project.h"

namespace smat::gui {

class ComparisonWindow;
class PageTabs;
class Workbench;

/// Images as pages: one of a file, or two of files or results that are compared. Files are read off
/// this thread.
class ImagePages : public QObject {
    Q_OBJECT

  public:
    ImagePages(const Workbench& workbench, Dialogs& dialogs, PageTabs& tabs);

    /// Whether these are one or two images to be looked at: by name, text by what it holds. A
    /// single .csv, as we write it, is none: it comes back as a result, with its provenance.
    static bool areImages(const QStringList& files);
    /// One file as a page of its own, two as a comparison.
    void open(const QStringList& files);
    /// A page that compares two images: those of two files, or empty for somebody to fill. It goes
    /// again where neither file can be read.
    ComparisonWindow* compare(const QStringList& files = {});
    /// The same of two results that are images; nothing for others.
    ComparisonWindow* compareResults(int a, int b);

  private:
    /// Those whose images may be explained.
    std::vector<Project> openProjects() const;
    const Workbench& workbench_;
    Dialogs& dialogs_;
    PageTabs& tabs_;
    LatestTask task_;
};

} // namespace smat::gui
