// SPDX-License-Identifier: Apache-2.0
#include "app/panel/packing/mark_edge_list.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/packing/mark_sensor.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

using modbus::MarkVerdict;

constexpr double edgeMmPerUm = 0.001;
// A mark is expected in steps of the pitch, which is not known well enough for more of them.
constexpr double maxPitches = 6;
constexpr double samePlaceMm = 1.0;

struct VerdictWords {
    MarkVerdict verdict;
    MarkEdgeList::Look look;
    bool hasExpected; // the record has a distance from an expected mark
    const char* name;
    const char* sentence; // %1: distance from the expected mark, %2: window
};

// A new verdict of the controller is a row here. The last one is for verdicts that this panel does not know.
constexpr std::array verdictWords{
    VerdictWords{MarkVerdict::Taken, MarkEdgeList::Solid, true,
                 QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList", "taken"),
                 QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList", "Taken: %1. The window is ±%2.")},
    VerdictWords{
        MarkVerdict::OutsideWindow, MarkEdgeList::Rejected, true,
        QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList", "outside the window"),
        QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList",
                          "Not taken: %1; the window is ±%2. Check film and print, or widen the mark "
                          "window.")},
    VerdictWords{MarkVerdict::Searched, MarkEdgeList::Dashed, false,
                 QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList", "searched"),
                 QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList",
                                   "Searched: the controller looks for two marks at the distance of the "
                                   "recipe's bag length.")},
    VerdictWords{MarkVerdict::NotUsed, MarkEdgeList::Dotted, false,
                 QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList", "not used"),
                 QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList",
                                   "Not used: mark tracking is off. Switch it on in the list of this page.")},
    VerdictWords{
        MarkVerdict::TooNarrow, MarkEdgeList::Dotted, false,
        QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList", "too narrow"),
        QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList",
                          "Another print: narrower than a mark. If it is one, reduce the minimum width.")},
    VerdictWords{
        MarkVerdict::TooWide, MarkEdgeList::Dotted, false,
        QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList", "too wide"),
        QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList",
                          "Another print: wider than a mark. If it is one, raise the maximum width.")},
    VerdictWords{MarkVerdict::Masked, MarkEdgeList::Dotted, false,
                 QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList", "ignored"),
                 QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList",
                                   "Ignored: it lies in the ignored film behind the mark before it.")},
    VerdictWords{
        static_cast<MarkVerdict>(0xFFFF), MarkEdgeList::Rejected, false,
        QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList", "other"),
        QT_TRANSLATE_NOOP("campanel::panel::MarkEdgeList",
                          "Not taken, for a reason that this panel does not know. Update the panel.")},
};

const VerdictWords& wordsOf(MarkVerdict verdict)
{
    const auto* found = std::ranges::find(verdictWords, verdict, &VerdictWords::verdict);
    return found == verdictWords.end() ? verdictWords.back() : *found;
}

// Returns 1 when the distance is not that of a few pitches.
int pitchesIn(double distanceMm, double pitchMm)
{
    const double pitches = std::round(distanceMm / pitchMm);
    return pitches > 1 && pitches <= maxPitches ? static_cast<int>(pitches) : 1;
}

} // namespace

MarkEdgeList::MarkEdgeList(Controller& controller, MarkSensor& sensor, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_sensor(sensor)
    , m_verdicts(this)
{
    connect(&sensor, &MarkSensor::edgesRead, this, &MarkEdgeList::add);
    connect(&controller, &Controller::programChanged, this, &MarkEdgeList::clear); // another film
    const auto noteReason = [this] {
        if (m_shown.empty())
            emit changed();
    };
    connect(&controller, &Controller::stateChanged, this, noteReason);
    connect(controller.packing(), &PackingLine::changed, this, noteReason);
    connect(controller.packing(), &PackingLine::changed, this, &MarkEdgeList::noteWindow);
    LanguageNotifier::follow(this, [this] { update(); });
    update();
}

void MarkEdgeList::clear()
{
    m_edges.clear();
    m_shown.clear();
    update();
}

void MarkEdgeList::setPaused(bool paused)
{
    m_isPaused = paused;
    update();
}

void MarkEdgeList::add(const std::vector<modbus::MarkEdge>& edges)
{
    if (!m_edges.empty() && edges.front().number <= m_edges.back().record.number)
        m_edges.clear(); // the controller was restarted
    const PackingLine& packing = *m_controller.packing();
    const auto& status = packing.status();
    const double pitchMm =
        status && status->markPitchMm > 0 ? status->markPitchMm : m_controller.active().bagLengthMm;
    for (const modbus::MarkEdge& edge : edges)
        m_edges.push_back({edge, packing.windowMm(), pitchMm});
    while (m_edges.size() > maxEdges)
        m_edges.pop_front();
    update();
}

// The window may be read after the first edges.
void MarkEdgeList::noteWindow()
{
    const double windowMm = m_controller.packing()->windowMm();
    if (m_edges.empty() || !std::isnan(m_edges.front().windowMm) || std::isnan(windowMm))
        return;
    for (Edge& edge : m_edges)
        edge.windowMm = windowMm;
    update();
}

void MarkEdgeList::update()
{
    if (!m_isPaused)
        m_shown = m_edges;
    QList<MarkVerdictRow> rows;
    for (const VerdictWords& words : verdictWords) {
        const auto edges = std::ranges::count_if(
            m_shown, [&words](const Edge& edge) { return &wordsOf(edge.record.verdict) == &words; });
        if (edges != 0 || words.verdict <= MarkVerdict::OutsideWindow) // the others are rare
            rows << MarkVerdictRow{tr(words.name), words.look, static_cast<int>(edges)};
    }
    m_verdicts.setRows(rows);
    emit changed();
}

std::optional<double> MarkEdgeList::Edge::offMm() const
{
    return wordsOf(record.verdict).hasExpected ? record.offMm : std::nullopt;
}

double MarkEdgeList::Edge::placeMm(const Edge& newest) const
{
    return static_cast<std::int32_t>(record.filmUm - newest.record.filmUm) * edgeMmPerUm; // it wraps
}

QList<double> MarkEdgeList::places() const
{
    QList<double> places;
    for (const Edge& edge : m_shown)
        places << edge.placeMm(m_shown.back());
    return places;
}

QList<int> MarkEdgeList::looks() const
{
    QList<int> looks;
    for (const Edge& edge : m_shown)
        looks << wordsOf(edge.record.verdict).look;
    return looks;
}

QStringList MarkEdgeList::notes() const
{
    QStringList notes;
    for (const Edge& edge : m_shown) {
        const auto offMm = edge.offMm();
        const bool isTold = offMm && wordsOf(edge.record.verdict).look == Rejected;
        const QString sign = isTold && *offMm > 0 ? u"+"_s : QString();
        notes << (isTold ? sign + Format().measure(*offMm, 1, u"mm"_s, edge.windowMm) : QString());
    }
    return notes;
}

// A mark that is missing has its place between those of two edges that follow one another.
QList<QPointF> MarkEdgeList::windows() const
{
    QList<QPointF> windows;
    const Edge* last = nullptr;
    bool isWhole = false; // since the last window no edge is unknown, and no mark was searched
    for (const Edge& edge : m_shown) {
        isWhole = isWhole && edge.record.number == last->record.number + 1 &&
                  edge.record.verdict != MarkVerdict::Searched;
        last = &edge;
        const auto offMm = edge.offMm();
        if (!offMm || std::isnan(edge.windowMm))
            continue;
        const double placeMm = edge.placeMm(m_shown.back()) - *offMm;
        const double stepMm = windows.isEmpty() ? edge.pitchMm : placeMm - windows.last().x();
        const int pitches = isWhole ? pitchesIn(stepMm, edge.pitchMm) : 1;
        for (int missing = pitches - 1; missing > 0; --missing)
            windows << QPointF(placeMm - stepMm * missing / pitches, edge.windowMm);
        if (stepMm > samePlaceMm)
            windows << QPointF(placeMm, edge.windowMm);
        isWhole = true;
    }
    return windows;
}

QString MarkEdgeList::sentence(const Edge& edge)
{
    const QString verdict = verdictSentence(edge);
    return edge.record.widthMm ? tr("%1 Its width is %2.", "a sentence, a length")
                                     .arg(verdict, Format().measure(*edge.record.widthMm, 1, u"mm"_s))
                               : verdict;
}

QString MarkEdgeList::verdictSentence(const Edge& edge)
{
    const VerdictWords& words = wordsOf(edge.record.verdict);
    if (!words.hasExpected)
        return tr(words.sentence);
    const Format format;
    const bool isNear = edge.record.offMm.has_value();
    const double offMm = edge.record.offMm.value_or(0);
    const QString distance = format.measure(std::abs(offMm), 1, u"mm"_s, edge.windowMm);
    const QString place = !isNear     ? tr("far from the expected mark")
                          : offMm < 0 ? tr("%1 before the expected mark").arg(distance)
                                      : tr("%1 behind the expected mark").arg(distance);
    const QString window = format.compactMeasure(edge.windowMm, 0, 1, u"mm"_s,
                                                 isNear ? std::optional(std::abs(offMm)) : std::nullopt);
    return tr(words.sentence).arg(place, window);
}

MarkEdgeList::Edges::const_reverse_iterator MarkEdgeList::rejected() const
{
    return std::find_if(m_shown.rbegin(), m_shown.rend(),
                        [](const Edge& edge) { return wordsOf(edge.record.verdict).look == Rejected; });
}

QString MarkEdgeList::newestText() const
{
    return m_shown.empty() ? QString() : sentence(m_shown.back());
}

QString MarkEdgeList::rejectedText() const
{
    return sinceRejected() > 0 ? sentence(*rejected()) : QString();
}

double MarkEdgeList::rejectedPlace() const
{
    const auto found = rejected();
    return found == m_shown.rend() ? unknown : found->placeMm(m_shown.back());
}

int MarkEdgeList::sinceRejected() const
{
    const auto found = rejected();
    return found == m_shown.rend() ? 0
                                   : static_cast<int>(m_shown.back().record.number - found->record.number);
}

bool MarkEdgeList::newestRejected() const
{
    return !m_shown.empty() && rejected() == m_shown.rbegin();
}

double MarkEdgeList::newestOffMm() const
{
    return m_shown.empty() ? unknown : m_shown.back().offMm().value_or(unknown);
}

QString MarkEdgeList::emptyText() const
{
    if (!m_shown.empty())
        return {};
    if (!m_controller.packing()->known())
        return tr("No packing machine data. Connect the controller and download a recipe of a rotary "
                  "cutter.");
    if (!m_sensor.isRecorded())
        return tr("This controller records no edges of its mark sensor. Update the controller: its register "
                  "map must be 1.6 or newer.");
    if (m_controller.state() != Controller::State::Running)
        return tr("No edges so far. Start the machine: edges are recorded while the film runs.");
    return tr("No edges although the film runs. Check the cable of the mark sensor and that the print passes "
              "below the sensor.");
}

QString MarkEdgeList::summary() const
{
    if (m_shown.empty())
        return emptyText();
    QStringList counts;
    for (const MarkVerdictRow& row : m_verdicts.rows())
        counts << tr("%1: %2", "verdict: number of edges").arg(row.name, QString::number(row.edges));
    return tr("%1 edges (%2). Newest edge: %3")
        .arg(QString::number(m_shown.size()), counts.join(u", "_s), newestText());
}

} // namespace campanel::panel
