// The picture: its pixels are read, and those of other events and moments are veiled.

import {at} from '../shared/dom.js';
import {asksForSome, wantedEvents} from './filters.js';
import {contentsOf, footOf, numbersIn, othersThan} from './pixels.js';
import {bytesOf} from './player.js';
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

/** @returns {Promise<void>} */
export async function readPicture() {
    const {data} = state;
    await picture.decode();
    const bytes = bytesOfImage(picture, width, height);
    // The colour behind everything is that of the corner.
    const [red, green, blue, alpha] = bytes;
    set({ground: alpha > 0 ? [red, green, blue] : [255, 255, 255],
         contents: contentsOf(new Uint32Array(bytes.buffer), width, height)});
    const frames = (await readNumbers(data.pixels)).map(value => value < 0 ? -1 : value + data.pixels.first);
    const objects = data.objects ? await readNumbers(data.objects) : null;
    if (data === state.data) set({pixels: {width, height, frames, objects}});
}

const veil = contextOf(at('veil', HTMLCanvasElement));
const veilPixels = veil.createImageData(width, height);
export const veilWords = new Uint32Array(veilPixels.data.buffer);

/** @type {(red: number, green: number, blue: number, alpha: number) => number} */
const colour = (red, green, blue, alpha) => new Uint32Array(new Uint8Array([red, green, blue, alpha]).buffer)[0];
const glow = colour(217, 72, 15, 215);

export const paleOf = ([red, green, blue] = state.ground) => colour(red, green, blue, 205);

export function drawGround() {
    at('view').style.backgroundColor = `rgb(${state.ground})`;
}

/** The events that are lit; null = all, and what is of no event. */
function litEvents() {
    const one = state.lightened ?? state.chosen;
    if (one !== null) return [one];
    return asksForSome() ? wantedEvents() : null;
}

/** Pales what is not of the chosen event or the place that is asked for, and marks the moment that the player shows. */
export function drawVeil() {
    const {pixels, time, now, moved, events} = state;
    if (!pixels) return;
    const {frames} = pixels;
    const reach = Math.max(1, Math.round((time.lastFrame - time.firstFrame) * 0.003));
    const isOther = othersThan(pixels, litEvents(), events);
    const pale = paleOf();
    for (let k = 0; k < frames.length; ++k) {
        const frame = frames[k];
        if (frame < 0) veilWords[k] = 0;  // lines and text
        else if (moved && Math.abs(frame - now) <= reach && frame !== time.firstFrame && frame !== time.lastFrame) veilWords[k] = glow;
        else veilWords[k] = isOther(k) ? pale : 0;
    }
    veil.putImageData(veilPixels, 0, 0);
}

/** Says at the arc's ends which is which, if there are enough pixels of the first and the last frame; a picture with
 * regions of events says it itself. */
export function drawEnds() {
    const {pixels, time, data} = state;
    if (!pixels || data.regions.length) return;
    for (const {label, frame, words} of [{label: at('begins'), frame: time.firstFrame, words: 'begins ' + time.clockOf(time.begins, false)},
                                         {label: at('ends'), frame: time.lastFrame, words: 'ends ' + time.clockOf(time.ends, false)}]) {
        const foot = footOf(pixels, frame);
        label.hidden = !foot;
        label.textContent = words;
        if (!foot) continue;
        label.style.left = foot[0] * 100 + '%';
        label.style.top = foot[1] * 100 + '%';
    }
}
