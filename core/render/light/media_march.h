// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/render/light/interior_list.h"
#include "core/render/light/light_arrival.h"
#include "core/render/light/surface_points.h"
#include "core/render/stages/filter_chain.h"
#include "core/scene/scene.h"
#include "core/texture/color_lookup.h"

namespace isoscope {

/// What media do on many ways: how much of the light behind comes through, and what they add of their own.
/// Samples are taken where POV-Ray 3.7 takes those of its method 3, and in the middle of their parts for the
/// other methods, which it moves at random (docs/povray/media.md). Shared by threads.
class MediaMarch {
  public:
    /// One way, and what find() finds of it.
    struct Way {
        Ray ray;  ///< of unit direction
        double distance = 0;
        InteriorList inside{};     ///< whose media it goes through
        std::uint32_t sample = 0;  ///< of the batch, for the light filters; without them the caller's
        glm::dvec3 light{0}, through{1};
    };

    /// The ways and the scratch memory of one thread.
    class Work : public ShapeState {
      public:
        explicit Work(std::span<const double> parameters) : lookup_(parameters) {}

        std::vector<Way> ways;

      private:
        friend class MediaMarch;

        struct Sample {
            std::uint32_t way;
            double t;
            glm::dvec3 shine{0}, loss{0};  ///< by unit of length
        };
        /// A part of a way between two samples, with a third in between; its halves are parts of their own
        /// where the samples differ.
        struct Part {
            std::uint32_t first, middle, last;
            std::uint32_t way;
            double length;    ///< of the whole part, which its samples need not reach
            double interval;  ///< in which it is
            int depth = 1;
            std::uint32_t firstHalf = none, lastHalf = none;
            static constexpr std::uint32_t none = 0xffffffff;
            glm::dvec3 shine{0}, loss{0};
        };
        /// One medium at one sample.
        struct Filling {
            const Medium* medium;
            int lightGroup;
            std::uint32_t sample;
            glm::dvec3 density{1};
        };

        ColorLookup lookup_;
        std::vector<Sample> samples_;
        std::vector<Part> parts_;
        std::vector<BeamStretch> lit_;
        std::vector<std::uint32_t> wholeParts_;  ///< of each way of a group: how many are not halves
        std::vector<Filling> fillings_;
        std::vector<std::uint32_t> scattering_;  ///< fillings, each a place in `places_`
        SurfacePoints places_;
        std::vector<std::uint32_t> litFillings_;  ///< those that the light at hand reaches, in `litPlaces_`
        SurfacePoints litPlaces_;
    };

    /// Which media count: those of all space, those of objects. None reach into what is not hollow.
    struct Concerned {
        bool space = true, objects = true;
    };
    /// Media scatter the light that `filters` leave; null: their own light and what they scatter is not
    /// asked for, only what comes through. The scene must outlive this.
    MediaMarch(const Scene& scene, Concerned concerned, std::shared_ptr<const LightFilters> filters);

    /// Whether any of them fills the space there.
    bool fills(const InteriorList& inside) const { return !mediaIn(inside).empty(); }
    /// Finds light and through of all ways of `own`. Early, with some of them as they were, when a stop is
    /// requested.
    void find(TileScratch& work, Work& own) const;

  private:
    /// A medium that fills a space, and whose lights it scatters.
    struct Present {
        const Medium* medium;
        int lightGroup;
    };
    std::vector<Present> mediaIn(const InteriorList& inside) const;
    std::size_t begin(std::size_t first, Work& own) const;
    void takeIntervals(std::uint32_t number, const Medium& rules, Work& own) const;
    void takeSamples(std::uint32_t way, const Medium& rules, double start, double length, Work& own) const;
    void findSamples(std::size_t first, TileScratch& work, Work& own) const;
    void scatter(TileScratch& work, Work& own) const;
    void takeLit(const LightSource& light, Work& own) const;
    void halve(std::size_t first, std::size_t end, Work& own) const;
    static void join(Work& own);
    void addUp(std::size_t first, std::size_t end, Work& own) const;

    const Scene& scene_;
    Concerned concerned_;
    std::shared_ptr<const LightFilters> filters_;
    std::vector<const LightSource*> beams_;  ///< of all lights that media scatter, if they all have one
};

}  // namespace isoscope
