#pragma once

#include <QWidget>

#include "gui/database/EditorContext.h"
#include "gui/database/EntryNumbers.h"

class QCheckBox;
class QComboBox;
class QTabBar;
class QTreeWidget;
class QTreeWidgetItem;

namespace smat::gui {

class NodeEditor;

/// The factors c_j(t, angle) of the components of a user-defined spectrum (eq. 6): a constant, and
/// tables over time, which may loop, and over the angle from the nose axis, and which of them
/// counts.
class FactorsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit FactorsPanel(EditorContext& context, QWidget* parent = nullptr);

    /// `spectrum` may be null where the entry names none.
    void setFactors(const irsg::ComponentFactors& factors, const irsg::UserSpectrum* spectrum,
                    const irsg::EntityState& state);

  signals:
    void edited(const irsg::ComponentFactors& factors, const QString& field, const QString& what);
    void gestureEnded();

  private:
    using Row = irsg::EntryField<irsg::ComponentFactor>;

    irsg::ComponentFactor shownFactor() const;
    /// The table of the tab that is in front.
    const Row& shownRow() const;
    /// The factor of the shown component, made where there is none.
    irsg::ComponentFactor& factor();
    /// Factors that say nothing are left out.
    void push(const QString& field, const QString& what);
    void showList();
    void showTable();
    void importTable();

    EditorContext& context_;
    irsg::ComponentFactors factors_;
    irsg::UserSpectrum spectrum_;
    irsg::EntityState state_;
    QString component_;
    QTreeWidget* list_ = nullptr;
    QTabBar* axis_ = nullptr;
    std::vector<const Row*> rows_; ///< of the tabs
    const Row* shownRow_ = nullptr;
    const Row* constantRow_ = nullptr;
    NumberField* constant_ = nullptr;
    const Row* selectionRow_ = nullptr;
    QComboBox* selection_ = nullptr;
    QCheckBox* loop_ = nullptr;
    NodeEditor* nodes_ = nullptr;
};

} // namespace smat::gui
