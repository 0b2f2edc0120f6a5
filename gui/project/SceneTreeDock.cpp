#include "gui/project/SceneTreeDock.h"

#include <algorithm>
#include <atomic>

#include <QEvent>
#include <QHeaderView>
#include <QMenu>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "gui/Workbench.h"
#include "gui/widgets/BackgroundPool.h"
#include "gui/widgets/Readable.h"
#include "gui/widgets/Theme.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/EnvironmentInput.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

/// What an item of the tree stands for, and where it is kept in the item.
enum class TreePart { project, model, database, group, index, sensor, atmosphere, sun, analysis };
constexpr int partRole = Qt::UserRole, modelRole = Qt::UserRole + 1, kindRole = Qt::UserRole + 2,
              numberRole = Qt::UserRole + 3;

TreePart partOf(const QTreeWidgetItem* item) {
    return static_cast<TreePart>(item->data(0, partRole).toInt());
}

QTreeWidgetItem* add(QTreeWidgetItem* parent, TreePart part, const QString& text,
                     const QString& detail = {}, const QString& drawing = {}) {
    auto* item = new QTreeWidgetItem(parent, {text, detail});
    item->setData(0, partRole, static_cast<int>(part));
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    if (!drawing.isEmpty())
        item->setIcon(0, icon(drawing));
    return item;
}

/// Marks an item as in need of attention.
void warn(QTreeWidgetItem* item, const QString& why) {
    item->setIcon(0, icon("warning"));
    item->setToolTip(0, why);
    item->setToolTip(1, why);
    const bool dark = isDark(item->treeWidget()->palette());
    for (int column = 0; column < 2; ++column)
        item->setForeground(column, dark ? QColor("#ff9a6b") : QColor("#c2410c"));
}

/// Which branch of the tree an item is, whatever stands in it.
QString branchOf(const QTreeWidgetItem* item) {
    const QString own = QString::number(static_cast<int>(partOf(item))) + "/" +
                        item->data(0, modelRole).toString() + "/" +
                        (partOf(item) == TreePart::group ? item->text(0) : QString());
    return item->parent() == nullptr ? own : branchOf(item->parent()) + ">" + own;
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
    tree_->setMinimumWidth(300);
    auto* nothing = new QTreeWidgetItem(tree_, {tr("nothing is open yet")});
    nothing->setFlags(Qt::NoItemFlags);
    setWidget(tree_);
    const auto followDatabase = [this] {
        if (!index_.empty() && workbench_.database().isOpen())
            setDatabase(0, workbench_.database().value());
    };
    watch_.setInterval(20);
    connect(&watch_, &QTimer::timeout, this, [this, followDatabase] {
        if (!loading_->done)
            return;
        watch_.stop();
        index_ = std::move(std::exchange(loading_, nullptr)->index);
        fill();
        followDatabase();
    });
    connect(tree_, &QTreeWidget::itemSelectionChanged, this, &SceneTreeDock::onSelected);
    connect(tree_, &QTreeWidget::itemActivated, this, &SceneTreeDock::onActivated);
    connect(tree_, &QWidget::customContextMenuRequested, this, &SceneTreeDock::showMenu);
    connect(&workbench_, &Workbench::projectOpened, this, &SceneTreeDock::load);
    connect(&workbench_.painted(), &PaintedModels::changed, this, &SceneTreeDock::count);
    connect(&workbench_, &Workbench::projectChanged, this, &SceneTreeDock::onProjectChanged);
    connect(&workbench_, &Workbench::settingsChanged, this, &SceneTreeDock::refreshSettings);
    connect(&workbench_.database(), &DatabaseSession::changed, this, followDatabase);
}

SceneTreeDock::~SceneTreeDock() = default;

void SceneTreeDock::onProjectChanged() {
    if (workbench_.project().models != models_)
        load();
    else
        fill();
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
            open.insert(branchOf(*it));
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
    if (selected == nullptr || partOf(selected) != TreePart::index) {
        fill();
        return;
    }
    const auto kind = static_cast<IndexKind>(selected->data(0, kindRole).toInt());
    const int number = selected->data(0, numberRole).toInt();
    const int ofModel = selected->data(0, modelRole).toInt();
    fill();
    showIndex(kind, number, ofModel);
}

void SceneTreeDock::fill() {
    const QSignalBlocker quiet(tree_);
    const QSet<QString> open = openBranches();
    tree_->clear();
    const Project& project = workbench_.project();
    auto* root = new QTreeWidgetItem(
        tree_, {textOf(project.title.empty() ? project.displayName() : project.title)});
    root->setData(0, partRole, static_cast<int>(TreePart::project));
    root->setIcon(0, icon("smat"));
    root->setToolTip(0, textOf(project.file.empty() ? "not saved yet" : project.file.string()));
    QFont bold = root->font(0);
    bold.setBold(true);
    root->setFont(0, bold);
    for (std::size_t i = 0; i < project.models.size(); ++i)
        fillModel(root, i);
    sensor_ = add(root, TreePart::sensor, {}, {}, "sensor");
    atmosphere_ = add(root, TreePart::atmosphere, {}, {}, "air");
    sun_ = add(root, TreePart::sun, {}, {}, "sun");
    auto* analyses = add(root, TreePart::group, tr("Analyses"), {}, "folder");
    for (const auto& analysis : project.analyses) {
        auto* item = add(analyses, TreePart::analysis, textOf(analysis.name), {},
                         textOf(name(analysis.kind)));
        item->setToolTip(0, textOf(analysis.notes));
    }
    if (project.analyses.empty())
        add(analyses, TreePart::group, tr("none in this project"))->setDisabled(true);
    refreshSettings();
    root->setExpanded(true);
    analyses->setExpanded(true);
    for (QTreeWidgetItemIterator it(tree_); *it != nullptr; ++it)
        if (open.contains(branchOf(*it)))
            (*it)->setExpanded(true);
}

void SceneTreeDock::fillModel(QTreeWidgetItem* root, std::size_t number) {
    const Project& project = workbench_.project();
    const ProjectModel& model = project.models[number];
    const ModelIndex& index = index_.at(number);
    const std::string name = model.name.empty() ? model.file.stem().string() : model.name;
    auto* item =
        add(root, TreePart::model, textOf(name), isLoading() ? tr("reading…") : QString(), "model");
    item->setToolTip(0, textOf(project.resolve(model.file).string()));
    auto* database = add(item, TreePart::database,
                         model.database.empty() ? tr("no signature database")
                                                : textOf(model.database.filename().string()),
                         {}, "database");
    database->setToolTip(0, textOf(project.resolve(model.database).string()));
    for (auto* one : {item, database})
        one->setData(0, modelRole, static_cast<int>(number));
    item->setExpanded(true);
    if (isLoading())
        return;

    if (!index.modelProblem.isEmpty()) {
        warn(item, index.modelProblem);
        item->setText(1, tr("unreadable"));
    }
    if (model.database.empty())
        warn(database, tr("Without a signature database nothing can be analysed. Press Enter to "
                          "choose one."));
    else if (!index.databaseProblem.isEmpty())
        warn(database, index.databaseProblem);
    fillIndices(item, number, IndexKind::temperature);
    fillIndices(item, number, IndexKind::material);
}

void SceneTreeDock::fillIndices(QTreeWidgetItem* parent, std::size_t model, IndexKind kind) {
    const bool isTemperature = kind == IndexKind::temperature;
    const auto& uses = isTemperature ? index_[model].temperatures : index_[model].materials;
    const bool hasDatabase = !workbench_.project().models[model].database.empty() &&
                             index_[model].databaseProblem.isEmpty();
    auto* group = add(parent, TreePart::group, isTemperature ? tr("Temperatures") : tr("Materials"),
                      QString::number(uses.size()), "folder");
    group->setHidden(uses.empty());
    bool missing = false;
    for (const auto& [number, use] : uses) {
        const QString name = use.hasEntry     ? (use.name.isEmpty() ? tr("unnamed") : use.name)
                             : use.isReplaced ? tr("(the fallback stands in)")
                                              : tr("(no entry)");
        auto* item = add(group, TreePart::index, QStringLiteral("%1  %2").arg(number).arg(name),
                         use.faces > 0 ? QString::number(use.faces) : QStringLiteral("–"));
        item->setData(0, modelRole, static_cast<int>(model));
        item->setData(0, kindRole, static_cast<int>(kind));
        item->setData(0, numberRole, number);
        item->setToolTip(1, tr("%1 faces, %2 m²").arg(use.faces).arg(use.area_m2, 0, 'g', 4));
        if (use.faces == 0)
            item->setForeground(0, tree_->palette().color(QPalette::PlaceholderText));
        if (use.isMissing() && hasDatabase) {
            warn(item, tr("%1 faces have this index, and the database has no entry for it")
                           .arg(use.faces));
            missing = true;
        }
    }
    if (missing) {
        warn(group, tr("Some indices have no entry in the database"));
        group->setExpanded(true);
    }
}

void SceneTreeDock::refreshSettings() {
    if (sensor_ == nullptr)
        return;
    const Settings& settings = workbench_.settings();
    const auto unit = [](const std::string& key) { return readableUnit(settingInfo(key).unit); };
    QStringList responses;
    for (const auto& file : settings[key::sensorResponse])
        responses << textOf(file.filename().string());
    const QString bands = textOf(settings.text(key::sensorBand)).replace(",", ", ");
    sensor_->setText(
        0,
        tr("Sensor %1 × %2 px, %3%4, %5")
            .arg(textOf(settings.text(key::sensorWidth)), textOf(settings.text(key::sensorHeight)),
                 textOf(settings.text(key::sensorFov)), unit(key::sensorFov),
                 responses.isEmpty() ? bands + " " + unit(key::sensorBand) : responses.join(", ")));
    QStringList airs;
    for (const auto& file : settings[key::environmentAtmospheres])
        airs << textOf(file.filename().string());
    atmosphere_->setText(0, airs.isEmpty() ? tr("No atmosphere")
                                           : tr("Atmosphere %1").arg(airs.join(", ")));
    // As analyses take it: an Environment file may give it.
    const irsg::SunPosition sun = sunOf(workbench_.project(), settings);
    sun_->setText(0, tr("Sun %1° azimuth, %2° elevation")
                         .arg(irsg::degrees(sun.azimuth_rad), 0, 'g', 6)
                         .arg(irsg::degrees(sun.elevation_rad), 0, 'g', 6));
    for (auto* item : {sensor_, atmosphere_, sun_}) {
        item->setFirstColumnSpanned(true);
        item->setToolTip(0, tr("Press Enter or double-click to change it"));
    }
}

void SceneTreeDock::showIndex(IndexKind kind, int index, int model) {
    for (QTreeWidgetItemIterator it(tree_); *it != nullptr; ++it) {
        if (partOf(*it) == TreePart::index && (*it)->data(0, modelRole).toInt() == model &&
            (*it)->data(0, kindRole).toInt() == static_cast<int>(kind) &&
            (*it)->data(0, numberRole).toInt() == index) {
            const QSignalBlocker quiet(tree_);
            (*it)->parent()->setExpanded(true);
            tree_->setCurrentItem(*it);
            tree_->scrollToItem(*it);
        }
    }
}

void SceneTreeDock::onSelected() {
    const auto selected = tree_->selectedItems();
    if (selected.isEmpty() || partOf(selected.front()) != TreePart::index) {
        emit nothingSelected();
        return;
    }
    const auto* item = selected.front();
    emit indexSelected(static_cast<IndexKind>(item->data(0, kindRole).toInt()),
                       item->data(0, numberRole).toInt(), item->data(0, modelRole).toInt());
}

void SceneTreeDock::onActivated(QTreeWidgetItem* item) {
    const int model = item->data(0, modelRole).toInt();
    switch (partOf(item)) {
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
        emit indexActivated(static_cast<IndexKind>(item->data(0, kindRole).toInt()),
                            item->data(0, numberRole).toInt(), model);
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
    const int model = item->data(0, modelRole).toInt();
    QMenu menu;
    if (partOf(item) == TreePart::model)
        menu.addAction(tr("Take another &model file…"), this,
                       [this, model] { emit modelFileWanted(model); });
    if (partOf(item) == TreePart::model || partOf(item) == TreePart::database)
        menu.addAction(tr("Take another signature &database…"), this,
                       [this, model] { emit databaseFileWanted(model); });
    if (partOf(item) == TreePart::analysis) {
        menu.addAction(tr("&New analysis from this…"), this,
                       [this, name = item->text(0)] { emit analysisActivated(name); });
        menu.addAction(tr("&Remove from the project"), this,
                       [this, name = item->text(0)] { emit removeAnalysisWanted(name); });
    }
    if (partOf(item) == TreePart::project || partOf(item) == TreePart::model)
        menu.addAction(tr("&Properties…"), this, &SceneTreeDock::propertiesWanted);
    if (!menu.isEmpty())
        menu.exec(tree_->viewport()->mapToGlobal(place));
}

} // namespace smat::gui
