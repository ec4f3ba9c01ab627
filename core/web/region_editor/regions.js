// Regions of a picture: polygons, as the options --roi and --mask have them. A box keeps its right angles.

import {clamp} from '../shared/text.js';

/**
 * @typedef {number[]} Corner x and y, pixels of the clip
 * @typedef {{box: boolean, corners: Corner[]}} Region
 */

/** @type {(list: Region[]) => Region[]} */
export const copyOf = list => list.map(region => ({box: region.box, corners: region.corners.map(corner => [...corner])}));

/**
 * The corners of a rectangle, from two that are opposite.
 * @type {(a: Corner, b: Corner) => Corner[]}
 */
export const boxOf = ([ax, ay], [bx, by]) => {
    const [left, right] = [Math.min(ax, bx), Math.max(ax, bx)];
    const [top, bottom] = [Math.min(ay, by), Math.max(ay, by)];
    return [[left, top], [right, top], [right, bottom], [left, bottom]];
};

/** @param {Corner[]} corners */
export function isBox(corners) {
    if (corners.length !== 4) return false;
    const [a, b, c, d] = corners;
    return (a[1] === b[1] && b[0] === c[0] && c[1] === d[1] && d[0] === a[0]) || (a[0] === b[0] && b[1] === c[1] && c[0] === d[0] && d[1] === a[1]);
}

/**
 * Parses the value of an option. Parts that are not polygons are left out.
 * @param {string} text
 * @returns {Region[]}
 */
export function parse(text) {
    return text.split(';').map(part => part.trim().split(/ +/).map(point => point.split(',').map(Number)))
        .filter(corners => corners.length > 2 && corners.every(point => point.length === 2 && point.every(Number.isFinite)))
        .map(corners => ({box: isBox(corners), corners}));
}

/** @type {(corners: Corner[]) => string} */
export const textOf = corners => corners.map(corner => corner.join(',')).join(' ');

/**
 * The option for the command line; empty without regions.
 * @param {string} name
 * @param {Region[]} regions
 */
export const optionText = (name, regions) => regions.length ? `--${name} "${regions.map(region => textOf(region.corners)).join('; ')}"` : '';

/**
 * Left, top, right, bottom.
 * @param {Corner[]} corners
 */
export function boundsOf(corners) {
    const xs = corners.map(corner => corner[0]);
    const ys = corners.map(corner => corner[1]);
    return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

/** @param {Region} region */
export function nameOf(region) {
    const [left, top, right, bottom] = boundsOf(region.corners);
    const where = `${right - left}×${bottom - top} at ${left},${top}`;
    return region.box ? where : `${region.corners.length} corners, ${where}`;
}

/**
 * The corners, moved as far as the picture goes.
 * @param {Corner[]} corners
 * @param {Corner} by
 * @param {number[]} size of the picture
 */
export function moved(corners, by, size) {
    const [left, top, right, bottom] = boundsOf(corners);
    const x = clamp(by[0], Math.min(0, -left), Math.max(0, size[0] - right));
    const y = clamp(by[1], Math.min(0, -top), Math.max(0, size[1] - bottom));
    return corners.map(corner => [corner[0] + x, corner[1] + y]);
}

/**
 * The corners after one has moved. In a box, the two beside it follow.
 * @param {Region} region
 * @param {number} place
 * @param {Corner} to
 */
export function withCorner({box, corners}, place, [x, y]) {
    if (!box) return corners.map((corner, k) => k === place ? [x, y] : corner);
    const [oldX, oldY] = corners[place];
    const opposite = (place + 2) % 4;
    return corners.map((corner, k) => k === place ? [x, y]
        : [corner[0] === oldX && k !== opposite ? x : corner[0], corner[1] === oldY && k !== opposite ? y : corner[1]]);
}

/**
 * The corners with one more, in the middle of the longest side.
 * @param {Corner[]} corners
 */
export function withMoreCorners(corners) {
    const after = (/** @type {number} */ k) => corners[(k + 1) % corners.length];
    const length = (/** @type {number} */ k) => Math.hypot(after(k)[0] - corners[k][0], after(k)[1] - corners[k][1]);
    const longest = corners.reduce((best, _, k) => length(k) > length(best) ? k : best, 0);
    const middle = corners[longest].map((value, axis) => Math.round((value + after(longest)[axis]) / 2));
    return [...corners.slice(0, longest + 1), middle, ...corners.slice(longest + 1)];
}
