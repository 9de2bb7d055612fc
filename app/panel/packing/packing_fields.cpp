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
};

} // namespace

PackingFields::PackingFields(Controller& machine, QObject* parent)
    : QAbstractListModel(parent)
    , m_machine(machine)
{
    for (const Listed& field : listed) {
        const modbus::RegisterInfo* info = modbus::findRegister(field.name);
        Q_ASSERT(info);
        m_fields.push_back({info, field.words, field.isSwitch, {}, {}});
    }
    connect(&machine, &Controller::parameterEnded, this, &PackingFields::takeOutcome);
    connect(&machine.link(), &link::Link::commandEnded, this, &PackingFields::takeCommand);
    connect(&machine, &Controller::connectionChanged, this, [this] {
        if (!m_machine.isConnected())
            forget();
    });
}

void PackingFields::read()
{
    if (!m_machine.isConnected() || !m_reads.isEmpty())
        return;
    for (const Field& field : m_fields) {
        const QString name = RegisterWords::name(*field.info);
        m_reads.insert(m_machine.readParameter(name.toLatin1().constData()));
    }
}

QString PackingFields::words(const QString& name)
{
    for (const Listed& field : listed) {
        if (name == QLatin1String(field.name))
            return tr(field.words);
    }
    return {};
}

// Pending reads end on their own, as all requests without a connection do.
void PackingFields::forget()
{
    m_reads.clear();
    for (Field& field : m_fields)
        field.value.reset();
    tell();
}

double PackingFields::value(const char* name) const
{
    const auto found =
        std::ranges::find_if(m_fields, [name](const Field& field) { return field.info->name == name; });
    return found == m_fields.end() ? unknown : found->value.value_or(unknown);
}

PackingFields::Field* PackingFields::find(const QString& name)
{
    const auto found = std::ranges::find_if(
        m_fields, [&name](const Field& field) { return RegisterWords::name(*field.info) == name; });
    return found == m_fields.end() ? nullptr : &*found;
}

void PackingFields::write(const char* name, double value)
{
    const Field* field = find(QString::fromLatin1(name));
    Q_ASSERT(field);
    if (!m_machine.accessCheck().require(Level::Technician))
        return;
    m_outcome = tr("Writing %1: %2 …").arg(tr(field->words), text(*field, value));
    m_isFailed = false;
    m_writes.insert(m_machine.writeParameter(name, value));
    emit changed();
}

void PackingFields::takeOutcome(const link::ParameterOutcome& outcome)
{
    m_reads.remove(outcome.id);
    const bool isOwn = m_writes.remove(outcome.id);
    // Handles outcomes of any origin: the registers can be written elsewhere too.
    const QString name = QString::fromStdString(outcome.name);
    Field* field = find(name);
    if (!field)
        return;
    const bool isDone = outcome.end == link::ParameterEnd::Done;
    // After a failure the value is unknown if it may have been written.
    if (isDone || outcome.end == link::ParameterEnd::OutcomeUnknown)
        field->value = isDone ? outcome.value : std::nullopt;
    if (isOwn) {
        m_isFailed = !isDone;
        m_isUnsaved = m_isUnsaved || isDone;
        m_outcome = isDone ? tr("%1: %2, read back from the controller.")
                                 .arg(tr(field->words), text(*field, outcome.value.value_or(unknown)))
                           : ConnectionSentences::parameter(tr(field->words), outcome);
        emit written(name, isDone, m_outcome);
    }
    tell();
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
    find(QStringLiteral("parameter.phase_gain"))->suggestion =
        gains ? std::optional(gains->phaseGain) : std::nullopt;
    find(QStringLiteral("parameter.length_gain"))->suggestion =
        gains ? std::optional(gains->lengthGain) : std::nullopt;
    tell();
}

void PackingFields::tell()
{
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
    emit changed();
}

const PackingFields::Field* PackingFields::selected() const
{
    return m_selected >= 0 && m_selected < rowCount() ? &m_fields[static_cast<std::size_t>(m_selected)]
                                                      : nullptr;
}

void PackingFields::writeSelected(double value)
{
    if (selected() && check(value).isEmpty())
        write(RegisterWords::name(*selected()->info).toLatin1().constData(), value);
}

void PackingFields::setOn(int row, bool on)
{
    const Field& field = m_fields.at(static_cast<std::size_t>(row));
    if (field.isSwitch)
        write(RegisterWords::name(*field.info).toLatin1().constData(), on ? 1 : 0);
}

void PackingFields::takeSuggestion(int row)
{
    const Field& field = m_fields.at(static_cast<std::size_t>(row));
    if (field.suggestion)
        write(RegisterWords::name(*field.info).toLatin1().constData(), *field.suggestion);
}

QString PackingFields::check(double value) const
{
    if (!selected() || (value >= minimum() && value <= maximum()))
        return {};
    return tr("From %1 to %2.").arg(text(*selected(), minimum()), text(*selected(), maximum()));
}

QString PackingFields::label() const
{
    return selected() ? tr(selected()->words) : QString();
}

QString PackingFields::unitOf(const Field& field)
{
    return QString::fromUtf8(field.info->unit.data(), static_cast<qsizetype>(field.info->unit.size()));
}

QString PackingFields::unit() const
{
    return selected() ? unitOf(*selected()) : QString();
}

QString PackingFields::valueText() const
{
    return selected() && selected()->value ? Format().number(*selected()->value, decimals())
                                           : Format::unknownText();
}

double PackingFields::minimum() const
{
    return selected() ? selected()->info->minimum : 0;
}

double PackingFields::maximum() const
{
    return selected() ? selected()->info->maximum : 0;
}

double PackingFields::defaultValue() const
{
    return selected() ? selected()->info->defaultValue : 0;
}

int PackingFields::decimals() const
{
    return selected() ? RegisterWords::decimals(*selected()->info) : 0;
}

// Returns the text with its unit, or On and Off.
QString PackingFields::text(const Field& field, double value)
{
    if (field.isSwitch)
        return value != 0 ? tr("On") : tr("Off");
    const QString number = Format().compact(value, 0, RegisterWords::decimals(*field.info));
    return field.info->unit.empty() ? number : number + u' ' + unitOf(field);
}

QString PackingFields::note(const Field& field) const
{
    if (field.isSwitch)
        return {};
    const QString range =
        tr("%1 to %2").arg(text(field, field.info->minimum), text(field, field.info->maximum));
    const bool isGain =
        field.info->name == "parameter.phase_gain" || field.info->name == "parameter.length_gain";
    if (!isGain)
        return range;
    if (!m_gains && m_bags >= GainEstimate::fewestBags)
        return tr("%1 · no suggestion: the mark positions do not vary (%2 bags)").arg(range).arg(m_bags);
    if (!m_gains)
        return tr("%1 · suggestion after %2 tracked bags, %3 so far")
            .arg(range)
            .arg(GainEstimate::fewestBags)
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
    const int digits = RegisterWords::decimals(*field.info);
    switch (role) {
    case NameRole:
        return tr(field.words);
    case ValueRole:
        if (!field.value)
            return Format::unknownText();
        return field.isSwitch ? text(field, *field.value) : Format().compact(*field.value, 0, digits);
    case UnitRole:
        return unitOf(field);
    case NoteRole:
        return note(field);
    case SwitchRole:
        return field.isSwitch;
    case OnRole:
        return field.value.value_or(0) != 0;
    case KnownRole:
        return field.value.has_value();
    case SuggestionRole: {
        const bool isOther = field.suggestion && field.value &&
                             std::abs(*field.suggestion - *field.value) >= 5 * field.info->scale;
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
