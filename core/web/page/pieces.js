// Which file shows a moment: of a recording, or of the pieces of its events that were kept.

/** @typedef {import('./data.js').Segment} Segment */

const slack = 0.02;  // seconds; less than a frame

/**
 * The file of a recording that shows a moment: the last that begins by then.
 * @param {Segment[]} files in order
 * @param {number} seconds
 */
export const fileAt = (files, seconds) => files.findLast(([, begin]) => begin <= seconds + 1e-6) ?? files[0];

/**
 * The piece that has a moment, or the next one; null = there is none from then on.
 * @param {Segment[]} pieces in order
 * @param {number} seconds
 */
export const pieceFrom = (pieces, seconds) => pieces.find(([, begin, length]) => seconds <= begin + length + slack) ?? null;

/**
 * Whether a piece has a moment.
 * @param {Segment[]} pieces in order
 * @param {number} seconds
 */
export const hasMoment = (pieces, seconds) => (pieceFrom(pieces, seconds)?.[1] ?? Infinity) <= seconds + slack;
