// SPDX-License-Identifier: Apache-2.0
#include "app/panel/audit/audit_words.h"

#include "app/panel/controller/start_permit.h"
#include "app/panel/kit/format.h"
#include "app/panel/maintenance/axis_fields.h"
#include "app/panel/maintenance/cam_switches.h"
#include "app/panel/maintenance/tower_fields.h"
#include "app/panel/packing/packing_fields.h"
#include "app/panel/settings/settings.h"
#include "app/panel/words/access_sentences.h"
#include "app/panel/words/master_sentences.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/trim_words.h"

#include <QDateTime>
#include <QLocale>

#include <algorithm>
#include <array>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

struct Word {
    const char* key;
    const char* words;
};

constexpr std::array areaWords{
    Word{"command", QT_TRANSLATE_NOOP("AuditWords", "Commands")},
    Word{"program", QT_TRANSLATE_NOOP("AuditWords", "Programs")},
    Word{"recipe", QT_TRANSLATE_NOOP("AuditWords", "Recipes")},
    Word{"parameter", QT_TRANSLATE_NOOP("AuditWords", "Parameters")},
    Word{"wizard", QT_TRANSLATE_NOOP("AuditWords", "Wizards")},
    Word{"setting", QT_TRANSLATE_NOOP("AuditWords", "Settings")},
    Word{"stop", QT_TRANSLATE_NOOP("AuditWords", "Stops")},
    Word{"order", QT_TRANSLATE_NOOP("AuditWords", "Orders")},
    Word{"film", QT_TRANSLATE_NOOP("AuditWords", "Film reels")},
    Word{"backup", QT_TRANSLATE_NOOP("AuditWords", "Backup and restore")},
    Word{"update", QT_TRANSLATE_NOOP("AuditWords", "Updates")},
    Word{"user", QT_TRANSLATE_NOOP("AuditWords", "Users and logins")},
    Word{"network", QT_TRANSLATE_NOOP("AuditWords", "Network")},
    Word{"alarm", QT_TRANSLATE_NOOP("AuditWords", "Alarms")},
    Word{"export", QT_TRANSLATE_NOOP("AuditWords", "Exports")},
    Word{"line", QT_TRANSLATE_NOOP("AuditWords", "Connection")},
    Word{"memory", QT_TRANSLATE_NOOP("AuditWords", "Panel database")},
    Word{"audit", QT_TRANSLATE_NOOP("AuditWords", "Audit trail")},
};

constexpr std::array whatWords{
    Word{"command.start", QT_TRANSLATE_NOOP("AuditWords", "Start")},
    Word{"command.jog_bag", QT_TRANSLATE_NOOP("AuditWords", "One bag by hand")},
    Word{"command.cut", QT_TRANSLATE_NOOP("AuditWords", "Single cut by hand")},
    Word{"command.take", QT_TRANSLATE_NOOP("AuditWords", "Next bag taken")},
    Word{"command.stop", QT_TRANSLATE_NOOP("AuditWords", "Stop")},
    Word{"command.stop_now", QT_TRANSLATE_NOOP("AuditWords", "Immediate stop")},
    Word{"command.home", QT_TRANSLATE_NOOP("AuditWords", "Reference run")},
    Word{"command.home_end", QT_TRANSLATE_NOOP("AuditWords", "Reference run ended")},
    Word{"command.jog_forward", QT_TRANSLATE_NOOP("AuditWords", "Jog forward")},
    Word{"command.jog_reverse", QT_TRANSLATE_NOOP("AuditWords", "Jog reverse")},
    Word{"command.jog_end", QT_TRANSLATE_NOOP("AuditWords", "Jog ended")},
    Word{"command.try_output", QT_TRANSLATE_NOOP("AuditWords", "Output tried")},
    Word{"command.try_output_end", QT_TRANSLATE_NOOP("AuditWords", "Output try ended")},
    Word{"command.measure", QT_TRANSLATE_NOOP("AuditWords", "Axis measured")},
    Word{"command.measure_end", QT_TRANSLATE_NOOP("AuditWords", "Measurement of an axis ended")},
    Word{"command.reset", QT_TRANSLATE_NOOP("AuditWords", "Fault reset")},
    Word{"command.save", QT_TRANSLATE_NOOP("AuditWords", "Saved in the controller")},
    Word{"command.teach", QT_TRANSLATE_NOOP("AuditWords", "Marks measured")},
    Word{"command.order", QT_TRANSLATE_NOOP("AuditWords", "Order started or changed")},
    Word{"command.order_end", QT_TRANSLATE_NOOP("AuditWords", "Order ended")},
    Word{"command.other", QT_TRANSLATE_NOOP("AuditWords", "Command")},
    Word{"program.download", QT_TRANSLATE_NOOP("AuditWords", "Download")},
    Word{"program.value", QT_TRANSLATE_NOOP("AuditWords", "Program value")},
    Word{"recipe.new", QT_TRANSLATE_NOOP("AuditWords", "New recipe")},
    Word{"recipe.save", QT_TRANSLATE_NOOP("AuditWords", "Recipe saved")},
    Word{"recipe.rename", QT_TRANSLATE_NOOP("AuditWords", "Recipe renamed")},
    Word{"recipe.delete", QT_TRANSLATE_NOOP("AuditWords", "Recipe deleted")},
    Word{"recipe.restore", QT_TRANSLATE_NOOP("AuditWords", "Recipe restored")},
    Word{"recipe.outside", QT_TRANSLATE_NOOP("AuditWords", "Value outside its approved window")},
    Word{"recipe.file_lost", QT_TRANSLATE_NOOP("AuditWords", "Recipe file lost or damaged")},
    Word{"recipe.machine_lost", QT_TRANSLATE_NOOP("AuditWords", "Machine data lost or damaged")},
    Word{"builder.file", QT_TRANSLATE_NOOP("AuditWords", "File of the machine builder")},
    Word{"film.scan", QT_TRANSLATE_NOOP("AuditWords", "Film reel scanned")},
    Word{"film.override", QT_TRANSLATE_NOOP("AuditWords", "Wrong film reel allowed")},
    Word{"parameter.write", QT_TRANSLATE_NOOP("AuditWords", "Parameter written")},
    Word{"wizard.marks", QT_TRANSLATE_NOOP("AuditWords", "Mark sensor measured")},
    Word{"wizard.axis", QT_TRANSLATE_NOOP("AuditWords", "Measured value of an axis taken")},
    Word{"setting.change", QT_TRANSLATE_NOOP("AuditWords", "Setting")},
    Word{"hand.speed", QT_TRANSLATE_NOOP("AuditWords", "Speed changed by hand")},
    Word{"hand.trim", QT_TRANSLATE_NOOP("AuditWords", "Trimmed by hand")},
    Word{"order.add", QT_TRANSLATE_NOOP("AuditWords", "Order added")},
    Word{"order.remove", QT_TRANSLATE_NOOP("AuditWords", "Order removed")},
    Word{"order.check", QT_TRANSLATE_NOOP("AuditWords", "First bag checked")},
    Word{"stop.reason", QT_TRANSLATE_NOOP("AuditWords", "Reason of a stop changed")},
    Word{"backup.make", QT_TRANSLATE_NOOP("AuditWords", "Backup created")},
    Word{"backup.restore", QT_TRANSLATE_NOOP("AuditWords", "Replaced by a backup")},
    Word{"backup.restored", QT_TRANSLATE_NOOP("AuditWords", "Restored from a backup")},
    Word{"update.start", QT_TRANSLATE_NOOP("AuditWords", "Update requested")},
    Word{"update.back", QT_TRANSLATE_NOOP("AuditWords", "Earlier version requested")},
    Word{"update.end", QT_TRANSLATE_NOOP("AuditWords", "Installation ended")},
    Word{"update.version", QT_TRANSLATE_NOOP("AuditWords", "Another version runs")},
    Word{"user.login", QT_TRANSLATE_NOOP("AuditWords", "Login")},
    Word{"user.logout", QT_TRANSLATE_NOOP("AuditWords", "Logout")},
    Word{"user.auto_logout", QT_TRANSLATE_NOOP("AuditWords", "Automatic logout")},
    Word{"user.add", QT_TRANSLATE_NOOP("AuditWords", "User added")},
    Word{"user.pin", QT_TRANSLATE_NOOP("AuditWords", "New PIN")},
    Word{"user.level", QT_TRANSLATE_NOOP("AuditWords", "Level changed")},
    Word{"user.rename", QT_TRANSLATE_NOOP("AuditWords", "User renamed")},
    Word{"user.remove", QT_TRANSLATE_NOOP("AuditWords", "User removed")},
    Word{"network.command", QT_TRANSLATE_NOOP("AuditWords", "Command from the network")},
    Word{"alarm.acknowledge", QT_TRANSLATE_NOOP("AuditWords", "Alarm acknowledged")},
    Word{"alarm.shelve", QT_TRANSLATE_NOOP("AuditWords", "Alarm shelved")},
    Word{"alarm.unshelve", QT_TRANSLATE_NOOP("AuditWords", "Alarm unshelved")},
    Word{"export.write", QT_TRANSLATE_NOOP("AuditWords", "Files written")},
    Word{"line.diagnose", QT_TRANSLATE_NOOP("AuditWords", "Connection diagnosed")},
    Word{"line.search", QT_TRANSLATE_NOOP("AuditWords", "Controller searched for")},
    Word{"line.reset", QT_TRANSLATE_NOOP("AuditWords", "Statistics reset")},
    Word{"memory.from_copy", QT_TRANSLATE_NOOP("AuditWords", "Replaced by its copy")},
    Word{"memory.lost", QT_TRANSLATE_NOOP("AuditWords", "Lost, new and empty")},
    Word{"audit.loss", QT_TRANSLATE_NOOP("AuditWords", "Rows lost")},
    Word{"audit.end_unknown", QT_TRANSLATE_NOOP("AuditWords", "Newest row unknown")},
    Word{"audit.trimmed", QT_TRANSLATE_NOOP("AuditWords", "Oldest rows deleted")},
};

// Each returns the label of a parameter; empty for one of something else.
constexpr std::array parameterWords{PackingFields::words, AxisFields::words,  CamSwitches::words,
                                    StartPermit::words,   TowerFields::words, MasterSentences::parameter};

constexpr std::array objectWords{
    Word{"connection", QT_TRANSLATE_NOOP("AuditWords", "connection")},
    Word{"clock", QT_TRANSLATE_NOOP("AuditWords", "clock")},
    Word{"time_zone", QT_TRANSLATE_NOOP("AuditWords", "time zone")},
    Word{"time_server", QT_TRANSLATE_NOOP("AuditWords", "time server")},
    Word{"network_address", QT_TRANSLATE_NOOP("AuditWords", "network address")},
    Word{"touchscreen", QT_TRANSLATE_NOOP("AuditWords", "calibration of the touchscreen")},
    Word{"simulated_faults", QT_TRANSLATE_NOOP("AuditWords", "simulated faults")},
    Word{"panel_software", QT_TRANSLATE_NOOP("AuditWords", "panel")},
    Word{"gateway_software", QT_TRANSLATE_NOOP("AuditWords", "gateway")},
    Word{"system_software", QT_TRANSLATE_NOOP("AuditWords", "system")},
    Word{"controller_software", QT_TRANSLATE_NOOP("AuditWords", "controller")},
};

constexpr std::array outcomeWords{
    Word{"done", QT_TRANSLATE_NOOP("AuditWords", "done")},
    Word{"requested", QT_TRANSLATE_NOOP("AuditWords", "requested")},
    Word{"not_sent", QT_TRANSLATE_NOOP("AuditWords", "not sent: no connection")},
    Word{"not_received", QT_TRANSLATE_NOOP("AuditWords", "not received by the controller")},
    Word{"unknown", QT_TRANSLATE_NOOP("AuditWords", "not known: no confirmation")},
    Word{"withdrawn", QT_TRANSLATE_NOOP("AuditWords", "withdrawn")},
    Word{"canceled", QT_TRANSLATE_NOOP("AuditWords", "canceled")},
    Word{"failed", QT_TRANSLATE_NOOP("AuditWords", "failed")},
    Word{"refused", QT_TRANSLATE_NOOP("AuditWords", "refused")},
    Word{"wrong_pin", QT_TRANSLATE_NOOP("AuditWords", "wrong PIN")},
    Word{"must_wait", QT_TRANSLATE_NOOP("AuditWords", "locked after wrong PINs")},
    Word{"released", QT_TRANSLATE_NOOP("AuditWords", "key released")},
    Word{"stopped", QT_TRANSLATE_NOOP("AuditWords", "stopped")},
    Word{"broken_off", QT_TRANSLATE_NOOP("AuditWords", "interrupted")},
    Word{"off_target", QT_TRANSLATE_NOOP("AuditWords", "written, but the cuts still deviate")},
};

// Returns "mm" for "program.bag_length"; empty without a register or a unit.
QString unitOf(const store::AuditEntry& entry)
{
    const std::string name = entry.object.toStdString();
    const modbus::RegisterInfo* info = modbus::findRegister(name);
    return info && !info->unit.empty()
               ? u' ' + QString::fromUtf8(info->unit.data(), static_cast<qsizetype>(info->unit.size()))
               : QString();
}

template <typename Words> const char* wordsFor(const Words& words, const QString& key)
{
    for (const Word& word : words) {
        if (key == QLatin1String(word.key))
            return word.words;
    }
    return nullptr;
}

} // namespace

QStringList AuditWords::areas()
{
    QStringList keys;
    for (const Word& word : areaWords)
        keys << QString::fromLatin1(word.key);
    return keys;
}

QString AuditWords::area(const QString& area)
{
    const char* words = wordsFor(areaWords, area);
    return words ? tr(words) : tr("All");
}

QString AuditWords::what(const QString& what)
{
    const char* words = wordsFor(whatWords, what);
    return words ? tr(words) : what;
}

QString AuditWords::object(const store::AuditEntry& entry)
{
    if (entry.what == u"program.value") {
        const std::string suffix = entry.object.section(u'.', 1).toStdString();
        for (const profile::FieldInfo& each : profile::fields) {
            if (!suffix.empty() && each.registerName == suffix)
                return RecipeWords::fieldName(each.field);
        }
    }
    if (entry.what == u"hand.trim") {
        const auto trim = std::ranges::find(program::trimTable, entry.object.toStdString(),
                                            &program::TrimInfo::registerName);
        if (trim != program::trimTable.end())
            return TrimWords::title(static_cast<program::Trim>(trim - program::trimTable.begin()));
    }
    if (entry.what == u"parameter.write" || entry.what == u"command.measure_end" ||
        entry.what == u"wizard.axis") {
        for (const auto wordsOf : parameterWords) {
            if (const QString words = wordsOf(entry.object); !words.isEmpty())
                return words;
        }
        return entry.object;
    }
    if (entry.what != u"setting.change")
        return entry.object;
    for (const SettingRow& row : settingTable) {
        if (row.label && shortKeyOf(row) == entry.object)
            return Settings::tr(row.label);
    }
    const char* words = wordsFor(objectWords, entry.object);
    return words ? tr(words) : entry.object;
}

QStringList AuditWords::keysWith(const QString& word)
{
    QStringList keys;
    const auto add = [&](const QString& key, const QString& words) {
        if (!word.isEmpty() && words.contains(word, Qt::CaseInsensitive))
            keys << key;
    };
    for (const Word& each : whatWords)
        add(QString::fromLatin1(each.key), tr(each.words));
    for (const Word& each : outcomeWords)
        add(QString::fromLatin1(each.key), tr(each.words));
    for (const Word& each : objectWords)
        add(QString::fromLatin1(each.key), tr(each.words));
    for (const SettingRow& row : settingTable) {
        if (row.label)
            add(shortKeyOf(row), Settings::tr(row.label));
    }
    for (const profile::FieldInfo& each : profile::fields) {
        if (!each.registerName.empty())
            add(u"program."_s + QString::fromStdString(std::string(each.registerName)),
                RecipeWords::fieldName(each.field));
    }
    for (const modbus::RegisterInfo& each : modbus::registers()) {
        const QString name = QString::fromUtf8(each.name.data(), static_cast<qsizetype>(each.name.size()));
        for (const auto wordsOf : parameterWords)
            add(name, wordsOf(name));
    }
    return keys;
}

QString AuditWords::outcome(const QString& outcome)
{
    // The form "refused 7", with the controller's number of the reason.
    const QString key = outcome.section(u' ', 0, 0);
    const char* words = wordsFor(outcomeWords, key);
    const QString number = outcome.section(u' ', 1);
    if (!words)
        return outcome;
    return number.isEmpty() ? tr(words) : tr("%1 (reason %2)", "refused (reason 7)").arg(tr(words), number);
}

QString AuditWords::who(const store::AuditEntry& entry)
{
    return entry.who.isEmpty() ? tr("nobody logged in") : entry.who;
}

QString AuditWords::change(const store::AuditEntry& entry)
{
    // The length of one line; the detail has the full text.
    constexpr qsizetype longest = 56;
    const QString before = entry.before.section(u" · CRC-32"_s, 0, 0);
    const QString after = entry.after.section(u" · CRC-32"_s, 0, 0);
    QString line = before.isEmpty() ? after : after.isEmpty() ? before : u"%1 → %2"_s.arg(before, after);
    line.replace(u'\n', u", "_s); // a list
    return line.size() <= longest ? line + unitOf(entry) : line.left(longest) + u'…';
}

QString AuditWords::time(qint64 timeMs)
{
    return Format::second(QDateTime::fromMSecsSinceEpoch(timeMs));
}

QString AuditWords::chain(const store::ChainCheck& check)
{
    const QString sequence = QString::number(check.brokenSequence());
    switch (check.fault()) {
    case store::ChainCheck::Fault::Altered:
        return tr("Row %1 was altered after it was written.").arg(sequence);
    case store::ChainCheck::Fault::Missing:
        return tr("Row %1 is missing: the audit trail was altered.").arg(sequence);
    case store::ChainCheck::Fault::MissingAtEnd:
        return tr("Row %1 and all later rows are missing.").arg(sequence);
    case store::ChainCheck::Fault::EndUnknown:
        return tr("Intact up to row %1. The file with the newest row is missing: later rows may be lost.")
            .arg(check.brokenSequence() - 1);
    case store::ChainCheck::Fault::None:
        break;
    }
    const QString rows = QLocale().toString(check.rows());
    return check.losses() > 0
               ? tr("Checked: %1 rows, intact; rows may have been lost earlier, see the trail.").arg(rows)
               : tr("Checked: %1 rows, intact.").arg(rows);
}

} // namespace campanel::panel
