// SPDX-License-Identifier: Apache-2.0
#include "app/panel/download/program_proof.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/words/connection_sentences.h"

#include <algorithm>
#include <span>
#include <utility>

using namespace Qt::StringLiterals;

namespace campanel::panel {

using link::ComparisonStage;

namespace {

const auto unknownText = u"--"_s;

// Returns the recipe without limits: they are not in the bank and do not influence the table.
program::Recipe withoutLimits(program::Recipe recipe)
{
    using profile::Field;
    const auto most = [](Field field) { return profile::info(field).max; };
    recipe.machine.maxMotorRpm = most(Field::MaxMotorRpm);
    recipe.machine.maxKnifeAccelerationMmPerS2 = most(Field::MaxKnifeAcceleration);
    recipe.machine.maxPulseFrequencyHz = most(Field::MaxPulseFrequency);
    recipe.machine.maxRateBagsPerMin = most(Field::MaxRate);
    recipe.machine.maxAccelerationMmPerS2 = most(Field::MaxAcceleration);
    recipe.machine.maxTorqueNm = recipe.machine.ratedTorqueNm = recipe.machine.naturalFrequencyHz = 0;
    return recipe;
}

// Returns the table of the recipe with this CRC-32; empty when there is none. Limits cause refusals and
// influence some tables.
std::vector<std::uint16_t> rebuilt(const program::Recipe& recipe, std::uint32_t crc)
{
    for (const program::Recipe& each : {recipe, withoutLimits(recipe)}) {
        auto image = program::buildProgram(each);
        if (image && image->crc == crc)
            return std::move(image->registers);
    }
    return {};
}

} // namespace

ProgramProof::ProgramProof(Controller& controller, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
{
    connect(&controller.link(), &link::Link::comparisonReported, this, &ProgramProof::takeReport);
}

void ProgramProof::noteDownloaded(std::vector<std::uint16_t> registers, std::uint32_t crc)
{
    m_downloaded = std::move(registers);
    m_downloadedCrc = crc;
}

void ProgramProof::update()
{
    const auto& status = m_controller.status();
    // A result belongs to one program, and is valid while the line is watched.
    const bool isFinding = result() == Result::Equal || result() == Result::Different;
    if (m_hasResult &&
        (!status || status->generation != m_report.generation || (isFinding && !m_controller.isConnected())))
        m_hasResult = false;
    emit changed();
}

QString ProgramProof::blockedReason() const
{
    if (const QString reason = m_controller.blockedReason(Action::Compare); !reason.isEmpty())
        return reason;
    if (!m_controller.status()->activeCrc)
        return tr("The controller has no program. Download a recipe first.");
    return {};
}

void ProgramProof::compare()
{
    if (!canCompare())
        return;
    const std::uint32_t crc = m_controller.status()->activeCrc.value_or(0);
    m_basis = Basis::OwnChecksum;
    m_expected.clear();
    if (!m_downloaded.empty() && m_downloadedCrc == crc) {
        m_basis = Basis::Downloaded;
        m_expected = m_downloaded;
    } else if (const auto& program = m_controller.program()) {
        m_expected = rebuilt(program->recipe, crc);
        m_basis = m_expected.empty() ? Basis::OwnChecksum : Basis::Rebuilt;
    }
    m_report = {};
    m_isRunning = true;
    m_hasResult = false;
    emit changed();
    m_controller.link().compareProgram(m_expected);
}

void ProgramProof::cancel()
{
    if (m_isRunning)
        m_controller.link().cancelComparison();
}

void ProgramProof::takeReport(const link::ComparisonReport& report)
{
    if (!m_isRunning)
        return;
    m_report = report;
    m_isRunning = report.stage == ComparisonStage::Reading;
    m_hasResult = !m_isRunning;
    emit changed();
}

ProgramProof::Result ProgramProof::result() const
{
    if (!m_hasResult)
        return Result::None;
    switch (m_report.stage) {
    case ComparisonStage::Equal:
        return Result::Equal;
    case ComparisonStage::Different:
        return Result::Different;
    default:
        return Result::Undecided;
    }
}

QString ProgramProof::text() const
{
    if (m_hasResult)
        return resultText();
    if (m_isRunning)
        return m_report.isInterrupted
                   ? tr("The connection is lost. The comparison continues when it is restored.")
                   : tr("Reading the table back from the controller …");
    const QString reason = blockedReason();
    return reason.isEmpty()
               ? tr("Reads back and compares every register of the table, also while the machine runs.")
               : reason;
}

QString ProgramProof::basisText() const
{
    switch (m_basis) {
    case Basis::Downloaded:
        return tr("what this panel downloaded");
    case Basis::Rebuilt:
        return tr("the table computed again from its recipe");
    case Basis::OwnChecksum:
        break;
    }
    return tr("the controller's own checksum");
}

QString ProgramProof::resultText() const
{
    switch (m_report.stage) {
    case ComparisonStage::Equal:
        return m_expected.empty() ? tr("Identical: the table of generation %1 matches %2. CRC-32 %3.",
                                       "%2: \"the controller's own checksum\"")
                                        .arg(m_report.generation)
                                        .arg(basisText(), Format::hex(m_report.readCrc, 8))
                                  : tr("Identical: all %1 registers of generation %2 match %3. CRC-32 %4.",
                                       "%3: for example \"what this panel downloaded\"")
                                        .arg(m_expected.size())
                                        .arg(m_report.generation)
                                        .arg(basisText(), Format::hex(m_report.readCrc, 8));
    case ComparisonStage::Different:
        return differentText();
    case ComparisonStage::ProgramChanged:
        return tr("The controller's program changed during the comparison. Compare again.");
    case ComparisonStage::NoProgram:
        return tr("The controller has no program. Download a recipe first.");
    case ComparisonStage::Canceled:
        return tr("Canceled without a result.");
    case ComparisonStage::Failed:
        return failureText();
    case ComparisonStage::Reading:
        break;
    }
    return {};
}

QString ProgramProof::differentText() const
{
    if (!m_report.firstDifference)
        return tr("Different: the table read back has CRC-32 %1, the controller reports %2. Download the "
                  "recipe again.")
            .arg(Format::hex(m_report.readCrc, 8), Format::hex(m_report.controllerCrc, 8));
    const auto& first = *m_report.firstDifference;
    const QString values =
        tr("first %1: %2 instead of %3", "register: its value, expected value")
            .arg(nameOf(first.offset), Format::hex(first.actual, 4), Format::hex(first.expected, 4));
    return m_report.differingRegisters == 1
               ? tr("Different: 1 of %1 registers does not match %2, %3. Download the recipe again.")
                     .arg(m_expected.size())
                     .arg(basisText(), values)
               : tr("Different: %1 of %2 registers do not match %3, %4. Download the recipe again.")
                     .arg(m_report.differingRegisters)
                     .arg(m_expected.size())
                     .arg(basisText(), values);
}

QString ProgramProof::failureText() const
{
    if (m_report.isConnectionMissing)
        return tr("Not compared: there is no connection to the controller.");
    if (m_report.isBusy)
        return tr("Not compared: another comparison is in progress.");
    return m_report.error
               ? tr("Not compared. %1", "%1: whole sentence").arg(ConnectionSentences::error(*m_report.error))
               : QString();
}

// Returns the name of a header field as in the register document, or the number of a row.
QString ProgramProof::nameOf(quint16 offset) const
{
    if (offset >= modbus::bankHeaderRegisters)
        return tr("register %1 of the rows").arg(offset - modbus::bankHeaderRegisters + 1);
    const auto header =
        std::span(m_expected).first(std::min<std::size_t>(m_expected.size(), modbus::bankHeaderRegisters));
    for (const modbus::NamedValue& value : modbus::namedValues(modbus::activeBankBase, header)) {
        const int first = value.address - modbus::activeBankBase;
        if (offset >= first && offset < first + value.count)
            return QString::fromStdString(value.name());
    }
    return Format::hex(modbus::activeBankBase + offset, 4);
}

QString ProgramProof::activeText() const
{
    const auto& program = m_controller.program();
    const auto& status = m_controller.status();
    if (!status)
        return unknownText;
    if (!status->activeCrc)
        return tr("no program");
    if (!program)
        return tr("generation %1, CRC-32 %2").arg(status->generation).arg(Format::hex(*status->activeCrc, 8));
    return tr("%1 · v%2, generation %3, CRC-32 %4")
        .arg(m_controller.active().name, QString::number(m_controller.active().version),
             QString::number(status->generation), Format::hex(*status->activeCrc, 8));
}

QString ProgramProof::savedText() const
{
    const auto& status = m_controller.status();
    if (!status)
        return unknownText;
    if (!status->savedCrc)
        return tr("none: no program after a power loss");
    return status->savedCrc == status->activeCrc ? tr("identical: kept after a power loss")
                                                 : tr("different, CRC-32 %1: restored after a power loss")
                                                       .arg(Format::hex(*status->savedCrc, 8));
}

} // namespace campanel::panel
