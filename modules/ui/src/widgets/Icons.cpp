// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Theme.h"

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

namespace palpate::ui {

namespace {

// Symbols are drawn on a 24 x 24 grid.

void poly(QPainter& p, std::initializer_list<QPointF> points)
{
    p.drawPolyline(QPolygonF(points));
}

/// Outstretched finger on a surface.
QPainterPath finger()
{
    QPainterPath finger;
    finger.moveTo(9.2, 16);
    finger.lineTo(9.2, 5.2);
    finger.arcTo(QRectF(9.2, 3, 4.4, 4.4), 180, -180);
    finger.lineTo(13.6, 10.2);
    finger.lineTo(17.6, 11.2);
    finger.quadTo(19.6, 11.8, 19.4, 14);
    finger.lineTo(18.6, 18);
    finger.quadTo(18, 21, 15, 21);
    finger.lineTo(11.6, 21);
    finger.quadTo(9.6, 21, 8.4, 19.4);
    finger.lineTo(4.8, 14.6);
    finger.quadTo(4.4, 13, 6, 12.8);
    finger.quadTo(7, 12.8, 9.2, 15.4);
    return finger;
}

void drawEye(QPainter& p, bool isOpen, const QColor& ink)
{
    QPainterPath lid;
    lid.moveTo(2.5, 12);
    lid.quadTo(12, 2.5, 21.5, 12);
    lid.quadTo(12, 21.5, 2.5, 12);
    p.drawPath(lid);
    if (isOpen) {
        p.setBrush(ink);
        p.drawEllipse(QPointF(12, 12), 2.6, 2.6);
    } else {
        p.drawLine(QPointF(4, 4), QPointF(20, 20));
    }
}

void drawArrowBack(QPainter& p)
{
    QPainterPath arrow;
    arrow.moveTo(4.5, 9.5);
    arrow.lineTo(14.5, 9.5);
    arrow.cubicTo(22, 9.5, 22, 19, 14.5, 19);
    arrow.lineTo(9, 19);
    p.drawPath(arrow);
    poly(p, {{8.8, 5}, {4.5, 9.5}, {8.8, 14}});
}

/// Filled symbols of the recorder and player controls.
void drawControl(QPainter& p, Symbol symbol)
{
    switch (symbol) {
    case Symbol::Stop:
        p.drawRoundedRect(QRectF(6.5, 6.5, 11, 11), 1, 1);
        break;
    case Symbol::Play:
        p.drawPolygon(QPolygonF({{8, 5.5}, {18.5, 12}, {8, 18.5}}));
        break;
    case Symbol::Pause:
        p.drawRect(QRectF(7, 6, 3, 12));
        p.drawRect(QRectF(14, 6, 3, 12));
        break;
    case Symbol::Restart:
        p.drawRect(QRectF(6, 6, 1.6, 12));
        p.drawPolygon(QPolygonF({{18.5, 6}, {9.5, 12}, {18.5, 18}}));
        break;
    default:
        break;
    }
}

/// Symbols of the message kinds.
void drawMessage(QPainter& p, Symbol symbol)
{
    switch (symbol) {
    case Symbol::Warning:
        p.setPen(QPen(warningColour(), 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        p.drawPolygon(QPolygonF({{12, 3.5}, {21.5, 20}, {2.5, 20}}));
        p.drawLine(QPointF(12, 9.5), QPointF(12, 14));
        p.drawPoint(QPointF(12, 17));
        break;
    case Symbol::Told:
        p.drawEllipse(QPointF(12, 12), 9, 9);
        poly(p, {{7.8, 12.4}, {10.8, 15.4}, {16.4, 9}});
        break;
    case Symbol::Error:
        p.drawEllipse(QPointF(12, 12), 9, 9);
        poly(p, {{8.6, 8.6}, {15.4, 15.4}});
        poly(p, {{15.4, 8.6}, {8.6, 15.4}});
        break;
    case Symbol::Offer:
        p.drawEllipse(QPointF(12, 12), 9, 9);
        poly(p, {{7.4, 12}, {16.4, 12}});
        poly(p, {{12.8, 8.4}, {16.4, 12}, {12.8, 15.6}});
        break;
    default:
        break;
    }
}

void drawSymbol(QPainter& p, Symbol symbol, const QColor& ink)
{
    switch (symbol) {
    case Symbol::Open:
        poly(p, {{3, 18.5}, {3, 6}, {9, 6}, {11, 8.5}, {19, 8.5}, {19, 11}});
        poly(p, {{3, 18.5}, {6.2, 11}, {21.5, 11}, {18.5, 18.5}, {3, 18.5}});
        break;
    case Symbol::Camera: // orbits around a cube's corner: rotating the view
        p.drawEllipse(QPointF(12, 12), 9.0, 3.8);
        p.drawEllipse(QPointF(12, 12), 3.8, 9.0);
        p.setBrush(ink);
        p.drawEllipse(QPointF(12, 12), 1.2, 1.2);
        break;
    case Symbol::Hand:
    case Symbol::HandOff:
        p.drawPath(finger());
        if (symbol == Symbol::HandOff) {
            p.drawLine(QPointF(3.5, 3.5), QPointF(20.5, 20.5));
        }
        break;
    case Symbol::Record:
        p.setPen(Qt::NoPen);
        p.setBrush(recordColour());
        p.drawEllipse(QPointF(12, 12), 6.5, 6.5);
        break;
    case Symbol::Stop:
    case Symbol::Play:
    case Symbol::Pause:
    case Symbol::Restart:
        p.setBrush(ink);
        drawControl(p, symbol);
        break;
    case Symbol::Snapshot:
        p.drawRoundedRect(QRectF(3, 7.5, 18, 12), 2, 2);
        poly(p, {{8, 7.5}, {9.5, 5}, {14.5, 5}, {16, 7.5}});
        p.drawEllipse(QPointF(12, 13.4), 3.6, 3.6);
        break;
    case Symbol::Fit:
        poly(p, {{4, 9}, {4, 4}, {9, 4}});
        poly(p, {{15, 4}, {20, 4}, {20, 9}});
        poly(p, {{20, 15}, {20, 20}, {15, 20}});
        poly(p, {{9, 20}, {4, 20}, {4, 15}});
        p.drawEllipse(QPointF(12, 12), 3.6, 3.6);
        break;
    case Symbol::Eye:
    case Symbol::EyeOff:
        drawEye(p, symbol == Symbol::Eye, ink);
        break;
    case Symbol::Warning:
    case Symbol::Told:
    case Symbol::Error:
    case Symbol::Offer:
        drawMessage(p, symbol);
        break;
    case Symbol::Undo:
    case Symbol::Redo:
        if (symbol == Symbol::Redo) {
            p.translate(24, 0);
            p.scale(-1, 1);
        }
        drawArrowBack(p);
        break;
    case Symbol::Mark: // a flag
        p.drawLine(QPointF(6, 3.5), QPointF(6, 21));
        p.setBrush(ink);
        p.drawPolygon(QPolygonF({{6, 4}, {19, 8.2}, {6, 12.5}}));
        break;
    case Symbol::Keys:
        p.drawRoundedRect(QRectF(2.5, 6.5, 19, 11.5), 2, 2);
        for (const double x : {6.0, 10.0, 14.0, 18.0}) {
            p.drawPoint(QPointF(x, 10));
        }
        p.drawLine(QPointF(8, 14.4), QPointF(16, 14.4));
        break;
    }
}

class SymbolEngine final : public QIconEngine
{
  public:
    explicit SymbolEngine(Symbol symbol)
        : m_symbol(symbol)
    {
    }
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const QColor ink = QApplication::palette().color(group, QPalette::ButtonText);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        painter->scale(rect.width() / 24.0, rect.height() / 24.0);
        painter->setPen(QPen(ink, 1.7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        if (mode == QIcon::Disabled) {
            painter->setOpacity(0.55);
        }
        drawSymbol(*painter, m_symbol, ink);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }
    [[nodiscard]] QIconEngine* clone() const override { return new SymbolEngine(m_symbol); }

  private:
    Symbol m_symbol;
};

} // namespace

QIcon icon(Symbol symbol)
{
    return QIcon(new SymbolEngine(symbol));
}

} // namespace palpate::ui
