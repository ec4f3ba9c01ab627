// Commands for a shell that a page offers, and names of files.

import {sidesOf} from '../shared/shapes.js';
import {upright} from '../shared/text.js';
import {numberOf} from './events.js';
import {fileAt, footageOf, hasMoment} from './pieces.js';

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
 * @param {boolean} [gone] whether only the pieces are left
 * @returns {File[] | null}
 */
export function filesOf(data, time, frames, gone = false) {
    const all = footageOf(data, gone);
    const [first, last] = [frames.first, frames.last].map(frame => time.secondsOf(frame));
    if (!hasMoment(all, first)) return null;
    const files = all.slice(all.indexOf(fileAt(all, first)), all.indexOf(fileAt(all, last)) + 1);
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
 * @param {boolean} [gone] whether only the pieces are left
 */
export function cutCommand(data, time, place, gone = false) {
    const event = data.events?.[place];
    const files = event ? filesOf(data, time, event, gone) : null;
    if (!event || !files) return null;
    const commandOf = (/** @type {File[]} */ some) => {
        const [path, begin] = some[0];
        const name = path.slice(path.lastIndexOf('/') + 1);
        const stem = name.replace(/\.[^.]*$/, '').replace(/^-/, '_');
        const timeText = (/** @type {number} */ seconds) => (Math.max(seconds, begin) - begin).toFixed(3) + 's';
        const ending = gone ? name.slice(name.lastIndexOf('.')) : data.cut.ending;
        return ['vvr cut', ...some.map(([file]) => quoted(file)), ...gone ? [] : data.cut.names.map(names => `--names ${quoted(names)}`),
                `--start ${timeText(time.secondsOf(event.first))} --end ${timeText(Math.min(time.endOf(event), some[some.length - 1][2]))}`,
                `-o ${quoted(`${stem}-event-${numberOf(data.events ?? [], place)}${ending}`)}`].join(' ');
    };
    // Files that overlap can't be joined.
    const overlap = files.some(([, from], i) => i > 0 && from < files[i - 1][2] - 0.001);
    return overlap ? files.map(file => commandOf([file])).join(' && ') : commandOf(files);
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
 * @param {boolean} [gone] whether only the pieces are left
 */
export function stillCommand(data, time, frame, gone = false) {
    const file = filesOf(data, time, {first: frame, last: frame}, gone)?.[0];
    if (!file) return null;
    const [path, begin] = file;
    const seconds = Math.max(0, time.secondsOf(frame) - begin - Math.min(time.lengthOf(frame) / 2, 0.01));
    const input = quoted(path.startsWith('-') ? './' + path : path);
    return `ffmpeg -ss ${seconds.toFixed(3)} -i ${input} -frames:v 1 ${quoted(stillName(data, time, frame, '.png'))}`;
}

/**
 * The command that draws the picture from an angle; null = no file.
 * @param {PageData} data
 * @param {Timeline} time
 * @param {{angle: number[], unbent: boolean, density: number, piece: [number, number] | null, bends: boolean}} turned
 * @param {boolean} [gone] whether only the pieces are left
 */
export function renderCommand(data, time, {angle, unbent, density, piece, bends}, gone = false) {
    const files = filesOf(data, time, {first: time.firstFrame, last: time.lastFrame}, gone);
    if (!files) return null;
    const part = piece && bends ? [`--start ${piece[0].toFixed(3)}s`, `--end ${piece[1].toFixed(3)}s`] : [];
    return ['vvr render', ...files.map(([path]) => quoted(path)), ...data.cut.names.map(names => `--names ${quoted(names)}`), `--camera ${angle.join(',')}`,
            ...unbent ? ['--layout box'] : [], ...density === 1 ? [] : [`--opacity ${density.toFixed(2)}`], ...part, '-o turned.png'].join(' ');
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
