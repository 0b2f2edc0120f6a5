#pragma once

#include <set>
#include <vector>

#include <QAbstractTableModel>
#include <QWidget>

#include "gui/widgets/NumericTableView.h"
#include "irsg/signature/ReflectanceTable.h"
#include "irsg/signature/SignatureDatabase.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace smat::gui {

/// A table of reflectance over directions: a row a direction, a column a wavelength behind the
/// angles. Takes what the type allows. The angles of a BRDF make a grid and stay.
class ReflectanceModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    using QAbstractTableModel::QAbstractTableModel;

    void setTable(const irsg::ReflectanceTable& table);
    const irsg::ReflectanceTable& table() const { return table_; }
    /// Why a text cannot stand in a cell; empty where it can.
    QString problemOf(const QModelIndex& cell, const QString& text) const;
    /// A direction half way from row `row` to the next one, between their values, or a new last
    /// one; of directional-hemispherical reflectance.
    void insertAfter(int row);
    /// Leaves one row at the least.
    void remove(const std::set<int>& rows);
    /// Puts a block of numbers at a cell, in rows that there are. Answers why it cannot be; empty
    /// where it is done.
    QString pasteAt(const QModelIndex& cell, const std::vector<std::vector<double>>& block);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  signals:
    /// By the user. `what` ends the name of the step.
    void edited(const irsg::ReflectanceTable& table, const QString& what);

  private:
    int angles() const { return table_.isBrdf() ? 3 : 1; }
    QString unitOf(const QModelIndex& cell) const {
        return cell.column() < angles() ? QStringLiteral("deg") : QString();
    }
    std::vector<irsg::ReflectanceTable::Row> with(const QModelIndex& cell, double value) const;
    void put(irsg::ReflectanceTable::Row& row, int column, double value) const;
    void take(std::vector<irsg::ReflectanceTable::Row> rows, const QString& what);

    irsg::ReflectanceTable table_;
};

/// The rows of a table of reflectance.
class ReflectanceView : public NumericTableView {
    Q_OBJECT

  public:
    ReflectanceView(ReflectanceModel& model, QWidget* parent);

    void insertRow() override;
    void removeRows() override;

  private:
    QString pasteAt(const QModelIndex& cell, const Rows& block) override;

    ReflectanceModel& model_;
};

/// The table beside its buttons, and where there is none yet, a button that makes one of emissivity
/// and transmissivity.
class ReflectanceEditor : public QWidget {
    Q_OBJECT

  public:
    explicit ReflectanceEditor(QWidget* parent);
    void show(const irsg::Material& material, const irsg::SpectralRange& band);

  signals:
    void edited(const irsg::ReflectanceTable& table, const QString& what);
    void gestureEnded();

  private:
    irsg::ReflectanceTable ofEmissivity() const;
    void refuse(const QString& problem);

    ReflectanceModel* model_ = nullptr;
    ReflectanceView* view_ = nullptr;
    QPushButton* begin_ = nullptr;
    QToolButton *insert_ = nullptr, *remove_ = nullptr;
    QLabel* message_ = nullptr;
    irsg::Material material_;
    irsg::SpectralRange band_;
};

} // namespace smat::gui
