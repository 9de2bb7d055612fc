/* SPDX-License-Identifier: Apache-2.0 */
/* The products: seen by the eye over the infeed, placed on the film, and before the knife until their cut.
 * Infeed and film positions in 1/256 pulse of their motors; the position of a product is the pair of film
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
    int64_t maximum;  /* length of one product on the film, 0: any */
} ctl_product_settings;

/* A product that was seen and is not on the film yet. */
typedef struct {
    int64_t number; /* of the infeed's cycle in which it is placed */
    int64_t behind; /* film length from its place to its middle */
    int64_t length; /* film */
} ctl_coming;

typedef struct {
    int64_t lead;
    int64_t trail;
} ctl_product;

typedef struct {
    ctl_product_settings settings;
    bool covered;         /* the eye now */
    int64_t lead;         /* infeed position at which the eye was covered */
    int64_t watched_from; /* infeed positions before this were not observed */
    int64_t next;         /* number of the next product to be placed */
    ctl_coming coming[CTL_PRODUCTS];
    uint32_t coming_count;
    ctl_product laid[CTL_PRODUCTS]; /* from the knife to where they are laid */
    uint32_t laid_count;
    uint32_t total;     /* placed since power-up */
    int64_t longest;    /* maximum length of a product on the film since the settings changed */
    bool known;         /* a place that was watched from its beginning was laid on the film: */
    int64_t known_from; /* before this film position unknown products may be at the knife */
} ctl_products;

/* Applies the settings at the infeed position `infeed`. After a change of geometry, and at first, the
 * products between eye and film are unknown; the products on the film are kept. */
void ctl_products_set(ctl_products* products, const ctl_product_settings* settings, int64_t infeed);
/* Returns how far the middle of a product that ends here at the eye is behind its place on the infeed. */
int64_t ctl_products_off(const ctl_products* products, int64_t trail);
/* The infeed's positions are counted anew from now on: smaller by so much, of which the places of the
 * products between eye and film were elsewhere by `found`. */
void ctl_products_shift(ctl_products* products, int64_t by, int64_t found);
/* Handles an edge of a product at the eye. */
void ctl_products_edge(ctl_products* products, int64_t infeed, bool covered);
/* Returns true when product `number` is missing: its place passed the eye without a product. */
bool ctl_products_missing(const ctl_products* products, int64_t number, int64_t infeed);
/* Returns true when no product has come yet for the place that is at the eye. */
bool ctl_products_place_free(const ctl_products* products, int64_t infeed);
/* Places the products that are due on the film, for an infeed at `infeed` and a film that moved from
 * `film_before` to `film`. */
void ctl_products_lay(ctl_products* products, int64_t infeed_before, int64_t infeed, int64_t film_before,
                      int64_t film);
/* Returns true when a product is across a cut at this film position, or nearer to it than the clearance. */
bool ctl_products_across(const ctl_products* products, int64_t cut, int64_t clearance);
/* Returns true when a product was longer than the maximum since the settings changed: two hang together. */
bool ctl_products_joined(const ctl_products* products);
/* Removes the products past the knife; returns the number of products of the bag that ends at `cut`, without
 * those that are too long. */
uint32_t ctl_products_cut(ctl_products* products, int64_t cut);

#ifdef __cplusplus
}
#endif

#endif
