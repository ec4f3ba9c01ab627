// Ways of objects, [time, x, y, time, x, y, ...]: tenths of a second, thousandths of the picture's width and height.
// Page and index have the same ways, and ask them here, so that they give the same answers.

import {partInBox} from './shapes.js';

/**
 * @typedef {import('./shapes.js').Point} Point
 * @typedef {import('./shapes.js').Sides} Sides
 * @typedef {{at: number, side: number}} Crossing tenths of a second, and the side to which it goes, 1 or -1; 0 = it only
 *     touched the line
 */

/**
 * On which side of the line from (ax, ay) to (bx, by) a point is: the sign says it; 0 = on the line.
 * @type {(a: Point, b: Point, x: number, y: number) => number}
 */
const sideOf = ([ax, ay], [bx, by], x, y) => Math.sign((bx - ax) * (y - ay) - (by - ay) * (x - ax));

/**
 * Where the way from one point to the next meets the line through a and b, as a share of the way.
 * @type {(a: Point, b: Point, x: number, y: number, toX: number, toY: number) => number}
 */
function shareAt([ax, ay], [bx, by], x, y, toX, toY) {
    const before = (bx - ax) * (y - ay) - (by - ay) * (x - ax);
    const after = (bx - ax) * (toY - ay) - (by - ay) * (toX - ax);
    return before / (before - after);
}

/**
 * Each time that a way goes across the line from a to b, in order, with the time at which it leaves the line. An object
 * that comes to the line, stands on it and goes back did not cross it, nor did one that was on it at first, or is on it at
 * last.
 * @param {number[]} way
 * @param {Point} a
 * @param {Point} b
 * @returns {Crossing[]}
 */
export function crossingsOf(way, a, b) {
    const crossings = [];
    let from = 0;  // the side on which it was last
    for (let k = 0; k < way.length; k += 3) {
        const [time, x, y] = [way[k], way[k + 1], way[k + 2]];
        const side = sideOf(a, b, x, y);
        if (side === 0) continue;
        if (from !== 0 && side !== from) {
            const [before, lastX, lastY] = [way[k - 3], way[k - 2], way[k - 1]];
            const ends = [a, b].map(end => sideOf([lastX, lastY], [x, y], end[0], end[1]));
            if (ends[0] * ends[1] <= 0) {
                crossings.push({at: Math.round(before + shareAt(a, b, lastX, lastY, x, y) * (time - before)), side});
            }
        }
        from = side;
    }
    return crossings;
}

const touch = 10;  // tenths of a second

/**
 * What a way has to do with the line from a to b: each crossing, but one that is taken back within a second is a touch of the
 * line, as the path of an object's centre trembles by as much.
 * @param {number[]} way
 * @param {Point} a
 * @param {Point} b
 */
export function meetingsOf(way, a, b) {
    /** @type {Crossing[]} */
    const meetings = [];
    for (const crossing of crossingsOf(way, a, b)) {
        const before = meetings[meetings.length - 1];
        if (before?.side === -crossing.side && crossing.at - before.at <= touch) before.side = 0;
        else meetings.push(crossing);
    }
    return meetings;
}

/**
 * When a way is within a rectangle, from and to, in tenths of a second, in order.
 * @param {number[]} way
 * @param {Sides} box
 */
export function staysOf(way, box) {
    /** @type {[from: number, to: number][]} */
    const stays = [];
    for (let k = 0; k < way.length; k += 3) {
        const next = Math.min(k + 3, way.length - 3);
        const part = partInBox(way[k + 1], way[k + 2], way[next + 1], way[next + 2], box);
        if (!part) continue;
        const [from, to] = part.map(share => way[k] + share * (way[next] - way[k]));
        const before = stays[stays.length - 1];
        if (before?.[1] === from) before[1] = to;
        else stays.push([from, to]);
    }
    return stays;
}

/**
 * How long a way is within a rectangle, and when first, both in tenths of a second; null = never.
 * @param {number[]} way
 * @param {Sides} box
 */
export function stayOf(way, box) {
    const stays = staysOf(way, box);
    return stays.length ? {at: Math.round(stays[0][0]), lasts: stays.reduce((sum, [from, to]) => sum + to - from, 0)} : null;
}

/**
 * A stay in words: "here 8.4 s", or that it was too short to be one.
 * @param {{lasts: number}} stay
 * @param {(seconds: number) => string} words of a duration
 */
export const stayWords = ({lasts}, words) => lasts < 0.5 ? 'came past here' : `here ${words(lasts / 10)}`;

/**
 * What a search says of a thing of the scene, which is not there while its event lasts: "missing from 0:40".
 * @param {string} time at which the event begins
 */
export const missingWords = time => 'missing from ' + time;

/**
 * Where a way is at a time, in thousandths; before and after it, at its ends.
 * @param {number[]} way
 * @param {number} tenths of a second
 */
export function pointOnWay(way, tenths) {
    let k = 0;
    while (k + 3 < way.length && way[k + 3] <= tenths) k += 3;
    const next = Math.min(k + 3, way.length - 3);
    const share = way[next] > way[k] ? Math.min(1, Math.max(0, (tenths - way[k]) / (way[next] - way[k]))) : 0;
    return [way[k + 1] + share * (way[next + 1] - way[k + 1]), way[k + 2] + share * (way[next + 2] - way[k + 2])];
}

/**
 * The box about a way: most ways are nowhere near the place that is asked for.
 * @param {number[]} way
 * @returns {Sides}
 */
export function boundsOf(way) {
    const bounds = [Infinity, Infinity, -Infinity, -Infinity];
    for (let k = 0; k + 2 < way.length; k += 3) {
        bounds[0] = Math.min(bounds[0], way[k + 1]);
        bounds[1] = Math.min(bounds[1], way[k + 2]);
        bounds[2] = Math.max(bounds[2], way[k + 1]);
        bounds[3] = Math.max(bounds[3], way[k + 2]);
    }
    return bounds;
}

/**
 * An arrow for the way across a line, as it is seen, y downwards: the line's normal on the side to which it went.
 * @param {{from: Point, to: Point}} line
 * @param {number} side
 * @param {number[]} size of the picture in pixels, of which the places are shares or other parts
 */
export function arrowAcross({from, to}, side, [width, height]) {
    const [x, y] = [-(to[1] - from[1]) * height * side, (to[0] - from[0]) * width * side];
    return '→↘↓↙←↖↑↗'[(Math.round(Math.atan2(y, x) / (Math.PI / 4)) + 8) % 8];
}

const mostCrossings = 4;  // that are told one by one

/**
 * "crossed ← 0:06, → 0:10"; if it never did, "touched 0:06".
 * @param {Crossing[]} meetings
 * @param {{from: Point, to: Point}} line
 * @param {number[]} size of the picture in pixels
 * @param {(seconds: number) => string} clock
 */
export function crossingWords(meetings, line, size, clock) {
    const crossings = meetings.filter(({side}) => side !== 0);
    if (!crossings.length) return 'touched ' + clock(meetings[0].at / 10);
    const told = crossings.slice(0, mostCrossings).map(({at, side}) => `${arrowAcross(line, side, size)} ${clock(at / 10)}`).join(', ');
    const more = crossings.length - mostCrossings;
    if (more <= 0) return 'crossed ' + told;
    const both = [1, -1].map(side => ({arrow: arrowAcross(line, side, size), count: crossings.filter(crossing => crossing.side === side).length}))
        .filter(({count}) => count > 0).map(({arrow, count}) => `${arrow} ${count}`).join(', ');
    return `crossed ${crossings.length} times (${both}): ${told}, and ${more} more`;
}
