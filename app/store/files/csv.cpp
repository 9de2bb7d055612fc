// SPDX-License-Identifier: Apache-2.0
#include "app/store/files/csv.h"

#include "app/store/files/files.h"

#include <QDateTime>
#include <QRegularExpression>

#include <limits>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

// Excel and LibreOffice take a text as a formula that begins with one of these signs, also behind spaces; the
// wide ones in some languages. A spreadsheet of another language splits a text at the other separator, and a
// number there is harmless.
QString withoutFormula(QString text)
{
    static const QRegularExpression formula(u"(^|[,;|])(?=\\s*[=+\\-@\uFF1D\uFF0B\uFF0D\uFF20])"
                                            "(?!(?<=.)\\s*[+-]?[0-9]+([.,][0-9]+)?\\s*($|[,;|]))"_s,
                                            QRegularExpression::UseUnicodePropertiesOption);
    return text.replace(formula, u"\\1'"_s);
}

} // namespace

CsvDialect spreadsheetDialect(const QLocale& locale)
{
    const bool hasComma = locale.decimalPoint() == u","_s;
    return {hasComma ? ';' : ',', hasComma ? ',' : '.', true};
}

CsvWriter::CsvWriter(QStringView header, const CsvDialect& dialect)
    : m_csv(dialect)
{
    for (const QStringView name : header.split(u','))
        text(name.toString());
    endLine();
}

void CsvWriter::endLine()
{
    m_csv.endLine();
    ++m_rows;
}

CsvWriter& CsvWriter::text(const QString& text)
{
    m_csv.add(withoutFormula(oneLine(text, std::numeric_limits<qsizetype>::max())).toStdString());
    return *this;
}

CsvWriter& CsvWriter::value(const QString& text)
{
    static const QRegularExpression number(u"^-?[0-9]+(\\.[0-9]+)?(e[+-]?[0-9]+)?$"_s);
    if (!number.match(text).hasMatch())
        return this->text(text);
    m_csv.addDigits(text.toStdString());
    return *this;
}

CsvWriter& CsvWriter::number(double value, int decimals)
{
    m_csv.addFixed(value, decimals);
    return *this;
}

CsvWriter& CsvWriter::number(const std::optional<double>& value, int decimals)
{
    return value ? number(*value, decimals) : empty();
}

CsvWriter& CsvWriter::significant(double value)
{
    constexpr int digits = 10;
    m_csv.addSignificant(value, digits);
    return *this;
}

CsvWriter& CsvWriter::whole(qint64 value)
{
    m_csv.addWhole(value);
    return *this;
}

CsvWriter& CsvWriter::empty()
{
    m_csv.add({});
    return *this;
}

CsvWriter& CsvWriter::utc(qint64 timeMs)
{
    return text(timeMs == 0 ? QString()
                            : QDateTime::fromMSecsSinceEpoch(timeMs).toUTC().toString(Qt::ISODateWithMs));
}

CsvWriter& CsvWriter::utcAndLocal(qint64 timeMs)
{
    const QDateTime local = QDateTime::fromMSecsSinceEpoch(timeMs);
    utc(timeMs);
    return text(local.toOffsetFromUtc(local.offsetFromUtc()).toString(Qt::ISODateWithMs));
}

CsvWriter& CsvWriter::clock(bool isDoubtful)
{
    return text(isDoubtful ? u"not set"_s : u"set"_s);
}

CsvWriter& CsvWriter::yesOrNo(bool isTrue)
{
    return text(isTrue ? u"yes"_s : u"no"_s);
}

} // namespace campanel::store
