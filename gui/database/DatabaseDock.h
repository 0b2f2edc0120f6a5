#pragma once

#include <QDockWidget>

#include "gui/database/DatabaseFiles.h"
#include "gui/database/EditorContext.h"

class QLabel;
class QSplitter;
class QTabWidget;
class QToolButton;

namespace smat::gui {

class DatabaseBanner;
class EntryList;
class EntryPanel;
class FindingsPanel;
class MaterialPanel;
class SpectrumPanel;
class TemperaturePanel;

/// The editor of the signature database of the chosen model: materials, temperatures, spectra and
/// findings as tabs, each a list with the entry that is chosen beside or below it.
class DatabaseDock : public QDockWidget {
    Q_OBJECT

  public:
    DatabaseDock(Workbench& workbench, const Dialogs& dialogs, QWidget* window);

    /// The entry that is shown; none on the tab of findings.
    std::optional<EntryKey> current() const;
    void select(const EntryKey& key);
    /// Those of a face that was picked: both tabs select theirs, and the one that is open stays.
    void selectCodes(int temperature, int material);
    /// Opens and saves what is edited here.
    DatabaseFiles& files() { return files_; }
    /// The faces of the target are not known yet.
    bool isReadingModel() const { return context_.isReadingModel(); }

    QTabWidget* tabs() const { return tabs_; }
    FindingsPanel* findings() const { return findings_; }
    DatabaseBanner* banner() const { return banner_; }

  public slots:
    void addFromLibrary();
    void copyFromDatabase();
    void importMaterial();
    /// Into this index where one is meant.
    void importMaterialInto(std::optional<int> wanted);
    void importSpectrum();
    void exportSpectrum();

  signals:
    /// The entry that is shown is another, or none.
    void currentChanged(const std::optional<smat::gui::EntryKey>& key);
    /// Codes and entries are to be made from the names in the model.
    void firstSignatureWanted();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    struct Page {
        EntryList* list = nullptr;
        EntryPanel* panel = nullptr;
        QSplitter* split = nullptr;
    };
    Page& pageOf(EntryKind kind) { return pages_[static_cast<std::size_t>(kind)]; }
    void addPage(EntryKind kind, EntryPanel* panel, const QString& title);
    QWidget* makeHeader();
    void refresh();
    void takeEntries(irsg::SignatureDatabase source, const QString& title, const QString& step);

    EditorContext context_;
    DatabaseFiles files_;
    QLabel* title_ = nullptr;
    QLabel* empty_ = nullptr;
    QToolButton* save_ = nullptr;
    DatabaseBanner* banner_ = nullptr;
    QTabWidget* tabs_ = nullptr;
    std::array<Page, 3> pages_;
    FindingsPanel* findings_ = nullptr;
    TemperaturePanel* temperature_ = nullptr;
};

} // namespace smat::gui
