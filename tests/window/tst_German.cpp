// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/ui/MessageBar.h>
#include <palpate/ui/Messages.h>
#include <palpate/ui/Translated.h>

#include <QAbstractItemView>
#include <QFile>
#include <QLabel>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTranslator>

#include <cmath>
#include <limits>

using namespace palpate;

/// Tests the window in German: messages from the engine about unusable files are translated too.
class German : public QObject
{
    Q_OBJECT

    QTranslator m_german;
    std::unique_ptr<test::Desk> m_desk;

    std::filesystem::path write(const char* name, const QByteArray& bytes) const
    {
        const std::filesystem::path file = m_desk->folder() / name;
        QFile out(QString::fromStdString(file.string()));
        if (!out.open(QIODevice::WriteOnly) || out.write(bytes) != bytes.size()) {
            qFatal("cannot write %s", file.c_str());
        }
        return file;
    }

    /// Finds English function words that do not occur in German.
    static QString englishIn(const QString& text)
    {
        static const QRegularExpression english(QStringLiteral("\\b(the|is|are|not|no|of|with|without|cannot|expected|"
                                                               "found|file|mesh|surface|has|and|to|auf Englisch)\\b"));
        const QRegularExpressionMatch match = english.match(text);
        return match.hasMatch() ? text : QString();
    }

    /// Returns the window's messages after opening a file: over the view, and in the list of messages.
    QString saidOf(const std::filesystem::path& file)
    {
        if (!m_desk->show()) {
            return QStringLiteral("no window");
        }
        QSignalSpy failed(&m_desk->window(), &MainWindow::openFailed);
        QSignalSpy ready(&m_desk->window(), &MainWindow::ready);
        m_desk->window().open({file});
        if (!QTest::qWaitFor([&] { return failed.count() + ready.count() > 0; }, test::kPatience_ms)) {
            return QStringLiteral("no answer");
        }
        QTest::qWait(100);
        QStringList lines{m_desk->window().findChild<ui::MessageBar*>()->text()};
        for (const QAbstractItemView* view : m_desk->window().findChildren<QAbstractItemView*>()) {
            const auto* list = qobject_cast<const ui::Messages*>(view->model());
            for (int row = 0; list != nullptr && row < list->rowCount(); ++row) {
                lines << list->text(row);
            }
        }
        return lines.join(QLatin1Char('\n'));
    }

    static geometry::TriangleMesh withCorner(const core::Vec3& corner)
    {
        geometry::TriangleMesh mesh = test::sphere(4, 20.0);
        mesh.vertices.front() = corner;
        return mesh;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        QVERIFY(m_german.load(QStringLiteral(":/translations/palpate_de.qm")));
        QCoreApplication::installTranslator(&m_german);
        m_desk = std::make_unique<test::Desk>();
    }
    void cleanupTestCase()
    {
        m_desk.reset();
        QCoreApplication::removeTranslator(&m_german);
    }

    void whatCannotBeUsedIsSaidInGerman_data()
    {
        QTest::addColumn<std::filesystem::path>("file");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* name, const std::filesystem::path& file, const char* said) {
            QTest::newRow(name) << file << QString::fromUtf8(said);
        };
        row("gone", m_desk->folder() / "gone.stl", "gone.stl: kann nicht geöffnet werden");
        row("empty", write("empty.stl", ""), "empty.stl: Byte 0: die Datei ist leer");
        row("letter", write("letter.obj", "Dear colleague,\n"), "letter.obj");
        row("page", write("page.stl", "<!DOCTYPE html><html></html>"), "eine Webseite");
        row("image", write("image.stl", "NRRD0004\n"), "der Kopf endet nicht");
        row("cut", write("cut.stl", QByteArray(100, '\0')), "cut.stl");
        row("flat",
            m_desk->writeStl("flat.stl",
                             {{core::Vec3(0, 0, 0), core::Vec3(1, 0, 0), core::Vec3(2, 0, 0)}, {{0, 1, 2}}}),
            "keines der Dreiecke hat eine Fläche");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        row("not numbers", m_desk->writeStl("nan.stl", withCorner(core::Vec3(nan, 0, 0))), "keine Zahlen");
        row("far", m_desk->writeStl("far.stl", withCorner(core::Vec3(1e9, 0, 0))), "weiter als 10 km");
        geometry::TriangleMesh open = test::sphere(4, 20.0);
        open.triangles.resize(open.triangles.size() - 3);
        row("holes", m_desk->writeStl("holes.stl", open), "hat Löcher oder einen Rand");
        row("not a recording", write("note.palpate", "not a database, but long enough to be read"),
            "kopieren Sie die lesbaren Teile mit `palpate session recover`");
        row("newer scene", write("newer.palpate.json", R"({"version": 99, "structures": []})"), "eine neuere Fassung");
        row("no scene", write("other.palpate.json", R"({"a": 1})"), "ist keine Szene von Palpate");
        row("bad opacity",
            write("opaque.palpate.json", R"({"version": 1, "structures": [{"mesh": "a.stl", "opacity": 7}]})"),
            "opacity: gefunden: 7, erwartet: 0 bis 1");
        row("scene without its mesh",
            write("alone.palpate.json", R"({"version": 1, "structures": [{"mesh": "gone.stl", "name": "liver"}]})"),
            "gone.stl: kann nicht geöffnet werden");
        const std::filesystem::path recording = std::filesystem::path(PALPATE_SOURCE_DIR) / "data/phantom";
        std::filesystem::copy_file(recording / "palpation.palpate", m_desk->folder() / "lonely.palpate");
        row("recording without its mesh", m_desk->folder() / "lonely.palpate", "die Datei ist nicht da");
        std::filesystem::create_directory(m_desk->folder() / "nothing");
        row("folder without meshes", m_desk->folder() / "nothing", "ein Ordner ohne Dateien mit Oberflächen");
    }
    void whatCannotBeUsedIsSaidInGerman()
    {
        QFETCH(const std::filesystem::path, file);
        QFETCH(const QString, said);
        const QString lines = saidOf(file);
        QVERIFY2(lines.contains(said), qPrintable(lines));
        QCOMPARE(englishIn(lines), QString());
    }

    void foreignTextsSayTheirLanguage()
    {
        QCOMPARE(ui::translated(core::Message::untranslated("a.stl: the moon is in the way")),
                 QStringLiteral("a.stl: the moon is in the way (auf Englisch)"));
        QCOMPARE(ui::translated(core::Message()), QString());
    }

    void namesAreNotTranslatedAndNumbersAreLocal()
    {
        QCOMPARE(ui::translated(core::Message(PALPATE_TEXT("the file is empty"))),
                 QStringLiteral("die Datei ist leer"));
        const core::Message line(PALPATE_TEXT("line %1"), 7);
        QCOMPARE(ui::translated(core::Message(PALPATE_TEXT("%1: %2"), "the 100 %1 box.stl", line)),
                 QStringLiteral("the 100 %1 box.stl: Zeile 7"));
    }

    /// In English the engine's own messages stay unchanged.
    void inEnglishNothingChanges()
    {
        QCoreApplication::removeTranslator(&m_german);
        const core::Message line(PALPATE_TEXT("%1 open edges: the surface has holes or a rim"), core::Count(1234));
        QCOMPARE(ui::translated(line), QStringLiteral("1,234 open edges: the surface has holes or a rim"));
        QCoreApplication::installTranslator(&m_german);
    }

    void fieldsHaveGermanNames()
    {
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->openPhantom());
        QStringList found;
        for (const QWidget* one : m_desk->window().findChildren<QWidget*>()) {
            const auto* label = qobject_cast<const QLabel*>(one);
            for (const QString& text : {one->accessibleName(), one->toolTip(), label ? label->text() : QString()}) {
                static const QRegularExpression field(QStringLiteral("\\b([Ss]tiffness|[Dd]amping|[Ff]riction)\\b"));
                if (field.match(text).hasMatch() || !englishIn(text).isEmpty()) {
                    found << text;
                }
            }
        }
        QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
    }
};

PALPATE_TEST(German)
#include "tst_German.moc"
