#pragma once

#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

#include <QObject>
#include <QStringList>

#include "gui/widgets/Dialogs.h"

namespace smat::gui {

class ImagePages;
class ProjectFiles;
class ResultsDock;
class ScenarioPages;
class Workbench;

/// Opens files of any kind, each by what it is, wherever they come from: a dialog, a drop, the
/// command line.
class FileOpening : public QObject {
    Q_OBJECT

  public:
    using Opener = std::function<bool(const std::filesystem::path&)>;
    FileOpening(QWidget* window, const Workbench& workbench, Dialogs& dialogs,
                ProjectFiles& projects, ImagePages& images, ResultsDock& results,
                ScenarioPages& scenarios);

    /// Who opens files of other kinds: asked in turn for a file with one of these suffixes ("exr")
    /// until one answers true.
    void openWith(const QStringList& suffixes, Opener opener);
    /// A scenario as a page, one image as a page or two as a comparison, saved results, of which
    /// several plots are overlaid as well, else a project or a model.
    void open(const QStringList& files);
    /// Asks which one.
    void choose();
    /// What a start of the program does: opens a file, if one is named, and offers what a crash
    /// left behind (see ProjectFiles::begin). Returns whether something is open.
    bool begin(const std::filesystem::path& file);

  private:
    void openOther(const std::filesystem::path& file);
    void overlayResultsFrom(std::size_t first);

    QWidget* window_;
    const Workbench& workbench_;
    Dialogs& dialogs_;
    ProjectFiles& projects_;
    ImagePages& images_;
    ResultsDock& results_;
    std::vector<std::pair<QStringList, Opener>> openers_;
};

} // namespace smat::gui
