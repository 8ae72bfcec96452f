// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <QImage>

namespace palpate::app {

/// The picture as a whole: fits everything into the view, saves a picture.
class PicturePart : public WindowPart
{
    Q_OBJECT
  public:
    explicit PicturePart(const WindowCore& core);
    void addActions() override;
    void showState(const WindowState& state) override;

  private:
    void saveSnapshot();
    [[nodiscard]] QImage captioned(const QImage& picture, double scale) const;

    WindowCore m_core;
};

} // namespace palpate::app
