// SPDX-License-Identifier: Apache-2.0
#include "app/panel/packing/packing_fields.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/numbers.h"
#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/register_words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace campanel::panel {

namespace {

struct Listed {
    const char* name;
    const char* words;
    bool isSwitch;
};

// The fields in the order of the screen; the register map has the texts.
constexpr std::array listed{
    Listed{"parameter.mark_tracking", QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Mark tracking"),
           true},
    Listed{"parameter.phase_gain",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Phase gain: correction of slip"), false},
    Listed{"parameter.length_gain",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Length gain: correction of length"), false},
    Listed{"parameter.mark_distance",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Mark sensor to knife"), false},
    Listed{"parameter.mark_offset",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Cut offset behind its mark"), false},
    Listed{"parameter.mark_window", QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Mark window, ±"),
           false},
    Listed{"parameter.mark_missing_limit",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Missing marks in a row before stop"), false},
    Listed{"parameter.phase_limit",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Phase limit: max. shift of a cut"), false},
    Listed{"parameter.length_limit",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Length limit: max. change of a bag"), false},
    Listed{"parameter.length_trim",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Length trim without marks"), false},
    Listed{"parameter.anti_cut",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Anti-cut: knife stays open over product"),
           true},
    Listed{"parameter.cut_clearance",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Clearance on both sides of a cut"), false},
    Listed{"parameter.skip_limit",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Skipped cuts in a row before stop"), false},
    Listed{"parameter.empty_bag",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Film waits for a missing product"), true},
    Listed{"parameter.product_distance",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Product placement to knife"), false},
    Listed{"parameter.eye_distance",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Product eye to placement"), false},
    Listed{"parameter.flight_pitch",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Product pitch on the infeed"), false},
    Listed{"parameter.flight_pulses",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Infeed motor: pulses per product"), false},
    Listed{"parameter.film_feed",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Film motor: film per revolution"), false},
    Listed{"parameter.film_pulses",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Film motor: pulses per revolution"), false},
    Listed{"parameter.knife_step",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Knife: max. speed step at a change"), false},
    Listed{"parameter.film_step",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Film: max. speed step at a change"), false},
    Listed{"parameter.infeed_step",
           QT_TRANSLATE_NOOP("campanel::panel::PackingFields", "Infeed: max. speed step at a change"), false},
};

} // namespace

PackingFields::PackingFields(Controller& machine, QObject* parent)
    : QAbstractListModel(parent)
    , m_machine(machine)
{
    for (const Listed& field : listed) {
        Parameter& parameter = machine.parameter(field.name);
        m_fields.push_back({&parameter, field.words, field.isSwitch, {}});
        connect(&parameter, &Parameter::changed, this, &PackingFields::tell);
    }
    connect(&machine.link(), &link::Link::commandEnded, this, &PackingFields::takeCommand);
    connect(&m_value, &Value::setRequested, this, [this](double value) {
        if (const Field* field = selected())
            write(*field, value);
    });
}

void PackingFields::read()
{
    for (const Field& field : m_fields)
        field.parameter->read();
}

QString PackingFields::words(const QString& name)
{
    for (const Listed& field : listed) {
        if (name == QLatin1String(field.name))
            return tr(field.words);
    }
    return {};
}

double PackingFields::value(const char* name) const
{
    const auto found =
        std::ranges::find_if(m_fields, [name](const Field& field) { return field.info().name == name; });
    return found == m_fields.end() ? unknown : found->value().value_or(unknown);
}

PackingFields::Field& PackingFields::find(std::string_view name)
{
    const auto found =
        std::ranges::find_if(m_fields, [name](const Field& field) { return field.info().name == name; });
    Q_ASSERT(found != m_fields.end());
    return *found;
}

void PackingFields::write(const char* name, double value)
{
    write(find(name), value);
}

void PackingFields::write(const Field& field, double value)
{
    if (!field.parameter->write(value, {this, [this, &field](const link::ParameterOutcome& outcome) {
                                            endWrite(field, outcome);
                                        }}))
        return;
    m_outcome = tr("Writing %1: %2 …").arg(tr(field.words), text(field, value));
    m_isFailed = false;
    emit changed();
}

void PackingFields::endWrite(const Field& field, const link::ParameterOutcome& outcome)
{
    const bool isDone = outcome.end == link::ParameterEnd::Done;
    m_isFailed = !isDone;
    m_isUnsaved = m_isUnsaved || isDone;
    m_outcome = isDone ? tr("%1: %2, read back from the controller.")
                             .arg(tr(field.words), text(field, outcome.value.value_or(unknown)))
                       : ConnectionSentences::parameter(tr(field.words), outcome);
    if (!isDone)
        field.parameter->read();
    emit written(RegisterWords::name(field.info()), isDone, m_outcome);
    emit changed();
}

void PackingFields::save()
{
    const auto& status = m_machine.status();
    if (m_machine.isConnected() && status && status->activeCrc &&
        m_machine.accessCheck().require(Level::Technician))
        m_machine.send(modbus::Command::SaveToFlash, {0, 0, *status->activeCrc});
}

void PackingFields::takeCommand(const link::CommandOutcome& outcome)
{
    if (outcome.command != modbus::Command::SaveToFlash || outcome.end != link::CommandEnd::Done)
        return;
    m_isUnsaved = false;
    m_outcome.clear();
    emit changed();
}

void PackingFields::suggest(const std::optional<GainSuggestion>& gains, int bags)
{
    m_gains = gains;
    m_bags = bags;
    find("parameter.phase_gain").suggestion = gains ? std::optional(gains->phaseGain) : std::nullopt;
    find("parameter.length_gain").suggestion = gains ? std::optional(gains->lengthGain) : std::nullopt;
    tell();
}

void PackingFields::tell()
{
    updateValue();
    emit dataChanged(index(0), index(rowCount() - 1));
    emit changed();
}

void PackingFields::retranslate()
{
    m_outcome.clear();
    tell();
}

void PackingFields::select(int row)
{
    m_selected = row;
    updateValue();
    emit changed();
}

const PackingFields::Field* PackingFields::selected() const
{
    return m_selected >= 0 && m_selected < rowCount() ? &m_fields[static_cast<std::size_t>(m_selected)]
                                                      : nullptr;
}

void PackingFields::updateValue()
{
    const Field* field = selected();
    if (!field)
        return;
    const modbus::RegisterInfo& info = field->info();
    const int decimals = RegisterWords::decimals(info);
    m_value.show({tr(field->words), unitOf(*field),
                  Format().number(field->value().value_or(unknown), decimals), info.minimum, info.maximum,
                  info.defaultValue, decimals});
}

void PackingFields::setOn(int row, bool on)
{
    const Field& field = m_fields.at(static_cast<std::size_t>(row));
    if (field.isSwitch)
        write(field, on ? 1 : 0);
}

void PackingFields::takeSuggestion(int row)
{
    const Field& field = m_fields.at(static_cast<std::size_t>(row));
    if (field.suggestion)
        write(field, *field.suggestion);
}

QString PackingFields::unitOf(const Field& field)
{
    return QString::fromUtf8(field.info().unit.data(), static_cast<qsizetype>(field.info().unit.size()));
}

// Returns the text with its unit, or On and Off.
QString PackingFields::text(const Field& field, double value)
{
    if (field.isSwitch)
        return value != 0 ? tr("On") : tr("Off");
    const QString number = Format().compact(value, 0, RegisterWords::decimals(field.info()));
    return field.info().unit.empty() ? number : number + u' ' + unitOf(field);
}

QString PackingFields::note(const Field& field) const
{
    if (field.isSwitch)
        return {};
    const QString range =
        tr("%1 to %2").arg(text(field, field.info().minimum), text(field, field.info().maximum));
    const bool isGain =
        field.info().name == "parameter.phase_gain" || field.info().name == "parameter.length_gain";
    if (!isGain)
        return range;
    if (!m_gains && m_bags >= GainEstimate::minBags)
        return tr("%1 · no suggestion: the mark positions do not vary (%2 bags)").arg(range).arg(m_bags);
    if (!m_gains)
        return tr("%1 · suggestion after %2 tracked bags, %3 so far")
            .arg(range)
            .arg(GainEstimate::minBags)
            .arg(m_bags);
    const Format format;
    return tr("%1 · film slip %2 mm per bag, sensor std dev %3 mm (%4 bags)")
        .arg(range, format.number(m_gains->slipMm, 3), format.number(m_gains->sensorMm, 3))
        .arg(m_bags);
}

int PackingFields::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_fields.size());
}

QVariant PackingFields::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Field& field = m_fields[static_cast<std::size_t>(index.row())];
    const int digits = RegisterWords::decimals(field.info());
    switch (role) {
    case NameRole:
        return tr(field.words);
    case ValueRole:
        if (!field.value())
            return Format::unknownText();
        return field.isSwitch ? text(field, *field.value()) : Format().compact(*field.value(), 0, digits);
    case UnitRole:
        return unitOf(field);
    case NoteRole:
        return note(field);
    case SwitchRole:
        return field.isSwitch;
    case OnRole:
        return field.value().value_or(0) != 0;
    case KnownRole:
        return field.value().has_value();
    case SuggestionRole: {
        const bool isOther = field.suggestion && field.value() &&
                             std::abs(*field.suggestion - *field.value()) >= 5 * field.info().scale;
        return isOther ? Format().number(*field.suggestion, digits) : QString();
    }
    default:
        return {};
    }
}

QHash<int, QByteArray> PackingFields::roleNames() const
{
    return {{NameRole, "name"},   {ValueRole, "value"},          {UnitRole, "unit"},
            {NoteRole, "note"},   {SwitchRole, "toggle"},        {OnRole, "on"},
            {KnownRole, "known"}, {SuggestionRole, "suggestion"}};
}

} // namespace campanel::panel
