// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuresDialog.h"

#include <palpate/study/SessionExport.h>
#include <palpate/ui/FindingsModel.h>
#include <palpate/ui/SessionPanel.h>
#include <palpate/ui/StructureModel.h>

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLocale>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <memory>
#include <utility>

using namespace palpate;

namespace {

QString number(double value, int digits = 2)
{
    return QLocale().toString(value, 'f', digits);
}

/// A table of cells that are escaped here; the first row is its head. A little narrower than the view: Qt rounds 100 %
/// up.
QString table(const QString& title, const std::vector<QStringList>& rows)
{
    QString html = QStringLiteral("<h3>%1</h3><table cellspacing='0' cellpadding='4' width='99%'>").arg(title);
    bool isHead = true;
    for (const QStringList& row : rows) {
        html += QStringLiteral("<tr>");
        for (qsizetype i = 0; i < row.size(); ++i) {
            const QString tag = isHead ? QStringLiteral("th") : QStringLiteral("td");
            html += QStringLiteral("<%1 align='%2'>%3</%1>")
                        .arg(tag, i == 0 ? QStringLiteral("left") : QStringLiteral("right"), row[i].toHtmlEscaped());
        }
        html += QStringLiteral("</tr>");
        isHead = false;
    }
    return html + QStringLiteral("</table>");
}

QString toHtml(const session::SessionMeasures& m)
{
    const auto tr = [](const char* text) { return MeasuresDialog::tr(text); };
    const session::ContactMeasures& all = m.sums.contact;
    QString html =
        table(tr("Session"),
              {{tr("Duration"), tr("In contact"), tr("Contacts"), tr("Path of the hand"), tr("Path on the surface")},
               {ui::clockText(m.sums.duration_s), ui::clockText(all.time_s),
                QLocale().toString(static_cast<qlonglong>(m.sums.contact.contacts)),
                tr("%1 mm").arg(number(m.sums.pathLength_mm, 0)), tr("%1 mm").arg(number(m.sums.contactPath_mm, 0))}});
    std::vector<QStringList> rows{{tr("Force and depth"), tr("Time [s]"), tr("Mean [N]"), tr("Median [N]"),
                                   tr("95 % [N]"), tr("Peak [N]"), tr("Deepest [mm]"), tr("Presses")}};
    const auto contact = [&](const QString& name, const session::ContactMeasures& c,
                             const std::vector<session::Phase>& phases) {
        const session::PhaseSummary presses = session::summary(phases, session::Phase::Kind::Press);
        rows.push_back({name, number(c.time_s, 1), number(c.meanForce_N), number(c.medianForce_N), number(c.p95Force_N),
                        number(c.peakForce_N), number(c.peakDepth_mm, 1), QString::number(presses.phases)});
    };
    contact(tr("All"), all, m.phases);
    for (const auto& [name, part] : m.sums.structures) {
        const auto phases = m.structurePhases.find(name);
        contact(ui::readableName(name), part,
                phases != m.structurePhases.end() ? phases->second : std::vector<session::Phase>());
    }
    html += table(tr("Touch"), rows);
    rows = {{tr("Hand"), tr("Phases"), tr("Time [s]"), tr("Mean [N]"), tr("Peak [N]")}};
    for (const auto kind : {session::Phase::Kind::Search, session::Phase::Kind::Press}) {
        const session::PhaseSummary sum = session::summary(m.phases, kind);
        rows.push_back({kind == session::Phase::Kind::Search ? tr("Searching") : tr("Pressing"),
                        QString::number(sum.phases), number(sum.time_s, 1), number(sum.meanForce_N),
                        number(sum.peakForce_N)});
    }
    html += table(tr("Search and press"), rows);
    rows = {{tr("Surface"), tr("Area [cm²]"), tr("Covered [%]"), tr("Longest dwell [s]")}};
    for (const session::SurfaceMeasures& surface : m.surfaces) {
        rows.push_back({ui::readableName(surface.structure), number(0.01 * surface.area_mm2, 1),
                        number(100.0 * surface.coverage(), 1), number(surface.longestDwell_s, 1)});
    }
    for (const std::string& name : m.unmeasured) {
        rows.push_back({ui::readableName(name), tr("its mesh is not open"), {}, {}});
    }
    html += table(tr("Coverage, within %1 mm").arg(number(m.distance_mm, 0)), rows);
    if (!m.findings.empty()) {
        rows = {{tr("Finding"), tr("Where"), tr("Marked"), tr("First touched"), tr("Dwell [s]"), tr("Visits"),
                 tr("Mean [N]"), tr("Peak [N]")}};
        for (const session::FindingMeasures& one : m.findings) {
            if (!one.finding.hasPlace) {
                continue;
            }
            rows.push_back(
                {ui::typeSign(one.finding.type) + QLatin1Char(' ') + QString::fromStdString(one.finding.name),
                 ui::readableName(one.finding.structure), ui::clockText(one.marked_s),
                 one.firstTouched_s ? ui::clockText(*one.firstTouched_s) : tr("never"), number(one.dwell_s, 1),
                 QString::number(one.visits), number(one.meanForce_N), number(one.peakForce_N)});
        }
        if (rows.size() > 1) {
            html += table(tr("Findings"), rows);
        }
        rows = {{tr("Note"), tr("Written")}};
        for (const session::FindingMeasures& one : m.findings) {
            if (!one.finding.note.empty()) {
                const QString about =
                    one.finding.hasPlace ? QString::fromStdString(one.finding.name + ": ") : QString();
                rows.push_back({about + QString::fromStdString(one.finding.note), ui::clockText(one.marked_s)});
            }
        }
        if (rows.size() > 1) {
            html += table(tr("Notes"), rows);
        }
        rows = {{tr("Felt when marked"), tr("Structure"), tr("Force [N]"), tr("Depth [mm]")}};
        for (const session::FindingMeasures& one : m.findings) {
            for (const core::FeltLayer& layer : one.finding.layers) {
                rows.push_back({QString::fromStdString(one.finding.name), QString::fromStdString(layer.structure),
                                number(layer.force_N), number(layer.depth_mm, 1)});
            }
        }
        if (rows.size() > 1) {
            html += table(tr("Findings, layer by layer"), rows);
        }
    }
    return html + QStringLiteral("<p>%1</p>").arg(tr("Research measures, not a diagnosis."));
}

} // namespace

MeasuresDialog::MeasuresDialog(const std::filesystem::path& recording, session::MeshesByHash meshes, QWidget* parent)
    : QDialog(parent)
    , m_recording(recording)
{
    setWindowTitle(tr("What %1 says").arg(QString::fromStdString(recording.filename().string())));
    setAttribute(Qt::WA_DeleteOnClose);
    m_text = new QTextBrowser(this);
    m_text->setAccessibleName(tr("Measures of the session"));
    m_text->setPlainText(tr("Measuring…"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* csv = buttons->addButton(tr("Ticks as CSV…"), QDialogButtonBox::ActionRole);
    m_vtp = buttons->addButton(tr("Path and surface as VTP…"), QDialogButtonBox::ActionRole);
    m_vtp->setEnabled(false);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(csv, &QPushButton::clicked, this, &MeasuresDialog::exportCsv);
    connect(m_vtp, &QPushButton::clicked, this, &MeasuresDialog::exportVtp);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_text);
    layout->addWidget(buttons);
    resize(720, 640);
    m_worker = std::thread([this, meshes = std::move(meshes)]() mutable {
        using Measured = core::Result<session::SessionMeasures>;
        const auto reader = session::RecordingReader::open(m_recording);
        auto measured = std::make_shared<Measured>(reader.status());
        if (reader.isOk()) {
            for (const std::string& hash : reader.value()->embeddedHashes()) {
                auto surface = reader.value()->embedded(hash);
                if (surface.isOk()) {
                    meshes[hash] = std::make_shared<const geometry::RepairedMesh>(std::move(surface).value());
                }
            }
            session::MeasureOptions options;
            options.isCancelled = &m_isCancelled;
            *measured = session::measureSession(*reader.value(), meshes, options);
        }
        if (!m_isCancelled) {
            QMetaObject::invokeMethod(
                this, [this, measured] { present(std::move(*measured)); }, Qt::QueuedConnection);
        }
    });
}

MeasuresDialog::~MeasuresDialog()
{
    m_isCancelled = true;
    m_worker.join();
}

void MeasuresDialog::present(core::Result<session::SessionMeasures> measured)
{
    if (!measured.isOk()) {
        m_text->setPlainText(QString::fromStdString(measured.status().message()));
        return;
    }
    m_measures = std::move(measured).value();
    m_text->setHtml(toHtml(*m_measures));
    m_vtp->setEnabled(true);
}

void MeasuresDialog::tell(const core::Status& status, const QString& done)
{
    setWindowTitle(status.isOk() ? done : QString::fromStdString(status.message()));
}

void MeasuresDialog::exportCsv()
{
    const QString chosen = QFileDialog::getSaveFileName(this, tr("Ticks as CSV"), {}, tr("CSV (*.csv)"));
    if (chosen.isEmpty()) {
        return;
    }
    const auto reader = session::RecordingReader::open(m_recording);
    tell(reader.isOk() ? study::exportTicks(*reader.value(), chosen.toStdU16String()) : reader.status(),
         tr("Written to %1").arg(chosen));
}

void MeasuresDialog::exportVtp()
{
    QString chosen = QFileDialog::getSaveFileName(this, tr("Path and surface as VTP"), {}, tr("VTK poly data (*.vtp)"));
    if (chosen.isEmpty()) {
        return;
    }
    if (!chosen.endsWith(QLatin1String(".vtp"))) {
        chosen += QStringLiteral(".vtp");
    }
    const std::filesystem::path path = chosen.toStdU16String();
    const auto reader = session::RecordingReader::open(m_recording);
    core::Status status = reader.isOk() ? study::exportPath(*reader.value(), path) : reader.status();
    if (status.isOk()) {
        status = study::exportSurface(*m_measures, study::surfaceFileOf(path));
    }
    tell(status, tr("Written to %1 and beside it").arg(chosen));
}
