#pragma once

#include <QDialog>

namespace smat::gui {

struct ResultEntry;

/// How a result came to be: the command line that makes it from a terminal, with a button that
/// copies it, and every line of its provenance.
class ResultDetailsDialog : public QDialog {
    Q_OBJECT

  public:
    explicit ResultDetailsDialog(const ResultEntry& entry, QWidget* parent = nullptr);
};

} // namespace smat::gui
