// SPDX-License-Identifier: Apache-2.0
// Invariants of the register table and its texts; REGISTERS.md must match the table.
// `campanel-generate-registers --markdown` writes it.
#include "modbus/map/blocks.h"
#include "modbus/map/crc32.h"
#include "modbus/map/register_document.h"
#include "modbus/map/register_map.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QtTest>

#include <QFile>
#include <QSet>

#include <bit>
#include <cstring>

namespace test_register_map {

using namespace campanel::modbus;

class RegisterMapTest : public QObject {
    Q_OBJECT

private slots:
    void committedDocumentIsCurrent();
    void namesAreUnique();
    void everyEnumNameIsListed();
    void enumValuesAreUniqueAndExplained();
    void everyDefaultIsInsideItsLimits();
    void banksFitBetweenTheirBases();
    void windowsFitOneFrame();
    void blocksHaveTheLengthsThatTheClientReads();
    void headerNamesEveryRegister();
    void registersOfMap12AreUnchanged();
};

void RegisterMapTest::committedDocumentIsCurrent()
{
    QFile file(campanel::test::sourcePath("modbus/REGISTERS.md"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray generated = QByteArray::fromStdString(registersMarkdown());
    QVERIFY2(file.readAll() == generated,
             "modbus/REGISTERS.md is out of date: write it anew by campanel-generate-registers --markdown");
}

void RegisterMapTest::namesAreUnique()
{
    QSet<QByteArray> seen;
    for (const auto rows : {registers(), bankFields()}) {
        for (const RegisterInfo& row : rows) {
            const QByteArray name(row.name.data(), static_cast<qsizetype>(row.name.size()));
            QVERIFY2(!seen.contains(name), name.constData());
            QVERIFY2(!row.text.empty(), name.constData());
            seen.insert(name);
        }
    }
    QVERIFY(findRegister("status.no_such") == nullptr);
}

void RegisterMapTest::everyEnumNameIsListed()
{
    for (const auto rows : {registers(), bankFields()}) {
        for (const RegisterInfo& row : rows) {
            if (row.enumName.empty())
                continue;
            const auto all = enumerations();
            const bool listed = std::any_of(
                all.begin(), all.end(), [&row](const EnumInfo& info) { return info.name == row.enumName; });
            QVERIFY2(listed, row.enumName.data());
        }
    }
}

void RegisterMapTest::enumValuesAreUniqueAndExplained()
{
    for (const EnumInfo& info : enumerations()) {
        // Values count up without gaps, from 0 or, for laws, from 1: a decoder may compare with the last one.
        std::uint16_t expected = info.name == "Law" ? 1 : 0;
        for (const EnumValue& value : info.values) {
            if (info.name == "BagBit" && value.name == "Taken") // behind the bag lengths of the record
                expected = bagLengthsFrom + std::bit_width(maxBagLengths);
            QVERIFY2(value.value == expected++, value.name.data());
            const std::string text = meaning(value);
            QVERIFY2(text.ends_with('.'), value.name.data());
            QVERIFY2(text.find('%') == std::string::npos, value.name.data());
            QCOMPARE(enumText(info.name, value.value), text);
            QCOMPARE(enumName(info.name, value.value), std::string(value.name));
        }
        QVERIFY(enumText(info.name, expected).empty());
    }
    QVERIFY(!enumText("Refusal", static_cast<std::uint16_t>(Refusal::HeartbeatLost)).empty());
    QVERIFY(!enumText("TransferResult", static_cast<std::uint16_t>(TransferResult::StateRefuses)).empty());
    QVERIFY(!enumText("Command", static_cast<std::uint16_t>(Command::SetClock)).empty());
}

void RegisterMapTest::everyDefaultIsInsideItsLimits()
{
    for (const RegisterInfo& row : registers()) {
        if (row.access != Access::ReadWrite || row.type == RegisterType::Block)
            continue;
        QVERIFY2(row.minimum <= row.defaultValue && row.defaultValue <= row.maximum, row.name.data());
        QVERIFY2(row.maximum > row.minimum, row.name.data());
    }
}

void RegisterMapTest::banksFitBetweenTheirBases()
{
    QVERIFY(activeBankBase + bankRegisters <= stagedBankBase);
    QVERIFY(stagedBankBase + bankRegisters <= 0x10000);
    const RegisterInfo& lastField = bankFields()[bankFields().size() - 2];
    QCOMPARE(lastField.address + lastField.count, int{bankHeaderRegisters});
    QCOMPARE(int{bankFields().back().address}, int{bankHeaderRegisters});
}

void RegisterMapTest::windowsFitOneFrame()
{
    // Function 23 has at most 121 written and 125 read registers.
    const int transferWritten =
        findRegister("transfer.data")->address + blockRegisters - findRegister("transfer.session")->address;
    QVERIFY(transferWritten <= 121);
    const int readbackRead = findRegister("readback_result.data")->address + readbackRegisters -
                             findRegister("readback_result.tag")->address;
    QCOMPARE(readbackRead, 125);
}

void RegisterMapTest::blocksHaveTheLengthsThatTheClientReads()
{
    const auto end = [](std::string_view name) {
        return findRegister(name)->address + findRegister(name)->count;
    };
    QCOMPARE(end("identity.max_pulse_frequency") - identityAddress, int{identityRegisters});
    QCOMPARE(end("status.sample_time") - statusAddress, 40);
    QCOMPARE(end("result.reason") - findRegister("result.counter")->address, int{commandResultRegisters});
    QCOMPARE(end("transfer_result.staged_crc") - findRegister("transfer_result.session")->address,
             int{transferResultRegisters});
    QCOMPARE(end("command.argument2") - findRegister("command.counter")->address, 6);
}

void RegisterMapTest::headerNamesEveryRegister()
{
    const QByteArray header = QByteArray::fromStdString(registersCHeader());
    QVERIFY(header.contains("#define CTL_REG_STATUS_ACTIVE_CRC 0x0109u\n"));
    QVERIFY(header.contains("#define CTL_COMMAND_STOP_AT_CYCLE_END 2u\n"));
    QVERIFY(header.contains("#define CTL_MAX_PARAMETER_RAMP_TIME 10000u\n"));
    for (const RegisterInfo& row : registers()) {
        QByteArray name(row.name.data(), static_cast<qsizetype>(row.name.size()));
        QVERIFY2(header.contains("#define CTL_REG_" + name.toUpper().replace('.', '_') + ' '),
                 name.constData());
    }
}

// A panel of register map 1.2 works with this controller: what it knows is where it was. The number is the
// CRC-32 of that map's rows.
void RegisterMapTest::registersOfMap12AreUnchanged()
{
    std::vector<std::uint8_t> rows;
    int count = 0;
    for (const RegisterInfo& row : registers()) {
        const bool isNewParameter = row.name.starts_with("parameter.") && row.address >= 0x00A6;
        if (row.minor != 0 || isNewParameter || row.name.starts_with("io.") ||
            row.name == "identity.table_layouts")
            continue;
        ++count;
        // The windows of the banks may grow: a controller says how large its own are
        // (identity.bank_registers).
        const bool isBank = row.name == "active" || row.name == "staged";
        constexpr int bankRegistersOfMap12 = 8468;
        QVERIFY(!isBank || row.count >= bankRegistersOfMap12);
        const QByteArray text =
            QByteArray(row.name.data(), static_cast<qsizetype>(row.name.size())) + ' ' +
            QByteArray::number(row.address) + ' ' + QByteArray::number(static_cast<int>(row.type)) + ' ' +
            QByteArray::number(isBank ? bankRegistersOfMap12 : row.count) + ' ' +
            QByteArray::number(static_cast<int>(row.access)) + ' ' + QByteArray::number(row.scale) + '\n';
        rows.insert(rows.end(), text.begin(), text.end());
    }
    QCOMPARE(count, 141);
    QCOMPARE(crc32(rows), 1240010993u);
}

CAMPANEL_TEST(RegisterMapTest)

} // namespace test_register_map

#include "test_register_map.moc"
