// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"
#include "shell/Language.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QTranslator>
#include <QXmlStreamReader>

using namespace palpate;

namespace {

/// A message of a catalogue.
struct Message
{
    QString context, source;
    QStringList translations; ///< several for a plural form
    bool isPlural = false;
    bool isFinished = true;
};

/// Reads the messages of a Qt catalogue in order.
/// @return empty if the file does not parse
QList<Message> readCatalogue(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QXmlStreamReader xml(&file);
    QList<Message> messages;
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) {
            continue;
        }
        if (xml.name() == QLatin1String("name")) {
            context = xml.readElementText();
        } else if (xml.name() == QLatin1String("message")) {
            messages.push_back({context, {}, {}, xml.attributes().hasAttribute(QLatin1String("numerus")), true});
        } else if (xml.name() == QLatin1String("source")) {
            messages.back().source = xml.readElementText();
        } else if (xml.name() == QLatin1String("translation")) {
            messages.back().isFinished = !xml.attributes().hasAttribute(QLatin1String("type"));
            if (!messages.back().isPlural) {
                messages.back().translations << xml.readElementText();
            }
        } else if (xml.name() == QLatin1String("numerusform")) {
            messages.back().translations << xml.readElementText();
        }
    }
    return xml.hasError() ? QList<Message>{} : messages;
}

/// Returns the matches of a pattern in a text, sorted.
QStringList found(const QString& text, const char* pattern)
{
    QStringList all;
    auto matches = QRegularExpression(QString::fromUtf8(pattern)).globalMatch(text);
    while (matches.hasNext()) {
        all << matches.next().captured();
    }
    all.sort();
    return all;
}

/// Returns the fault of a translation; empty if the translation is correct.
QString faultOf(const Message& message, const QString& translation)
{
    if (translation.isEmpty()) {
        return QStringLiteral("empty");
    }
    // In a plural form, "a file" may omit the number.
    const char* places = message.isPlural ? "%L?[0-9]" : "%(L?[0-9]|n)";
    if (found(translation, places) != found(message.source, places)) {
        return QStringLiteral("other placeholders");
    }
    constexpr const char* kMnemonic = "&(?=\\p{L})";
    if (found(translation, kMnemonic).size() != found(message.source, kMnemonic).size()) {
        return QStringLiteral("other mnemonics (&)");
    }
    if (translation.endsWith(QChar(0x2026)) != message.source.endsWith(QChar(0x2026))) {
        return QStringLiteral("… at one end only");
    }
    return {};
}

/// A source file, without lines that are comments.
struct Source
{
    QString path; ///< in the source tree
    QString text;
};

QList<Source> sourcesIn(const QStringList& folders)
{
    static const QRegularExpression comment(QStringLiteral("^\\s*//.*$"), QRegularExpression::MultilineOption);
    const QString root = QStringLiteral(PALPATE_SOURCE_DIR "/");
    QList<Source> all;
    for (const QString& folder : folders) {
        QDirIterator files(root + folder, {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                           QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            if (file.open(QIODevice::ReadOnly)) {
                all.push_back({file.fileName().mid(root.size()), QString::fromUtf8(file.readAll()).remove(comment)});
            }
        }
    }
    return all;
}

const QStringList kProduct{QStringLiteral("modules"), QStringLiteral("app"), QStringLiteral("plugins")};

/// @return the texts marked with PALPATE_TEXT in these sources
QStringList markedTexts(const QList<Source>& sources)
{
    static const QRegularExpression mark(QStringLiteral(R"re(\bPALPATE_TEXT\(\s*((?:"(?:\\.|[^"\\])*"\s*)+)\))re"));
    static const QRegularExpression literal(QStringLiteral(R"re("((?:\\.|[^"\\])*)")re"));
    QStringList all;
    for (const Source& source : sources) {
        for (auto marks = mark.globalMatch(source.text); marks.hasNext();) {
            QString text;
            for (auto parts = literal.globalMatch(marks.next().captured(1)); parts.hasNext();) {
                text += parts.next().captured(1);
            }
            all << text.replace(QStringLiteral("\\\""), QStringLiteral("\""));
        }
    }
    return all;
}

/// @return the statements of a source that build a message by concatenation: a literal with a word and a blank next to
/// a `+` and PALPATE_TEXT in the same statement, or English text of a message next to a `+`
QStringList concatenations(const QString& source)
{
    static const QRegularExpression literal(QStringLiteral(R"re("((?:\\.|[^"\\])*)")re"));
    static const QRegularExpression words(QStringLiteral("\\p{L}{2}.* | .*\\p{L}{2}"));
    static const QRegularExpression message(QStringLiteral("\\b(PALPATE_TEXT|Message|fault)\\("));
    static const QRegularExpression glued(QStringLiteral("\"w\"\\s*\\+|\\+\\s*\"w\""));
    static const QRegularExpression english(
        QStringLiteral("\\+=?\\s*[\\w.\\->()]*(\\.|->)(english|message)\\(\\)|\\b(english|message)\\(\\)\\s*\\+"));
    const QString code = QString(source).remove(QStringLiteral("'\"'")); // a quotation mark that begins no literal
    QString plain;
    qsizetype end = 0;
    for (auto literals = literal.globalMatch(code); literals.hasNext();) {
        const QRegularExpressionMatch one = literals.next();
        plain += code.mid(end, one.capturedStart() - end);
        plain += one.captured(1).contains(words) ? QStringLiteral("\"w\"") : QStringLiteral("\"\"");
        end = one.capturedEnd();
    }
    plain += code.mid(end);
    QStringList all;
    for (const QString& statement : plain.split(QLatin1Char(';'))) {
        if ((statement.contains(message) && statement.contains(glued)) || statement.contains(english)) {
            all << statement.simplified();
        }
    }
    return all;
}

} // namespace

/// Tests the catalogues of the window's texts: resources/translations.
class Catalogues : public QObject
{
    Q_OBJECT

    static void addLanguages()
    {
        QTest::addColumn<QString>("code");
        for (const app::Language& language : app::languages()) {
            if (language.code != QLatin1String("en")) {
                QTest::newRow(qPrintable(language.code)) << language.code;
            }
        }
    }

  private Q_SLOTS:
    void eachIsOffered()
    {
        QStringList offered;
        for (const app::Language& language : app::languages()) {
            offered << QStringLiteral("palpate_%1.ts").arg(language.code);
        }
        offered.sort();
        QCOMPARE(QDir(PALPATE_SOURCE_DIR "/resources/translations").entryList({QStringLiteral("*.ts")}), offered);
    }

    void isInTheProgram_data() { addLanguages(); }
    void isInTheProgram()
    {
        QFETCH(QString, code);
        QTranslator translator;
        QVERIFY(translator.load(QStringLiteral("palpate_") + code, QStringLiteral(":/translations")));
        QCOMPARE(translator.language(), code);
        QVERIFY(!translator.translate("palpate::app::RecordingPart", "Session").isEmpty());
    }

    void isFinished_data() { addLanguages(); }
    void isFinished()
    {
        QFETCH(QString, code);
        const QList<Message> messages =
            readCatalogue(QStringLiteral(PALPATE_SOURCE_DIR "/resources/translations/palpate_%1.ts").arg(code));
        QVERIFY(messages.size() > 800);
        QStringList faults;
        for (const Message& message : messages) {
            const QString where = message.context + QStringLiteral(": ") + message.source + QStringLiteral(": ");
            if (!message.isFinished) {
                faults << where + QStringLiteral("unfinished");
                continue;
            }
            if (message.translations.size() != (message.isPlural ? 2 : 1)) {
                faults << where + QStringLiteral("%1 translations").arg(message.translations.size());
            }
            for (const QString& translation : message.translations) {
                if (const QString fault = faultOf(message, translation); !fault.isEmpty()) {
                    faults << where + translation + QStringLiteral(": ") + fault;
                }
            }
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    }

    /// English has a catalogue of its texts with a number only.
    void englishHasSingularAndPlural()
    {
        const QString folder = QStringLiteral(PALPATE_SOURCE_DIR "/resources/translations/");
        const auto plurals = [&folder](const char* file) {
            QList<Message> all = readCatalogue(folder + QLatin1String(file));
            all.removeIf([](const Message& message) { return !message.isPlural; });
            return all;
        };
        const auto placesOf = [](const QList<Message>& messages) {
            QStringList places;
            for (const Message& message : messages) {
                places << message.context + QStringLiteral(": ") + message.source;
            }
            places.sort();
            return places;
        };
        const QList<Message> english = plurals("palpate_en.ts");
        QCOMPARE(placesOf(english), placesOf(plurals("palpate_de.ts")));
        QStringList faults;
        for (const Message& message : english) {
            const bool isWhole = message.isFinished && message.translations.size() == 2;
            for (const QString& text : message.translations) {
                const QString fault =
                    text.contains(QStringLiteral("(s)")) ? QStringLiteral("(s)") : faultOf(message, text);
                faults += fault.isEmpty() ? QStringList() : QStringList(text + QStringLiteral(": ") + fault);
            }
            faults += isWhole ? QStringList() : QStringList(message.source + QStringLiteral(": unfinished"));
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
        QTranslator translator;
        QVERIFY(translator.load(QStringLiteral("palpate_en"), QStringLiteral(":/translations")));
        QCOMPARE(translator.translate("palpate::ui::StructureList", "%n hidden target(s)", nullptr, 1),
                 QStringLiteral("%n hidden target"));
    }

    void holdsEachMessageOfTheEngine_data() { addLanguages(); }
    void holdsEachMessageOfTheEngine()
    {
        QFETCH(QString, code);
        QSet<QString> known;
        for (const Message& message :
             readCatalogue(QStringLiteral(PALPATE_SOURCE_DIR "/resources/translations/palpate_%1.ts").arg(code))) {
            if (message.context == QStringLiteral("palpate::Message")) {
                known << message.source;
            }
        }
        const QStringList marked = markedTexts(sourcesIn(kProduct));
        QVERIFY(marked.contains(QStringLiteral("%1: %2")));
        QStringList missing;
        for (const QString& text : marked) {
            if (!known.contains(text)) {
                missing << text;
            }
        }
        QVERIFY2(missing.isEmpty(), qPrintable(QStringLiteral("run resources/translations/update.sh and translate:\n") +
                                               missing.join(QLatin1Char('\n'))));
    }

    /// A message is one text with arguments: clauses that are put together have no entry in a catalogue.
    void noMessageIsConcatenated()
    {
        QCOMPARE(concatenations(QStringLiteral("return fault(file + \": found \" + word);")).size(), 1);
        QCOMPARE(concatenations(QStringLiteral("lines.push_back(name + status.message());")).size(), 1);
        QVERIFY(
            concatenations(QStringLiteral("return {PALPATE_TEXT(\"found %1\"), folder + \"/\" + file};")).isEmpty());
        QStringList faults;
        for (const Source& source : sourcesIn(kProduct)) {
            for (const QString& statement : concatenations(source.text)) {
                faults << source.path + QStringLiteral(": ") + statement;
            }
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    }

    /// Only texts of other software are shown without translation.
    void onlyForeignTextsAreUntranslated()
    {
        const QStringList foreign{
            QStringLiteral("app/src/shared/Program.cpp"),                   // what() of an exception
            QStringLiteral("modules/core/include/palpate/core/Message.h"),  // declaration
            QStringLiteral("modules/core/src/Message.cpp"),                 // rare errors of the C library
            QStringLiteral("modules/device/src/PluginProbe.cpp"),           // plugins
            QStringLiteral("modules/meshio/src/scene/ReadScene.cpp"),       // Qt's JSON parser
            QStringLiteral("modules/session/src/database/Database.cpp"),    // SQLite
            QStringLiteral("modules/session/src/database/ReadOnlyVfs.cpp"), // SQLite
            QStringLiteral("modules/study/src/session/ReadMarkups.cpp"),    // Qt's JSON parser
            QStringLiteral("plugins/forcedimension/src/Dhd.cpp"),           // errors of libdhd
        };
        QStringList found;
        for (const Source& source : sourcesIn(kProduct)) {
            if (source.text.contains(QRegularExpression(QStringLiteral("\\buntranslated\\(")))) {
                found << source.path;
            }
        }
        found.sort();
        QCOMPARE(found, foreign);
    }

    void frenchHasItsSpaces()
    {
        // No line break before high punctuation: U+202F.
        const QRegularExpression bare(QStringLiteral("[^\\x{202F}\\s][;!?](\\s|$)|[\\p{L})]:(\\s|$)|[ \\x{A0}][;:!?»]|"
                                                     "«[^\\x{202F}]|[^\\x{202F}]»|'"));
        QStringList faults;
        for (const Message& message :
             readCatalogue(QStringLiteral(PALPATE_SOURCE_DIR "/resources/translations/palpate_fr.ts"))) {
            for (const QString& translation : message.translations) {
                if (translation.contains(bare)) {
                    faults << translation;
                }
            }
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    }
};

PALPATE_TEST(Catalogues)
#include "tst_Catalogues.moc"
