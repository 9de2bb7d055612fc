// SPDX-License-Identifier: Apache-2.0
// The products of a packing machine: on the infeed under the eye, then on the film until the cut. Each has a
// nominal place on the infeed, with a small or large offset, or is missing. Positions on the infeed are in
// products: product n in its place is laid on the film where the infeed stands at n + 1/2, whatever the
// program.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <vector>

namespace campanel::controller {

struct ProductOptions {
    double lengthMm = 0.0;        // 0: 0.6 of the bag length
    double lengthScatterMm = 0.5; // standard deviation
    double scatterMm = 2.0;
    double laySlipMm = 0.3; // slip on the film, not detected by the eye
    double eyeNoiseMm = 0.2;
    double missing = 0.0;   // share of missing products
    double misplaced = 0.0; // share anywhere within 0.45 of a bag length from its place
    double joined = 0.0;    // share of products that hang together with the next one
    double pitchMm = 500.0; // on the infeed
    double eyeMm = 1000.0;  // distance before the laying position
    double layMm = 700.0;   // from there to the knife, rounded to half bags
};

class Infeed {
public:
    Infeed(const ProductOptions& options, std::uint64_t seed);

    // Loads bags of this length.
    void load(double bagMm, double position);
    // Moves to the next position; drawnBeforeMm and drawnMm are the film drawn before and after, including
    // slip.
    void moveTo(double position, double drawnBeforeMm, double drawnMm);

    struct Edge {
        double position = 0.0;
        bool covered = false;
    };
    std::optional<Edge> takeEdge();

    // The film drawn when the edges of a product on the film are at the knife.
    struct Laid {
        double leadMm = 0.0;
        double trailMm = 0.0;
    };
    struct Cut {
        std::vector<Laid> products; // in the bag that ends with this cut
        bool through = false;       // the knife hit a product
    };
    // Closes the knife with this much film drawn.
    Cut cut(double drawnMm);

private:
    struct Product {
        std::int64_t number = 0;
        double behindMm = 0.0; // distance behind its place
        double lengthMm = 0.0;
        int pieces = 1;
    };
    void generate();
    [[nodiscard]] bool hangsTogether();
    void passEye(double position);
    void layOne(double drawnMm);

    ProductOptions m_options;
    std::mt19937_64 m_random;
    std::normal_distribution<double> m_normal;
    double m_bagMm = 0.0;
    double m_position = 0.0;
    std::int64_t m_next = 0; // next product to generate
    std::optional<Product> m_last;
    std::deque<Edge> m_due;       // edges that have not reached the eye yet
    std::deque<Edge> m_edges;     // edges that have, and were not taken
    std::deque<Product> m_coming; // products to lay
    std::deque<Laid> m_laid;
};

} // namespace campanel::controller
