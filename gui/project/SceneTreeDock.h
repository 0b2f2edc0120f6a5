#pragma once

#include <memory>
#include <vector>

#include <QDockWidget>
#include <QSet>
#include <QTimer>

#include "gui/project/SceneIndex.h"

class QTreeWidget;
class QTreeWidgetItem;

namespace smat::gui {

class Workbench;

/// The project as a tree: its models with the indices of temperature and material, how many faces
/// carry each and what the database calls it; sensor, atmosphere and analyses. What is missing is
/// marked. Files are read in the background.
class SceneTreeDock : public QDockWidget {
    Q_OBJECT

  public:
    explicit SceneTreeDock(Workbench& workbench, QWidget* parent = nullptr);
    ~SceneTreeDock() override;

    /// Selects an index as a click on it would, without a signal: a face was picked in the view.
    void showIndex(IndexKind kind, int index, int model = 0);
    /// A database that is edited stands in for the file of its model until the next reload.
    void setDatabase(int model, const irsg::SignatureDatabase& database);
    /// Lets a person type another name for a model.
    void rename(int model);
    bool isLoading() const { return loading_ != nullptr; }
    const std::vector<ModelIndex>& index() const { return index_; }

  signals:
    /// The faces that carry this index are of interest.
    void indexSelected(smat::gui::IndexKind kind, int index, int model);
    /// Something else than an index is selected.
    void nothingSelected();
    /// A person wants a model to be added, that one to go, or to become the target.
    void addModelWanted();
    void removeModelWanted(int model);
    void targetWanted(int model);
    void modelFileWanted(int model);
    void databaseFileWanted(int model);
    void sensorActivated();
    void atmosphereActivated();
    void sunActivated();
    void analysisActivated(const QString& name);
    void removeAnalysisWanted(const QString& name);
    void propertiesWanted();
    void indexActivated(smat::gui::IndexKind kind, int index, int model);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    struct Loading;
    void load();
    void count();
    void onProjectChanged();
    void followDatabases();
    void showChosen();
    void atomicRename(QTreeWidgetItem* item);
    QSet<QString> openBranches() const;
    void fill();
    void fillModel(QTreeWidgetItem* root, std::size_t number);
    void fillIndices(QTreeWidgetItem* parent, std::size_t model, IndexKind kind);
    void refreshSettings();
    void onSelected();
    void onActivated(QTreeWidgetItem* item);
    void showMenu(const QPoint& place);

    Workbench& workbench_;
    QTreeWidget* tree_ = nullptr;
    QTreeWidgetItem* sensor_ = nullptr;
    QTreeWidgetItem* atmosphere_ = nullptr;
    QTreeWidgetItem* sun_ = nullptr;
    std::vector<ModelIndex> index_;
    std::vector<ProjectModel> models_; ///< those that index_ is of
    Project filled_;                   ///< as the tree shows it
    std::shared_ptr<Loading> loading_;
    QTimer watch_;
};

} // namespace smat::gui
