// SPDX-License-Identifier: Apache-2.0
#include "app/plot/qr_code.h"

#include <QPainter>
#include <QPainterPath>

#include <qrencode.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

namespace campanel::plot {

QrModules qrModules(const QString& text)
{
    constexpr unsigned char darkBit = 1;
    constexpr int anyVersion = 0;
    constexpr unsigned int utf8 = 26; // its Extended Channel Interpretation
    const QByteArray bytes = text.toUtf8();
    if (bytes.isEmpty())
        return {};
    const std::unique_ptr<QRinput, decltype(&QRinput_free)> input(QRinput_new2(anyVersion, QR_ECLEVEL_M),
                                                                  &QRinput_free);
    const bool isAscii = std::ranges::all_of(text, [](QChar letter) { return letter.unicode() < 0x80; });
    if (!input || (!isAscii && QRinput_appendECIheader(input.get(), utf8) != 0) ||
        QRinput_append(input.get(), QR_MODE_8, static_cast<int>(bytes.size()),
                       reinterpret_cast<const unsigned char*>(bytes.constData())) != 0)
        return {};
    const std::unique_ptr<QRcode, decltype(&QRcode_free)> code(QRcode_encodeInput(input.get()), &QRcode_free);
    if (!code)
        return {};
    QrModules modules{code->width, {}};
    const auto count = static_cast<std::size_t>(code->width) * static_cast<std::size_t>(code->width);
    modules.dark.reserve(count);
    std::transform(code->data, code->data + count, std::back_inserter(modules.dark),
                   [](unsigned char module) { return (module & darkBit) != 0; });
    return modules;
}

void paintQrCode(QPainter& painter, const QRectF& square, const QrModules& modules)
{
    if (modules.perSide == 0)
        return;
    QPainterPath dark;
    for (int row = 0; row < modules.perSide; ++row) {
        for (int column = 0; column < modules.perSide; ++column) {
            if (modules.dark[static_cast<std::size_t>(row * modules.perSide + column)])
                dark.addRect(column, row, 1, 1);
        }
    }
    const double side = modules.perSide + 2.0 * qrQuietModules;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillRect(square, Qt::white);
    painter.translate(square.topLeft());
    painter.scale(square.width() / side, square.height() / side);
    painter.translate(qrQuietModules, qrQuietModules);
    painter.fillPath(dark.simplified(), Qt::black); // one outline: no seams between modules on paper
    painter.restore();
}

QrCode::QrCode(QQuickItem* parent)
    : QQuickPaintedItem(parent)
{
}

void QrCode::setText(const QString& text)
{
    if (m_text == text)
        return;
    m_text = text;
    m_modules = qrModules(text);
    update(boundingRect().toAlignedRect());
    emit textChanged();
}

void QrCode::paint(QPainter* painter)
{
    const int modules = m_modules.perSide + 2 * qrQuietModules;
    const double side = modules * std::floor(std::min(width(), height()) / modules);
    paintQrCode(*painter, {std::floor((width() - side) / 2), std::floor((height() - side) / 2), side, side},
                m_modules);
}

} // namespace campanel::plot
