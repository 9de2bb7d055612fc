// SPDX-License-Identifier: Apache-2.0
// campanelctl registers: the register map as document or JSON, and live reading by name.
#include "app/cli/commands.h"
#include "app/cli/invocation.h"
#include "app/cli/link_session.h"
#include "app/cli/report.h"
#include "modbus/map/codec.h"
#include "modbus/map/register_document.h"

#include <QJsonArray>
#include <QJsonDocument>

using namespace Qt::StringLiterals;

namespace campanel::cli {
namespace {

using modbus::RegisterInfo;

QJsonArray registersJson(std::span<const RegisterInfo> rows)
{
    QJsonArray array;
    for (const RegisterInfo& row : rows) {
        QJsonObject object{{u"name"_s, fromView(row.name)},
                           {u"address"_s, row.address},
                           {u"type"_s, fromView(modbus::typeName(row.type))},
                           {u"registers"_s, row.count},
                           {u"writable"_s, row.access == modbus::Access::ReadWrite},
                           {u"scale"_s, row.scale},
                           {u"unit"_s, fromView(row.unit)},
                           {u"meaning"_s, fromView(row.text)}};
        if (!row.enumName.empty())
            object[u"values"_s] = fromView(row.enumName);
        if (row.access == modbus::Access::ReadWrite && row.maximum > row.minimum) {
            object[u"minimum"_s] = row.minimum;
            object[u"maximum"_s] = row.maximum;
            object[u"default"_s] = row.defaultValue;
        }
        array.append(object);
    }
    return array;
}

QByteArray mapJson()
{
    QJsonObject values;
    for (const modbus::EnumInfo& info : modbus::enumerations()) {
        QJsonArray entries;
        for (const modbus::EnumValue& value : info.values)
            entries.append(QJsonObject{{u"value"_s, value.value},
                                       {u"name"_s, fromView(value.name)},
                                       {u"meaning"_s, QString::fromStdString(modbus::meaning(value))}});
        values[fromView(info.name)] = entries;
    }
    return QJsonDocument(QJsonObject{{u"map_major"_s, modbus::mapMajor},
                                     {u"map_minor"_s, modbus::mapMinor},
                                     {u"device_type"_s, modbus::deviceType},
                                     {u"active_bank"_s, modbus::activeBankBase},
                                     {u"staged_bank"_s, modbus::stagedBankBase},
                                     {u"registers"_s, registersJson(modbus::registers())},
                                     {u"bank_fields"_s, registersJson(modbus::bankFields())},
                                     {u"values"_s, values}})
        .toJson();
}

QString addressText(const RegisterInfo& row)
{
    return QString::fromStdString(modbus::hexAddress(row.address));
}

QByteArray mapLines(bool isCsv)
{
    using Csv = store::CsvWriter;
    using Row = RegisterInfo;
    store::CsvTable<Row> csv(
        {{u"address"_s, [](Csv& line, const Row& row) { line.text(addressText(row)); }},
         {u"name"_s, [](Csv& line, const Row& row) { line.text(fromView(row.name)); }},
         {u"type"_s, [](Csv& line, const Row& row) { line.text(fromView(modbus::typeName(row.type))); }},
         {u"registers"_s, [](Csv& line, const Row& row) { line.whole(row.count); }},
         {u"writable"_s,
          [](Csv& line, const Row& row) { line.yesOrNo(row.access == modbus::Access::ReadWrite); }},
         {u"scale"_s, [](Csv& line, const Row& row) { line.significant(row.scale); }},
         {u"unit"_s, [](Csv& line, const Row& row) { line.text(fromView(row.unit)); }}});
    QString text;
    for (const auto rows : {modbus::registers(), modbus::bankFields()}) {
        for (const RegisterInfo& row : rows) {
            csv.add(row);
            text += u"%1  %2 %3 %4\n"_s.arg(addressText(row), fromView(row.name).leftJustified(34),
                                            fromView(modbus::typeName(row.type)).leftJustified(6),
                                            fromView(row.text));
        }
    }
    return isCsv ? csv.bytes() : text.toUtf8();
}

// Returns the address; fields of a bank have offsets and are read from the active bank.
std::uint16_t addressOf(const RegisterInfo& info)
{
    const auto fields = modbus::bankFields();
    const bool inBank = &info >= fields.data() && &info < fields.data() + fields.size();
    return static_cast<std::uint16_t>(info.address + (inBank ? modbus::activeBankBase : 0));
}

Outcome readLive(const Invocation& call, const QString& format)
{
    QList<const RegisterInfo*> wanted;
    for (const QString& name : call.arguments()) {
        const RegisterInfo* info = modbus::findRegister(name.toStdString());
        if (info == nullptr)
            return fail(ExitCode::Usage,
                        u"Unknown register \"%1\". campanelctl registers lists all registers."_s.arg(name));
        if (info->type == modbus::RegisterType::Block)
            return fail(ExitCode::Usage, u"%1 is a block of %2 registers; name a single value."_s.arg(
                                             name, QString::number(info->count)));
        wanted << info;
    }
    if (wanted.isEmpty())
        return fail(ExitCode::Usage, u"Name the registers to read, such as status.state."_s);
    auto session = LinkSession::open(call);
    if (!session)
        return tl::unexpected(session.error());
    QJsonObject values;
    for (const RegisterInfo* info : wanted) {
        const auto read = session->client().readProven(addressOf(*info), info->count);
        if (!read)
            return fail(read.error());
        const modbus::RegisterReader reader(*read, info->address);
        const bool isText = info->type == modbus::RegisterType::Text;
        values[fromView(info->name)] = isText ? QJsonValue(QString::fromStdString(reader.text(*info)))
                                              : QJsonValue(reader.physical(*info));
    }
    return call.deliver(formatted(values, format));
}

} // namespace

Outcome runRegisters(const Invocation& call)
{
    QString format = call.format();
    if (call.isSet(u"json"_s))
        format = u"json"_s;
    if (call.isSet(u"markdown"_s))
        format = u"markdown"_s;
    if (call.isSet(u"read"_s)) {
        if (format == u"markdown")
            return fail(ExitCode::Usage, u"Values are printed as text, csv or json, not as markdown."_s);
        return readLive(call, format);
    }
    if (!call.arguments().isEmpty())
        return fail(ExitCode::Usage,
                    u"To read %1, add --read and --port."_s.arg(call.arguments().join(u", "_s)));
    if (format == u"json")
        return call.deliver(mapJson());
    if (format == u"markdown")
        return call.deliver(QByteArray::fromStdString(modbus::registersMarkdown()));
    return call.deliver(mapLines(format == u"csv"));
}

} // namespace campanel::cli
