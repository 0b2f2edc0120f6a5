#include "gui/project/SceneTreeDock.h"

#include <algorithm>
#include <atomic>

#include <QEvent>
#include <QHeaderView>
#include <QMenu>
#include <QShortcut>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "gui/project/SceneTreeItems.h"
#include "gui/widgets/BackgroundPool.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Theme.h"
#include "gui/workbench/Workbench.h"

namespace smat::gui {

namespace {

/// Whether a model and its database have to be read anew for what the tree tells of them.
bool readAlike(const ProjectModel& a, const ProjectModel& b) {
    return a.file == b.file && a.options == b.options && a.database == b.database &&
           a.fallbackTemperature == b.fallbackTemperature &&
           a.fallbackMaterial == b.fallbackMaterial;
}

bool saysTheSame(const ModelIndex& a, const ModelIndex& b) {
    const auto equal = [](const auto& x, const auto& y) {
        return std::ranges::equal(x, y, [](const auto& one, const auto& other) {
            return one.first == other.first && one.second.name == other.second.name &&
                   one.second.hasEntry == other.second.hasEntry &&
                   one.second.isReplaced == other.second.isReplaced;
        });
    };
    return a.databaseProblem == b.databaseProblem && equal(a.temperatures, b.temperatures) &&
           equal(a.materials, b.materials);
}

} // namespace

struct SceneTreeDock::Loading {
    std::atomic<bool> done = false;
    std::vector<ModelIndex> index;
};

SceneTreeDock::SceneTreeDock(Workbench& workbench, QWidget* parent)
    : QDockWidget(tr("Scene"), parent), workbench_(workbench) {
    setObjectName("sceneDock");
    tree_ = new QTreeWidget(this);
    tree_->setObjectName("sceneTree");
    tree_->setColumnCount(2);
    tree_->setHeaderLabels({tr("Project"), tr("Faces")});
    tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    tree_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    tree_->header()->setStretchLastSection(false);
    tree_->headerItem()->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    tree_->setIconSize(QSize(16, 16));
    tree_->setIndentation(16);
    tree_->setUniformRowHeights(true);
    tree_->setFrameShape(QFrame::NoFrame);
    tree_->setContextMenuPolicy(Qt::CustomContextMenu);
    tree_->setMinimumWidth(220);
    auto* nothing = new QTreeWidgetItem(tree_, {tr("nothing is open yet")});
    nothing->setFlags(Qt::NoItemFlags);
    setWidget(tree_);
    tree_->setEditTriggers(QAbstractItemView::EditKeyPressed);
    auto* remove = new QShortcut(Qt::Key_Delete, tree_, nullptr, nullptr, Qt::WidgetShortcut);
    connect(remove, &QShortcut::activated, this, [this] {
        if (const auto* item = tree_->currentItem();
            item != nullptr && treePartOf(item) == TreePart::model)
            emit removeModelWanted(item->data(0, treeModelRole).toInt());
    });
    watch_.setInterval(20);
    connect(&watch_, &QTimer::timeout, this, [this] {
        if (!loading_->done)
            return;
        watch_.stop();
        index_ = std::move(std::exchange(loading_, nullptr)->index);
        fill();
        followDatabases();
    });
    connect(tree_, &QTreeWidget::itemChanged, this, &SceneTreeDock::atomicRename);
    connect(tree_, &QTreeWidget::itemSelectionChanged, this, &SceneTreeDock::onSelected);
    connect(tree_, &QTreeWidget::itemActivated, this, &SceneTreeDock::onActivated);
    connect(tree_, &QWidget::customContextMenuRequested, this, &SceneTreeDock::showMenu);
    connect(&workbench_, &Workbench::projectOpened, this, &SceneTreeDock::load);
    connect(&workbench_.painted(), &PaintedModels::changed, this, &SceneTreeDock::count);
    connect(&workbench_, &Workbench::projectChanged, this, &SceneTreeDock::onProjectChanged);
    connect(&workbench_, &Workbench::settingsChanged, this, &SceneTreeDock::refreshSettings);
    connect(&workbench_.database(), &DatabaseSession::changed, this,
            &SceneTreeDock::followDatabases);
    connect(&workbench_, &Workbench::modelChosen, this, &SceneTreeDock::showChosen);
}

SceneTreeDock::~SceneTreeDock() = default;

void SceneTreeDock::onProjectChanged() {
    const Project& project = workbench_.project();
    if (!std::ranges::equal(project.models, models_, readAlike))
        load();
    else if (toldByTree(project) != filled_)
        fill();
}

void SceneTreeDock::followDatabases() {
    if (isLoading() || !workbench_.hasProject())
        return;
    const Project& project = workbench_.project();
    const DatabaseSession& session = workbench_.database();
    const auto edited = workbench_.editedDatabases();
    for (std::size_t i = 0; i < std::min(index_.size(), project.models.size()); ++i) {
        const auto file = project.resolve(project.models[i].database);
        if (const auto found = edited.find(file); found != edited.end())
            setDatabase(static_cast<int>(i), *found->second);
        else if (session.isOpen() && !file.empty() &&
                 std::filesystem::absolute(file).lexically_normal() == session.file())
            setDatabase(static_cast<int>(i), session.value());
    }
}

void SceneTreeDock::showChosen() {
    if (!workbench_.hasProject())
        return;
    const QSignalBlocker quiet(tree_);
    const auto chosen = static_cast<int>(workbench_.chosenModel());
    const bool areSeveral = workbench_.project().models.size() > 1;
    const auto* current = tree_->currentItem();
    const bool isElsewhere = current != nullptr && current->data(0, treeModelRole).isValid() &&
                             current->data(0, treeModelRole).toInt() != chosen;
    for (QTreeWidgetItemIterator it(tree_); *it != nullptr; ++it) {
        if (treePartOf(*it) != TreePart::model)
            continue;
        const bool isChosen = areSeveral && (*it)->data(0, treeModelRole).toInt() == chosen;
        QFont font = tree_->font();
        font.setBold(isChosen);
        (*it)->setFont(0, font);
        if (isChosen && isElsewhere)
            tree_->setCurrentItem(*it);
    }
}

void SceneTreeDock::rename(int model) {
    for (QTreeWidgetItemIterator it(tree_); *it != nullptr; ++it) {
        if (treePartOf(*it) == TreePart::model && (*it)->data(0, treeModelRole).toInt() == model) {
            tree_->setCurrentItem(*it);
            tree_->editItem(*it);
            return;
        }
    }
}

void SceneTreeDock::atomicRename(QTreeWidgetItem* item) {
    if (treePartOf(item) != TreePart::model)
        return;
    const auto model = static_cast<std::size_t>(item->data(0, treeModelRole).toInt());
    const std::string name = item->text(0).trimmed().toStdString();
    const auto& models = workbench_.project().models;
    // The name goes where the item may be gone.
    if (model < models.size() && name != models[model].shownName())
        QTimer::singleShot(0, this, [this, model, name] {
            if (model < workbench_.project().models.size())
                workbench_.renameModel(model, name);
            fill();
        });
}

void SceneTreeDock::changeEvent(QEvent* event) {
    QDockWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && workbench_.hasProject() && !index_.empty())
        fill();
}

QSet<QString> SceneTreeDock::openBranches() const {
    QSet<QString> open;
    for (QTreeWidgetItemIterator it(tree_); *it != nullptr; ++it)
        if ((*it)->isExpanded())
            open.insert(treeBranchOf(*it));
    return open;
}

void SceneTreeDock::load() {
    models_ = workbench_.project().models;
    loading_ = std::make_shared<Loading>();
    index_.assign(workbench_.project().models.size(), {});
    fill();
    count();
}

/// What is told meanwhile stays.
void SceneTreeDock::count() {
    loading_ = std::make_shared<Loading>();
    backgroundPool().start(
        [work = loading_, project = workbench_.project(), models = workbench_.models()] {
            work->index = loadSceneIndex(project, *models);
            work->done = true;
        });
    watch_.start();
}

void SceneTreeDock::setDatabase(int model, const irsg::SignatureDatabase& database) {
    if (isLoading())
        return;
    ModelIndex& one = index_.at(static_cast<std::size_t>(model));
    const ModelIndex before = one;
    for (auto* uses : {&one.temperatures, &one.materials}) {
        std::erase_if(*uses, [](const auto& use) { return use.second.faces == 0; });
        for (auto& [index, use] : *uses)
            use.hasEntry = false, use.name.clear();
    }
    const ProjectModel& of = workbench_.project().models.at(static_cast<std::size_t>(model));
    const ModelIndex entries = makeModelIndex(of, {}, database);
    for (auto [into, from, fallback] :
         {std::tuple{&one.temperatures, &entries.temperatures, of.fallbackTemperature},
          std::tuple{&one.materials, &entries.materials, of.fallbackMaterial}}) {
        for (const auto& [index, use] : *from) {
            (*into)[index].name = use.name;
            (*into)[index].hasEntry = true;
        }
        for (auto& [index, use] : *into)
            use.isReplaced = !use.hasEntry && fallback && from->contains(*fallback);
    }
    one.databaseProblem.clear();
    // Most edits change values, which are not shown here.
    if (saysTheSame(one, before))
        return;
    const auto* selected = tree_->currentItem();
    if (selected == nullptr || treePartOf(selected) != TreePart::index) {
        fill();
        return;
    }
    const auto kind = static_cast<IndexKind>(selected->data(0, treeKindRole).toInt());
    const int number = selected->data(0, treeNumberRole).toInt();
    const int ofModel = selected->data(0, treeModelRole).toInt();
    fill();
    showIndex(kind, number, ofModel);
}

void SceneTreeDock::showIndex(IndexKind kind, int index, int model) {
    for (QTreeWidgetItemIterator it(tree_); *it != nullptr; ++it) {
        if (treePartOf(*it) == TreePart::index && (*it)->data(0, treeModelRole).toInt() == model &&
            (*it)->data(0, treeKindRole).toInt() == static_cast<int>(kind) &&
            (*it)->data(0, treeNumberRole).toInt() == index) {
            const QSignalBlocker quiet(tree_);
            (*it)->parent()->setExpanded(true);
            tree_->setCurrentItem(*it);
            tree_->scrollToItem(*it);
        }
    }
}

void SceneTreeDock::onSelected() {
    const auto selected = tree_->selectedItems();
    if (!selected.isEmpty() && selected.front()->data(0, treeModelRole).isValid())
        workbench_.chooseModel(
            static_cast<std::size_t>(selected.front()->data(0, treeModelRole).toInt()));
    if (selected.isEmpty() || treePartOf(selected.front()) != TreePart::index) {
        emit nothingSelected();
        return;
    }
    const auto* item = selected.front();
    emit indexSelected(static_cast<IndexKind>(item->data(0, treeKindRole).toInt()),
                       item->data(0, treeNumberRole).toInt(), item->data(0, treeModelRole).toInt());
}

void SceneTreeDock::onActivated(QTreeWidgetItem* item) {
    const int model = item->data(0, treeModelRole).toInt();
    switch (treePartOf(item)) {
    case TreePart::model:
        if (!index_.at(static_cast<std::size_t>(model)).modelProblem.isEmpty())
            emit modelFileWanted(model);
        break;
    case TreePart::database:
        emit databaseFileWanted(model);
        break;
    case TreePart::sensor:
        emit sensorActivated();
        break;
    case TreePart::atmosphere:
        emit atmosphereActivated();
        break;
    case TreePart::sun:
        emit sunActivated();
        break;
    case TreePart::analysis:
        emit analysisActivated(item->text(0));
        break;
    case TreePart::index:
        emit indexActivated(static_cast<IndexKind>(item->data(0, treeKindRole).toInt()),
                            item->data(0, treeNumberRole).toInt(), model);
        break;
    case TreePart::project:
        emit propertiesWanted();
        break;
    case TreePart::group:
        break;
    }
}

void SceneTreeDock::showMenu(const QPoint& place) {
    const auto* item = tree_->itemAt(place);
    if (item == nullptr)
        return;
    const int model = item->data(0, treeModelRole).toInt();
    QMenu menu;
    if (treePartOf(item) == TreePart::project || treePartOf(item) == TreePart::model)
        menu.addAction(tr("&Add a model…"), this, &SceneTreeDock::addModelWanted);
    if (treePartOf(item) == TreePart::model) {
        const bool areSeveral = workbench_.project().models.size() > 1;
        menu.addAction(tr("Re&name"), this, [this, model] { rename(model); });
        menu.addAction(tr("Make it the &target"), this, [this, model] { emit targetWanted(model); })
            ->setEnabled(model > 0);
        menu.addAction(tr("&Remove from the scene"), this,
                       [this, model] { emit removeModelWanted(model); })
            ->setEnabled(areSeveral);
        menu.addSeparator();
    }
    if (treePartOf(item) == TreePart::model)
        menu.addAction(tr("Take another &model file…"), this,
                       [this, model] { emit modelFileWanted(model); });
    if (treePartOf(item) == TreePart::model || treePartOf(item) == TreePart::database)
        menu.addAction(tr("Take another signature &database…"), this,
                       [this, model] { emit databaseFileWanted(model); });
    if (treePartOf(item) == TreePart::analysis) {
        menu.addAction(tr("&New analysis from this…"), this,
                       [this, name = item->text(0)] { emit analysisActivated(name); });
        menu.addAction(tr("&Remove from the project"), this,
                       [this, name = item->text(0)] { emit removeAnalysisWanted(name); });
    }
    if (treePartOf(item) == TreePart::project || treePartOf(item) == TreePart::model)
        menu.addAction(tr("&Properties…"), this, &SceneTreeDock::propertiesWanted);
    if (!menu.isEmpty())
        menu.exec(tree_->viewport()->mapToGlobal(place));
}

} // namespace smat::gui

#include "moc_SceneTreeDock.cpp"
