#pragma once

#include <QDialog>

namespace smat::gui {

struct ResultEntry;

/// How a result came to be: the command line that makes it from a terminal, with a button that
/// copies it, every line of its provenance, and, after a run, how long each of its stages took.
class ResultDetailsDialog : public QDialog {
    Q_OBJECT

  public:
    explicit ResultDetailsDialog(const ResultEntry& entry, QWidget* parent = nullptr);
};

} // namespace smat::gui
