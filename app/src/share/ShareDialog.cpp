// SPDX-License-Identifier: BSD-3-Clause
#include "share/ShareDialog.h"

#include "share/ReceivedSurfaces.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>

#include <algorithm>

namespace palpate::app {

namespace {

constexpr auto kPortKey = "share/port";
constexpr auto kSurfacesKey = "share/surfaces";
constexpr int kLowestPort = 1024; // lower ones are for services of the system
constexpr int kHighestPort = 65535;

QLabel* wrappedLabel(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    return label;
}

} // namespace

ShareDialog::ShareDialog(QWidget* parent)
    : QDialog(parent)
    , m_reach(new QComboBox(this))
    , m_warning(wrappedLabel(tr("Not encrypted and without a password: everyone in this network can read the touch and "
                                "the findings."),
                             this))
    , m_port(new QSpinBox(this))
    , m_surfaces(new QCheckBox(tr("&Add surfaces that 3D Slicer sends to the scene"), this))
    , m_state(wrappedLabel({}, this))
{
    setWindowTitle(tr("Share with 3D Slicer"));
    setObjectName(QStringLiteral("share-dialog"));
    m_reach->addItem(tr("This computer only"), QStringLiteral("127.0.0.1"));
    m_reach->addItem(tr("All computers in the network"), QStringLiteral("0.0.0.0"));
    m_reach->setObjectName(QStringLiteral("share-reach"));
    connect(m_reach, &QComboBox::currentIndexChanged, this, &ShareDialog::showWarning);
    const QSettings settings;
    m_port->setRange(kLowestPort, kHighestPort);
    m_port->setGroupSeparatorShown(false);
    m_port->setValue(settings.value(QLatin1String(kPortKey), igtl::kDefaultPort).toInt());
    m_port->setObjectName(QStringLiteral("share-port"));
    m_surfaces->setChecked(settings.value(QLatin1String(kSurfacesKey), true).toBool());
    m_surfaces->setToolTip(tr("Stored in %1, for this user only").arg(ReceivedSurfaces::folder()));
    m_state->setObjectName(QStringLiteral("share-state"));
    m_state->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_toggle = buttons->addButton(tr("Start sharing"), QDialogButtonBox::ActionRole);
    m_toggle->setObjectName(QStringLiteral("share-toggle"));
    m_toggle->setDefault(true);
    connect(m_toggle, &QPushButton::clicked, this, [this] {
        if (m_isRunning) {
            Q_EMIT stopWanted();
        } else {
            QSettings().setValue(QLatin1String(kPortKey), m_port->value());
            QSettings().setValue(QLatin1String(kSurfacesKey), m_surfaces->isChecked());
            Q_EMIT startWanted();
        }
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* form = new QFormLayout(this);
    form->addRow(wrappedLabel(
        tr("Sends the hand, the touched point, the force and the findings by OpenIGTLink. In 3D Slicer, open the "
           "module "
           "OpenIGTLinkIF, add a connector of type Client with this port and the host name localhost (on another "
           "computer: the address of this one), and activate it."),
        this));
    form->addRow(tr("&Reachable from"), m_reach);
    form->addRow(QString(), m_warning);
    form->addRow(tr("&Port"), m_port);
    form->addRow(m_surfaces);
    form->addRow(m_state);
    form->addRow(buttons);
    setMinimumWidth(460);
    showWarning();
    showReport({}, 0.0);
}

igtl::ShareOptions ShareDialog::options() const
{
    igtl::ShareOptions options;
    options.address = m_reach->currentData().toString().toStdString();
    options.port = static_cast<std::uint16_t>(m_port->value());
    options.takesSurfaces = m_surfaces->isChecked();
    return options;
}

void ShareDialog::showWarning()
{
    m_warning->setVisible(m_reach->currentIndex() > 0);
    fitHeight();
}

/// A window does not grow with its wrapped texts.
void ShareDialog::fitHeight()
{
    layout()->activate();
    resize(width(), layout()->totalHeightForWidth(width()));
}

void ShareDialog::showReport(const igtl::ShareReport& report, double perSecond)
{
    m_isRunning = report.port != 0;
    m_toggle->setText(m_isRunning ? tr("Stop sharing") : tr("Start sharing"));
    for (QWidget* widget :
         {static_cast<QWidget*>(m_reach), static_cast<QWidget*>(m_port), static_cast<QWidget*>(m_surfaces)}) {
        widget->setEnabled(!m_isRunning);
    }
    QStringList lines;
    if (!m_isRunning) {
        lines << tr("Not shared.");
    } else if (report.peers.empty()) {
        lines << tr("Waiting for 3D Slicer at port %1.").arg(report.port);
    } else {
        QStringList peers;
        for (const std::string& peer : report.peers) {
            peers << QString::fromStdString(peer);
        }
        lines << tr("Connected: %1").arg(peers.join(QStringLiteral(", ")));
        lines << tr("%1 messages a second").arg(QLocale().toString(perSecond, 'f', 0));
    }
    if (report.dropped > 0) {
        lines << tr("%n message(s) not sent, because the receiver is too slow", nullptr,
                    static_cast<int>(std::min<std::uint64_t>(report.dropped, 1'000'000'000)));
    }
    if (!report.problem.empty()) {
        lines << tr("Latest error: %1").arg(QString::fromStdString(report.problem));
    }
    m_state->setText(lines.join(QLatin1Char('\n')));
    fitHeight();
}

void ShareDialog::showFailure(const QString& line)
{
    showReport({}, 0.0);
    m_state->setText(line);
    fitHeight();
}

} // namespace palpate::app

#include "moc_ShareDialog.cpp"
