// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/parameter_fields.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/kit/numbers.h"
#include "app/panel/kit/units.h"
#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/controller_sentences.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/register_words.h"

#include <algorithm>
#include <cmath>

namespace campanel::panel {

ParameterFields::ParameterFields(Controller& controller, QObject* parent)
    : QAbstractListModel(parent)
    , m_controller(controller)
{
    connect(&controller.link(), &link::Link::commandEnded, this, &ParameterFields::takeCommand);
    connect(&m_value, &Value::setRequested, this, [this](double value) {
        const Field* field = selected();
        if (m_controller.accessCheck().require(Level::Technician) && field)
            write(*field, value);
    });
    LanguageNotifier::follow(this, [this] {
        m_outcome.clear(); // it is in the previous language
        notifyChange();
    });
}

void ParameterFields::setFields(std::vector<Field> fields)
{
    beginResetModel();
    for (const Field& field : m_fields)
        disconnect(field.parameter, nullptr, this, nullptr);
    m_fields = std::move(fields);
    m_selected = -1;
    for (const Field& field : m_fields)
        connect(field.parameter, &Parameter::changed, this, &ParameterFields::notifyChange);
    endResetModel();
}

void ParameterFields::read()
{
    for (const Field& field : m_fields)
        field.parameter->read();
}

void ParameterFields::readIfUncertain()
{
    for (const Field& field : m_fields)
        field.parameter->readIfUncertain();
}

double ParameterFields::value(const char* name) const
{
    const auto found =
        std::ranges::find_if(m_fields, [name](const Field& field) { return field.info().name == name; });
    return found == m_fields.end() ? unknown : found->value().value_or(unknown);
}

ParameterFields::Field& ParameterFields::find(std::string_view name)
{
    const auto found =
        std::ranges::find_if(m_fields, [name](const Field& field) { return field.info().name == name; });
    Q_ASSERT(found != m_fields.end());
    return *found;
}

void ParameterFields::write(const char* name, double value)
{
    write(find(name), value);
}

void ParameterFields::write(const Field& field, double value)
{
    if (const QString why = objection(field, value); !why.isEmpty()) {
        m_outcome = why;
        m_isFailed = true;
        emit written(RegisterWords::name(field.info()), false, why);
        emit changed();
        return;
    }
    if (!field.parameter->write(value, {this, [this, field](const link::ParameterOutcome& outcome) {
                                            endWrite(field, outcome);
                                        }}))
        return;
    m_outcome = tr("Writing %1: %2 …").arg(label(field), text(field, value));
    m_isFailed = false;
    emit changed();
}

void ParameterFields::endWrite(const Field& field, const link::ParameterOutcome& outcome)
{
    const bool isDone = outcome.end == link::ParameterEnd::Done;
    m_isFailed = !isDone;
    m_isUnsaved = m_isUnsaved || isDone;
    m_outcome = isDone ? tr("%1: %2, read back from the controller.")
                             .arg(label(field), text(field, outcome.value.value_or(unknown)))
                       : ConnectionSentences::parameter(label(field), outcome);
    if (!isDone)
        field.parameter->read();
    emit written(RegisterWords::name(field.info()), isDone, m_outcome);
    emit changed();
}

void ParameterFields::save()
{
    const auto& status = m_controller.status();
    if (m_controller.accessCheck().require(Level::Technician) && m_controller.isConnected() && status &&
        status->activeCrc)
        m_controller.send(modbus::Command::SaveToFlash, {0, 0, *status->activeCrc});
}

void ParameterFields::takeCommand(const link::CommandOutcome& outcome)
{
    if (outcome.command != modbus::Command::SaveToFlash || outcome.end != link::CommandEnd::Done)
        return;
    m_isUnsaved = false;
    m_outcome.clear();
    emit changed();
}

void ParameterFields::notifyChange()
{
    updateValue();
    if (!m_fields.empty())
        emit dataChanged(index(0), index(rowCount() - 1));
    emit changed();
}

void ParameterFields::select(int row)
{
    m_selected = row;
    updateValue();
    emit changed();
}

const ParameterFields::Field* ParameterFields::selected() const
{
    return m_selected >= 0 && m_selected < rowCount() ? &m_fields[static_cast<std::size_t>(m_selected)]
                                                      : nullptr;
}

void ParameterFields::updateValue()
{
    const Field* field = selected();
    if (!field)
        return;
    const modbus::RegisterInfo& info = field->info();
    const int decimals = RegisterWords::decimals(info);
    const double value = field->value().value_or(unknown);
    m_value.show({label(*field), unitOf(*field), Format().amount(value, decimals, unitOf(*field)),
                  info.minimum, info.maximum, info.defaultValue, decimals, value});
}

void ParameterFields::setChoice(int row, int choice)
{
    if (!m_controller.accessCheck().require(Level::Technician) || row < 0 || row >= rowCount())
        return;
    const Field& field = m_fields[static_cast<std::size_t>(row)];
    if (field.hasChoices)
        write(field, choice);
}

void ParameterFields::takeSuggestion(int row)
{
    if (!m_controller.accessCheck().require(Level::Technician) || row < 0 || row >= rowCount())
        return;
    const Field& field = m_fields[static_cast<std::size_t>(row)];
    if (field.suggestion)
        write(field, *field.suggestion);
}

QString ParameterFields::unitOf(const Field& field)
{
    return RecipeWords::unit(field.info().unit);
}

QStringList ParameterFields::choicesOf(const Field& field) const
{
    if (!field.hasChoices)
        return {};
    const QStringList texts = ControllerSentences::texts(field.info().enumName);
    return texts.isEmpty() ? QStringList{tr("Off"), tr("On")} : texts;
}

// Returns the text with its unit, or that of the choice.
QString ParameterFields::text(const Field& field, double value) const
{
    if (field.hasChoices)
        return std::isfinite(value) ? choicesOf(field).value(static_cast<int>(value)) : Format::unknownText();
    return Format().compactMeasure(value, 0, RegisterWords::decimals(field.info()), unitOf(field));
}

QString ParameterFields::range(const Field& field) const
{
    return tr("%1 to %2").arg(text(field, field.info().minimum), text(field, field.info().maximum));
}

QString ParameterFields::note(const Field& field) const
{
    if (field.parameter->isMissing())
        return tr("Not in this controller. Update its firmware.");
    return field.hasChoices ? QString() : range(field);
}

int ParameterFields::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_fields.size());
}

QVariant ParameterFields::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Field& field = m_fields[static_cast<std::size_t>(index.row())];
    const int digits = RegisterWords::decimals(field.info());
    switch (role) {
    case NameRole:
        return label(field);
    case ValueRole:
        if (!field.value())
            return Format::unknownText();
        return field.hasChoices ? text(field, *field.value())
                                : Format().compactAmount(*field.value(), 0, digits, unitOf(field));
    case UnitRole:
        return Units::of(unitOf(field)).unit;
    case NoteRole:
        return note(field);
    case ChoicesRole:
        return choicesOf(field);
    case ChoiceRole:
        return static_cast<int>(field.value().value_or(-1));
    case KnownRole:
        return field.value().has_value();
    case SuggestionRole: {
        const bool isOther = field.suggestion && field.value() &&
                             std::abs(*field.suggestion - *field.value()) >= 5 * field.info().scale;
        return isOther ? Format().amount(*field.suggestion, digits, unitOf(field)) : QString();
    }
    case MeasurableRole:
        return isMeasurable(field);
    default:
        return {};
    }
}

QHash<int, QByteArray> ParameterFields::roleNames() const
{
    return {{NameRole, "name"},   {ValueRole, "value"},           {UnitRole, "unit"},
            {NoteRole, "note"},   {ChoicesRole, "choices"},       {ChoiceRole, "choice"},
            {KnownRole, "known"}, {SuggestionRole, "suggestion"}, {MeasurableRole, "measurable"}};
}

} // namespace campanel::panel
