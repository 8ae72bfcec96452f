// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/session/RecordingReader.h>
#include <palpate/session/Recovery.h>

#include <QFile>
#include <QTemporaryDir>

#include <limits>

using namespace palpate;
using session::RecordingReader;

/// Tests recordings of older versions: the first 1,750 ticks of the phantom's palpation.
class OldRecordings : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    static std::filesystem::path kept(int version)
    {
        return PALPATE_SOURCE_DIR "/tests/session/data/version" + std::to_string(version) + ".palpate";
    }

    static void eachVersion()
    {
        QTest::addColumn<int>("version");
        QTest::newRow("1") << 1;
        QTest::newRow("2") << 2;
    }

  private Q_SLOTS:
    void openAndVerify_data() { eachVersion(); }
    void openAndVerify()
    {
        QFETCH(int, version);
        const auto reader = RecordingReader::open(kept(version));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        QCOMPARE(reader.value()->info().version, version);
        QVERIFY2(reader.value()->verify().isOk(), reader.value()->verify().message().c_str());
        QCOMPARE(reader.value()->scenes().at(0).structures.at(1).tissue.stiffness_N_per_mm, 0.6);
        int touching = 0;
        const auto status =
            reader.value()->forEach(0, std::numeric_limits<std::int64_t>::max(), [&](const servo::TickRecord& tick) {
                const bool isTouching = tick.felt.structure >= 0;
                const core::Vec3 spring = tick.felt.p_WG - tick.p_WH;
                const haptics::Contact& only = tick.felt.contacts[0];
                // Defaults for data missing in old versions: the normal is the spring's, and one layer has the whole
                // force.
                const bool isRight =
                    isTouching == (tick.felt.contactCount == 1) &&
                    (!isTouching || (tick.felt.n_W == spring / spring.norm() && only.p_WG == tick.felt.p_WG &&
                                     only.n_W == tick.felt.n_W && only.f_W == tick.felt.f_W &&
                                     only.depth_mm == spring.norm() && only.structure == 0));
                touching += isTouching ? 1 : 0;
                return isRight;
            });
        QVERIFY(status.isOk());
        QCOMPARE(touching, 318);
    }

    /// Without the page that leads to the others, rows are recognised by their form, which differs between versions.
    void areRecoveredRowByRow_data() { eachVersion(); }
    void areRecoveredRowByRow()
    {
        QFETCH(int, version);
        QFile file(QString::fromStdString(kept(version).string()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray bytes = file.readAll();
        bytes.replace(0, 4096, QByteArray(4096, 'x'));
        const std::filesystem::path hurt = m_folder.filePath("hurt.palpate").toStdString();
        const std::filesystem::path copy = m_folder.filePath("copy.palpate").toStdString();
        QFile out(m_folder.filePath("hurt.palpate"));
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(bytes);
        out.close();
        const auto result = session::recoverRecording(hurt, copy);
        QVERIFY2(result.isOk(), result.status().message().c_str());
        QCOMPARE(result.value().ticks, std::int64_t{1750});
        const auto reader = RecordingReader::open(copy);
        QVERIFY2(reader.isOk() && reader.value()->verify().isOk(), reader.status().message().c_str());
        if (version == 2) { // version 1: only the ticks
            QCOMPARE(reader.value()->scenes().size(), std::size_t{1});
            for (const core::Message& loss : result.value().losses) {
                QVERIFY2(loss.english().find("checksum") == std::string::npos, loss.english().c_str());
            }
        }
    }

    void becomeThisVersionWhenCopied_data() { eachVersion(); }
    void becomeThisVersionWhenCopied()
    {
        QFETCH(int, version);
        const std::filesystem::path copy = m_folder.filePath("whole.palpate").toStdString();
        const auto result = session::recoverRecording(kept(version), copy);
        QVERIFY2(result.isOk() && result.value().losses.empty(), result.status().message().c_str());
        const auto reader = RecordingReader::open(copy);
        QCOMPARE(reader.value()->info().version, session::kRecordingVersion);
        QVERIFY(reader.value()->verify().isOk());
        QCOMPARE(reader.value()->extent().ticks, std::int64_t{1750});
    }
};

PALPATE_TEST(OldRecordings)
#include "tst_OldRecordings.moc"
