#pragma once

#include <cstddef>
#include <cstdint>

namespace vvr::fields {

/// The numbers by which fields are tuned. A comment names the unit first, then one reason. Lengths are field pixels,
/// levels are grey levels, times are seconds of the clip, a share is from 0 to 1. The source is in brackets: a paper;
/// [OpenCV] its default; [masks] docs/fields.md measures the masks with it. One without a source was set by hand, and
/// nobody has measured it alone.
struct Thresholds {
    int sampling = 3;  ///< pixels between samples of a picture's levels or colours: a sparse sample is enough

    /// What differs from the empty scene.
    struct {
        int usual = 24;      ///< levels; the upper threshold, unless another is asked for [masks]
        int gain = 2;        ///< field values per level
        double weak = 0.85;  ///< share of it, the lower threshold: clothes rarely differ equally everywhere [masks]
        double strong_noise = 5;    ///< median noises at the usual threshold, to which the upper one rises … [masks]
        double weak_noise = 3;      ///< … and the lower one [masks]
        double most_strong = 60;    ///< levels at the usual threshold, to which noise may raise the upper one …
        double most_weak = 36;      ///< … and the lower one
        double hole = 0.25;         ///< share of the threshold; an enclosed hole that differs less is scene [masks]
        int head = 800;             ///< picture's area / 800: the largest hole, a head in a usual picture
        int small = 4;              ///< minimum areas; smaller objects are mostly rim, which looks like shadow [masks]
        int half_car = 18;          ///< picture's longer side / 18: half a car in a usual picture [masks]
        double most_changed = 0.4;  ///< share of the picture; what stays and is larger is another scene, not an object
        double some_changed = 0.1;  ///< share that suffices where colours come or go; with less, the scene is as before
        double learning = 10;       ///< seconds in which another scene is learnt …
        double step = 0.4;          ///< … from frames that are at least so many seconds apart
    } object;

    /// A shadow is darker, but keeps its colour (after Horprasert, Harwood and Davis, ICCV 1999). A tint is the
    /// difference between the channels' ratios to the empty scene.
    struct {
        float darkest = 0.45F;        ///< share of the light that the sky leaves; dark clothes keep less [masks]
        float tint = 0.07F;           ///< tint of the pixels around one, at most [masks]
        float tint_of_pixel = 0.06F;  ///< tint of a single pixel, which proves less [masks]
        float most_tint = 0.3F;       ///< tint of a pixel from which on it is none, whatever is around it [masks]
        float sky = 0.1F;             ///< tint per missing share of light, as the sky is bluer than the sun [masks]
    } shadow;

    /// Whether a picture has colours.
    struct {
        int least_tint = 6;          ///< levels; compression tints grey by up to 2, scenes of little colour have 12
        int most_tint_of_grey = 12;  ///< levels by which a camera may tint all of a grey picture
    } colour;

    /// Changes of the light.
    struct {
        int darkest = 3;             ///< levels; below, a camera clips …
        int brightest = 250;         ///< … and above
        int cut_off = 240;           ///< levels; smoothing mixes clipped pixels with others: those above may be clipped
        int levels_per_class = 8;    ///< levels whose change is taken as one
        int fewest = 20;             ///< pixels; a class of fewer is left out
        double least_distance = 12;  ///< levels between two classes whose change gives a slope (Theil 1950, Sen 1968)
        double least_gain = 0.4;     ///< ratio; a fit beyond it is taken as this
        double most_gain = 2.5;      ///< ratio, as above
        int block = 8;               ///< pixels; three blocks are compared at once, and a person seldom fills them
        float least_texture = 12;    ///< levels per pixel, times Sobel's weights; less may be noise
        float same_texture = 0.7F;   ///< correlation of gradients from which on a block shows the empty scene
        double least_explained = 0.6;  ///< share of the textured blocks that differ: with fewer, it is no light
        double reach = 2;              ///< blocks, σ: how far a block tells the light of others
        float jump = 3;                ///< levels by which most of the quantiles change where the light jumps
    } light;

    /// The frames of which the empty scene is made.
    struct {
        int frames = 31;          ///< frames; odd, so that the median is the middle value
        std::size_t fewest = 8;   ///< frames; a quarter of fewer is one, which tells neither what lasts nor the noise
        double step = 0.64;       ///< seconds between the first frames of a clip: passers-by are absent in most of 20 s
        double live = 2;          ///< seconds of a live stream, which can't wait
        double live_step = 0.08;  ///< seconds between its frames
        int level_tolerance = 18;   ///< levels by which a channel of an unchanged pixel may vary over a clip
        float least_contrast = 20;  ///< levels between the darkest and brightest twentieth, else the camera is covered
        std::size_t looks = 8;      ///< frames in which a detector looks for people, about
        std::size_t fewest_behind = 2;  ///< frames; what a single one shows behind them may be a shadow or a reflection
    } scene;

    /// The reference that follows the scene, and ghosts in it.
    struct {
        double slowness = 1.24;  ///< seconds, time constant: it adapts in about four seconds
        double first = 0.04;     ///< seconds that count as passed before the first frame
        int edge = 3;     ///< pixels around objects where it does not adapt: their soft edges are below the threshold
        int steady = 12;  ///< levels by which a stationary pixel may vary
        int ghost = 5;    ///< seconds without a change from which on it may be a ghost
        int check = 1;    ///< seconds between two searches for ghosts
        double edge_ratio = 2;  ///< ratio of its outline in the reference to that in the frame, at least
        double edge_step = 8;   ///< levels of its outline in the reference, at least
    } running;

    /// The noise of a pixel, from the frames with the smallest differences. A factor makes the largest of these a
    /// median: for Gaussian noise, 0.67 σ / 0.32 σ or 0.67 σ / 0.43 σ.
    struct {
        std::size_t frames = 10;  ///< frames spread over the clip, about
        double share = 0.25;      ///< share of the frames; at a counter, the scene may be empty in no more [masks]
        double to_median = 2.1;   ///< its factor
        double share_shaking = 1.0 / 3;   ///< share if the camera shakes: edges tremble, but not in each frame [masks]
        double to_median_shaking = 1.55;  ///< its factor
        double stable = 0.15;  ///< share of the frames that are empty even where an object lies most of the time
        int most_ratio = 4;    ///< ratio to the noise of these frames, at most: with more …
        int most_excess = 2;   ///< levels on top of it, at most: … it is the object
    } noise;

    /// A camera that shakes. Windows on four levels of a pyramid find shifts of up to about thirty pixels.
    struct {
        std::size_t frames = 7;    ///< frames that tell whether it shakes
        int points = 120;          ///< corners all over the picture, at most, so that no object covers most of them
        double quality = 0.01;     ///< share of the best corner's quality, at least [OpenCV's samples]
        int points_per_side = 24;  ///< corners along the longer side, at most
        int window = 15;           ///< pixels
        int top_level = 3;         ///< levels of the pyramid above the first [OpenCV]
        int steps = 12;            ///< steps of the search, at most
        double precision = 0.05;   ///< pixels of the last step: noise and compression allow about a tenth of one
        float tolerance = 0.75F;   ///< pixels; shifts that differ by less agree
        int fewest_agreeing = 8;   ///< corners that prove a shift …
        double agreeing = 0.25;    ///< … and share of those that were found again
        double visible = 0.5;      ///< pixels; from here on, edges appear in the difference
    } shake;

    /// Where something moves: the mean difference between two frames in a tile.
    struct {
        float least = 0.5F;        ///< levels: finds a motion of a tenth of a pixel in a clip without noise
        float most = 4;            ///< levels: still finds a person in the noisiest clip
        float above_noise = 1.6F;  ///< ratio to a quiet tile; noise alone stays below it over 64 pixels
        float excess = 0.25F;      ///< levels above that ratio
    } motion;

    /// Flow.
    struct {
        std::int64_t few_frames = 64;  ///< frames; a shorter clip has flow everywhere
        double most_parts = 0.7;  ///< share of the picture; larger parts cost more, with their margins, than all of it
        double barron_smooth = 1.5;   ///< pixels and frames, σ (Barron, Fleet and Beauchemin 1994)
        double pyramid_smooth = 0.8;  ///< pixels, σ before the derivatives of the pyramid
        int smallest_level = 24;      ///< pixels; smaller pictures show nothing that can be tracked
        float longest_step = 1;       ///< pixels; the linearized equations hold for about one, and errors accumulate
        int coarsest = 6;             ///< pixels; a grid of this size has no coarser one
        int smallest_dis = 48;        ///< pixels; it compares patches of 8×8 at a quarter of the size
        float levels_per_pixel = 24;  ///< levels per pixel per frame: 255 is more than CCTV shows at its field size
    } flow;

    /// OpenCV's adaptive background models.
    struct {
        int history = 500;              ///< frames [OpenCV]
        double variances = 16;          ///< σ² of MOG2's match [OpenCV]
        double squared_distance = 400;  ///< levels² of KNN's match [OpenCV]
    } background;
};

inline constexpr Thresholds thresholds{};

}  // namespace vvr::fields
