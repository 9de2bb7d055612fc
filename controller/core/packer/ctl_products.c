/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_products.h"

#include <string.h>

#define RATIO_BITS 20u

static int64_t to_film(const ctl_products* products, int64_t infeed)
{
    const int64_t film =
        (int64_t)((uint64_t)(infeed < 0 ? -infeed : infeed) * products->settings.ratio >> RATIO_BITS);
    return infeed < 0 ? -film : film;
}

/* Rounded down, also below zero. */
static int64_t divided(int64_t value, int64_t by)
{
    const int64_t quotient = value / by;
    return value % by < 0 ? quotient - 1 : quotient;
}

void ctl_products_set(ctl_products* products, const ctl_product_settings* settings, int64_t infeed)
{
    const bool same =
        products->settings.flight == settings->flight && products->settings.eye == settings->eye;
    products->settings = *settings;
    if (same)
        return;
    products->coming_count = 0;
    products->covered = false;
    products->known = false;
    products->watched_from = infeed;
    products->next = divided(infeed - settings->lay, settings->flight) + 1;
}

static bool is_too_long(const ctl_products* products, int64_t length)
{
    return products->settings.maximum != 0 && length > products->settings.maximum;
}

bool ctl_products_joined(const ctl_products* products)
{
    return is_too_long(products, products->longest);
}

/* Infeed position at which the middle of product `number` passes the eye when it lies in its place. */
static int64_t place_at_eye(const ctl_products* products, int64_t number)
{
    const ctl_product_settings* settings = &products->settings;
    return number * settings->flight + settings->lay - settings->eye;
}

static int64_t number_at_eye(const ctl_products* products, int64_t middle)
{
    const int64_t flight = products->settings.flight;
    return divided(middle - place_at_eye(products, 0) + flight / 2, flight);
}

int64_t ctl_products_off(const ctl_products* products, int64_t trail)
{
    const int64_t middle = products->lead + (trail - products->lead) / 2;
    return middle - place_at_eye(products, number_at_eye(products, middle));
}

/* It may belong to the place beside it then, as long as that was not laid. */
static void place_again(ctl_products* products, ctl_coming* coming, int64_t found)
{
    const int64_t pitch = to_film(products, products->settings.flight);
    coming->behind -= to_film(products, found);
    if (2 * coming->behind >= pitch) {
        coming->number += 1;
        coming->behind -= pitch;
    } else if (2 * coming->behind < -pitch && coming->number > products->next) {
        coming->number -= 1;
        coming->behind += pitch;
    }
}

void ctl_products_shift(ctl_products* products, int64_t by, int64_t found)
{
    products->lead -= by;
    products->watched_from -= by;
    for (uint32_t i = 0; found != 0 && i < products->coming_count; ++i)
        place_again(products, &products->coming[i], found);
}

static void come(ctl_products* products, int64_t lead, int64_t trail)
{
    const int64_t middle = lead + (trail - lead) / 2;
    ctl_coming coming;
    coming.number = number_at_eye(products, middle);
    coming.behind = to_film(products, middle - place_at_eye(products, coming.number));
    coming.length = to_film(products, trail - lead);
    if (coming.length > products->longest)
        products->longest = coming.length;
    if (products->coming_count < CTL_PRODUCTS)
        products->coming[products->coming_count++] = coming;
}

void ctl_products_edge(ctl_products* products, int64_t infeed, bool covered)
{
    if (products->settings.flight == 0 || covered == products->covered)
        return;
    products->covered = covered;
    if (covered)
        products->lead = infeed;
    else
        come(products, products->lead, infeed);
}

bool ctl_products_missing(const ctl_products* products, int64_t number, int64_t infeed)
{
    const int64_t half = products->settings.flight / 2;
    const int64_t place = place_at_eye(products, number);
    if (place - half < products->watched_from || place + half > infeed)
        return false;
    if (products->covered && products->lead < place + half) /* it may still turn out to be this one */
        return false;
    for (uint32_t i = 0; i < products->coming_count; ++i) {
        if (products->coming[i].number == number)
            return false;
    }
    return true;
}

bool ctl_products_place_free(const ctl_products* products, int64_t infeed)
{
    const uint32_t count = products->coming_count;
    const int64_t next = count != 0 ? products->coming[count - 1u].number + 1 : products->next;
    return !products->covered && infeed >= place_at_eye(products, next) - products->settings.flight / 2;
}

static void lay_one(ctl_products* products, const ctl_coming* coming, int64_t film)
{
    const int64_t middle = film + products->settings.distance + coming->behind;
    const ctl_product product = {middle - coming->length / 2, middle + coming->length / 2};
    if (products->laid_count == CTL_PRODUCTS) {
        products->laid_count -= 1;
        memmove(&products->laid[0], &products->laid[1], products->laid_count * sizeof products->laid[0]);
    }
    products->laid[products->laid_count++] = product;
    products->total += 1;
}

/* All that belong to `number` are laid at this film position. */
static void lay_number(ctl_products* products, int64_t number, int64_t film)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < products->coming_count; ++i) {
        const ctl_coming coming = products->coming[i];
        if (coming.number == number) {
            lay_one(products, &coming, film);
        } else if (coming.number > number) {
            products->coming[kept++] = coming;
        }
    }
    products->coming_count = kept;
}

void ctl_products_lay(ctl_products* products, int64_t infeed_before, int64_t infeed, int64_t film_before,
                      int64_t film)
{
    if (products->settings.flight == 0)
        return;
    for (;;) {
        const int64_t due = products->next * products->settings.flight + products->settings.lay;
        if (due > infeed)
            return;
        const int64_t way = infeed - infeed_before;
        const int64_t part = way > 0 && due > infeed_before ? due - infeed_before : 0;
        const int64_t at = way > 0 ? film_before + (film - film_before) * part / way : film;
        const int64_t begins = place_at_eye(products, products->next) - products->settings.flight / 2;
        if (!products->known && begins >= products->watched_from) {
            products->known = true;
            products->known_from = at + products->settings.distance;
        }
        lay_number(products, products->next, at);
        products->next += 1;
    }
}

bool ctl_products_across(const ctl_products* products, int64_t cut, int64_t clearance)
{
    for (uint32_t i = 0; i < products->laid_count; ++i) {
        const ctl_product* product = &products->laid[i];
        if (cut > product->lead - clearance && cut < product->trail + clearance)
            return true;
    }
    return false;
}

uint32_t ctl_products_cut(ctl_products* products, int64_t cut)
{
    uint32_t kept = 0;
    uint32_t bagged = 0;
    for (uint32_t i = 0; i < products->laid_count; ++i) {
        const ctl_product product = products->laid[i];
        const int64_t length = product.trail - product.lead;
        if (product.lead + length / 2 >= cut)
            products->laid[kept++] = product;
        else if (!is_too_long(products, length))
            bagged += 1;
    }
    products->laid_count = kept;
    return bagged;
}
