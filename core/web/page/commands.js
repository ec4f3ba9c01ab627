// Commands for a shell that a page offers, and names of files.

import {sidesOf} from '../shared/shapes.js';
import {upright} from '../shared/text.js';
import {numberOf} from './events.js';

/**
 * @typedef {import('./data.js').PageData} PageData
 * @typedef {import('./timeline.js').Timeline} Timeline
 * @typedef {[path: string, begin: number, end: number]} File
 */

/**
 * Text as one word for a shell.
 * @param {string} text
 */
export const quoted = text => /^[\w./-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;

/**
 * The files that show frames, in order, with the seconds at which each begins and ends; null if there is none, or if a
 * name has control characters.
 * @param {PageData} data
 * @param {Timeline} time
 * @param {{first: number, last: number}} frames
 * @returns {File[] | null}
 */
export function filesOf(data, time, frames) {
    const [first, end] = [time.secondsOf(frames.first), time.endOf(frames)];
    const segments = data.segments ?? [];
    const files = segments.length ? segments.filter(([, begin, length]) => begin < end - 1e-6 && begin + length > first + 1e-6)
        : [/** @type {import('./data.js').Segment} */ ([data.clip ?? '', 0, Infinity])];
    try {
        const paths = files.map(([address, begin, length]) => /** @type {File} */ ([decodeURIComponent(address).replace(/^\.\/(?=\.\.\/)/, ''), begin, begin + length]));
        return paths.length && paths.every(([path]) => path !== '' && !/[\u0000-\u001f\u007f]/.test(path)) ? paths : null;
    } catch {
        return null;
    }
}

/**
 * The command that cuts an event out of the clip, or out of those files of a recording that show it; null = no file.
 * @param {PageData} data
 * @param {Timeline} time
 * @param {number} place of the event
 */
export function cutCommand(data, time, place) {
    const event = data.events?.[place];
    const files = event ? filesOf(data, time, event) : null;
    if (!event || !files) return null;
    const [path, begin] = files[0];
    const stem = path.slice(path.lastIndexOf('/') + 1).replace(/\.[^.]*$/, '').replace(/^-/, '_');
    const timeText = (/** @type {number} */ seconds) => (Math.max(seconds, begin) - begin).toFixed(3) + 's';
    const overlap = files.some(([, from], i) => i > 0 && from < files[i - 1][2] - 0.001);
    const output = `${stem}-event-${numberOf(data.events ?? [], place)}${overlap ? '.mp4' : data.cut.ending}`;
    return ['vvr cut', ...files.map(([file]) => quoted(file)), ...data.cut.names.map(names => `--names ${quoted(names)}`),
            `--start ${timeText(time.secondsOf(event.first))} --end ${timeText(Math.min(time.endOf(event), files[files.length - 1][2]))}`,
            overlap ? '--exact' : [], `-o ${quoted(output)}`].flat().join(' ');
}

/**
 * The name of a still: its camera, else its clip, and its time.
 * @param {PageData} data
 * @param {Timeline} time
 * @param {number} frame
 * @param {string} extension
 */
export function stillName(data, time, frame, extension) {
    const seconds = time.secondsOf(frame);
    const source = upright(data.camera ?? data.name).replace(/[^\p{L}\p{N}._-]+/gu, '_');
    return `${source} ${time.dayOf(seconds)} ${time.clockOf(seconds).replaceAll(':', '-')}${extension}`.replace(/ +/g, ' ');
}

/**
 * The command that takes a frame out of the clip in its full size; null = no file. FFmpeg shows the first frame that is
 * not before a time.
 * @param {PageData} data
 * @param {Timeline} time
 * @param {number} frame
 */
export function stillCommand(data, time, frame) {
    const file = filesOf(data, time, {first: frame, last: frame})?.[0];
    if (!file) return null;
    const [path, begin] = file;
    const seconds = Math.max(0, time.secondsOf(frame) - begin - Math.min(time.lengthOf(frame) / 2, 0.01));
    const input = quoted(path.startsWith('-') ? './' + path : path);
    return `ffmpeg -ss ${seconds.toFixed(3)} -i ${input} -frames:v 1 ${quoted(stillName(data, time, frame, '.png'))}`;
}

/** @param {number[]} sides left, top, right, bottom in pixels */
const polygonOf = ([left, top, right, bottom]) => `'${left},${top} ${right},${top} ${right},${bottom} ${left},${bottom}'`;

/**
 * The option --mask that keeps out what happens in a box, with a border of a hundredth.
 * @param {number[]} box in shares of the picture
 * @param {number[]} size of the clip
 */
export function maskOption([left, top, right, bottom], size) {
    const sides = [left - 0.01, top - 0.01, right + 0.01, bottom + 0.01].map((share, k) => Math.round(Math.min(1, Math.max(0, share)) * size[k % 2]));
    return `--mask ${polygonOf(sides)}`;
}

/**
 * A rectangle as the option --roi: its corners in pixels of the clip.
 * @param {{from: number[], to: number[]}} shape in shares of the picture
 * @param {number[]} size of the clip
 */
export function roiOption(shape, size) {
    return `--roi ${polygonOf(sidesOf(shape).map((share, k) => Math.round(share * size[k % 2])))}`;
}
