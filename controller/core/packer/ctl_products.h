/* SPDX-License-Identifier: Apache-2.0 */
/* The products: seen by the eye over the infeed, laid on the film, and lying before the knife until their
 * cut. Infeed and film positions in 1/256 pulse of their motors; where a product lies is told by the film
 * positions at which its edges pass the knife. */
#ifndef CTL_PRODUCTS_H
#define CTL_PRODUCTS_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_PRODUCTS 24u

typedef struct {
    int64_t flight;   /* infeed from product to product */
    int64_t lay;      /* infeed position of a product when it is laid, from the start of its cycle */
    int64_t eye;      /* infeed from the eye to there */
    uint64_t ratio;   /* film per infeed, 2^-20 */
    int64_t distance; /* film from there to the knife: whole bags and a half */
} ctl_product_settings;

/* One that was seen and is not laid yet. */
typedef struct {
    int64_t number; /* of the infeed's cycle in which it is laid */
    int64_t behind; /* film by which its middle lies behind its place */
    int64_t length; /* film */
} ctl_coming;

typedef struct {
    int64_t lead;
    int64_t trail;
} ctl_product;

typedef struct {
    ctl_product_settings settings;
    bool covered;         /* the eye now */
    int64_t lead;         /* infeed position at which it was covered */
    int64_t watched_from; /* infeed positions before this were never seen */
    int64_t next;         /* number of the next one to be laid */
    ctl_coming coming[CTL_PRODUCTS];
    uint32_t coming_count;
    ctl_product laid[CTL_PRODUCTS]; /* from the knife to where they are laid */
    uint32_t laid_count;
    uint32_t total;  /* laid since power-up */
    int64_t longest; /* film length of the longest one seen since the settings were made */
} ctl_products;

/* The infeed stands at `infeed`. When its geometry is another one than before, and at first, what is under
 * way between eye and film is not known; what lies on the film lies there. */
void ctl_products_set(ctl_products* products, const ctl_product_settings* settings, int64_t infeed);
/* An edge passed the eye at that infeed position. */
void ctl_products_edge(ctl_products* products, int64_t infeed, bool covered);
/* Product `number` is known not to come: its place went by under the eye, and nothing was there. */
bool ctl_products_missing(const ctl_products* products, int64_t number, int64_t infeed);
/* The infeed has come to `infeed`, the film from `film_before` to `film`: lays what is due. */
void ctl_products_lay(ctl_products* products, int64_t infeed_before, int64_t infeed, int64_t film_before,
                      int64_t film);
/* A product lies across a cut made at this film position, or nearer to it than the clearance. */
bool ctl_products_across(const ctl_products* products, int64_t cut, int64_t clearance);
/* Forgets what is past the knife; returns the products of the bag that ends at `cut`. */
uint32_t ctl_products_cut(ctl_products* products, int64_t cut);

#ifdef __cplusplus
}
#endif

#endif
