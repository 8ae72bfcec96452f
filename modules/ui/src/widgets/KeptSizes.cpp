// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Theme.h"

#include <QEvent>
#include <QSize>
#include <QWidget>

namespace palpate::ui {

namespace {

constexpr auto kKeptFont = "keptFont";

/// Updates a widget's font when the parent's font changes, because Qt does not scale an explicitly set size.
class KeptFont final : public QObject
{
  public:
    KeptFont(QWidget& widget, double ratio, int weight)
        : QObject(&widget)
        , m_widget(widget)
        , m_ratio(ratio)
        , m_weight(weight)
    {
        setObjectName(QLatin1String(kKeptFont));
        widget.parentWidget()->installEventFilter(this);
        take();
    }
    void set(double ratio, int weight)
    {
        m_ratio = ratio;
        m_weight = weight;
        take();
    }
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::FontChange && watched == m_widget.parentWidget()) {
            // Queued: the style sheet propagates fonts after this event and would restore the old one.
            QMetaObject::invokeMethod(
                this, [this] { take(); }, Qt::QueuedConnection);
        }
        return false;
    }

  private:
    void take()
    {
        const QFont base = m_widget.parentWidget()->font();
        QFont font = m_widget.font();
        if (base.pointSizeF() > 0.0) {
            font.setPointSizeF(m_ratio * base.pointSizeF());
        } else {
            font.setPixelSize(qRound(m_ratio * base.pixelSize()));
        }
        font.setWeight(static_cast<QFont::Weight>(m_weight));
        m_widget.setFont(font);
    }

    QWidget& m_widget;
    double m_ratio;
    int m_weight;
};

/// Updates the icon size when the widget's font changes.
class KeptIconSize final : public QObject
{
  public:
    KeptIconSize(QWidget& widget, int usual_px)
        : QObject(&widget)
        , m_widget(widget)
        , m_usual_px(usual_px)
    {
        widget.installEventFilter(this);
        take();
    }
    bool eventFilter(QObject*, QEvent* event) override
    {
        if (event->type() == QEvent::FontChange) {
            take();
        }
        return false;
    }

  private:
    void take()
    {
        const int side_px = withText_px(m_usual_px);
        m_widget.setProperty("iconSize", QSize(side_px, side_px)); // common property of buttons, lists and tool bars
    }

    QWidget& m_widget;
    int m_usual_px;
};

} // namespace

void keepIconSize(QWidget& widget, int usual_px)
{
    new KeptIconSize(widget, usual_px); // owned by the widget
}

void keepFont(QWidget& widget, double ratio, int weight)
{
    if (auto* kept = widget.findChild<QObject*>(QLatin1String(kKeptFont), Qt::FindDirectChildrenOnly)) {
        static_cast<KeptFont*>(kept)->set(ratio, weight);
        return;
    }
    new KeptFont(widget, ratio, weight); // owned by the widget
}

} // namespace palpate::ui
