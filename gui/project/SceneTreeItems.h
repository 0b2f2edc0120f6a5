#pragma once

#include <QTreeWidgetItem>

#include "gui/widgets/Theme.h"
#include "smatcore/project/Project.h"

namespace smat::gui {

/// What an item of the scene tree stands for, and where it is kept in the item.
enum class TreePart { project, model, database, group, index, sensor, atmosphere, sun, analysis };
constexpr int treePartRole = Qt::UserRole, treeModelRole = Qt::UserRole + 1,
              treeKindRole = Qt::UserRole + 2, treeNumberRole = Qt::UserRole + 3;

TreePart treePartOf(const QTreeWidgetItem* item);
QTreeWidgetItem* addTreeItem(QTreeWidgetItem* parent, TreePart part, const QString& text,
                             const QString& detail = {}, const QString& drawing = {});
/// Marks an item as in need of attention.
void warnTreeItem(QTreeWidgetItem* item, const QString& why);
/// Which branch of the tree an item is, whatever stands in it.
QString treeBranchOf(const QTreeWidgetItem* item);
/// Of a project, what the tree tells of it.
Project toldByTree(const Project& project);

} // namespace smat::gui
