// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/view/LabelLayout.h>

#include <random>

using namespace palpate;
using Point = Eigen::Vector2d;

namespace {

constexpr double kDisc_px = 6.5;

std::vector<view::DiscLabel> labelsAt(const std::vector<Point>& discs)
{
    std::vector<view::DiscLabel> labels;
    for (const Point& disc : discs) {
        labels.push_back({disc, Point(22, 16), Point::Zero(), false});
    }
    return labels;
}

bool overlap(const Point& a, const Point& aSize, const Point& b, const Point& bSize)
{
    return ((a - b).cwiseAbs().array() < 0.5 * (aSize + bSize).array()).all();
}

/// Returns an empty string if no text covers another text or a disc.
QString whatIsCovered(const std::vector<view::DiscLabel>& labels)
{
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t k = 0; k < labels.size(); ++k) {
            const Point centre = labels[i].disc_px + labels[i].offset_px;
            const Point other = labels[k].disc_px + labels[k].offset_px;
            if (overlap(centre, labels[i].size_px, labels[k].disc_px, Point::Constant(2.0 * kDisc_px))) {
                return QStringLiteral("label %1 covers disc %2").arg(i).arg(k);
            }
            if (i != k && overlap(centre, labels[i].size_px, other, labels[k].size_px)) {
                return QStringLiteral("labels %1 and %2").arg(i).arg(k);
            }
        }
    }
    return {};
}

} // namespace

class LabelLayout : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void aloneItIsUpAndRightWithoutALine()
    {
        auto labels = labelsAt({Point(0, 0), Point(200, 50)});
        view::placeLabels(labels, kDisc_px);
        for (const view::DiscLabel& one : labels) {
            QVERIFY(one.offset_px.x() > 0.0 && one.offset_px.y() > 0.0);
            QVERIFY(!one.isMoved);
        }
    }

    void nothingIsCovered_data()
    {
        QTest::addColumn<std::vector<Point>>("discs");
        QTest::newRow("side by side") << std::vector<Point>{Point(0, 0), Point(8, 0)};
        QTest::newRow("one above the other") << std::vector<Point>{Point(0, 0), Point(0, 8)};
        QTest::newRow("in one place") << std::vector<Point>{Point(5, 5), Point(5, 5)};
        QTest::newRow("eight in one place") << std::vector<Point>(8, Point(-3, 40));
        for (unsigned seed = 1; seed <= 20; ++seed) {
            std::mt19937 random(seed);
            std::vector<Point> discs;
            for (int i = 0; i < 20; ++i) {
                const double x = 0.01 * static_cast<double>(random() % 16000);
                discs.emplace_back(x, 0.01 * static_cast<double>(random() % 16000));
            }
            QTest::addRow("20 in 160 pixels, seed %u", seed) << discs;
        }
        // A large screen, and positions far outside of the view.
        for (const double middle_px : {0.0, 1200.0, -1e6}) {
            std::mt19937 random(7);
            std::vector<Point> discs;
            for (int i = 0; i < 400; ++i) {
                const double x = middle_px + 0.01 * static_cast<double>(random() % 200000) - 1000.0;
                discs.emplace_back(x, middle_px + 0.01 * static_cast<double>(random() % 200000) - 1000.0);
            }
            QTest::addRow("400 in 2000 pixels about %.0f", middle_px) << discs;
        }
    }
    void nothingIsCovered()
    {
        QFETCH(const std::vector<Point>, discs);
        auto labels = labelsAt(discs);
        view::placeLabels(labels, kDisc_px);
        QCOMPARE(whatIsCovered(labels), QString());
    }

    void aLabelStaysOffWhatIsTaken()
    {
        auto labels = labelsAt({Point(0, 0)});
        view::placeLabels(labels, kDisc_px);
        const Point usual = labels[0].offset_px;
        const Eigen::AlignedBox2d hand(usual - Point(6, 6), usual + Point(6, 6));
        view::placeLabels(labels, kDisc_px, {hand});
        const Point centre = labels[0].offset_px, half = 0.5 * labels[0].size_px;
        QVERIFY(!Eigen::AlignedBox2d(centre - half, centre + half).intersects(hand));
        QVERIFY(labels[0].isMoved);
        view::placeLabels(labels, kDisc_px);
        QVERIFY(labels[0].offset_px == usual);
    }

    void aMovedLabelStaysWhereItIsWhileTheViewTurns()
    {
        auto labels = labelsAt({Point(0, 0), Point(8, 0)});
        view::placeLabels(labels, kDisc_px);
        QVERIFY(labels[1].isMoved);
        const Point before = labels[1].offset_px;
        for (int step = 0; step < 40; ++step) { // 23 degrees
            const double angle = -0.01 * step;
            labels[1].disc_px = Point(8 * std::cos(angle), 8 * std::sin(angle));
            view::placeLabels(labels, kDisc_px);
            QCOMPARE(whatIsCovered(labels), QString());
            QVERIFY(labels[1].offset_px == before);
        }
        labels[1].disc_px = Point(80, 0);
        view::placeLabels(labels, kDisc_px);
        QVERIFY(!labels[1].isMoved);
    }

    void withNoRoomAtAllTheUsualPlaceIsTaken()
    {
        auto labels = labelsAt(std::vector<Point>(300, Point(0, 0)));
        view::placeLabels(labels, kDisc_px);
        QVERIFY(!labels.back().isMoved);
        QVERIFY(labels.back().offset_px == labels.front().offset_px);
    }

    void aTextBesideAPointStaysWhereItWas()
    {
        view::PointLabel label{Eigen::Vector2d(0, 0), Eigen::Vector2d(60, 20), Eigen::Vector2d(1, 0), -1};
        const Eigen::AlignedBox2d view(Eigen::Vector2d(-200, -100), Eigen::Vector2d(200, 100));
        const auto box = [](double x, double y, double half) {
            return Eigen::AlignedBox2d(Eigen::Vector2d(x - half, y - half), Eigen::Vector2d(x + half, y + half));
        };
        const Eigen::Vector2d first = view::placeBeside(label, {box(0, 0, 5)}, view);
        QVERIFY(first.x() > 30.0 && std::abs(first.y()) < 1e-9);
        // An obstacle appears and disappears: the label moves away and stays there.
        const Eigen::Vector2d other = view::placeBeside(label, {box(0, 0, 5), box(40, 0, 8)}, view);
        QVERIFY((other - first).norm() > 5.0);
        QCOMPARE(view::placeBeside(label, {box(0, 0, 5)}, view), other);
        // At the border the label goes to the other side; without free space the label is still inside the view.
        label.point_px = Eigen::Vector2d(190, 0);
        QVERIFY(view::placeBeside(label, {box(190, 0, 5)}, view).x() <= 170.0);
        const Eigen::Vector2d inside = view::placeBeside(label, {box(0, 0, 500)}, view);
        QVERIFY(std::abs(inside.x()) <= 170.0 && std::abs(inside.y()) <= 90.0);
    }
};

PALPATE_TEST(LabelLayout)
#include "tst_LabelLayout.moc"
