// SPDX-License-Identifier: Apache-2.0
#include "app/panel/words/stop_words.h"

#include "app/panel/kit/format.h"
#include "app/panel/words/alarm_catalogue.h"
#include "app/panel/words/controller_sentences.h"

#include <array>

using namespace Qt::StringLiterals;

namespace campanel::panel {

using store::StateInterval;

namespace {

struct ReasonWord {
    const char* part;
    const char* words;
};

constexpr std::array reasonWords{
    ReasonWord{"waiting", QT_TRANSLATE_NOOP("StopWords", "Waiting for products")},
    ReasonWord{"material", QT_TRANSLATE_NOOP("StopWords", "Material")},
    ReasonWord{"film_change", QT_TRANSLATE_NOOP("StopWords", "Film change")},
    ReasonWord{"film_torn", QT_TRANSLATE_NOOP("StopWords", "Film torn")},
    ReasonWord{"no_product", QT_TRANSLATE_NOOP("StopWords", "No product")},
    ReasonWord{"product_jam", QT_TRANSLATE_NOOP("StopWords", "Product jam")},
    ReasonWord{"machine", QT_TRANSLATE_NOOP("StopWords", "Machine")},
    ReasonWord{"film_jam", QT_TRANSLATE_NOOP("StopWords", "Film jam")},
    ReasonWord{"knife", QT_TRANSLATE_NOOP("StopWords", "Knife, jaws")},
    ReasonWord{"sensor", QT_TRANSLATE_NOOP("StopWords", "Sensor")},
    ReasonWord{"adjustment", QT_TRANSLATE_NOOP("StopWords", "Adjustment")},
    ReasonWord{"quality", QT_TRANSLATE_NOOP("StopWords", "Quality")},
    ReasonWord{"seal", QT_TRANSLATE_NOOP("StopWords", "Seal")},
    ReasonWord{"length", QT_TRANSLATE_NOOP("StopWords", "Bag length")},
    ReasonWord{"print", QT_TRANSLATE_NOOP("StopWords", "Print")},
    ReasonWord{"changeover", QT_TRANSLATE_NOOP("StopWords", "Changeover")},
    ReasonWord{"cleaning", QT_TRANSLATE_NOOP("StopWords", "Cleaning")},
    ReasonWord{"maintenance", QT_TRANSLATE_NOOP("StopWords", "Maintenance")},
    ReasonWord{"break", QT_TRANSLATE_NOOP("StopWords", "Break")},
    ReasonWord{"no_order", QT_TRANSLATE_NOOP("StopWords", "No order")},
};

} // namespace

QString StopWords::state(StateInterval::State state)
{
    return state == StateInterval::State::Suspended
               ? tr("Waiting")
               : ControllerSentences::text(static_cast<modbus::State>(state));
}

QString StopWords::reasonPart(const QString& part)
{
    for (const ReasonWord& word : reasonWords) {
        if (part == QLatin1String(word.part))
            return tr(word.words);
    }
    return part;
}

QString StopWords::reason(const QString& reason)
{
    if (reason.isEmpty())
        return tr("No reason");
    if (const AlarmKind* alarm = AlarmCatalogue::find(reason))
        return tr("%1 (%2)", "title and code of an alarm").arg(alarm->title(), reason);
    const QString group = reasonPart(reason.section(u'/', 0, 0));
    const QString name = reason.section(u'/', 1);
    return name.isEmpty() ? group : tr("%1 · %2", "group and reason").arg(group, reasonPart(name));
}

QString StopWords::duration(qint64 durationMs)
{
    constexpr qint64 msPerSecond = 1000;
    constexpr qint64 secondsPerMinute = 60;
    constexpr qint64 minutesPerHour = 60;
    const qint64 seconds = durationMs / msPerSecond;
    const qint64 minutes = seconds / secondsPerMinute;
    if (minutes == 0)
        return Format::unbroken(tr("%1 s").arg(seconds));
    if (minutes < minutesPerHour)
        return Format::unbroken(tr("%1 min").arg(minutes));
    return Format::unbroken(
        tr("%1 h %2 min").arg(minutes / minutesPerHour).arg(minutes % minutesPerHour, 2, 10, QChar(u'0')));
}

} // namespace campanel::panel
