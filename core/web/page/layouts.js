// The layouts of the volume: where the places of C-space are in P-space, as core/space/ has it (docs/design.md, Coordinates).

/**
 * @typedef {number[]} Point x, y and t in C-space, or x, y and z in P-space
 * @typedef {[rMin: number, rMax: number, height: number]} Shape in P-space units
 * @typedef {'horseshoe' | 'box'} LayoutName
 */

/** @param {Shape} shape */
const lengthOfBox = ([rMin, rMax]) => Math.PI * (rMin + rMax) / 2;

/**
 * The map, and the values of its shader's uniforms.
 * @type {Record<LayoutName, {pOf: (shape: Shape, c: Point) => Point, uniforms: (shape: Shape) => Record<string, number>}>}
 */
export const layouts = {
    horseshoe: {
        pOf([rMin, rMax, height], [x, y, t]) {
            const r = rMin + (rMax - rMin) * x;
            return [-r * Math.cos(Math.PI * t), height * y, r * Math.sin(Math.PI * t)];
        },
        uniforms: ([rMin, rMax, height]) => ({layout_r_min: rMin, layout_depth: rMax - rMin, layout_height: height}),
    },
    box: {
        pOf: (shape, [x, y, t]) => [lengthOfBox(shape) * (t - 0.5), shape[2] * y, (shape[1] - shape[0]) * x],
        uniforms: shape => ({layout_depth: shape[1] - shape[0], layout_height: shape[2], layout_length: lengthOfBox(shape)}),
    },
};

/** @typedef {(c: Point) => Point} Map from C-space to P-space */

/**
 * @param {number} count
 * @param {(share: number) => Point[]} pointsAt
 */
const along = (count, pointsAt) => Array.from({length: count + 1}, (_, k) => pointsAt(k / count)).flat();

/** The corners of a frame: upper left, upper right, lower right, lower left. */
export const corners = [[1, 1], [0, 1], [0, 0], [1, 0]];

/**
 * Points of the volume's edges, which a camera has to show.
 * @param {Map} pOf
 */
export const outlinePoints = pOf => along(64, t => corners.map(([x, y]) => pOf([x, y, t])));

/** Length of a mark of the ruler, in x of C-space. */
const markLength = 0.045;

/**
 * The ends of a mark on an edge along time.
 * @param {number[]} edge x and y, 0 or 1 each
 * @param {number} t
 * @returns {Point[]}
 */
export const markAt = ([x, y], t) => [[x, y, t], [x + (x > 0.5 ? markLength : -markLength), y, t]];

/**
 * The outer ends of the marks.
 * @param {Map} pOf
 * @param {number[]} edge
 */
export const rulerReach = (pOf, edge) => along(64, t => [pOf(markAt(edge, t)[1])]);

/**
 * The outermost edge in the picture, where texts hide nothing.
 * @param {Map} pOf
 * @param {(p: Point) => number[]} pixelOf
 * @param {number[]} size of the picture
 */
export function outerEdge(pOf, pixelOf, [width, height]) {
    let best = [1, 1];
    let farthest = -1;
    for (const edge of [[1, 1], [0, 1], [1, 0], [0, 0]]) {
        const sum = along(32, t => [pixelOf(pOf([...edge, t]))])
            .reduce((before, [x, y]) => before + Math.hypot(x - width / 2, y - height / 2), 0);
        if (sum <= farthest * 1.001) continue;  // ties go to the earlier edge
        [farthest, best] = [sum, edge];
    }
    return best;
}

/**
 * The volume's edges and its cuts at some times, as lines in C-space.
 * @param {number[]} cuts t of each
 * @returns {Point[][]} from and to of each line
 */
export function edgeLines(cuts) {
    const steps = 96;
    const lines = corners.flatMap(([x, y]) => Array.from({length: steps}, (_, k) => [[x, y, k / steps], [x, y, (k + 1) / steps]]));
    return [...lines, ...cuts.flatMap(t => corners.map(([x, y], k) => [[x, y, t], [...corners[(k + 1) % 4], t]]))];
}
