// SPDX-License-Identifier: BSD-3-Clause
// A Qt window in which a surface of VTK is palpated with the pointer. With an argument, a simulated hand presses
// instead; the window closes after three seconds and the last message is printed.
#include <palpate/device/SimulatedHand.h>
#include <palpate/ui/PalpationView.h>

#include <QApplication>
#include <QMainWindow>
#include <QStatusBar>
#include <QTimer>
#include <vtkNew.h>
#include <vtkSphereSource.h>

#include <cstdio>
#include <memory>

int main(int argc, char** argv)
{
    palpate::ui::PalpationView::prepareApplication();
    QApplication app(argc, argv);
    QMainWindow window;
    auto* view = new palpate::ui::PalpationView(&window);
    window.setCentralWidget(view);
    const auto say = [&window](const QString& line) { window.statusBar()->showMessage(line); };

    vtkNew<vtkSphereSource> ball; // the output of your pipeline
    ball->SetRadius(40.0);        // mm
    ball->Update();
    const auto liver = view->add(ball->GetOutput(), {.name = "liver", .tissue = {.stiffness_N_per_mm = 0.4}});
    if (!liver.isOk()) {
        qFatal("%s", qPrintable(view->text(liver.status())));
    }
    say(view->notes(liver.value()).join(' '));
    QObject::connect(view, &palpate::ui::PalpationView::touched, [&](const palpate::ui::TouchReading& touch) {
        say(QString("%1 N, %2 mm").arg(touch.force_N, 0, 'f', 2).arg(touch.depth_mm, 0, 'f', 1));
    });
    QObject::connect(view, &palpate::ui::PalpationView::notice, say);
    QObject::connect(view, &palpate::ui::PalpationView::faulted, [&](const QString& line) {
        say(line);
        QTimer::singleShot(3000, view, &palpate::ui::PalpationView::rearm); // better: when the user agrees
    });
    view->setPalpating(true);
    if (argc > 1) {
        const auto hand = palpate::device::HandScript::make({{0, {0, 0, 41}}, {1, {0, 0, 38}}, {9, {0, 0, 38}}});
        (void)view->useDevice(std::make_unique<palpate::device::SimulatedHand>(hand.value()));
        QTimer::singleShot(3000, &app, &QApplication::quit);
        QObject::connect(&app, &QApplication::aboutToQuit,
                         [&] { std::puts(qPrintable(window.statusBar()->currentMessage())); });
    }
    window.resize(900, 600);
    window.show();
    return app.exec();
}
