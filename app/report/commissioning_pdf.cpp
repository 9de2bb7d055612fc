// SPDX-License-Identifier: Apache-2.0
#include "app/report/commissioning_pdf.h"

#include "app/plot/curve_plot.h"
#include "app/plot/qr/qr_code.h"

#include <QBuffer>
#include <QGuiApplication>
#include <QPainter>
#include <QPdfWriter>

#include <algorithm>

namespace campanel::report {

namespace {

// The resolution: sizes are in px of 1/96 inch; the paper has four times as many dots.
constexpr int dotsPerPx = 4;
constexpr int dotsPerInch = 96 * dotsPerPx;
constexpr double marginMm = 18;
constexpr int titlePx = 26;
constexpr int headingPx = 15;
constexpr int textPx = 12;
constexpr double gapPx = 14;
constexpr double rowGapPx = 3;
constexpr double labelShare = 0.45; // share of a column
constexpr double curvesHeightPx = 560;
constexpr double qrSidePx = 120; // 32 mm: modules of 0.7 mm for the longest code
const QColor ink(0x17, 0x21, 0x2B);
const QColor secondary(0x5A, 0x68, 0x75);
const QColor line(0xCF, 0xD6, 0xDC);
const QColor fault(0xB3, 0x26, 0x1E);

QFont fontOf(int px, bool isBold = false)
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(px);
    font.setBold(isBold);
    return font;
}

class Paper {
public:
    Paper(QIODevice& device, const panel::ReportData& data)
        : m_data(data)
        , m_writer(&device)
    {
        m_writer.setResolution(dotsPerInch);
        m_writer.setPageLayout({QPageSize(QPageSize::A4), QPageLayout::Portrait,
                                QMarginsF(marginMm, marginMm, marginMm, marginMm), QPageLayout::Millimeter});
        m_writer.setTitle(data.title + QStringLiteral(" - ") + data.recipe);
        m_writer.setCreator(QStringLiteral("CamPanel"));
        m_painter.begin(&m_writer);
        m_painter.scale(dotsPerPx, dotsPerPx);
        m_width = static_cast<double>(m_writer.width()) / dotsPerPx;
        m_height = static_cast<double>(m_writer.height()) / dotsPerPx - 2 * textPx;
        furnish();
    }

    void title()
    {
        text(m_data.title, fontOf(titlePx, true), ink, 0, m_width);
        text(m_data.recipe, fontOf(headingPx), secondary, 0, m_width);
        m_y += gapPx;
    }

    // Paints QR codes side by side, each with its text.
    void codes()
    {
        if (m_data.codes.isEmpty())
            return;
        need(qrSidePx);
        const double top = m_y;
        double bottom = top + qrSidePx;
        const double column = (m_width - gapPx) / 2;
        double x = 0;
        for (const panel::ReportCode& each : m_data.codes) {
            plot::paintQrCode(m_painter, {x, top, qrSidePx, qrSidePx}, plot::qrModules(each.code));
            const double left = x + qrSidePx;
            const double width = column - qrSidePx;
            m_y = top + headingPx;
            text(each.title, fontOf(textPx), secondary, left, width);
            text(each.code, fontOf(headingPx, true), ink, left, width, Qt::TextWrapAnywhere);
            x += column + gapPx;
            bottom = std::max(bottom, m_y);
        }
        m_y = bottom + gapPx;
    }

    void section(const panel::ReportSection& section)
    {
        // A heading must not be alone at the end of a page.
        need(heightOf(section.title, fontOf(headingPx, true), m_width) + 4 * textPx);
        text(section.title, fontOf(headingPx, true), ink, 0, m_width);
        m_painter.setPen(line);
        m_painter.drawLine(QPointF(0, m_y), QPointF(m_width, m_y));
        m_y += rowGapPx;
        rows(section.rows);
        for (const QString& each : section.lines) {
            need(heightOf(each, fontOf(textPx), m_width));
            text(each, fontOf(textPx), m_data.isFeasible ? ink : fault, 0, m_width);
        }
        m_y += gapPx;
    }

    void curves()
    {
        if (!m_data.curves.isValid())
            return;
        need(curvesHeightPx + 2 * headingPx);
        text(m_data.curvesTitle, fontOf(headingPx, true), ink, 0, m_width);
        plot::CurvePlot plot;
        plot.setSize(QSizeF(m_width, curvesHeightPx));
        const auto set = [&plot](const char* name, const QVariant& value) { plot.setProperty(name, value); };
        set("curves", m_data.curves);
        set("quantities", m_data.quantities);
        set("titles", m_data.titles);
        set("factors", QVariant::fromValue(m_data.factors));
        set("markerTimes", QVariant::fromValue(m_data.markerTimes));
        set("violations", QVariant::fromValue(m_data.violations));
        set("limitVelocity", m_data.limitVelocity);
        set("limitAcceleration", m_data.limitAcceleration);
        set("limitFrequency", m_data.limitFrequency);
        set("limitLabel", m_data.limitLabel);
        plot::CurveStyle& style = *plot.curveStyle();
        style.axisFont = fontOf(textPx - 1);
        style.titleFont = fontOf(textPx, true);
        style.locale = QLocale();
        style.gridColor = line;
        style.inkColor = ink;
        style.secondaryInkColor = secondary;
        style.markerColor = secondary;
        style.velocityColor = QColor(0x0A, 0x6C, 0x9E);
        style.accelerationColor = QColor(0x1E, 0x7B, 0x4A);
        style.frequencyColor = QColor(0x6A, 0x3F, 0x9C);
        style.limitColor = QColor(0xB2, 0x6A, 0x00);
        style.violationColor = fault;
        style.lineWidth = 1.5;
        m_painter.save();
        m_painter.translate(0, m_y);
        plot.print(m_painter);
        m_painter.restore();
        m_y += curvesHeightPx + gapPx;
    }

private:
    // Paints two columns of name and value, filled row by row.
    void rows(const QList<std::pair<QString, QString>>& rows)
    {
        const double column = (m_width - gapPx) / 2;
        const double label = labelShare * column;
        for (qsizetype i = 0; i < rows.size();) {
            // A text wider than half the page gets the whole width.
            const auto isWide = [&](const auto& row) {
                return QFontMetricsF(fontOf(textPx)).horizontalAdvance(row.second) > column - label;
            };
            const bool isAlone = isWide(rows[i]) || i + 1 == rows.size() || isWide(rows[i + 1]);
            const qsizetype count = isAlone ? 1 : 2;
            const double valueWidth = (isAlone ? m_width : column) - label;
            double height = 0;
            for (qsizetype k = i; k < i + count; ++k)
                height = std::max({height, heightOf(rows[k].first, fontOf(textPx), label - gapPx),
                                   heightOf(rows[k].second, fontOf(textPx), valueWidth)});
            need(height);
            const double top = m_y;
            for (qsizetype k = 0; k < count; ++k) {
                const double x = static_cast<double>(k) * (column + gapPx);
                m_y = top;
                text(rows[i + k].first, fontOf(textPx), secondary, x, label - gapPx);
                m_y = top;
                text(rows[i + k].second, fontOf(textPx), ink, x + label, valueWidth);
            }
            m_y = top + height + rowGapPx;
            i += count;
        }
    }

    [[nodiscard]] double heightOf(const QString& words, const QFont& font, double width,
                                  Qt::TextFlag wrap = Qt::TextWordWrap)
    {
        m_painter.setFont(font);
        return m_painter.boundingRect(QRectF(0, 0, width, m_height), wrap, words).height();
    }

    void text(const QString& words, const QFont& font, const QColor& color, double x, double width,
              Qt::TextFlag wrap = Qt::TextWordWrap)
    {
        const double height = heightOf(words, font, width, wrap);
        m_painter.setFont(font);
        m_painter.setPen(color);
        m_painter.drawText(QRectF(x, m_y, width, height + 1), wrap, words);
        m_y += height + rowGapPx;
    }

    void need(double height)
    {
        if (m_y + height <= m_height || m_y == 0)
            return;
        m_writer.newPage();
        ++m_page;
        m_y = 0;
        furnish();
    }

    // Paints the footer of each page.
    void furnish()
    {
        m_painter.setFont(fontOf(textPx - 2));
        m_painter.setPen(secondary);
        const QRectF foot(0, m_height + textPx / 2.0, m_width, 1.6 * textPx);
        m_painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter, m_data.footer);
        m_painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter, m_data.pageText.arg(m_page));
    }

    const panel::ReportData& m_data;
    QPdfWriter m_writer;
    QPainter m_painter;
    double m_width = 0;
    double m_height = 0; // above the footer
    double m_y = 0;
    int m_page = 1;
};

} // namespace

QByteArray commissioningPdf(const panel::ReportData& data)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        Paper paper(buffer, data);
        paper.title();
        paper.codes();
        for (const panel::ReportSection& section : data.sections)
            paper.section(section);
        paper.curves();
    } // closes the file
    return buffer.data();
}

} // namespace campanel::report
