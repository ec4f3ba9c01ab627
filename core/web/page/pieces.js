// Which file shows a moment: of a recording, or of the pieces of its events that were kept.

import {upright} from '../shared/text.js';

/** @typedef {import('./data.js').Segment} Segment */

const little = 0.002;  // seconds; shorter than any frame, longer than the rounding of times

/** @type {(file: Segment, seconds: number) => boolean} */
const hasEnded = ([, begin, length], seconds) => seconds >= begin + length - little;

/**
 * The file that shows a moment: the first that has not ended by then. In a gap it is the next one, after the end the
 * last. The program does the same (core/footage/segments.h).
 * @param {Segment[]} files in order
 * @param {number} seconds
 */
export const fileAt = (files, seconds) => files.find(file => !hasEnded(file, seconds)) ?? files[files.length - 1];

/**
 * Whether a file has a moment.
 * @param {Segment[]} files in order
 * @param {number} seconds
 */
export const hasMoment = (files, seconds) => files.some(file => file[1] <= seconds + little && !hasEnded(file, seconds));

/**
 * The files of the clip, or its pieces if the clip is gone.
 * @param {import('./data.js').PageData} data
 * @param {boolean} [gone]
 * @returns {Segment[]}
 */
export function footageOf(data, gone = false) {
    if (gone) return data.pieces ?? [];
    if (data.segments?.length) return data.segments;
    return data.clip ? [[data.clip, 0, Infinity]] : [];
}

/**
 * The name of a file, without its folders.
 * @param {Segment} file
 */
export function nameOf([address]) {
    const name = address.slice(address.lastIndexOf('/') + 1);
    try {
        return upright(decodeURIComponent(name));
    } catch {
        return upright(name);
    }
}
