// Where the picture lies in its view.

import {clamp} from '../shared/text.js';

/**
 * @typedef {object} View
 * @property {number[]} size of the picture, pixels
 * @property {number[]} room width and height of the view
 * @property {number[]} contents the part of the picture that is not empty: left, top, right, bottom
 * @property {number} scale 1 = all contents fit
 * @property {number[]} middle the point of the picture that is in the middle of the view, in shares of the picture
 */

/**
 * The size of the picture in the view, its upper left corner, and the middle, moved so that no border comes into the view.
 * @param {View} view
 */
export function placed({size: [width, height], room, contents: [left, top, right, bottom], scale, middle}) {
    const fit = Math.min(room[0] / (right - left), room[1] / (bottom - top));
    const size = [width * fit * scale, height * fit * scale];
    const ends = [[left / width, right / width], [top / height, bottom / height]];
    const inside = [0, 1].map(k => {
        const half = room[k] / 2 / size[k];
        const [low, high] = ends[k];
        // Contents that are smaller than the view stand in its middle.
        return 2 * half >= high - low ? (low + high) / 2 : clamp(middle[k], low + half, high - half);
    });
    return {size, middle: inside, corner: [0, 1].map(k => room[k] / 2 - inside[k] * size[k])};
}

/**
 * Zooms so that a point of the picture stays in its place.
 * @param {{scale: number, middle: number[]}} view
 * @param {number} factor
 * @param {number[]} point in shares of the picture
 */
export function zoomedAbout({scale, middle}, factor, point) {
    const wanted = clamp(scale * factor, 1, 16);
    return {scale: wanted, middle: middle.map((value, k) => point[k] + (value - point[k]) * scale / wanted)};
}

/**
 * Whether the wheel zooms: in a window of few lines, as of a page that is magnified, it scrolls unless Ctrl is held.
 * @param {WheelEvent} event
 */
export const wheelZooms = event => event.ctrlKey || !matchMedia('(max-height: 520px)').matches;
