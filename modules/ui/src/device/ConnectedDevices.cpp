// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/ConnectedDevices.h"

#include "palpate/ui/Translated.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cstddef>

namespace palpate::ui {

namespace {

using State = DeviceFamily::State;

/// Plugins of this project, in the order of the table.
constexpr std::array<const char*, 6> kPlugins{"openhaptics",   "forcedimension", "haply",
                                              "woodenhaptics", "spacemouse",     "openigtlink"};

QString familyName(const std::string& plugin)
{
    const QString names[] = {ConnectedDevices::tr("3D Systems Touch, Phantom"),
                             ConnectedDevices::tr("Force Dimension omega, delta, sigma, lambda"),
                             ConnectedDevices::tr("Haply Inverse3, Minverse"),
                             ConnectedDevices::tr("WoodenHaptics, Polhem"),
                             ConnectedDevices::tr("SpaceMouse (input only)"),
                             ConnectedDevices::tr("Tracked hand by OpenIGTLink (input only)")};
    const auto* const known = std::find(kPlugins.begin(), kPlugins.end(), plugin);
    return known != kPlugins.end() ? names[static_cast<std::size_t>(known - kPlugins.begin())] : QString();
}

DeviceFamily unavailable(const QString& name, const QString& stateText, const QString& nextStep)
{
    return {name, State::Unavailable, stateText, nextStep};
}

/// State of a plugin that was found and is not skipped.
DeviceFamily searched(device::PluginHost& host, const device::PluginInfo& info,
                      const std::vector<device::OtherDevice>& onBus)
{
    const QString known = familyName(info.id), own = QString::fromStdString(info.name);
    const QString name = known.isEmpty() ? own : known;
    const auto found = host.find(info.id);
    if (!found.isOk()) {
        return unavailable(name, ConnectedDevices::tr("driver not usable"), translated(found.status()));
    }
    QStringList ready, problems;
    for (const device::FoundDevice& one : found.value()) {
        const QString device = QString::fromStdString(one.name);
        one.problem.empty()
            ? ready << device
            : problems << ConnectedDevices::tr("%1: %2").arg(device, QString::fromStdString(one.problem));
    }
    if (!ready.isEmpty()) {
        return {name, State::Ready, ConnectedDevices::tr("connected: %1").arg(ready.join(QStringLiteral(", "))),
                (QStringList(ConnectedDevices::tr("Choose Device › %1.").arg(own)) + problems).join(QLatin1Char('\n'))};
    }
    if (!problems.isEmpty()) {
        return {name, State::NotReady, ConnectedDevices::tr("not ready"), problems.join(QLatin1Char('\n'))};
    }
    const auto other =
        std::find_if(onBus.begin(), onBus.end(), [&](const device::OtherDevice& one) { return one.plugin == info.id; });
    if (other != onBus.end()) {
        return {name, State::NotReady,
                ConnectedDevices::tr("connected, not ready: %1").arg(QString::fromStdString(other->name)),
                ConnectedDevices::tr("It needs %1.").arg(QString::fromStdString(other->needs))};
    }
    // Makes no connection, but opens the library of the maker, which may be missing.
    const QString steps = stepsToConnect(info.id);
    if (const auto made = host.make(info.id); !made.isOk()) {
        const bool isLibraryMissing = made.status().code() == core::StatusCode::NotFound;
        return unavailable(name,
                           isLibraryMissing ? ConnectedDevices::tr("supported; the maker's library is missing")
                                            : ConnectedDevices::tr("driver cannot start"),
                           isLibraryMissing && !steps.isEmpty() ? steps : translated(made.status()));
    }
    return {name, State::NotConnected, ConnectedDevices::tr("supported; none is connected"),
            steps.isEmpty() ? QString::fromStdString(info.drives) : steps};
}

/// State of one plugin. @param entry  null: not installed
DeviceFamily familyOf(device::PluginHost* host, const device::PluginEntry* entry, const std::string& plugin,
                      const std::vector<device::OtherDevice>& onBus)
{
    if (entry == nullptr) {
        return unavailable(
            familyName(plugin), ConnectedDevices::tr("driver not installed"),
            ConnectedDevices::tr("Install the plugin “%1”, a part of Palpate.").arg(QString::fromStdString(plugin)));
    }
    if (!entry->status.isOk()) {
        const QString known = familyName(entry->info.id);
        const QString name = !known.isEmpty()           ? known
                             : entry->info.name.empty() ? QString::fromStdString(entry->file.filename().string())
                                                        : QString::fromStdString(entry->info.name);
        return unavailable(name, ConnectedDevices::tr("driver skipped"), translated(entry->status));
    }
    return searched(*host, device::PluginInfo(entry->info), onBus);
}

} // namespace

QString stepsToConnect(const std::string& plugin)
{
    const QString steps[] = {
        ConnectedDevices::tr("Install the maker's Touch driver and OpenHaptics 3, connect the arm, run Touch_Setup."),
        ConnectedDevices::tr("Install the maker's Force Dimension SDK 3, connect the arm, switch it on."),
        ConnectedDevices::tr("Start the maker's Inverse Service (3.1 or later), connect the arm, calibrate it in the "
                             "Haply Hub."),
        ConnectedDevices::tr("Connect the arm by USB, choose it in the menu Device, then Device › Calibrate."),
        ConnectedDevices::tr("Connect it by USB. It has no motors: it moves the hand or the view, or sets the force."),
        ConnectedDevices::tr("Start the program that sends the tracked tool, such as 3D Slicer, at port 18944. There "
                             "is no force on the hand.")};
    const auto* const known = std::find(kPlugins.begin(), kPlugins.end(), plugin);
    return known != kPlugins.end() ? steps[static_cast<std::size_t>(known - kPlugins.begin())] : QString();
}

std::vector<DeviceFamily> deviceFamilies(device::PluginHost* host, const std::vector<device::OtherDevice>& onBus)
{
    std::vector<device::PluginEntry> entries;
    if (host != nullptr) {
        entries = host->plugins(); // a copy: searching may change the state of an entry
    }
    std::vector<DeviceFamily> families;
    for (const char* plugin : kPlugins) {
        // The first of several files of a plugin is used, unless it is skipped.
        const device::PluginEntry* entry = nullptr;
        for (const device::PluginEntry& one : entries) {
            if (one.info.id == plugin && (entry == nullptr || (!entry->status.isOk() && one.status.isOk()))) {
                entry = &one;
            }
        }
        families.push_back(familyOf(host, entry, plugin, onBus));
    }
    for (const device::PluginEntry& entry : entries) {
        if (std::find(kPlugins.begin(), kPlugins.end(), entry.info.id) == kPlugins.end()) {
            families.push_back(familyOf(host, &entry, entry.info.id, onBus));
        }
    }
    for (const device::OtherDevice& other : onBus) {
        if (other.plugin.empty()) {
            families.push_back({QString::fromStdString(other.name), State::NotReady,
                                ConnectedDevices::tr("connected, not supported yet"),
                                ConnectedDevices::tr("It needs %1.").arg(QString::fromStdString(other.needs))});
        }
    }
    return families;
}

ConnectedDevices::ConnectedDevices(device::PluginHost* host, QWidget* parent)
    : QDialog(parent)
    , m_host(host)
    , m_table(new QTableWidget(this))
{
    setWindowTitle(tr("Devices"));
    setObjectName(QStringLiteral("connected-devices"));
    m_table->setColumnCount(3);
    m_table->setHorizontalHeaderLabels({tr("Device"), tr("State"), tr("Next step")});
    m_table->setAccessibleName(tr("Devices"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setWordWrap(true);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* note =
        new QLabel(tr("The drivers were tested against emulated hardware only. The mouse and the simulated hand "
                      "need no device. The page “devices” of the documentation (Help menu) describes "
                      "each installation."),
                   this);
    note->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* again = buttons->addButton(tr("Search again"), QDialogButtonBox::ActionRole);
    connect(again, &QPushButton::clicked, this, &ConnectedDevices::search);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_table);
    layout->addWidget(note);
    layout->addWidget(buttons);
    const int letter_px = fontMetrics().averageCharWidth(), line_px = fontMetrics().height();
    resize(120 * letter_px, 30 * line_px);
    search();
}

void ConnectedDevices::search()
{
    QApplication::setOverrideCursor(Qt::WaitCursor);
    const std::vector<DeviceFamily> families = deviceFamilies(m_host, device::recogniseOtherDevices());
    QApplication::restoreOverrideCursor();
    m_table->setRowCount(static_cast<int>(families.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const DeviceFamily& one = families[static_cast<std::size_t>(row)];
        auto* name = new QTableWidgetItem(one.name);
        auto* state = new QTableWidgetItem(one.stateText);
        QFont font = state->font();
        font.setBold(one.state == State::Ready || one.state == State::NotReady);
        name->setFont(font);
        state->setFont(font);
        m_table->setItem(row, 0, name);
        m_table->setItem(row, 1, state);
        m_table->setItem(row, 2, new QTableWidgetItem(one.nextStep));
    }
}

} // namespace palpate::ui

#include "palpate/ui/moc_ConnectedDevices.cpp"
