// Shapes that are searched for: a rectangle or a line.

/**
 * @typedef {number[]} Point x and y
 * @typedef {number[]} Sides left, top, right, bottom
 * @typedef {{kind: 'box' | 'line', from: Point, to: Point}} Shape
 */

/** @type {(shape: {from: Point, to: Point}) => Sides} */
export const sidesOf = ({from, to}) => [Math.min(from[0], to[0]), Math.min(from[1], to[1]), Math.max(from[0], to[0]), Math.max(from[1], to[1])];

/** @type {(a: Sides, b: Sides) => boolean} */
export const meets = (a, b) => a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3];

/**
 * The part of the stretch from (x, y) to (toX, toY) that lies in a rectangle, as shares of the stretch; null = none.
 * @param {number} x
 * @param {number} y
 * @param {number} toX
 * @param {number} toY
 * @param {Sides} sides
 * @returns {[number, number] | null}
 */
export function partInBox(x, y, toX, toY, [left, top, right, bottom]) {
    let [begin, end] = [0, 1];
    for (const [from, by, low, high] of [[x, toX - x, left, right], [y, toY - y, top, bottom]]) {
        if (by === 0) {
            if (from < low || from > high) return null;
            continue;
        }
        const [a, b] = by > 0 ? [(low - from) / by, (high - from) / by] : [(high - from) / by, (low - from) / by];
        begin = Math.max(begin, a);
        end = Math.min(end, b);
    }
    return begin <= end ? [begin, end] : null;
}

/**
 * The shape in another unit.
 * @param {Shape} shape
 * @param {number} by
 * @returns {Shape}
 */
export const scaled = ({kind, from, to}, by) => ({kind, from: from.map(value => value * by), to: to.map(value => value * by)});
