// SPDX-License-Identifier: Apache-2.0
#include "app/store/signed_order.h"

#include "app/store/files/json_keys.h"
#include "app/store/files/json_reader.h"
#include "app/store/recipes/signed_text.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <array>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

const SignedForm orderForm{u"campanel-signed-order"_s, u"order"_s, u"machine"_s};

constexpr std::array actions{OrderRow::Action::None, OrderRow::Action::Message, OrderRow::Action::Stop};

QByteArray textOf(const OrderRow& order)
{
    return QJsonDocument(QJsonObject{{u"order"_s, order.text},
                                     {u"lot"_s, order.lot},
                                     {u"recipe"_s, order.recipe},
                                     {u"quantity"_s, order.quantity},
                                     {u"action"_s, nameOf(order.action)},
                                     {u"message_before"_s, order.messageBefore}})
        .toJson(QJsonDocument::Compact);
}

tl::expected<OrderRow, FileError> orderIn(const QByteArray& text)
{
    std::optional<FileError> failure;
    ObjectReader reader(QJsonDocument::fromJson(text).object(), u"order."_s, failure);
    profile::FieldInfo bags;
    bags.max = maxOrderedBags;
    OrderRow order;
    order.text = reader.text(u"order"_s);
    order.lot = reader.text(u"lot"_s);
    order.recipe = reader.text(u"recipe"_s);
    order.messageBefore = static_cast<qint64>(reader.number(u"message_before"_s, true, bags));
    bags.min = 1;
    order.quantity = static_cast<qint64>(reader.number(u"quantity"_s, true, bags));
    const QString action = reader.text(u"action"_s);
    QStringList names;
    bool isKnown = false;
    for (const OrderRow::Action each : actions) {
        names << nameOf(each);
        if (action == names.last()) {
            order.action = each;
            isKnown = true;
        }
    }
    if (!isKnown)
        reader.fail(u"action"_s, FileError::Kind::NotAChoice, action, names.join(u", "_s));
    reader.refuseUnknownKeys();
    for (const auto& [key, value] : {std::pair{u"order"_s, order.text}, std::pair{u"lot"_s, order.lot}}) {
        if (value.trimmed().isEmpty())
            reader.fail(key, FileError::Kind::WrongType, {}, FileErrorText::aVisibleText());
    }
    if (const auto key = repeatedKey(text))
        return tl::unexpected(FileError{FileError::Kind::RepeatedKey, {}, *key, {}, {}, 0});
    if (failure)
        return tl::unexpected(*failure);
    return order;
}

} // namespace

QByteArray signOrder(const OrderRow& order, const QString& machine, qint64 signedMs, const SigningKey& key)
{
    return signText(orderForm, QString::fromUtf8(textOf(order)), machine, signedMs, key);
}

tl::expected<SignedOrder, FileError> verifyOrder(const QByteArray& json, const QString& path,
                                                 const QList<SignerKey>& keys)
{
    const auto text = verifyText(orderForm, json, path, keys);
    if (!text)
        return tl::unexpected(text.error());
    const auto order = orderIn(text->text.toUtf8());
    if (!order) {
        FileError error = order.error();
        error.path = path;
        return tl::unexpected(error);
    }
    return SignedOrder{*order, text->mark, text->signer, text->signedMs()};
}

} // namespace campanel::store
