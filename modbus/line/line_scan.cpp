// SPDX-License-Identifier: Apache-2.0
#include "modbus/line/line_scan.h"

#include <algorithm>
#include <array>

namespace campanel::modbus {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr milliseconds drainTime{25};
// The attempts after a damaged answer, which may be accidental.
constexpr int attemptsWhenDamaged = 2;
// The units of a diagnosis besides the configured one.
constexpr std::array likelyUnits{1, 2, 3};
// The allowance in a search: longer than the 16 ms of a USB adapter and the work of a slow device.
constexpr milliseconds shortAllowance{60};
constexpr milliseconds longAllowance = AnswerAllowance::longest; // the promised maximum

template <typename Candidate> nanoseconds longestTime(const Candidate& candidate)
{
    return pairTime(candidate.line, readFrames(identityRegisters)) + candidate.allowance + drainTime;
}

bool isSame(const LineSettings& a, const LineSettings& b)
{
    return a.baud == b.baud && a.parity == b.parity && a.stopBits == b.stopBits;
}

LineCondition conditionOf(const LinkError& error)
{
    switch (error.kind) {
    case LinkErrorKind::PortAbsent:
        return LineCondition::PortAbsent;
    case LinkErrorKind::PortBusy:
        return LineCondition::PortBusy;
    case LinkErrorKind::PortNotPermitted:
        return LineCondition::PortNotPermitted;
    case LinkErrorKind::PortNotSerial:
        return LineCondition::PortNotSerial;
    case LinkErrorKind::PortSettings:
        return LineCondition::PortSettings;
    case LinkErrorKind::PortGone:
    case LinkErrorKind::NotOpen:
        return LineCondition::PortGone;
    case LinkErrorKind::WrongMapMajor:
        return LineCondition::OtherMapVersion;
    case LinkErrorKind::NotCamPanel:
    case LinkErrorKind::WrongIdentity:
    case LinkErrorKind::ForeignAnswer: // a complete frame, but not ours
        return LineCondition::OtherDevice;
    case LinkErrorKind::BadChecksum:
    case LinkErrorKind::BadFrame:
        return LineCondition::Garbage;
    case LinkErrorKind::Exception:
        return LineCondition::Refused;
    default:
        return LineCondition::NoBytes;
    }
}

bool isAnswer(LineCondition condition)
{
    return condition <= LineCondition::OtherDevice;
}

} // namespace

std::vector<LineSettings> likelyLines(const LineSettings& first)
{
    struct Format {
        Parity parity;
        std::uint8_t stopBits;
    };
    constexpr std::array formats{Format{Parity::None, 1}, Format{Parity::Even, 1}, Format{Parity::None, 2},
                                 Format{Parity::Odd, 1},  Format{Parity::Even, 2}, Format{Parity::Odd, 2}};
    constexpr std::array<std::uint32_t, supportedBauds.size()> bauds{115200, 19200, 9600, 38400, 57600};
    std::vector<LineSettings> lines{first};
    for (const Format& format : formats) {
        for (const std::uint32_t baud : bauds) {
            const LineSettings line{baud, format.parity, format.stopBits};
            if (!isSame(line, first))
                lines.push_back(line);
        }
    }
    return lines;
}

LineScan::LineScan(ScanPlan plan)
    : m_plan(std::move(plan))
{
    if (!m_plan.port.empty())
        m_ports.push_back({m_plan.port});
    if (m_plan.depth != ScanPlan::Depth::Diagnosis) {
        for (const std::string& port : m_plan.otherPorts) {
            if (port != m_plan.port)
                m_ports.push_back({port});
        }
        planSearch(m_plan.depth == ScanPlan::Depth::Usual);
    } else if (!m_ports.empty()) {
        planDiagnosis();
    }
    for (const Candidate& candidate : m_candidates)
        m_remaining += longestTime(candidate);
    m_ended = m_candidates.empty();
}

void LineScan::planDiagnosis()
{
    m_candidates.push_back({0, static_cast<std::uint8_t>(m_plan.unit), m_plan.line, longAllowance});
    for (const int unit : likelyUnits) {
        if (unit != m_plan.unit)
            m_candidates.push_back({0, static_cast<std::uint8_t>(unit), m_plan.line, longAllowance});
    }
}

// Plans the configured unit and unit 1 with every setting of the line, then all units; a usual search only
// has the first part, with one stop bit and no or even parity.
void LineScan::planSearch(bool isUsual)
{
    std::vector<LineSettings> lines = likelyLines(m_plan.line);
    if (isUsual)
        std::erase_if(lines, [&](const LineSettings& line) {
            return !isSame(line, m_plan.line) && (line.stopBits != 1 || line.parity == Parity::Odd);
        });
    const auto ports = static_cast<std::uint16_t>(m_ports.size());
    for (const LineSettings& line : lines) {
        for (std::uint16_t port = 0; port < ports; ++port) {
            m_candidates.push_back({port, static_cast<std::uint8_t>(m_plan.unit), line, shortAllowance});
            if (m_plan.unit != 1)
                m_candidates.push_back({port, 1, line, shortAllowance});
        }
    }
    if (isUsual)
        return;
    for (const LineSettings& line : lines) {
        for (std::uint16_t port = 0; port < ports; ++port)
            planUnits(port, line);
    }
}

void LineScan::planUnits(std::uint16_t port, const LineSettings& line)
{
    for (int unit = 1; unit <= lastUnit; ++unit)
        m_candidates.push_back({port, static_cast<std::uint8_t>(unit), line, shortAllowance});
    m_candidates.back().allowance = longAllowance; // late answers to the last ones arrive before the next
                                                   // line
}

// Returns true when bytes that answer this question of a search may be the late answer to an earlier one.
bool LineScan::mayBeLate(const Candidate& candidate) const
{
    const bool isAskedAgain =
        m_patient && m_patient->port == candidate.port && isSame(m_patient->line, candidate.line);
    return candidate.allowance == shortAllowance && !isAskedAgain;
}

// Repeats the questions that a late answer may belong to before the next one.
void LineScan::askAgainPatiently()
{
    m_patient = m_candidates[m_next];
    std::vector<Candidate> again;
    nanoseconds before{0};
    for (std::size_t i = m_next + 1; i-- > 0 && before <= longAllowance;) {
        Candidate candidate = m_candidates[i];
        if (candidate.port != m_patient->port || !isSame(candidate.line, m_patient->line))
            break;
        before += longestTime(candidate);
        candidate.allowance = longAllowance;
        m_remaining += longestTime(candidate);
        again.push_back(candidate);
    }
    m_candidates.insert(m_candidates.begin() + static_cast<std::ptrdiff_t>(m_next) + 1, again.begin(),
                        again.end());
}

void LineScan::advance()
{
    if (m_ended)
        return;
    const Candidate candidate = m_candidates[m_next]; // a copy, because asking may move the others
    if (openFor(candidate))
        ask(candidate);
    skipDone();
    const LineFinding* found = controller();
    const bool isFound = m_plan.depth == ScanPlan::Depth::Diagnosis ? !m_findings.empty() : found != nullptr;
    if (isFound || m_next == m_candidates.size())
        finish();
}

bool LineScan::openFor(const Candidate& candidate)
{
    Port& port = m_ports[candidate.port];
    if (m_client && m_openPort == candidate.port && isSame(m_client->settings().line, candidate.line) &&
        m_client->settings().answerAllowance == candidate.allowance)
        return true;
    m_client.reset(); // before the next one uses the port
    LinkSettings settings{port.path, candidate.line, candidate.unit, candidate.allowance, false};
    auto client = std::make_unique<RtuClient>(std::move(settings));
    if (const auto opened = client->open(); !opened) {
        LineFinding finding = findingAt(candidate, conditionOf(opened.error()));
        finding.detail = opened.error().detail;
        if (finding.condition == LineCondition::PortNotPermitted)
            finding.group = opened.error().detail;
        if (finding.condition == LineCondition::PortBusy)
            finding.holders = holdersOf(port.path);
        m_findings.push_back(std::move(finding));
        port.isDone = true;
        return false;
    }
    m_client = std::move(client);
    m_openPort = candidate.port;
    port.bytesSeen += m_client->record().figures.receivedBytes();
    return true;
}

void LineScan::ask(const Candidate& candidate)
{
    Port& port = m_ports[candidate.port];
    port.isTried = true;
    const LinkFigures& figures = m_client->record().figures;
    const std::uint64_t before = figures.receivedBytes();
    const std::uint64_t straysBefore = figures.strayBytes();
    const auto identity = m_client->probe(candidate.unit);
    const std::uint64_t bytes = figures.receivedBytes() - before;
    port.bytesSeen += bytes;
    port.strayBytes += figures.strayBytes() - straysBefore;
    if (!identity && identity.error().kind == LinkErrorKind::Exception)
        port.exception = identity.error().code;
    port.isEchoing = port.isEchoing || m_client->isEchoing();
    const LineCondition condition = identity ? LineCondition::Controller : conditionOf(identity.error());
    const bool isOfAnotherQuestion = !identity && identity.error().kind == LinkErrorKind::ForeignAnswer;
    if (mayBeLate(candidate) && (isOfAnotherQuestion || (bytes > 0 && !isAnswer(condition)))) {
        askAgainPatiently();
    } else if (!isAnswer(condition) && condition != LineCondition::PortGone) {
        if (bytes > 0 && condition != LineCondition::Refused && ++m_attempt < attemptsWhenDamaged)
            return; // repeats the same one
    } else {
        LineFinding finding = findingAt(candidate, condition);
        if (identity)
            finding.identity = *identity;
        else
            finding.code = identity.error().code;
        const bool isConfiguredLine =
            candidate.port == 0 && !m_plan.port.empty() && isSame(candidate.line, m_plan.line);
        if (identity && isConfiguredLine && candidate.unit != m_plan.unit)
            finding.condition = LineCondition::WrongUnit;
        // A device that answers at any speed, as over a network bridge, is one finding.
        const bool isKnown = std::ranges::any_of(m_findings, [&](const LineFinding& known) {
            return known.port == finding.port && known.unit == finding.unit &&
                   known.condition == finding.condition;
        });
        if (!isKnown)
            m_findings.push_back(std::move(finding));
        port.isDone = condition == LineCondition::PortGone;
    }
    m_attempt = 0;
    m_remaining -= longestTime(candidate);
    ++m_next;
}

LineFinding LineScan::findingAt(const Candidate& candidate, LineCondition condition) const
{
    const Port& port = m_ports[candidate.port];
    LineFinding finding;
    finding.condition = condition;
    finding.port = port.path;
    finding.line = candidate.line;
    finding.unit = candidate.unit;
    finding.bytesSeen = port.bytesSeen;
    finding.strayBytes = port.strayBytes;
    finding.latencyTimerMs = ftdiLatencyMs(port.path);
    return finding;
}

void LineScan::skipDone()
{
    while (m_next < m_candidates.size() && m_ports[m_candidates[m_next].port].isDone) {
        m_remaining -= longestTime(m_candidates[m_next]);
        ++m_next;
        m_attempt = 0;
    }
}

// Returns the finding of a port where no device was found.
LineFinding LineScan::findingWithout(std::uint16_t port) const
{
    const Port& tried = m_ports[port];
    const Candidate configured{port, static_cast<std::uint8_t>(m_plan.unit), m_plan.line};
    LineFinding finding = findingAt(configured, LineCondition::NoBytes);
    finding.code = tried.exception;
    if (tried.exception != 0)
        finding.condition = LineCondition::Refused;
    else if (tried.bytesSeen > 0)
        finding.condition = LineCondition::Garbage;
    else if (tried.isEchoing)
        finding.condition = LineCondition::EchoOnly;
    return finding;
}

// Adds the findings of the ports without an answer.
void LineScan::finish()
{
    m_ended = true;
    m_client.reset();
    if (controller() != nullptr)
        return;
    for (std::uint16_t i = 0; i < m_ports.size(); ++i) {
        const Port& port = m_ports[i];
        const bool isFound = std::ranges::find(m_findings, port.path, &LineFinding::port) != m_findings.end();
        if (!isFound && port.isTried)
            m_findings.push_back(findingWithout(i));
    }
}

const LineFinding* LineScan::controller() const
{
    const auto found = std::ranges::find_if(m_findings, &LineFinding::isController);
    return found == m_findings.end() ? nullptr : &*found;
}

ScanProgress LineScan::progress() const
{
    ScanProgress progress;
    progress.done = static_cast<int>(m_next);
    progress.total = static_cast<int>(m_candidates.size());
    if (!m_ended) {
        const Candidate& next = m_candidates[m_next];
        progress.port = m_ports[next.port].path;
        progress.line = next.line;
        progress.unit = next.unit;
        progress.remaining = std::chrono::ceil<milliseconds>(m_remaining);
    }
    return progress;
}

} // namespace campanel::modbus
