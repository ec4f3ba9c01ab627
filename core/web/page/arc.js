// Where moments and places of the clip are in the picture. The program gives cross-sections of the volume; between them it
// is straight.

import {clamp} from '../shared/text.js';

/** @typedef {number[]} Section seconds; x and y of the corners: upper left, upper right, lower right, lower left */

/**
 * The cross-section at a time; null = the picture has no volume.
 * @param {Section[]} sections in order of time
 * @param {number} seconds
 * @returns {number[] | null} x and y of the four corners
 */
export function sectionAt(sections, seconds) {
    if (!sections.length) return null;
    let after = sections.findIndex(section => section[0] >= seconds);
    if (after < 0) after = sections.length - 1;
    const [end, ...to] = sections[after];
    const [begin, ...from] = sections[Math.max(0, after - 1)];
    const share = end > begin ? clamp((seconds - begin) / (end - begin), 0, 1) : 1;
    return to.map((value, k) => from[k] + share * (value - from[k]));
}

/**
 * A place of the frame in its cross-section, by the perspective of its four corners.
 * @param {number[]} corners
 * @param {number} u share of the frame's width
 * @param {number} v share of its height
 * @returns {[number, number]}
 */
export function pointIn([x0, y0, x1, y1, x2, y2, x3, y3], u, v) {
    const [sumX, sumY] = [x0 - x1 + x2 - x3, y0 - y1 + y2 - y3];
    const [dx1, dx2, dy1, dy2] = [x1 - x2, x3 - x2, y1 - y2, y3 - y2];
    const whole = dx1 * dy2 - dx2 * dy1;
    const g = whole ? (sumX * dy2 - dx2 * sumY) / whole : 0;
    const h = whole ? (dx1 * sumY - sumX * dy1) / whole : 0;
    const depth = g * u + h * v + 1;
    return [((x1 - x0 + g * x1) * u + (x3 - x0 + h * x3) * v + x0) / depth,
            ((y1 - y0 + g * y1) * u + (y3 - y0 + h * y3) * v + y0) / depth];
}

/**
 * An event's path in the picture. Between two places it goes through each cross-section, as the picture is straight only
 * from one of these to the next.
 * @param {Section[]} sections
 * @param {{path: number[][]}} event
 * @param {import('./timeline.js').Timeline} time
 * @returns {[number, number][]}
 */
export function trailOf(sections, event, time) {
    /** @type {[number, number][]} */
    const points = [];
    const add = (/** @type {number} */ seconds, /** @type {number} */ x, /** @type {number} */ y) => {
        const corners = sectionAt(sections, seconds);
        if (corners) points.push(pointIn(corners, x, y));
    };
    /** @type {number[] | null} */
    let before = null;
    for (const [frame, x, y] of event.path) {
        const seconds = time.secondsOf(frame);
        if (before) {
            const [begin, fromX, fromY] = before;
            for (const [between] of sections.filter(([at]) => at > begin && at < seconds)) {
                const share = (between - begin) / (seconds - begin);
                add(between, fromX + share * (x - fromX), fromY + share * (y - fromY));
            }
        }
        add(seconds, x, y);
        before = [seconds, x, y];
    }
    return points;
}

/** @typedef {{left: number, top: number, right: number, bottom: number}} Box */

/** @type {(a: Box, b: Box) => boolean} */
export const overlap = (a, b) => a.right > b.left && b.right > a.left && a.bottom > b.top && b.bottom > a.top;

/**
 * Which of its boxes each takes: the first that overlaps none that was taken before; -1 = none.
 * @param {Box[][]} choices of the most important first
 * @returns {number[]}
 */
export function roomFor(choices) {
    /** @type {Box[]} */
    const taken = [];
    return choices.map(boxes => {
        const free = boxes.findIndex(box => !taken.some(other => overlap(box, other)));
        if (free >= 0) taken.push(boxes[free]);
        return free;
    });
}

/**
 * The box around all cross-sections: left, top, right, bottom.
 * @param {Section[]} sections
 */
export function boundsOf(sections) {
    const [xs, ys] = [1, 2].map(first => sections.flatMap(section => section.filter((_, k) => k > 0 && (k - first) % 2 === 0)));
    return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}
