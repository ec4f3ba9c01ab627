// Which of a clip's events its card shows: the place of the pointer, a key or a swipe says it; and which of its pictures.

import {clamp} from '../shared/text.js';
import {nearestStill} from './sheet.js';

/** @typedef {import('./answers.js').SceneEvent} SceneEvent */

const shortestSwipe = 30;  // pixels: a shorter move is a tap
const tolerance = 0.5;  // seconds by which a picture may be beside an event that it still shows

/**
 * When an event begins and ends, in seconds of its clip.
 * @param {SceneEvent} event
 */
export const spanOf = event => [event.way[0] / 10, event.way[event.way.length - 3] / 10];

/**
 * The place of the event under the pointer: each has as much of the card's width.
 * @param {number} share of the card's width
 * @param {number} count of events
 */
export const placeUnder = (share, count) => clamp(Math.floor(share * count), 0, Math.max(0, count - 1));

/**
 * By how many events a key turns.
 * @param {{key: string, altKey?: boolean, ctrlKey?: boolean, metaKey?: boolean}} event
 */
export const turnOfKey = ({key, altKey, ctrlKey, metaKey}) =>
    altKey || ctrlKey || metaKey ? 0 : key === 'ArrowLeft' ? -1 : key === 'ArrowRight' ? 1 : 0;

/**
 * By how many events a swipe turns: the pictures go with the finger.
 * @param {number} by pixels to the right
 */
export const turnOfSwipe = by => Math.abs(by) > shortestSwipe ? -Math.sign(by) : 0;

/**
 * The mark that stands for an event; of very many events each mark stands for some.
 * @param {number} place of the event
 * @param {number} count of events
 * @param {number} marks
 */
export const markOf = (place, count, marks) => count <= marks ? place : Math.floor(place * marks / count);

/**
 * The picture of an event, in its middle if possible, and the second at which it shows it; null = it is of another moment.
 * @param {SceneEvent} event
 * @param {number[]} stills seconds of the clip's pictures, in order
 * @param {number} [wanted] the place of a picture
 */
export function pictureOfEvent(event, stills, wanted) {
    const [from, to] = spanOf(event);
    const still = wanted ?? nearestStill(stills, (from + to) / 2, from, to);
    const isIn = stills[still] >= from - tolerance && stills[still] <= to + tolerance;
    return {still, at: isIn ? clamp(stills[still], from, to) : null};
}
