// SPDX-License-Identifier: Apache-2.0
#include "app/report/commissioning_pdf.h"

#include "app/plot/curve_plot.h"
#include "app/plot/qr/qr_code.h"

#include <QBuffer>
#include <QGuiApplication>
#include <QPainter>
#include <QPdfWriter>

#include <algorithm>
#include <array>

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
constexpr double barHeightPx = 44;
constexpr double signatureHeightPx = 54;

QFont fontOf(int px, bool isBold = false)
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(px);
    font.setBold(isBold);
    return font;
}

class Paper {
public:
    Paper(QIODevice& device, const panel::ReportData& data, const ReportColors& colors)
        : m_data(data)
        , m_colors(colors)
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
        text(m_data.title, fontOf(titlePx, true), m_colors.ink, 0, m_width);
        text(m_data.recipe, fontOf(headingPx), m_colors.secondaryInk, 0, m_width);
        if (!m_data.machine.isEmpty())
            text(m_data.machine, fontOf(textPx), m_colors.secondaryInk, 0, m_width);
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
            text(each.title, fontOf(textPx), m_colors.secondaryInk, left, width);
            text(each.code, fontOf(headingPx, true), m_colors.ink, left, width, Qt::TextWrapAnywhere);
            x += column + gapPx;
            bottom = std::max(bottom, m_y);
        }
        m_y = bottom + gapPx;
    }

    // Paints the states of a shift over its hours, and what each pattern means.
    void bar()
    {
        const panel::ReportBar& bar = m_data.bar;
        if (bar.stretches.isEmpty())
            return;
        const QRectF frame(0, m_y, m_width, barHeightPx);
        for (const auto& each : bar.stretches)
            paintState({each.from * m_width, m_y, each.width * m_width, barHeightPx}, each.kind);
        m_painter.setPen(m_colors.line);
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawRect(frame);
        m_painter.setFont(fontOf(textPx - 2));
        m_painter.setPen(m_colors.secondaryInk);
        const double top = m_y + barHeightPx;
        constexpr double labelPx = 44;
        double free = -labelPx;
        for (const auto& [share, words] : bar.hours) {
            const double middle = std::clamp(share * m_width, labelPx / 2, m_width - labelPx / 2);
            if (middle - labelPx / 2 < free)
                continue;
            m_painter.drawText(QRectF(middle - labelPx / 2, top, labelPx, 1.6 * textPx), Qt::AlignCenter,
                               words);
            free = middle + labelPx / 2;
        }
        m_y = top + 2 * textPx;
        const double column = m_width / static_cast<double>(std::max<qsizetype>(1, bar.kinds.size()));
        for (qsizetype kind = 0; kind < bar.kinds.size(); ++kind) {
            const double x = static_cast<double>(kind) * column;
            paintState({x, m_y, 2.0 * textPx, textPx}, static_cast<int>(kind));
            m_painter.setPen(m_colors.secondaryInk);
            m_painter.drawText(QRectF(x + 2.6 * textPx, m_y - 2, column - 2.6 * textPx, 1.4 * textPx),
                               Qt::AlignLeft | Qt::AlignVCenter, bar.kinds[kind]);
        }
        m_y += 1.6 * textPx + gapPx;
    }

    // Paints a line for each thing that is written by hand.
    void signatures()
    {
        if (m_data.signatures.isEmpty())
            return;
        need(signatureHeightPx);
        const double y = m_y + signatureHeightPx - 2 * textPx;
        const double column = m_width / static_cast<double>(m_data.signatures.size());
        for (qsizetype i = 0; i < m_data.signatures.size(); ++i) {
            const double x = static_cast<double>(i) * column;
            m_painter.setPen(m_colors.ink);
            m_painter.drawLine(QPointF(x, y), QPointF(x + column - gapPx, y));
            m_painter.setPen(m_colors.secondaryInk);
            m_painter.setFont(fontOf(textPx));
            m_painter.drawText(QRectF(x, y + rowGapPx, column - gapPx, 1.6 * textPx), Qt::AlignLeft,
                               m_data.signatures[i]);
        }
        m_y = y + 2 * textPx + gapPx;
    }

    void section(const panel::ReportSection& section)
    {
        // A heading must not be alone at the end of a page.
        need(heightOf(section.title, fontOf(headingPx, true), m_width) + 4 * textPx);
        text(section.title, fontOf(headingPx, true), m_colors.ink, 0, m_width);
        m_painter.setPen(m_colors.line);
        m_painter.drawLine(QPointF(0, m_y), QPointF(m_width, m_y));
        m_y += rowGapPx;
        rows(section.rows, section.isList);
        for (const QString& each : section.lines) {
            need(heightOf(each, fontOf(textPx), m_width));
            text(each, fontOf(textPx), m_data.isFeasible ? m_colors.ink : m_colors.fault, 0, m_width);
        }
        m_y += gapPx;
    }

    void curves()
    {
        if (!m_data.curves.isValid())
            return;
        need(curvesHeightPx + 2 * headingPx);
        text(m_data.curvesTitle, fontOf(headingPx, true), m_colors.ink, 0, m_width);
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
        style.gridColor = m_colors.line;
        style.inkColor = m_colors.ink;
        style.secondaryInkColor = m_colors.secondaryInk;
        style.markerColor = m_colors.secondaryInk;
        style.velocityColor = m_colors.touch;
        style.accelerationColor = m_colors.acceleration;
        style.frequencyColor = m_colors.frequency;
        style.limitColor = m_colors.secondaryInk;
        style.violationColor = m_colors.fault;
        style.lineWidth = 1.5;
        m_painter.save();
        m_painter.translate(0, m_y);
        plot.print(m_painter);
        m_painter.restore();
        m_y += curvesHeightPx + gapPx;
    }

private:
    // Paints a stretch of the bar; a print in black tells the states apart by their patterns.
    void paintState(const QRectF& place, int kind)
    {
        const std::array brushes{QBrush(m_colors.sync), QBrush(m_colors.secondaryInk, Qt::BDiagPattern),
                                 QBrush(m_colors.warning, Qt::Dense5Pattern),
                                 QBrush(m_colors.touch, Qt::VerPattern), QBrush(m_colors.fault)};
        QBrush brush = brushes[static_cast<std::size_t>(std::clamp(kind, 0, 4))];
        brush.setTransform(QTransform::fromScale(1.0 / dotsPerPx, 1.0 / dotsPerPx));
        m_painter.fillRect(place, brush);
    }

    // Paints two columns of name and value, filled row by row; a list has one.
    void rows(const QList<std::pair<QString, QString>>& rows, bool isList)
    {
        const double column = (m_width - gapPx) / 2;
        const double label = labelShare * column;
        for (qsizetype i = 0; i < rows.size();) {
            // A text wider than half the page gets the whole width.
            const auto isWide = [&](const auto& row) {
                return QFontMetricsF(fontOf(textPx)).horizontalAdvance(row.second) > column - label;
            };
            const bool isAlone = isList || isWide(rows[i]) || i + 1 == rows.size() || isWide(rows[i + 1]);
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
                text(rows[i + k].first, fontOf(textPx), m_colors.secondaryInk, x, label - gapPx);
                m_y = top;
                text(rows[i + k].second, fontOf(textPx), m_colors.ink, x + label, valueWidth);
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
        m_painter.setPen(m_colors.secondaryInk);
        const QRectF foot(0, m_height + textPx / 2.0, m_width, 1.6 * textPx);
        m_painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter, m_data.footer);
        m_painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter, m_data.pageText.arg(m_page));
    }

    const panel::ReportData& m_data;
    const ReportColors& m_colors;
    QPdfWriter m_writer;
    QPainter m_painter;
    double m_width = 0;
    double m_height = 0; // above the footer
    double m_y = 0;
    int m_page = 1;
};

} // namespace

QByteArray commissioningPdf(const panel::ReportData& data, const ReportColors& colors)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        Paper paper(buffer, data, colors);
        paper.title();
        paper.bar();
        paper.codes();
        for (const panel::ReportSection& section : data.sections)
            paper.section(section);
        paper.curves();
        paper.signatures();
    } // closes the file
    return buffer.data();
}

} // namespace campanel::report
