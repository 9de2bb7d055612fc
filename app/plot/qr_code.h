// SPDX-License-Identifier: Apache-2.0
// The QR code of a text (ISO/IEC 18004, by libqrencode), on the screen and on paper. It is black on white in
// every theme: not each scanner reads it inverted.
#pragma once

#include <QQuickPaintedItem>
#include <QtQml/qqmlregistration.h>

#include <vector>

namespace campanel::plot {

// The quiet zone that the standard demands on each side, in modules.
constexpr int qrQuietModules = 4;

struct QrModules {
    int perSide = 0;        // without the quiet zone; 0: no code
    std::vector<bool> dark; // row by row
};

// Encodes the text as bytes with error correction M; other than ASCII is declared as UTF-8. An empty text and
// one of more than some 2300 bytes have no code.
[[nodiscard]] QrModules qrModules(const QString& text);

// Paints code and quiet zone over the whole square. Paints nothing where there is no code.
void paintQrCode(QPainter& painter, const QRectF& square, const QrModules& modules);

class QrCode : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(QString text READ text WRITE setText NOTIFY textChanged FINAL)

public:
    explicit QrCode(QQuickItem* parent = nullptr);

    // Paints the largest centered square of whole pixels per module.
    void paint(QPainter* painter) override;

    [[nodiscard]] const QString& text() const { return m_text; }
    void setText(const QString& text);

signals:
    void textChanged();

private:
    QString m_text;
    QrModules m_modules;
};

} // namespace campanel::plot
