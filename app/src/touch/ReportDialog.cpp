// SPDX-License-Identifier: BSD-3-Clause
#include "touch/ReportDialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>

namespace palpate::app {

namespace {

constexpr auto kExaminerKey = "report/examiner";
constexpr int kWidth_px = 400; // of the fields with their names

} // namespace

ReportDialog::ReportDialog(QWidget* parent)
    : QDialog(parent)
    , m_case(new QLineEdit(this))
    , m_examiner(new QLineEdit(QSettings().value(QLatin1String(kExaminerKey)).toString(), this))
{
    setWindowTitle(tr("Report"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* explanation = new QLabel(tr("The report contains views, findings, lumps, distances and the force of the open "
                                      "recording. Both fields may stay empty."),
                                   this);
    explanation->setWordWrap(true);
    explanation->setMinimumWidth(kWidth_px); // its height follows from the width
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(tr("Write report…"), QDialogButtonBox::AcceptRole)->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* form = new QFormLayout(this);
    form->addRow(explanation);
    form->addRow(tr("&Case"), m_case);
    form->addRow(tr("&Examiner"), m_examiner);
    form->addRow(buttons);
}

QString ReportDialog::caseText() const
{
    return m_case->text().trimmed();
}

QString ReportDialog::examiner() const
{
    return m_examiner->text().trimmed();
}

void ReportDialog::accept()
{
    QSettings().setValue(QLatin1String(kExaminerKey), examiner());
    QDialog::accept();
}

} // namespace palpate::app

#include "moc_ReportDialog.cpp"
