// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QString>

class QLineEdit;

namespace palpate::app {

/// Asks for the free texts of a report. The examiner is remembered, the case is not.
class ReportDialog : public QDialog
{
    Q_OBJECT
  public:
    explicit ReportDialog(QWidget* parent);

    [[nodiscard]] QString caseText() const;
    [[nodiscard]] QString examiner() const;
    void accept() override;

  private:
    QLineEdit* m_case = nullptr;
    QLineEdit* m_examiner = nullptr;
};

} // namespace palpate::app
