// SPDX-License-Identifier: Apache-2.0
// Tells ThreadSanitizer that an event is delivered after it was posted and that a thread is waited for after
// it quit, which it cannot see in Debian's Qt. These functions stand before Qt's own in programs of the
// preset `tsan`: a signal, an invokeMethod() or a quit() releases; the delivery of an event or the end of a
// wait() acquires. All share one place, so a race between two threads that also exchange calls in between is
// not found.
#include <QCoreApplication>
#include <QMetaObject>
#include <QObject>
#include <QThread>

#include <dlfcn.h>
#include <sanitizer/tsan_interface.h>

namespace {

char posted;

bool deliver(void**)
{
    __tsan_acquire(&posted);
    return false; // and Qt delivers it
}

[[maybe_unused]] const bool isRegistered =
    QInternal::registerCallback(QInternal::EventNotifyCallback, &deliver);

template <typename Function> Function* next(const char* symbol)
{
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, symbol));
}

} // namespace

void QMetaObject::activate(QObject* sender, const QMetaObject* of, int signal, void** arguments)
{
    using Activate = void(QObject*, const QMetaObject*, int, void**);
    static Activate* const original =
        next<Activate>("_ZN11QMetaObject8activateEP7QObjectPKS_iPPv");
    __tsan_release(&posted);
    original(sender, of, signal, arguments);
}

bool QMetaObject::invokeMethodImpl(QObject* object, QtPrivate::QSlotObjectBase* slot,
                                   Qt::ConnectionType type, void* result)
{
    using Invoke = bool(QObject*, QtPrivate::QSlotObjectBase*, Qt::ConnectionType, void*);
    static Invoke* const original = next<Invoke>(
        "_ZN11QMetaObject16invokeMethodImplEP7QObjectPN9QtPrivate15QSlotObjectBaseEN2Qt14ConnectionTypeEPv");
    // Never deleted: Qt counts its references where the sanitizer does not see it.
    slot->ref();
    __tsan_release(&posted);
    return original(object, slot, type, result);
}

void QThread::quit()
{
    static auto* const original = next<void(QThread*)>("_ZN7QThread4quitEv");
    __tsan_release(&posted);
    original(this);
}

bool QThread::wait(QDeadlineTimer deadline)
{
    static auto* const original = next<bool(QThread*, QDeadlineTimer)>("_ZN7QThread4waitE14QDeadlineTimer");
    const bool hasEnded = original(this, deadline);
    if (hasEnded)
        __tsan_acquire(&posted);
    return hasEnded;
}
