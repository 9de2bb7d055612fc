// SPDX-License-Identifier: Apache-2.0
// `Orders.offers` in QML: the orders that the plant's network offers to this machine, each with its signer or
// why it cannot be taken. They stay in memory until the plant withdraws them; a person puts one into the
// queue.
#pragma once

#include "app/panel/kit/offer_model.h"
#include "app/plant/local_messages.h"
#include "app/store/signed_order.h"

#include <QMap>
#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class DatabaseService;

class OrderOffers : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Orders.offers is the only one")
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ rows CONSTANT FINAL)
    // The orders that can be taken, by their titles; empty: none.
    Q_PROPERTY(QString titles READ titles NOTIFY changed FINAL)

public:
    // The records must outlive the object.
    OrderOffers(DatabaseService& records, QObject* parent);

    // Checks signatures with the keys in this folder, and that an order is for the machine of this name.
    void setTrust(const QString& keyFolder, const QString& machine);
    // Adds, replaces or withdraws an offer.
    void takeOffer(const plant::OfferMessage& offer);
    // Checks all of them again after the queue or the log has changed.
    void update();

    [[nodiscard]] OfferModel* rows() { return &m_rows; }
    [[nodiscard]] QString titles() const { return m_titles; }
    // Returns the order of a row that can be taken.
    [[nodiscard]] std::optional<store::SignedOrder> orderAt(int row) const;

signals:
    void changed();

private:
    struct Checked {
        QString name; // of the offer
        tl::expected<store::SignedOrder, store::FileError> order;
        bool isKnown = false; // it waits in the queue, or was started once
    };

    void show();
    [[nodiscard]] OfferRow row(const Checked& offer) const;
    [[nodiscard]] QString refusal(const Checked& offer) const; // empty: it can be taken

    DatabaseService& m_records;
    QString m_keyFolder;
    QString m_machine;
    QMap<QString, QByteArray> m_received;
    QList<Checked> m_checked;
    OfferModel m_rows{this};
    QString m_titles;
};

} // namespace campanel::panel
