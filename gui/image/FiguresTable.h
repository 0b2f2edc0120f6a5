#pragma once

#include <QList>
#include <QStringList>
#include <QTableWidget>

namespace smat::gui {

/// A table of numbers to read and to copy: Ctrl+C copies the selected cells, or all with their
/// headings where nothing is selected, separated by tabs and line breaks.
class FiguresTable : public QTableWidget {
    Q_OBJECT

  public:
    explicit FiguresTable(QWidget* parent = nullptr);

    /// Rows of as many cells as there are headings (LogicError).
    void setFigures(const QStringList& headings, const QList<QStringList>& rows);
    /// Everything, as Ctrl+C copies it.
    QString allText() const;
    void copy() const;

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    /// In a narrow table the names in the first column give way to the numbers and wrap.
    void fitColumns();
};

} // namespace smat::gui
