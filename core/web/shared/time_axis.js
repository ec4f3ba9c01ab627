// A time axis: which part of the time it shows, and its ticks.

import {clamp} from './text.js';

const steps = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400, 43200, 86400];

/**
 * Seconds from tick to tick.
 * @param {number} lasts what the axis shows, in seconds
 * @param {number} most ticks that there is space for
 */
export const tickStep = (lasts, most) => steps.find(seconds => lasts / seconds <= most) ?? 86400 * Math.ceil(lasts / 864000);

/**
 * The seconds at which there are ticks. The last 2 % are left out: a label has no space there.
 * @param {number} from what the axis shows, in seconds
 * @param {number} lasts
 * @param {number} most ticks that there is space for
 * @param {number} begin what the clock shows at second 0; ticks are at whole steps of the clock
 */
export function ticksOf(from, lasts, most, begin) {
    const step = tickStep(lasts, most);
    const zero = begin % step;
    const ticks = [];
    for (let seconds = Math.ceil((from + zero) / step) * step - zero; seconds <= from + lasts * 0.98; seconds += step) ticks.push(seconds);
    return ticks;
}

/**
 * The part of a time span that an axis shows after it moves or zooms, within the whole span.
 * @param {{from: number, lasts: number}} part
 * @param {{from: number, lasts: number}} whole
 */
export function within(part, whole) {
    return {from: clamp(part.from, whole.from, whole.from + whole.lasts - part.lasts), lasts: part.lasts};
}

/**
 * Zooms an axis about a point of it; 2 seconds are the least that it shows.
 * @param {{from: number, lasts: number}} part that is shown
 * @param {{from: number, lasts: number}} whole
 * @param {number} factor above 1 shows more
 * @param {number} share the point that stays in place, as a share of the axis
 */
export function zoomed(part, whole, factor, share) {
    const lasts = clamp(part.lasts * factor, Math.min(whole.lasts, 2), whole.lasts);
    return within({from: part.from + share * (part.lasts - lasts), lasts}, whole);
}
