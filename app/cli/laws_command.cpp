// SPDX-License-Identifier: Apache-2.0
// campanelctl laws: the table of laws with their peak values by formula, and their purposes.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/report.h"
#include "profile/laws/laws.h"

#include <QJsonArray>

#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

QStringList usesOf(const profile::Law& law)
{
    QStringList uses;
    if (law.isSpeedLaw)
        uses << u"speed"_s;
    if (law.isDisplacementLaw)
        uses << u"displacement"_s;
    return uses;
}

// Formats with six decimals, like published tables of laws.
QString fixed(double value)
{
    constexpr int decimals = 6;
    return std::isfinite(value) ? QString::number(value, 'f', decimals) : u"inf"_s;
}

// Returns "ramp_fraction = 0.25", the parameters of the row.
QString parametersText(const profile::Law& law)
{
    QStringList texts;
    for (const profile::LawParameterInfo& parameter : law.parameters)
        texts << fromView(parameter.id) + u" = "_s + QString::fromLatin1(number(parameter.defaultValue));
    return texts.join(u"; "_s);
}

struct Row {
    const profile::Law& law;
    profile::LawPeaks peaks;
    double travel; // G(1)

    explicit Row(const profile::Law& of)
        : law(of)
        , peaks(of.peaks(defaultParameters(of)))
        , travel(of.at(1, defaultParameters(of)).integral)
    {
    }
};

QJsonObject asJson(const Row& row)
{
    QJsonArray parameters;
    for (const profile::LawParameterInfo& parameter : row.law.parameters)
        parameters.append(QJsonObject{{u"id"_s, fromView(parameter.id)},
                                      {u"minimum"_s, parameter.min},
                                      {u"maximum"_s, parameter.max},
                                      {u"default"_s, parameter.defaultValue}});
    return {{u"key"_s, fromView(row.law.key)},
            {u"name"_s, fromView(row.law.name)},
            {u"uses"_s, QJsonArray::fromStringList(usesOf(row.law))},
            {u"parameters"_s, parameters},
            {u"cv"_s, row.peaks.cv},
            {u"ca"_s, row.peaks.ca},
            {u"cj"_s, row.peaks.cj}, // JSON has no infinity: null
            {u"g_integral"_s, row.travel},
            {u"strength"_s, fromView(row.law.strength)},
            {u"weakness"_s, fromView(row.law.weakness)}};
}

const store::CsvColumns<Row>& lawColumns()
{
    using Csv = store::CsvWriter;
    static const store::CsvColumns<Row> all{
        {u"key"_s, [](Csv& csv, const Row& row) { csv.text(fromView(row.law.key)); }},
        {u"name"_s, [](Csv& csv, const Row& row) { csv.text(fromView(row.law.name)); }},
        {u"uses"_s, [](Csv& csv, const Row& row) { csv.text(usesOf(row.law).join(u"; "_s)); }},
        {u"parameters"_s, [](Csv& csv, const Row& row) { csv.text(parametersText(row.law)); }},
        {u"cv"_s, [](Csv& csv, const Row& row) { csv.value(fixed(row.peaks.cv)); }},
        {u"ca"_s, [](Csv& csv, const Row& row) { csv.value(fixed(row.peaks.ca)); }},
        {u"cj"_s, [](Csv& csv, const Row& row) { csv.value(fixed(row.peaks.cj)); }},
        {u"g_integral"_s, [](Csv& csv, const Row& row) { csv.value(fixed(row.travel)); }},
        {u"strength"_s, [](Csv& csv, const Row& row) { csv.text(fromView(row.law.strength)); }},
        {u"weakness"_s, [](Csv& csv, const Row& row) { csv.text(fromView(row.law.weakness)); }}};
    return all;
}

QString textLine(const QString& key, const QString& name, const QString& uses, const QStringList& numbers)
{
    QString line = key.leftJustified(20) + name.leftJustified(20) + uses.leftJustified(20);
    for (const QString& cell : numbers)
        line += cell.rightJustified(12);
    return line + u'\n';
}

QString asText(const Row& row)
{
    QString text =
        textLine(fromView(row.law.key), fromView(row.law.name), usesOf(row.law).join(u", "_s),
                 {fixed(row.peaks.cv), fixed(row.peaks.ca), fixed(row.peaks.cj), fixed(row.travel)});
    if (!row.law.parameters.empty())
        text += u"    with "_s + parametersText(row.law) + u'\n';
    return text + u"    + "_s + fromView(row.law.strength) + u"\n    - "_s + fromView(row.law.weakness) +
           u'\n';
}

} // namespace

Outcome runLaws(const Invocation& call)
{
    QString format = call.format();
    for (const QString& name : {u"csv"_s, u"json"_s}) {
        if (call.isSet(name))
            format = name;
    }
    QJsonArray list;
    store::CsvTable<Row> csv(lawColumns());
    QString text = textLine(u"key"_s, u"name"_s, u"uses"_s, {u"Cv"_s, u"Ca"_s, u"Cj"_s, u"G(1)"_s});
    for (const profile::Law& law : profile::laws()) {
        const Row row(law);
        list.append(asJson(row));
        csv.add(row);
        text += asText(row);
    }
    if (format == u"json")
        return call.deliver(formatted({{u"laws"_s, list}}, format));
    return call.deliver(format == u"csv" ? csv.bytes() : text.toUtf8());
}

} // namespace campanel::cli
