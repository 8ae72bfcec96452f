// SPDX-License-Identifier: BSD-3-Clause
#include "touch/MeasuresDialog.h"

#include "shared/Console.h"
#include "shared/Paths.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/study/SearchedLumps.h>
#include <palpate/study/SessionExport.h>
#include <palpate/ui/RecordedTouch.h>
#include <palpate/ui/Translated.h>

#include <QAccessible>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QKeySequence>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStringList>
#include <QTextBrowser>
#include <QTimer>
#include <QVBoxLayout>

#include <utility>

using namespace palpate;

namespace {

constexpr int kShort_ms = 300; // shorter exports show no progress

/// Title, file name extension and file dialog filter of an export.
struct Kind
{
    const char* title;
    const char* ending;
    const char* filter;
};

Kind kindOf(MeasuresDialog::Export what)
{
    switch (what) {
    case MeasuresDialog::Export::Csv:
        return {QT_TRANSLATE_NOOP("MeasuresDialog", "Data table (CSV)"), ".csv",
                QT_TRANSLATE_NOOP("MeasuresDialog", "Data table (*.csv)")};
    case MeasuresDialog::Export::Vtp:
        return {QT_TRANSLATE_NOOP("MeasuresDialog", "Path and map for 3D Slicer"), ".vtp",
                QT_TRANSLATE_NOOP("MeasuresDialog", "VTK poly data (*.vtp)")};
    case MeasuresDialog::Export::Json:
        break;
    }
    return {QT_TRANSLATE_NOOP("MeasuresDialog", "Results (JSON)"), ".json",
            QT_TRANSLATE_NOOP("MeasuresDialog", "Results (*.json)")};
}

/// Returns true if the surface of a touched structure is missing.
bool lacksSurface(const session::RecordingReader& reader, const session::MeshesByHash& meshes)
{
    for (const session::SceneRecord& scene : reader.scenes()) {
        for (const session::StructureRecord& structure : scene.structures) {
            if (structure.palpable && !meshes.contains(structure.source.sha256)) {
                return true;
            }
        }
    }
    return false;
}

QString lineOf(const core::Status& status)
{
    return ui::translated(status);
}

} // namespace

MeasuresDialog::MeasuresDialog(const std::filesystem::path& recording, session::MeshesByHash meshes, QWidget* parent)
    : QDialog(parent)
    , m_recording(recording)
{
    setWindowTitle(tr("Results of %1").arg(toText(recording.filename())));
    setAttribute(Qt::WA_DeleteOnClose);
    m_text = new QTextBrowser(this);
    m_text->setAccessibleName(tr("Results of the session"));
    m_text->setPlainText(tr("Measuring…"));
    m_text->installEventFilter(this);
    m_said = new QLabel(this);
    m_said->setWordWrap(true);
    m_said->setTextFormat(Qt::PlainText);
    m_said->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_said->setAccessibleDescription(tr("Result of the last export"));
    m_said->hide();
    m_progress = new QProgressBar(this);
    m_progress->setRange(0, 1000);
    m_progress->setAccessibleName(tr("Export progress"));
    m_cancel = new QPushButton(tr("Cancel export"), this);
    m_cancel->setAutoDefault(false);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_isCancelled = true; });
    auto* line = new QHBoxLayout;
    line->addWidget(m_progress, 1);
    line->addWidget(m_cancel);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_said);
    layout->addLayout(line);
    makeButtons();
    setBusy(false);
    resize(760, 680);
    measure(std::move(meshes));
}

MeasuresDialog::~MeasuresDialog()
{
    m_isClosing = true;
    m_isCancelled = true;
    m_worker.join();
    if (m_exporter.joinable()) {
        m_exporter.join();
    }
}

void MeasuresDialog::makeButtons()
{
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* const copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    copy->setToolTip(tr("Copy all tables for a spreadsheet (Ctrl+C)"));
    connect(copy, &QPushButton::clicked, this, &MeasuresDialog::copy);
    m_ofMeasures.push_back(copy);
    const auto add = [&](Export what, const QString& tip) {
        QPushButton* const button =
            buttons->addButton(tr(kindOf(what).title) + QStringLiteral("…"), QDialogButtonBox::ActionRole);
        button->setToolTip(tip);
        connect(button, &QPushButton::clicked, this, [this, what] { choose(what); });
        return button;
    };
    m_csv = add(Export::Csv, tr("Every sample with time, positions, forces, depth and events"));
    m_ofMeasures.push_back(
        add(Export::Vtp, tr("Path of the hand, plus the touched surface with time spent and peak force")));
    m_ofMeasures.push_back(add(Export::Json, tr("All results in machine-readable form")));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout()->addWidget(buttons);
}

void MeasuresDialog::measure(session::MeshesByHash meshes)
{
    m_worker = std::thread([this, meshes = std::move(meshes)]() mutable {
        using Measured = core::Result<session::SessionMeasures>;
        const auto reader = session::RecordingReader::open(m_recording);
        auto measured = std::make_shared<Measured>(reader.status());
        bool isFingertip = false;
        if (reader.isOk()) {
            if (lacksSurface(*reader.value(), meshes)) {
                if (auto found = study::recordedSurfaces(*reader.value()); found.isOk()) {
                    meshes.merge(found.value());
                }
            }
            session::MeasureOptions options;
            const auto goesOn = [this](double) { return !m_isClosing; };
            options.progress = goesOn;
            options.distance_mm = study::defaultDistance_mm(*reader.value(), meshes);
            isFingertip = study::hasFingertip(*reader.value());
            const auto scene = study::sceneOfRecording(m_recording);
            auto organs = scene.isOk() ? study::computePalpability(scene.value(), {}, nullptr, goesOn)
                                       : core::Result<std::vector<study::OrganPalpability>>(scene.status());
            *measured = organs.isOk() ? study::measureSearch(*reader.value(), meshes, scene.value(),
                                                             std::move(organs).value(), std::move(options))
                                      : session::measureSession(*reader.value(), meshes, options);
        }
        if (!m_isClosing) {
            QMetaObject::invokeMethod(
                this, [this, measured, isFingertip] { present(std::move(*measured), isFingertip); },
                Qt::QueuedConnection);
        }
    });
}

void MeasuresDialog::present(core::Result<session::SessionMeasures> measured, bool isFingertip)
{
    if (!measured.isOk()) {
        m_text->setPlainText(lineOf(measured.status()));
        return;
    }
    m_measures = std::make_shared<const session::SessionMeasures>(std::move(measured).value());
    m_tables = resultTables(*m_measures, isFingertip);
    m_text->setHtml(QStringLiteral("<p style='font-size: large'>%1</p>").arg(summaryOf(*m_measures).toHtmlEscaped()) +
                    toHtml(m_tables));
    setBusy(m_isBusy);
    if (!m_measures->damaged.empty()) {
        say(ui::damageText(m_recording, m_measures->damaged.size()));
    }
}

void MeasuresDialog::setBusy(bool isBusy)
{
    m_isBusy = isBusy;
    m_csv->setEnabled(!isBusy);
    for (QPushButton* button : m_ofMeasures) {
        button->setEnabled(!isBusy && m_measures != nullptr);
    }
    m_progress->setVisible(false);
    m_cancel->setVisible(false);
    if (isBusy) {
        QTimer::singleShot(kShort_ms, this, [this] {
            m_progress->setVisible(m_isBusy);
            m_cancel->setVisible(m_isBusy);
        });
    }
}

void MeasuresDialog::say(const QString& line)
{
    m_said->setText(line);
    m_said->setVisible(!line.isEmpty());
    QAccessibleEvent event(m_said, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

void MeasuresDialog::copy()
{
    if (!m_tables.empty()) {
        QGuiApplication::clipboard()->setText(toTsv(m_tables));
        say(tr("Copied. Paste into a spreadsheet."));
    }
}

/// Ctrl+C without a selection copies all tables; the text widget alone would copy nothing.
bool MeasuresDialog::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy) &&
        !m_text->textCursor().hasSelection()) {
        copy();
        return true;
    }
    return QDialog::eventFilter(watched, event);
}

void MeasuresDialog::keyPressEvent(QKeyEvent* event)
{
    event->matches(QKeySequence::Copy) ? copy() : QDialog::keyPressEvent(event);
}

void MeasuresDialog::choose(Export what)
{
    const Kind kind = kindOf(what);
    std::filesystem::path suggested = m_recording;
    suggested.replace_extension(kind.ending);
    const QString chosen = QFileDialog::getSaveFileName(this, tr(kind.title), toText(suggested), tr(kind.filter));
    if (!chosen.isEmpty()) {
        exportTo(what, toPath(chosen));
    }
}

void MeasuresDialog::exportTo(Export what, std::filesystem::path path)
{
    const Kind kind = kindOf(what);
    const QString ending = QLatin1String(kind.ending);
    const QString found = QString::fromStdString(path.extension().string());
    std::error_code error;
    if (found.isEmpty()) {
        path += kind.ending;
        if (std::filesystem::exists(path, error)) { // the file dialog confirmed a different name
            say(tr("Nothing was written: %1 already exists. Enter the full file name to replace the file.")
                    .arg(toText(path)));
            return;
        }
    } else if (found.compare(ending, Qt::CaseInsensitive) != 0) {
        say(tr("Nothing was written: %1 ends in %2. For %3, enter a name that ends in %4.")
                .arg(toText(path.filename()), found, tr(kind.title), ending));
        return;
    }
    const std::filesystem::path surface = what == Export::Vtp ? study::surfaceFileOf(path) : std::filesystem::path();
    core::Status allowed = app::checkOutputs({m_recording}, {path, surface});
    if (allowed.isOk() && !surface.empty()) {
        allowed = study::checkSurfaceFile(surface);
    }
    if (!allowed.isOk()) {
        say(lineOf(allowed));
        return;
    }
    const auto written = [path](const core::Status& status) {
        return status.isOk() ? tr("Written to %1.").arg(toText(path)) : lineOf(status);
    };
    run([=, measures = m_measures, recording = m_recording](const std::function<bool(double)>& progress) {
        if (what == Export::Json) {
            return written(core::writeAtomically(path, study::measuresJson(*measures)));
        }
        const auto reader = session::RecordingReader::open(recording);
        if (!reader.isOk()) {
            return lineOf(reader.status());
        }
        const auto withDamage = [&](const QString& line) {
            return QStringList{line, ui::damageText(recording, reader.value()->faults().size())}
                .join(QLatin1Char(' '))
                .trimmed();
        };
        if (what == Export::Csv) {
            return withDamage(written(study::exportTicks(*reader.value(), path, progress)));
        }
        if (const core::Status status = study::exportPath(*reader.value(), path, progress); !status.isOk()) {
            return lineOf(status);
        }
        const core::Status status = study::exportSurface(*measures, surface);
        return withDamage(
            status.isOk()
                ? tr("Written to %1 and %2.").arg(toText(path), toText(surface.filename()))
                : tr("The path was written to %1, but the surface was not: %2").arg(toText(path), lineOf(status)));
    });
}

void MeasuresDialog::run(const std::function<QString(const std::function<bool(double)>& progress)>& work)
{
    if (m_isBusy) {
        return;
    }
    if (m_exporter.joinable()) {
        m_exporter.join(); // the thread has already reported its result
    }
    m_isCancelled = false;
    m_progress->setValue(0);
    say({});
    setBusy(true);
    m_exporter = std::thread([this, work] {
        const QString line = work([this](double share) {
            QMetaObject::invokeMethod(
                m_progress, [this, share] { m_progress->setValue(static_cast<int>(1000.0 * share)); },
                Qt::QueuedConnection);
            return !m_isCancelled;
        });
        if (!m_isClosing) {
            QMetaObject::invokeMethod(
                this,
                [this, line] {
                    setBusy(false);
                    say(line);
                },
                Qt::QueuedConnection);
        }
    });
}

#include "moc_MeasuresDialog.cpp"
