// SPDX-License-Identifier: Apache-2.0
#include "app/panel/hand/hand_trims.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/settings/settings.h"
#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/trim_words.h"

#include <algorithm>
#include <chrono>
#include <cmath>

using namespace std::chrono_literals;

namespace campanel::panel {

using program::Trim;

namespace {

constexpr auto trimsReadPeriod = 2s;
constexpr double trimResolutionMm = 0.001; // of the register
constexpr std::array trims{Trim::Cut, Trim::Product, Trim::Length};
static_assert(trims.size() == program::trimCount);

QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

// A later cut lies on the left: the film runs to the right.
bool isMoreLeft(Trim trim)
{
    return trim == Trim::Cut;
}

} // namespace

HandTrims::HandTrims(Controller& controller, QObject* parent)
    : Watched(parent)
    , m_controller(controller)
    , m_place(controller.parameter("master.place"))
    , m_values{HandValue{controller, program::trimTable[0].registerName},
               HandValue{controller, program::trimTable[1].registerName},
               HandValue{controller, program::trimTable[2].registerName}}
{
    for (const Trim trim : trims) {
        connect(&value(trim), &HandValue::changed, this, &HandTrims::update);
        connect(&value(trim), &HandValue::moved, this, [this, trim](double before, double after) {
            emit noted({.what = QStringLiteral("hand.trim"),
                        .object = toQString(value(trim).info().name),
                        .before = QString::number(before),
                        .after = QString::number(after)});
        });
    }
    connect(&m_place, &Parameter::changed, this, &HandTrims::update);
    connect(controller.masterSetting(), &MasterSetting::changed, this, &HandTrims::update);
    connect(controller.packing(), &PackingLine::changed, this, &HandTrims::update);
    connect(&controller.settings(), &Settings::changed, this, &HandTrims::update);
    updateEvery(trimsReadPeriod, [this] {
        for (const Trim trim : trims) {
            if (offered())
                value(trim).read();
        }
    });
    LanguageNotifier::follow(this, &HandTrims::update);
    update();
}

bool HandTrims::hasPacker() const
{
    return m_controller.program() && m_controller.program()->recipe.isCutter() &&
           m_controller.packing()->present();
}

bool HandTrims::isTooOld() const
{
    const auto& identity = m_controller.identity();
    return identity && !identity->hasRegister(m_values[0].info().name);
}

bool HandTrims::offered() const
{
    return m_controller.isConnected() && hasPacker() &&
           std::ranges::none_of(m_values, [](const HandValue& each) { return std::isnan(each.value()); });
}

QList<double> HandTrims::mm() const
{
    QList<double> all;
    for (const HandValue& each : m_values)
        all << (std::isnan(each.value()) ? 0.0 : each.value());
    return all;
}

bool HandTrims::moved() const
{
    return std::ranges::any_of(mm(), [](double each) { return each != 0; });
}

bool HandTrims::unsaved() const
{
    if (!offered())
        return false;
    const auto known =
        m_saved ? m_saved(QString::fromStdString(m_controller.program()->recipe.name)) : std::nullopt;
    const program::Trims saved = known.value_or(program::Trims{});
    return !std::ranges::equal(
        mm(), saved, [](double live, double kept) { return std::abs(live - kept) < trimResolutionMm / 2; });
}

double HandTrims::stepMm() const
{
    return m_controller.settings().values().number("hand.trim_step_mm");
}

QString HandTrims::stepText() const
{
    return Format().compactMeasure(stepMm(), 1, 3, QStringLiteral("mm"));
}

QString HandTrims::message() const
{
    for (const Trim trim : trims) {
        if (const auto& failure = value(trim).failure())
            return ConnectionSentences::parameter(TrimWords::title(trim), *failure);
    }
    return {};
}

QString HandTrims::blockedText(Trim trim) const
{
    const bool isWheel = m_controller.masterSetting()->leads() &&
                         m_place.lastValue() == static_cast<double>(modbus::MasterPlace::Wheel);
    if (trim == Trim::Product && isWheel)
        return tr("The line before this machine places the products.");
    if (trim == Trim::Length && m_controller.packing()->marksWanted())
        return tr("The marks set the length.");
    return {};
}

TrimRow HandTrims::row(Trim trim) const
{
    const HandValue& trimmed = value(trim);
    const QString blocked = blockedText(trim);
    TrimRow row;
    row.trim = static_cast<int>(trim);
    row.title = TrimWords::title(trim);
    row.amount = TrimWords::amount(trim, trimmed.value());
    const bool canLess = blocked.isEmpty() && trimmed.value() > trimmed.info().minimum;
    const bool canMore = blocked.isEmpty() && trimmed.value() < trimmed.info().maximum;
    row.leftText = isMoreLeft(trim) ? TrimWords::more(trim) : TrimWords::less(trim);
    row.rightText = isMoreLeft(trim) ? TrimWords::less(trim) : TrimWords::more(trim);
    row.canLeft = isMoreLeft(trim) ? canMore : canLess;
    row.canRight = isMoreLeft(trim) ? canLess : canMore;
    row.canReset = trimmed.value() < 0 || trimmed.value() > 0;
    if (!blocked.isEmpty())
        row.note = blocked;
    else if (!canLess || !canMore)
        row.note = tr("Limit reached: ±%1.")
                       .arg(Format().compactMeasure(trimmed.info().maximum, 0, 1, QStringLiteral("mm")));
    return row;
}

void HandTrims::update()
{
    if (offered())
        m_isPresent = true;
    else if (m_controller.isConnected() && (!hasPacker() || isTooOld()))
        m_isPresent = false;
    QList<TrimRow> rows;
    if (offered()) {
        for (const Trim trim : trims)
            rows << row(trim);
    }
    m_rows.setRows(rows);
    emit changed();
}

void HandTrims::moveTo(int row, double mm)
{
    if (m_controller.accessCheck().require(Level::Operator) && offered())
        m_values[static_cast<std::size_t>(row)].set(mm);
}

void HandTrims::left(int row)
{
    if (row >= 0 && row < m_rows.count() && m_rows.row(row).canLeft)
        moveTo(row, mm()[row] + (isMoreLeft(trims[static_cast<std::size_t>(row)]) ? stepMm() : -stepMm()));
}

void HandTrims::right(int row)
{
    if (row >= 0 && row < m_rows.count() && m_rows.row(row).canRight)
        moveTo(row, mm()[row] + (isMoreLeft(trims[static_cast<std::size_t>(row)]) ? -stepMm() : stepMm()));
}

void HandTrims::reset(int row)
{
    if (row >= 0 && row < m_rows.count())
        moveTo(row, 0);
}

void HandTrims::save()
{
    if (!m_controller.accessCheck().require(Level::Operator) || !offered())
        return;
    const auto& status = m_controller.status();
    if (status && status->activeCrc && status->activeCrc == status->savedCrc)
        m_controller.send(modbus::Command::SaveToFlash, {0, 0, *status->activeCrc});
    const QList<double> all = mm();
    program::Trims saved{};
    std::ranges::copy(all, saved.begin());
    emit saveWanted(QString::fromStdString(m_controller.program()->recipe.name), saved);
}

} // namespace campanel::panel
