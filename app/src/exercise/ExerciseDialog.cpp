// SPDX-License-Identifier: BSD-3-Clause
#include "exercise/ExerciseDialog.h"

#include "shared/Console.h"
#include "shared/Paths.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/ui/ReportFile.h>
#include <palpate/ui/Translated.h>

#include <QAccessible>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <memory>
#include <utility>
#include <vector>

namespace palpate::app {

namespace {

/// Converts the lengths of the style from rem, which Qt's rich text does not know, to pixels.
QString inPixels(QString html)
{
    constexpr double kRem_px = 16.0;
    static const QRegularExpression length(QStringLiteral("([0-9.]+)rem"));
    QRegularExpressionMatch found;
    while ((found = length.match(html)).hasMatch() && found.capturedEnd() < html.indexOf(QLatin1String("</style>"))) {
        const double size_px = kRem_px * found.captured(1).toDouble();
        html.replace(found.capturedStart(), found.capturedLength(), QStringLiteral("%1px").arg(qRound(size_px)));
    }
    return html;
}

} // namespace

ExerciseDialog::ExerciseDialog(const std::filesystem::path& recording, session::MeshesByHash meshes,
                               meshio::Exercise exercise,
                               std::function<QImage(const study::ExerciseScore& score)> picture, QWidget* parent)
    : QDialog(parent)
    , m_recording(recording)
    , m_picture(std::move(picture))
    , m_text(new QTextBrowser(this))
    , m_said(new QLabel(this))
{
    setObjectName(QStringLiteral("exerciseResults"));
    setWindowTitle(tr("Results of the exercise"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_text->setAccessibleName(tr("Results of the exercise"));
    m_text->setPlainText(tr("Scoring the recording…"));
    m_said->setWordWrap(true);
    m_said->setTextFormat(Qt::PlainText);
    m_said->setAccessibleDescription(tr("Result of saving"));
    m_said->hide();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_savePage = buttons->addButton(tr("Save page…"), QDialogButtonBox::ActionRole);
    m_savePage->setToolTip(tr("Save this page with a picture as PDF or web page"));
    m_saveNumbers = buttons->addButton(tr("Save numbers (JSON)…"), QDialogButtonBox::ActionRole);
    m_saveNumbers->setToolTip(tr("Save the numbers in machine-readable form, as palpate session exercise writes them"));
    QPushButton* again = buttons->addButton(tr("Do it again"), QDialogButtonBox::ActionRole);
    again->setToolTip(tr("Hide the targets again for another search"));
    m_savePage->setEnabled(false);
    m_saveNumbers->setEnabled(false);
    connect(m_savePage, &QPushButton::clicked, this, [this] { choose(true); });
    connect(m_saveNumbers, &QPushButton::clicked, this, [this] { choose(false); });
    connect(again, &QPushButton::clicked, this, &ExerciseDialog::againWanted);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_said);
    layout->addWidget(buttons);
    resize(720, 640);
    m_worker = std::thread([this, meshes = std::move(meshes), exercise = std::move(exercise)]() mutable {
        auto scored =
            std::make_shared<core::Result<ScoredExercise>>(scoreRecording(m_recording, std::move(meshes), exercise));
        QMetaObject::invokeMethod(
            this, [this, scored] { present(*scored); }, Qt::QueuedConnection);
    });
}

ExerciseDialog::~ExerciseDialog()
{
    m_worker.join();
}

void ExerciseDialog::present(const core::Result<ScoredExercise>& scored)
{
    if (!scored.isOk()) {
        m_text->setPlainText(ui::translated(scored.status()));
        return;
    }
    m_scored = scored.value();
    m_drawn = m_picture(m_scored->score);
    m_scored->facts.isPictured = !m_drawn.isNull();
    ScoredExercise shown = *m_scored;
    shown.facts.isPictured = false; // the view beside the dialog has the picture
    m_text->setHtml(inPixels(QString::fromUtf8(ui::reportHtml(study::composeExercise(shown.score, shown.facts), {}))));
    m_savePage->setEnabled(true);
    m_saveNumbers->setEnabled(true);
}

study::Report ExerciseDialog::page() const
{
    return study::composeExercise(m_scored->score, m_scored->facts);
}

void ExerciseDialog::choose(bool isPage)
{
    std::filesystem::path suggested = m_recording;
    suggested.replace_extension(isPage ? ".pdf" : ".json");
    const QString chosen =
        isPage ? QFileDialog::getSaveFileName(this, tr("Page of the exercise"), toText(suggested),
                                              tr("PDF for printing (*.pdf);;Web page, for screen readers too (*.html)"))
               : QFileDialog::getSaveFileName(this, tr("Numbers of the exercise"), toText(suggested),
                                              tr("Numbers (*.json)"));
    if (!chosen.isEmpty()) {
        saveTo(toPath(chosen));
    }
}

void ExerciseDialog::saveTo(const std::filesystem::path& path)
{
    const bool isNumbers = path.extension() == ".json";
    if (!isNumbers && !ui::reportFormatOf(path)) {
        say(tr("Nothing was written: %1 must end in .pdf, .html or .json.").arg(toText(path.filename())));
        return;
    }
    core::Status status = checkOutputs({m_recording}, {path});
    if (status.isOk()) {
        status = isNumbers ? core::writeAtomically(path, study::exerciseJson(m_scored->score))
                           : ui::writeReport(path, page(),
                                             m_drawn.isNull() ? std::vector<QImage>() : std::vector<QImage>{m_drawn});
    }
    say(status.isOk() ? tr("Written to %1.").arg(toText(path)) : ui::translated(status));
}

void ExerciseDialog::say(const QString& line)
{
    m_said->setText(line);
    m_said->show();
    QAccessibleEvent event(m_said, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

} // namespace palpate::app

#include "moc_ExerciseDialog.cpp"
