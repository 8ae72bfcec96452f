// SPDX-License-Identifier: BSD-3-Clause
#include "compare/ComparisonDialog.h"

#include "shared/Paths.h"

#include <palpate/ui/Translated.h>

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QPushButton>
#include <QStringList>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <memory>
#include <utility>

namespace palpate::app {

namespace {

ResultTable resultTable(const study::ReportTable& table)
{
    ResultTable out{ui::translated(table.caption), {QStringList()}};
    for (const study::ReportTable::Column& column : table.columns) {
        out.rows.front() << ui::translated(column.heading);
    }
    for (const std::vector<core::MessageArgument>& row : table.rows) {
        QStringList& cells = out.rows.emplace_back();
        for (const core::MessageArgument& cell : row) {
            cells << ui::translated(cell);
        }
    }
    return out;
}

} // namespace

ComparisonDialog::ComparisonDialog(const std::filesystem::path& first, const std::filesystem::path& second,
                                   study::CompareOptions options, QWidget* parent)
    : QDialog(parent)
    , m_text(new QTextBrowser(this))
{
    setWindowTitle(tr("Comparison of %1 (A) and %2 (B)").arg(toText(first.filename()), toText(second.filename())));
    setAttribute(Qt::WA_DeleteOnClose);
    m_text->setAccessibleName(tr("Comparison of two recordings"));
    m_text->setPlainText(tr("Measuring…"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    m_copy->setToolTip(tr("Copy all tables for a spreadsheet"));
    m_copy->setEnabled(false);
    connect(m_copy, &QPushButton::clicked, this, &ComparisonDialog::copy);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_text, 1);
    layout->addWidget(buttons);
    resize(760, 680);
    options.progress = [this](double) { return !m_isClosing; };
    m_worker = std::thread([this, first, second, options = std::move(options)] {
        const auto compared = std::make_shared<const core::Result<study::RecordingComparison>>(
            study::compareRecordings(first, second, options));
        if (!m_isClosing) {
            QMetaObject::invokeMethod(
                this, [this, compared] { present(*compared); }, Qt::QueuedConnection);
        }
    });
}

ComparisonDialog::~ComparisonDialog()
{
    m_isClosing = true;
    m_worker.join();
}

void ComparisonDialog::present(const core::Result<study::RecordingComparison>& compared)
{
    if (!compared.isOk()) {
        m_text->setPlainText(ui::translated(compared.status()));
        return;
    }
    for (const study::ReportTable& table : study::comparisonTables(compared.value().sessions)) {
        m_tables.push_back(resultTable(table));
    }
    QString html;
    for (const auto* lines : {&compared.value().missing, &compared.value().conditions}) {
        for (const core::Message& line : *lines) {
            html += QStringLiteral("<p>%1</p>").arg(ui::translated(line).toHtmlEscaped());
        }
    }
    html += QStringLiteral("<p>%1</p>")
                .arg(tr("By hand: a hand can tell two forces apart from about 7 % on (measured from 2.5 to 10 N).")
                         .toHtmlEscaped());
    m_text->setHtml(html + toHtml(m_tables));
    m_copy->setEnabled(true);
}

void ComparisonDialog::copy()
{
    QGuiApplication::clipboard()->setText(toTsv(m_tables));
}

} // namespace palpate::app

#include "moc_ComparisonDialog.cpp"
