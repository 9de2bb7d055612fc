// SPDX-License-Identifier: Apache-2.0
// The products of a packing machine: on the infeed under the eye, then on the film until they are cut. Each
// has its place on the infeed, from which it lies off by some mm, or far off, or is missing. Positions on the
// infeed in products: product n lies in its place when it is laid at n plus a share of the cycle.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <vector>

namespace campanel::controller {

struct ProductOptions {
    double lengthMm = 0.0;        // 0: 0.6 of the bag length
    double lengthScatterMm = 0.5; // standard deviations
    double scatterMm = 2.0;
    double laySlipMm = 0.3; // by which it slips on the film, unseen by the eye
    double eyeNoiseMm = 0.2;
    double missing = 0.0;   // share
    double misplaced = 0.0; // share that lies anywhere within 0.45 of a bag length from its place
    double pitchMm = 500.0; // on the infeed
    double eyeMm = 1000.0;  // before where they are laid
    double layMm = 700.0;   // from there to the knife, to the nearest half bag
};

class Infeed {
public:
    Infeed(const ProductOptions& options, std::uint64_t seed);

    // Bags of this length; products are laid at this share of the cycle.
    void load(double bagMm, double layShare, double position);
    // From one position to the next, while so much film has been drawn, slip included.
    void moveTo(double position, double drawnBeforeMm, double drawnMm);

    struct Edge {
        double position = 0.0;
        bool covered = false;
    };
    std::optional<Edge> takeEdge();

    // Film drawn when the edges of a product on the film are at the knife.
    struct Laid {
        double leadMm = 0.0;
        double trailMm = 0.0;
    };
    struct Cut {
        std::vector<Laid> products; // in the bag that ends here
        bool through = false;       // one lay under the knife
    };
    // The knife closes with so much film drawn.
    Cut cut(double drawnMm);

private:
    struct Product {
        std::int64_t number = 0;
        double behindMm = 0.0; // its place
        double lengthMm = 0.0;
    };
    void generate();
    void passEye(double position);
    void layOne(double drawnMm);

    ProductOptions m_options;
    std::mt19937_64 m_random;
    std::normal_distribution<double> m_normal;
    double m_bagMm = 0.0;
    double m_layShare = 0.0;
    double m_position = 0.0;
    std::int64_t m_next = 0; // to be generated
    std::optional<Product> m_last;
    std::deque<Edge> m_due;       // edges that have not reached the eye yet
    std::deque<Edge> m_edges;     // that have, and were not taken
    std::deque<Product> m_coming; // to be laid
    std::deque<Laid> m_laid;
};

} // namespace campanel::controller
