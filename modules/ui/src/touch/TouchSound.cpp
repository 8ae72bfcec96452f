// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TouchSound.h"

#include "palpate/ui/TouchTone.h"

#ifdef PALPATE_HAS_SOUND
#include <QAudio>
#include <QAudioDevice>
#include <QAudioFormat>
#include <QAudioSink>
#include <QIODevice>
#include <QMediaDevices>
#include <QThread>
#endif

#include <span>

namespace palpate::ui {

#ifdef PALPATE_HAS_SOUND

namespace {

/// Suppresses Qt's message on stderr about a missing sound server; `whyNot` reports this case to the user.
class Quiet
{
  public:
    Quiet()
        : m_before(qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {}))
    {
    }
    ~Quiet() { qInstallMessageHandler(m_before); }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

  private:
    QtMessageHandler m_before;
};

QAudioDevice loudspeaker()
{
    const Quiet quiet;
    return QMediaDevices::defaultAudioOutput();
}

QAudioFormat mono()
{
    QAudioFormat format;
    format.setSampleRate(TouchTone::kRate_Hz);
    format.setChannelCount(1);
    format.setSampleFormat(QAudioFormat::Float);
    return format;
}

/// Endless tone as input device of QAudioSink.
class ToneStream : public QIODevice
{
  public:
    TouchTone tone;

  protected:
    qint64 readData(char* data, qint64 bytes) override
    {
        // The sink passes an aligned float buffer.
        const auto count = static_cast<std::size_t>(bytes) / sizeof(float);
        tone.fill(std::span(reinterpret_cast<float*>(data), count));
        return static_cast<qint64>(count * sizeof(float));
    }
    qint64 writeData(const char* /*data*/, qint64 /*bytes*/) override { return -1; }
    [[nodiscard]] qint64 bytesAvailable() const override { return 1 << 20; }
};

} // namespace

/// The sink is created and lives on a separate thread, so that slow frames do not interrupt the sound.
struct TouchSound::Output
{
    static constexpr int kBuffer_ms = 60; ///< latency of the sound; shorter buffers stutter with some sound servers

    QThread thread;
    ToneStream* stream = new ToneStream;

    Output(const QAudioDevice& device, TouchSound& owner)
    {
        stream->open(QIODevice::ReadOnly | QIODevice::Unbuffered);
        stream->moveToThread(&thread);
        connect(&thread, &QThread::finished, stream, &QObject::deleteLater);
        thread.start();
        const auto gone = [this, &owner] {
            if (owner.m_output.get() == this) {
                owner.setOn(false);
                Q_EMIT owner.ended();
            }
        };
        QMetaObject::invokeMethod(stream, [tones = stream, device, gone, &owner] {
            auto* sink = new QAudioSink(device, mono(), tones);
            sink->setBufferSize(TouchTone::kRate_Hz * static_cast<int>(sizeof(float)) * kBuffer_ms / 1000);
            connect(sink, &QAudioSink::stateChanged, &owner, [gone](QAudio::State state) {
                if (state == QAudio::StoppedState) {
                    gone();
                }
            });
            sink->start(tones);
            if (sink->error() != QAudio::NoError) {
                QMetaObject::invokeMethod(&owner, gone);
            }
        });
    }
    ~Output()
    {
        thread.quit();
        thread.wait();
    }
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;
};

QString TouchSound::whyNot()
{
    const QAudioDevice device = loudspeaker();
    if (device.isNull()) {
        return tr("no loudspeaker found");
    }
    if (!device.isFormatSupported(mono())) {
        return tr("%1 cannot play the tone").arg(device.description());
    }
    return {};
}

bool TouchSound::setOn(bool isOn)
{
    if (isOn != (m_output != nullptr)) {
        m_output.reset();
        if (isOn && whyNot().isEmpty()) {
            m_output = std::make_unique<Output>(loudspeaker(), *this);
        }
    }
    return m_output != nullptr;
}

void TouchSound::setTouch(double ratio, double force_N, double limit_N)
{
    if (m_output) {
        m_output->stream->tone.set(pitch_Hz(ratio), loudness(force_N, limit_N));
    }
}

#else

struct TouchSound::Output
{
};

QString TouchSound::whyNot()
{
    return tr("built without Qt Multimedia");
}

bool TouchSound::setOn(bool /*isOn*/)
{
    return false;
}

void TouchSound::setTouch(double /*ratio*/, double /*force_N*/, double /*limit_N*/) {}

#endif

TouchSound::TouchSound(QObject* parent)
    : QObject(parent)
{
}

TouchSound::~TouchSound() = default;

} // namespace palpate::ui

#include "palpate/ui/moc_TouchSound.cpp"
