// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"
#include "WireBytes.h"
#include "WirePeer.h"

#include <palpate/ui/PalpationController.h>
#include <palpate/ui/Pieces.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

using namespace palpate;
using namespace palpate::test;
using core::Vec3;

/// Device › Share with 3D Slicer in the full window, against a peer that writes and reads bytes itself. Pictures of the
/// dialog go to the folder in PALPATE_TEST_PICTURES.
class Sharing : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;
    WirePeer m_peer;
    std::uint16_t m_port = 0;

    template<class T>
    T& part(const char* name)
    {
        T* found = m_desk->window().findChild<T*>(QLatin1String(name));
        if (found == nullptr) {
            qFatal("no widget is called %s", name);
        }
        return *found;
    }
    QString state() { return part<QLabel>("share-state").text(); }
    void keep(const char* name)
    {
        const QString folder = qEnvironmentVariable("PALPATE_TEST_PICTURES");
        if (!folder.isEmpty()) {
            QTest::qWait(700);
            QVERIFY(part<QDialog>("share-dialog")
                        .grab()
                        .save(QStringLiteral("%1/%2.png").arg(folder, QLatin1String(name))));
        }
    }
    /// Opens the dialog and starts at a free port, with a connected peer.
    void begin()
    {
        WirePeer other;
        m_port = other.listen();
        other.closeAll();
        m_desk->command("share").trigger();
        part<QSpinBox>("share-port").setValue(m_port);
        part<QPushButton>("share-toggle").click();
        QVERIFY2(state().contains(QString::number(m_port)), qPrintable(state()));
        QVERIFY(m_peer.connect(m_port));
        PALPATE_TRY_VERIFY(state().contains(QLatin1String("127.0.0.1")));
    }
    /// Reads until a text with these words comes, while the window works.
    bool hasText(const QByteArray& words)
    {
        return QTest::qWaitFor(
            [&] {
                const WireText text = m_peer.read("STRING", 20);
                return QByteArray(reinterpret_cast<const char*>(text.content.data()),
                                  static_cast<qsizetype>(text.content.size()))
                    .contains(words);
            },
            kPatience_ms);
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
    }
    void init()
    {
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->openPhantom());
    }
    void cleanup()
    {
        m_peer.closeAll();
        m_desk->close();
    }

    void warnsBeforeItSharesWithANetwork()
    {
        m_desk->command("share").trigger();
        auto& reach = part<QComboBox>("share-reach");
        QCOMPARE(reach.currentData().toString(), QStringLiteral("127.0.0.1"));
        keep("share-off");
        const auto labels = part<QDialog>("share-dialog").findChildren<QLabel*>();
        const auto warning = std::find_if(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->text().contains(QLatin1String("without a password"));
        });
        QVERIFY(warning != labels.end());
        QVERIFY(!(*warning)->isVisible());
        reach.setCurrentIndex(1);
        QVERIFY((*warning)->isVisible());
        keep("share-network");
    }

    void sendsTouchAndFindings()
    {
        begin();
        m_desk->window().setPalpating(true);
        auto& viewport = m_desk->window().viewport();
        m_desk->window().palpation().stepDepth(10);
        m_desk->window().palpation().pressAt(QPointF(0.5 * viewport.width(), 0.5 * viewport.height()));
        const auto shown = [&]() -> const view::TouchState& { return viewport.view().cursor().state(); };
        PALPATE_TRY_VERIFY(shown().isInContact);
        // The hand still settles, and a message has the state of some frame before.
        std::vector<view::TouchState> states{shown()};
        const auto watching = connect(&m_desk->window().palpation(), &ui::PalpationController::touched, this,
                                      [&] { states.push_back(shown()); });
        const std::map<std::string, Vec3 view::TouchState::*> vectors{{"PalpateGodObject", &view::TouchState::p_WG},
                                                                      {"PalpateHand", &view::TouchState::p_WH},
                                                                      {"PalpateForce", &view::TouchState::f_W}};
        std::set<std::string> right;
        // Each message is looked at once: a hand at rest is not sent again.
        const auto areSent = [&] {
            for (WireText message = m_peer.read("TRANSFORM", 20); !message.name.empty();
                 message = m_peer.read("TRANSFORM", 20)) {
                const Vec3 sent_W(-message.f32(36), -message.f32(40), message.f32(44));
                const auto vector_W = vectors.at(message.name);
                if (std::any_of(states.begin(), states.end(), [&](const view::TouchState& one) {
                        return one.isInContact && (sent_W - one.*vector_W).cwiseAbs().maxCoeff() < 0.01;
                    })) {
                    right.insert(message.name);
                }
            }
            return right.size() == vectors.size();
        };
        PALPATE_TRY_VERIFY(areSent());
        disconnect(watching);
        PALPATE_TRY_VERIFY(shown().isInContact);
        m_desk->command("mark").trigger();
        QVERIFY(hasText("Finding 1"));
        auto& chip = part<ui::Chip>("share");
        QVERIFY(!chip.said().isEmpty());
        keep("share-on");
        part<QPushButton>("share-toggle").click();
        QVERIFY(chip.said().isEmpty());
        QVERIFY(m_peer.isClosedByOther(10000));
    }

    void addsReceivedSurfacesToTheScene()
    {
        begin();
        const ui::StructureModel& model = m_desk->window().model();
        const int before = model.rowCount();
        std::vector<std::uint8_t> moved = tetrahedron();
        moved[41] ^= 0x01;            // another first coordinate
        for (int i = 0; i < 3; ++i) { // sent again without a change
            QVERIFY(m_peer.write(wireMessage("POLYDATA", "../tumour", tetrahedron())));
        }
        PALPATE_TRY_COMPARE(model.rowCount(), before + 1);
        QVERIFY(m_peer.write(wireMessage("POLYDATA", "kidney", moved)));
        PALPATE_TRY_COMPARE(model.rowCount(), before + 2);
        const auto& first = model.rows()[static_cast<std::size_t>(before)].loaded;
        QVERIFY2(first.description.name.find("tumour") != std::string::npos, first.description.name.c_str());
        QCOMPARE(first.surface->mesh.triangles.size(), std::size_t{4});
        const auto& vertices = first.surface->mesh.vertices;
        const auto has = [&vertices](const Vec3& p_W) {
            return std::any_of(vertices.begin(), vertices.end(),
                               [&](const Vec3& v) { return (v - p_W).norm() < 1e-6; });
        };
        QVERIFY(has({-10, 0, 0}) && has({0, -10, 0}) && has({0, 0, 10})); // from RAS
        QVERIFY(m_peer.write(wireMessage("POLYDATA", "bad", std::vector<std::uint8_t>(50))));
        PALPATE_TRY_VERIFY(state().contains(QLatin1String("\"bad\": POLYDATA")));
        QCOMPARE(model.rowCount(), before + 2);
        keep("share-error");
    }

    void statesThatThePortIsInUse()
    {
        WirePeer other;
        const std::uint16_t port = other.listen();
        m_desk->command("share").trigger();
        part<QSpinBox>("share-port").setValue(port);
        part<QPushButton>("share-toggle").click();
        QVERIFY2(state().contains(QLatin1String("Choose another port")), qPrintable(state()));
        QVERIFY(part<QSpinBox>("share-port").isEnabled());
    }
};

PALPATE_TEST(Sharing)
#include "tst_Sharing.moc"
