// The picture: its pixels are read, and those of other events and moments are veiled.

import {at} from '../shared/dom.js';
import {asksForSome, wantedEvents} from './filters.js';
import {contentsOf, numbersIn, othersThan} from './pixels.js';
import {bytesOf} from './base64.js';
import {pictureSize, set, state} from './state.js';

export const picture = at('picture', HTMLImageElement);
const [width, height] = pictureSize;

/** @param {HTMLCanvasElement} canvas */
function contextOf(canvas) {
    const context = canvas.getContext('2d', {willReadFrequently: true});
    if (!context) throw new Error('this browser draws nothing');
    return context;
}

/**
 * The pixels of the upper left corner of an image.
 * @param {CanvasImageSource} image
 * @param {number} wide
 * @param {number} high
 */
function bytesOfImage(image, wide, high) {
    const context = contextOf(Object.assign(document.createElement('canvas'), {width: wide, height: high}));
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, wide, high).data;
}

/** @param {import('./data.js').PixelData} source */
async function readNumbers(source) {
    const png = new Blob([bytesOf(source.src.split(',')[1])], {type: 'image/png'});
    const image = await createImageBitmap(png, {premultiplyAlpha: 'none', colorSpaceConversion: 'none'});
    return numbersIn(bytesOfImage(image, width, height), source.sum);
}

/**
 * What an image is like: the colour behind everything, which is that of the corner, or the page's own; and where its contents are.
 * @param {HTMLImageElement} image that is decoded
 * @param {import('./data.js').Overlay} overlay
 */
export function readLooks(image, overlay) {
    const bytes = bytesOfImage(image, width, height);
    const [red, green, blue, alpha] = bytes;
    return {ground: alpha > 0 ? [red, green, blue] : null, contents: joined(contentsOf(new Uint32Array(bytes.buffer), width, height), overlay)};
}

/**
 * @param {import('./data.js').Parts} parts
 * @returns {Promise<import('./pixels.js').Pixels | null>} null = they have not come
 */
export async function readPixels({pixels, objects}) {
    if (!pixels) return null;
    const frames = (await readNumbers(pixels)).map(value => value < 0 ? -1 : value + pixels.first);
    return {width, height, frames, objects: objects ? await readNumbers(objects) : null};
}

export async function readPicture() {
    const {data, parts} = state;
    await picture.decode();
    set(readLooks(picture, data.overlay));
    const pixels = await readPixels(parts);
    if (data === state.data && pixels) set({pixels});
}

/**
 * The part of the picture that has anything, with what lies over it.
 * @param {number[]} contents
 * @param {import('./data.js').Overlay} overlay
 */
function joined([left, top, right, bottom], {portraits, captions, map, notes}) {
    const boxes = [...portraits.map(({box}) => [box[0], box[1] - captions, box[2], box[3]]), ...map ? [map.box] : [],
                   ...notes.map(({at: [x, y]}) => [x - 40, y - 16, x + 40, y + 16])];
    for (const box of boxes) {
        [left, top] = [Math.min(left, box[0] - 8), Math.min(top, box[1] - 4)];
        [right, bottom] = [Math.max(right, box[2] + 8), Math.max(bottom, box[3] + 8)];
    }
    return [Math.max(0, left), Math.max(0, top), Math.min(width, right), Math.min(height, bottom)];
}

const veil = contextOf(at('veil', HTMLCanvasElement));
const veilPixels = veil.createImageData(width, height);
export const veilWords = new Uint32Array(veilPixels.data.buffer);

/** @type {(red: number, green: number, blue: number, alpha: number) => number} */
const colour = (red, green, blue, alpha) => new Uint32Array(new Uint8Array([red, green, blue, alpha]).buffer)[0];
/** The colour behind the picture. */
const groundOf = () => state.ground ?? (state.dark ? [30, 34, 39] : [255, 255, 255]);

export const paleOf = ([red, green, blue] = groundOf()) => colour(red, green, blue, 215);

export function drawGround() {
    const [red, green, blue] = state.ground ?? [0, 0, 0];
    at('view').classList.toggle('clear', state.ground === null);
    at('view').classList.toggle('light', state.ground !== null && red + green + blue > 3 * 128);
    at('view').style.backgroundColor = state.ground ? `rgb(${state.ground})` : '';
}

/**
 * The events that are lit; null = all, and what is of no event.
 * @param {number | null} [lightened] the one that the pointer is on
 */
export function litEvents(lightened = state.lightened) {
    const one = lightened ?? state.chosen;
    if (one !== null) return [one];
    return asksForSome() ? wantedEvents() : null;
}

/** Pales what is not of the chosen event or the place that is asked for, lines and shadows too. */
export function drawVeil() {
    const {pixels, events} = state;
    if (!pixels) return veil.clearRect(0, 0, width, height);
    const lit = litEvents();
    const isOther = othersThan(pixels, lit, events);
    const pale = paleOf();
    const [red, green, blue] = groundOf();
    const paleLine = lit === null ? 0 : colour(red, green, blue, 110);
    const {frames} = pixels;
    for (let k = 0; k < frames.length; ++k) veilWords[k] = frames[k] < 0 ? paleLine : isOther(k) ? pale : 0;
    veil.putImageData(veilPixels, 0, 0);
}
