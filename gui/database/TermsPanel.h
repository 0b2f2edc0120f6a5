#pragma once

#include <vector>

#include <QWidget>

#include "gui/database/EntryNumbers.h"
#include "irsg/signature/SurfaceTemperature.h"

class QCheckBox;
class QTabBar;

namespace smat::gui {

class NodeEditor;

/// The terms of eq. 7: its numbers, and its lookup tables of which one is shown at a time.
class TermsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit TermsPanel(QWidget* parent = nullptr);

    void setTerms(const irsg::TemperatureTerms& terms);
    QTabBar* tables() const { return tables_; }

  signals:
    /// By the user. `field` names what was edited, for merging; `what` is the name of the step less
    /// its entry: "T0", "f(power) at 0.5".
    void edited(const irsg::TemperatureTerms& terms, const QString& field, const QString& what);
    void gestureEnded();

  private:
    using Row = irsg::EntryField<irsg::TemperatureTerms>;

    /// The table of the tab that is in front.
    const Row& shownRow() const;
    void showTable();

    irsg::TemperatureTerms terms_;
    EntryNumbers<irsg::TemperatureTerms> numbers_;
    std::vector<const Row*> rows_; ///< of the tabs
    const Row* shownRow_ = nullptr;
    QTabBar* tables_ = nullptr;
    QCheckBox* loop_ = nullptr;
    NodeEditor* nodes_ = nullptr;
};

} // namespace smat::gui
