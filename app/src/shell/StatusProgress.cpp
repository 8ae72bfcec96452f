// SPDX-License-Identifier: BSD-3-Clause
#include "shell/StatusProgress.h"

#include <palpate/ui/HintLine.h>

#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

namespace palpate::app {

namespace {

constexpr int kProgressSteps = 1000;

} // namespace

StatusProgress::StatusProgress(QStatusBar& bar, ui::HintLine& hint, QObject* parent)
    : QObject(parent)
    , m_hint(hint)
    , m_bar(new QProgressBar(&bar))
    , m_cancel(new QToolButton(&bar))
{
    m_bar->setRange(0, kProgressSteps);
    m_bar->setFixedWidth(180);
    m_bar->setAccessibleName(tr("Progress"));
    m_cancel->setText(tr("Cancel"));
    m_cancel->setToolTip(tr("Cancel; the open scene does not change"));
    connect(m_cancel, &QToolButton::clicked, this, &StatusProgress::cancelled);
    bar.addWidget(m_bar);
    bar.addWidget(m_cancel);
    hide();
}

void StatusProgress::show(const QString& step, double share)
{
    m_hint.setText(step);
    m_bar->setRange(0, kProgressSteps);
    m_bar->setValue(static_cast<int>(share * kProgressSteps));
    m_bar->show();
    m_cancel->show();
}

void StatusProgress::showBusy()
{
    m_bar->setRange(0, 0);
    m_bar->show();
    m_cancel->show();
}

void StatusProgress::hide()
{
    m_bar->hide();
    m_cancel->hide();
}

void StatusProgress::end()
{
    hide();
    m_hint.say({});
}

bool StatusProgress::isVisible() const
{
    return m_bar->isVisible();
}

} // namespace palpate::app

#include "moc_StatusProgress.cpp"
