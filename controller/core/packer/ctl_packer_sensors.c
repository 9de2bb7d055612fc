/* SPDX-License-Identifier: Apache-2.0 */
/* Mark sensor and product eye of a packing machine. */
#include "packer/ctl_packer.h"

#include "base/ctl_words.h"

#define MAX_END_US ((int32_t)CTL_MAX_PARAMETER_MARK_DEAD_TIME)

static uint16_t parameter(const ctl_packer* packer, uint32_t address)
{
    return ctl_parameter16(packer->board, address);
}

/* An edge has latched the counts of the wheel where somebody else drives the film. */
static int64_t film_latched(ctl_packer* packer, int64_t at)
{
    return packer->wheel.on ? ctl_wheel_film_at(&packer->wheel, at) : at;
}

static int64_t infeed_latched(ctl_packer* packer, int64_t at)
{
    return packer->wheel.on ? ctl_wheel_infeed_at(&packer->wheel, at) : at;
}

static int64_t mark_before(const ctl_packer* packer, int64_t at)
{
    return ctl_past_before(&packer->film_past, at, parameter(packer, CTL_REG_PARAMETER_MARK_DEAD_TIME));
}

/* The dead time of the sensor at the end of a mark is another one, within the same limits. */
static int64_t mark_end_before(const ctl_packer* packer, int64_t at)
{
    const int32_t later = (int16_t)parameter(packer, CTL_REG_PARAMETER_MARK_END_LATER);
    const int32_t dead_us = (int32_t)parameter(packer, CTL_REG_PARAMETER_MARK_DEAD_TIME) + later;
    const int32_t limited = dead_us > MAX_END_US ? MAX_END_US : dead_us;
    return ctl_past_before(&packer->film_past, at, limited < 0 ? 0 : (uint32_t)limited);
}

/* Ends the print at the sensor, wherever its end was, and records it. */
static void end_mark(ctl_packer* packer, int64_t film)
{
    if (!packer->mark_sensor.there)
        return;
    ctl_mark_sensor_end(&packer->mark_sensor, &packer->marks, film);
    ctl_edges_add(&packer->edges, &packer->mark_sensor.edge);
    packer->busy = true;
}

static void begin_mark(ctl_packer* packer, int64_t latched)
{
    /* A board without the ends of marks leaves the one before of unknown width. */
    end_mark(packer, packer->mark_sensor.edge.at);
    ctl_edge* edge = &packer->mark_sensor.edge;
    edge->at = mark_before(packer, latched);
    edge->newer = ctl_past_last_way(&packer->film_past, 0);
    edge->older = ctl_past_last_way(&packer->film_past, 1);
    edge->dead_us = parameter(packer, CTL_REG_PARAMETER_MARK_DEAD_TIME);
    ctl_mark_sensor_begin(&packer->mark_sensor, &packer->marks);
    packer->busy = true;
}

/* A mark that seems to be missing may be on its way, or at the sensor. */
static void pass_marks(ctl_packer* packer)
{
    ctl_mark_sensor* sensor = &packer->mark_sensor;
    if (sensor->waits)
        ctl_mark_sensor_watch(sensor, &packer->marks, mark_end_before(packer, packer->film_actual));
    if (!ctl_marks_due(&packer->marks, packer->film_actual))
        return;
    const int64_t film = mark_before(packer, packer->film_actual);
    ctl_marks_pass(&packer->marks, sensor->waits && sensor->edge.at < film ? sensor->edge.at : film);
}

static void read_mark_sensor(ctl_packer* packer)
{
    const ctl_port* port = &packer->board->port;
    int64_t at = 0;
    bool covered = false;
    while (port->mark(port->context, &at, &covered)) {
        at = film_latched(packer, at);
        if (covered)
            begin_mark(packer, at);
        else
            end_mark(packer, mark_end_before(packer, at));
    }
    pass_marks(packer);
}

/* Nobody says where the flights of somebody else's infeed are: where the products lie. Returns by how much
 * the infeed's positions are smaller from now on. */
static int64_t find_flights(ctl_packer* packer, int64_t at, bool covered)
{
    ctl_products* products = &packer->products;
    if (!packer->wheel.on || covered || !products->covered)
        return 0;
    const ctl_wheel_step step =
        ctl_wheel_find_flights(&packer->wheel, ctl_products_off(products, at), packer->flight);
    ctl_products_shift(products, step.found + step.drift, step.found);
    return step.found + step.drift;
}

static void read_eye(ctl_packer* packer)
{
    const ctl_port* port = &packer->board->port;
    int64_t at = 0;
    bool covered = false;
    while (port->eye(port->context, &at, &covered)) {
        const uint16_t dead_us = parameter(packer, covered ? CTL_REG_PARAMETER_EYE_DEAD_TIME
                                                           : CTL_REG_PARAMETER_EYE_END_DEAD_TIME);
        const ctl_eye_edge edge = {ctl_past_before(&packer->infeed_past, infeed_latched(packer, at), dead_us),
                                   ctl_past_last_way(&packer->infeed_past, 0), dead_us, covered};
        ctl_products_edge(&packer->products, edge.at - find_flights(packer, edge.at, covered), covered);
        ctl_eye_edges_add(&packer->eye_edges, &edge);
        packer->busy = true;
    }
}

void ctl_packer_read_sensors(ctl_packer* packer)
{
    const ctl_port* port = &packer->board->port;
    const int64_t film = packer->film_actual;
    const int64_t infeed = packer->infeed_actual;
    ctl_wheel* wheel = &packer->wheel;
    packer->film_actual = wheel->on ? ctl_wheel_film(wheel) : port->film(port->context);
    packer->infeed_actual = wheel->on ? ctl_wheel_infeed(wheel) : port->infeed(port->context);
    ctl_past_add(&packer->film_past, packer->board->now_us, packer->film_actual);
    ctl_past_add(&packer->infeed_past, packer->board->now_us, packer->infeed_actual);
    read_mark_sensor(packer);
    if (wheel->on)
        ctl_wheel_watch(wheel, &packer->marks, packer->film_actual);
    read_eye(packer);
    ctl_products_lay(&packer->products, infeed, packer->infeed_actual, film, packer->film_actual);
}
