// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Pieces.h"

#include "palpate/ui/Theme.h"

#include <palpate/meshio/MeshFormats.h>

#include <QFileInfo>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace palpate::ui {

WelcomePage::WelcomePage(QWidget* parent)
    : QWidget(parent)
    , m_phantom(new QPushButton(tr("Try the phantom"), this))
    , m_recentTitle(new QLabel(tr("Recent"), this))
    , m_recent(new QVBoxLayout)
    , m_card(new QWidget(this))
{
    auto* title = new QLabel(tr("Feel segmented anatomy"), m_card);
    keepFont(*title, 2.0, QFont::DemiBold);
    title->setAlignment(Qt::AlignCenter);
    auto* hint = new QLabel(tr("Drop surface meshes or a scene here: %1")
                                .arg(QString::fromStdString(meshio::meshFormatNames(tr("or").toStdString()))),
                            m_card);
    hint->setAlignment(Qt::AlignCenter);
    hint->setForegroundRole(QPalette::PlaceholderText);
    hint->setWordWrap(true);
    auto* open = new QPushButton(icon(Symbol::Open), tr("Open anatomy…"), m_card);
    open->setDefault(true);
    open->setObjectName(QStringLiteral("openAnatomy"));
    open->setToolTip(tr("Open mesh or scene files (Ctrl+O)"));
    m_phantom->setParent(m_card);
    m_phantom->setIcon(icon(Symbol::Hand));
    m_phantom->setToolTip(tr("Open the bundled phantom: a liver with two lumps and a recorded palpation"));
    for (QPushButton* button : {open, m_phantom}) {
        keepIconSize(*button, 24);
        button->setMinimumSize(180, 46);
    }
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(14);
    buttons->addStretch(1);
    buttons->addWidget(open);
    buttons->addWidget(m_phantom);
    buttons->addStretch(1);
    auto* how = new QLabel(
        tr("Then click Palpate and drag on the anatomy to press; the wheel sets the depth. Press ? for all keys."),
        m_card);
    how->setWordWrap(true);
    how->setAlignment(Qt::AlignCenter);
    how->setForegroundRole(QPalette::PlaceholderText);
    m_recentTitle->setParent(m_card);
    QFont bold = font();
    bold.setBold(true);
    m_recentTitle->setFont(bold);
    m_recent->setSpacing(2);

    auto* card = new QVBoxLayout(m_card);
    card->setContentsMargins(36, 40, 36, 32);
    card->setSpacing(12);
    card->addWidget(title);
    card->addWidget(hint);
    card->addSpacing(10);
    card->addLayout(buttons);
    card->addSpacing(2);
    card->addWidget(how);
    card->addSpacing(10);
    card->addWidget(m_recentTitle);
    card->addLayout(m_recent);
    auto* layout = new QVBoxLayout(this);
    layout->addStretch(2);
    auto* middle = new QHBoxLayout;
    middle->addStretch(1);
    middle->addWidget(m_card, 100);
    middle->addStretch(1);
    layout->addLayout(middle);
    layout->addStretch(3);
    connect(open, &QPushButton::clicked, this, &WelcomePage::openWanted);
    connect(m_phantom, &QPushButton::clicked, this, &WelcomePage::phantomWanted);
    setChoices(false, {});
}

void WelcomePage::resizeEvent(QResizeEvent*)
{
    constexpr int kMost = 100; // maximum line length in characters
    m_card->setMaximumWidth(kMost * fontMetrics().averageCharWidth());
}

void WelcomePage::setChoices(bool hasPhantom, const QStringList& recent)
{
    m_phantom->setVisible(hasPhantom);
    m_recentTitle->setVisible(!recent.isEmpty());
    while (QLayoutItem* item = m_recent->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const QString& path : recent.mid(0, 6)) {
        const QFileInfo file(path);
        auto* link = new QPushButton(QStringLiteral("%1   —   %2").arg(file.fileName(), file.absolutePath()), m_card);
        link->setFlat(true);
        link->setStyleSheet(QStringLiteral("text-align: left; padding: 5px 6px;"));
        link->setToolTip(path);
        connect(link, &QPushButton::clicked, this, [this, path] { Q_EMIT recentWanted(path); });
        m_recent->addWidget(link);
    }
}

void WelcomePage::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::AlternateBase));
    painter.setPen(QPen(palette().color(QPalette::Mid), 2.0, Qt::DashLine));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(m_card->geometry()), 12, 12);
}

} // namespace palpate::ui
