#include "gui/project/SceneTreeItems.h"

#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "gui/project/SceneTreeDock.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/ThemeColors.h"
#include "gui/workbench/Workbench.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/EnvironmentInput.h"
#include "smatcore/settings/SettingKeys.h"

// The part of the scene tree that fills it.

namespace smat::gui {

TreePart treePartOf(const QTreeWidgetItem* item) {
    return static_cast<TreePart>(item->data(0, treePartRole).toInt());
}

QTreeWidgetItem* addTreeItem(QTreeWidgetItem* parent, TreePart part, const QString& text,
                             const QString& detail, const QString& drawing) {
    auto* item = new QTreeWidgetItem(parent, {text, detail});
    item->setData(0, treePartRole, static_cast<int>(part));
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    if (!drawing.isEmpty())
        item->setIcon(0, icon(drawing));
    return item;
}

/// Marks an item as in need of attention.
void warnTreeItem(QTreeWidgetItem* item, const QString& why) {
    item->setIcon(0, icon("warning"));
    item->setToolTip(0, why);
    item->setToolTip(1, why);
    for (int column = 0; column < 2; ++column)
        item->setForeground(column, colors::warningText(item->treeWidget()->palette()));
}

/// Which branch of the tree an item is, whatever stands in it.
QString treeBranchOf(const QTreeWidgetItem* item) {
    const QString own = QString::number(static_cast<int>(treePartOf(item))) + "/" +
                        item->data(0, treeModelRole).toString() + "/" +
                        (treePartOf(item) == TreePart::group ? item->text(0) : QString());
    return item->parent() == nullptr ? own : treeBranchOf(item->parent()) + ">" + own;
}

/// Of a project, what the tree tells of it.
Project toldByTree(const Project& project) {
    Project told = project;
    told.settings = {};
    for (ProjectModel& model : told.models) {
        model.pose = {};
        model.own = {};
    }
    return told;
}

void SceneTreeDock::fill() {
    const QSignalBlocker quiet(tree_);
    const QSet<QString> open = openBranches();
    tree_->clear();
    const Project& project = workbench_.project();
    filled_ = toldByTree(project);
    auto* root = new QTreeWidgetItem(
        tree_, {textOf(project.title.empty() ? project.displayName() : project.title)});
    root->setData(0, treePartRole, static_cast<int>(TreePart::project));
    root->setIcon(0, icon("smat"));
    root->setToolTip(0, textOf(project.file.empty() ? "not saved yet" : project.file.string()));
    QFont bold = root->font(0);
    bold.setBold(true);
    root->setFont(0, bold);
    for (std::size_t i = 0; i < project.models.size(); ++i)
        fillModel(root, i);
    sensor_ = addTreeItem(root, TreePart::sensor, {}, {}, "sensor");
    atmosphere_ = addTreeItem(root, TreePart::atmosphere, {}, {}, "air");
    sun_ = addTreeItem(root, TreePart::sun, {}, {}, "sun");
    auto* analyses = addTreeItem(root, TreePart::group, tr("Analyses"), {}, "folder");
    for (const auto& analysis : project.analyses) {
        auto* item = addTreeItem(analyses, TreePart::analysis, textOf(analysis.name), {},
                                 textOf(name(analysis.kind)));
        item->setToolTip(0, textOf(analysis.notes));
    }
    if (project.analyses.empty())
        addTreeItem(analyses, TreePart::group, tr("none in this project"))->setDisabled(true);
    refreshSettings();
    root->setExpanded(true);
    analyses->setExpanded(true);
    for (QTreeWidgetItemIterator it(tree_); *it != nullptr; ++it)
        if (open.contains(treeBranchOf(*it)))
            (*it)->setExpanded(true);
    showChosen();
}

void SceneTreeDock::fillModel(QTreeWidgetItem* root, std::size_t number) {
    const Project& project = workbench_.project();
    const ProjectModel& model = project.models[number];
    const ModelIndex& index = index_.at(number);
    auto* item = addTreeItem(root, TreePart::model, textOf(model.shownName()),
                             isLoading() ? tr("reading…") : QString(), "model");
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    const QString file = textOf(project.resolve(model.file).string());
    item->setToolTip(0, number == 0 && project.models.size() > 1
                            ? tr("The target, the one the camera looks at: %1").arg(file)
                            : file);
    auto* database =
        addTreeItem(item, TreePart::database,
                    model.database.empty() ? tr("no signature database")
                                           : textOf(model.database.filename().string()),
                    {}, "database");
    database->setToolTip(0, textOf(project.resolve(model.database).string()));
    for (auto* one : {item, database})
        one->setData(0, treeModelRole, static_cast<int>(number));
    item->setExpanded(true);
    if (isLoading())
        return;

    if (!index.modelProblem.isEmpty()) {
        warnTreeItem(item, index.modelProblem);
        item->setText(1, tr("unreadable"));
    }
    if (model.database.empty())
        warnTreeItem(database,
                     tr("Analyses need a signature database. Press Enter to choose one."));
    else if (!index.databaseProblem.isEmpty())
        warnTreeItem(database, index.databaseProblem);
    fillIndices(item, number, IndexKind::temperature);
    fillIndices(item, number, IndexKind::material);
}

void SceneTreeDock::fillIndices(QTreeWidgetItem* parent, std::size_t model, IndexKind kind) {
    const bool isTemperature = kind == IndexKind::temperature;
    const auto& uses = isTemperature ? index_[model].temperatures : index_[model].materials;
    const bool hasDatabase = !workbench_.project().models[model].database.empty() &&
                             index_[model].databaseProblem.isEmpty();
    auto* group =
        addTreeItem(parent, TreePart::group, isTemperature ? tr("Temperatures") : tr("Materials"),
                    QString::number(uses.size()), "folder");
    group->setHidden(uses.empty());
    group->setData(0, treeModelRole, static_cast<int>(model));
    bool missing = false;
    for (const auto& [number, use] : uses) {
        const QString name = use.hasEntry     ? (use.name.isEmpty() ? tr("unnamed") : use.name)
                             : use.isReplaced ? tr("(the fallback stands in)")
                                              : tr("(no entry)");
        auto* item =
            addTreeItem(group, TreePart::index, QStringLiteral("%1  %2").arg(number).arg(name),
                        use.faces > 0 ? QString::number(use.faces) : QStringLiteral("–"));
        item->setData(0, treeModelRole, static_cast<int>(model));
        item->setData(0, treeKindRole, static_cast<int>(kind));
        item->setData(0, treeNumberRole, number);
        item->setToolTip(1, tr("%1 faces, %2 m²").arg(use.faces).arg(use.area_m2, 0, 'g', 4));
        if (use.faces == 0)
            item->setForeground(0, tree_->palette().color(QPalette::PlaceholderText));
        if (use.isMissing() && hasDatabase) {
            warnTreeItem(item, tr("%1 faces have this index, and the database has no entry for it")
                                   .arg(use.faces));
            missing = true;
        }
    }
    if (missing) {
        warnTreeItem(group, tr("Some indices have no entry in the database"));
        group->setExpanded(true);
    }
}

void SceneTreeDock::refreshSettings() {
    if (sensor_ == nullptr)
        return;
    const Settings& settings = workbench_.settings();
    const auto unit = [](const std::string& key) { return formattedUnit(settingInfo(key).unit); };
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

} // namespace smat::gui
