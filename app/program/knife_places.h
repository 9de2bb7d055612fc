// SPDX-License-Identifier: Apache-2.0
// Estimates from the lengths of the bags where the knives of a shaft cut that are not quite evenly spaced. A
// bag is longer by the place of the knife that ends it and shorter by that of the one before.
#pragma once

#include <optional>
#include <vector>

namespace campanel::program {

struct KnifePlace {
    double mm = 0.0;       // behind its own place on the film, as seen from the first knife
    double marginMm = 0.0; // standard deviation
};

class KnifePlaces {
public:
    static constexpr int minBags = 30;      // of each knife
    static constexpr double leastMm = 0.02; // a smaller place is not worth a correction

    explicit KnifePlaces(int knives) { begin(knives); }
    // Begins anew for a shaft with so many knives.
    void begin(int knives);
    [[nodiscard]] int knives() const { return static_cast<int>(m_sums.size()); }
    // Adds a bag that ended at this knife, from 1, by its length minus the set length.
    void take(int knife, double deviationMm);
    // Returns nothing while too few bags tell of one of the knives.
    [[nodiscard]] std::optional<KnifePlace> place(int knife) const;
    // Returns the place to enter instead of `presentMm`, with which the bags were made; nothing while it is
    // within twice the margin.
    [[nodiscard]] std::optional<double> offered(int knife, double presentMm) const;

private:
    struct Sum {
        int bags = 0;
        double mm = 0.0;
        double squares = 0.0;
    };
    std::vector<Sum> m_sums;
};

} // namespace campanel::program
