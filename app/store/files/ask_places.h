// SPDX-License-Identifier: Apache-2.0
// Asks several places at the same time: a stick or a network share may never answer, and nothing can end a
// thread that waits for it. Such a thread is left alone, and its place is not asked again before it is back.
#pragma once

#include "app/store/files/exchange_places.h"

#include <QHash>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace campanel::store {

// Calls `ask` for each place in a thread of its own and waits for all of them, at most `patience`. Returns an
// answer for each place; nothing for one that is silent. `ask` must own what it uses.
template <class Answer>
[[nodiscard]] std::vector<std::optional<Answer>> askPlaces(const QList<Place>& places,
                                                           const std::function<Answer(const Place&)>& ask,
                                                           std::chrono::milliseconds patience)
{
    // For each thread that searches: the places that still owe an answer of this type.
    thread_local QHash<QString, std::shared_ptr<std::atomic<bool>>> debts;
    debts.removeIf([](const auto& debt) { return debt.value()->load(); });
    std::vector<std::optional<std::future<Answer>>> asked;
    for (const Place& place : places) {
        if (place.isSilent || debts.contains(place.path)) {
            asked.emplace_back();
            continue;
        }
        auto isBack = std::make_shared<std::atomic<bool>>(false);
        std::promise<Answer> promise;
        asked.emplace_back(promise.get_future());
        std::thread([ask, place, isBack, promise = std::move(promise)]() mutable {
            promise.set_value(ask(place));
            isBack->store(true);
        }).detach();
        debts.insert(place.path, isBack);
    }
    const auto end = std::chrono::steady_clock::now() + patience;
    std::vector<std::optional<Answer>> answers(asked.size());
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (asked[i] && asked[i]->wait_until(end) == std::future_status::ready) {
            answers[i] = asked[i]->get();
            debts.remove(places[static_cast<qsizetype>(i)].path);
        }
    }
    return answers;
}

} // namespace campanel::store
