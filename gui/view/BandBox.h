#pragma once

#include <QComboBox>
#include <QStringList>

namespace smat::gui {

class Workbench;

/// The sensor's band at hand: MWIR, LWIR, those that the project names anywhere, and any other as
/// it is typed ("3.4-4.1", um). A choice is a step that can be undone.
class BandBox : public QComboBox {
    Q_OBJECT

  public:
    explicit BandBox(Workbench& workbench, QWidget* parent = nullptr);

  signals:
    /// What was typed is no band: a sentence each.
    void refused(const QStringList& sentences);

  private:
    void fill();
    void choose(const QString& band);
    void addBand(const QString& band, const QString& name = {});

    Workbench& workbench_;
};

} // namespace smat::gui
