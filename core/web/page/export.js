// What can be taken along: links, commands, stills.

import {copyText} from '../shared/clipboard.js';
import {at, element} from '../shared/dom.js';
import {upright} from '../shared/text.js';
import {addressOfEvent, addressOfMoment} from './address.js';
import {cutCommand, roiOption, stillCommand, stillName} from './commands.js';
import {numberOf, stillNear} from './events.js';
import {tell} from './messages.js';
import {fileAt, footageOf} from './pieces.js';
import {hasFrame, previewUrl, video} from './player.js';
import {savedMarks} from './marks.js';
import {state} from './state.js';

/**
 * A picture of the frame that is shown; `from` says what it is taken from, '' = the clip.
 * @typedef {{image: HTMLVideoElement | HTMLImageElement, frame: number, from: string}} Shot
 */

/**
 * @param {string | null} text null = nothing to copy
 * @param {string} what it is
 */
export async function copy(text, what) {
    if (text === null) return;
    const shown = upright(text);
    tell(await copyText(text) ? `Copied ${what}: ${shown}` : `This browser copies nothing. Copy ${what} by hand: ${shown}`);
}

function linkHere() {
    const {chosen, events, time, now} = state;
    const hash = chosen === null ? addressOfMoment(time.secondsOf(now)) : addressOfEvent(numberOf(events, chosen));
    return location.href.split('#')[0] + hash;
}

/**
 * The frame that the preview shows: it has every second, third, ... alone.
 * @param {number} frame
 */
const frameOfPreview = frame => frame - (frame - state.time.firstFrame) % (state.parts.preview?.step ?? 1);

/** @returns {Shot | null} */
function playerNow() {
    const {film, now} = state;
    if (!film || !hasFrame(now)) return null;
    return {image: video, frame: film.isPreview ? frameOfPreview(now) : now, from: film.isPreview ? 'the preview in this page' : ''};
}

/**
 * The preview at the moment that is shown.
 * @returns {Promise<Shot | null>}
 */
async function previewNow() {
    const {parts: {preview}, time, now} = state;
    if (!preview) return null;
    const small = document.createElement('video');
    small.muted = true;
    small.src = previewUrl();
    const happens = (/** @type {string} */ name) => new Promise((done, fail) => {
        small.addEventListener(name, done, {once: true});
        small.addEventListener('error', () => fail(new Error('the preview does not open')), {once: true});
    });
    await happens('loadeddata');
    small.currentTime = Math.max(0, time.timeWithin(now) - preview.begin);
    await happens('seeked');
    return {image: small, frame: frameOfPreview(now), from: 'the preview in this page'};
}

/** @returns {Promise<Shot>} */
async function stillNow() {
    const nearest = stillNear(state.parts.stills, state.now);
    if (!nearest) throw new Error('the stills of this page have not come yet');
    const image = new Image();
    image.src = nearest.src;
    await image.decode();
    return {image, frame: nearest.frame, from: 'a still in this page'};
}

/** @param {Shot['image']} image */
const sizeOf = image => image instanceof HTMLVideoElement ? [image.videoWidth, image.videoHeight] : [image.naturalWidth, image.naturalHeight];

/**
 * @param {Shot['image']} image
 * @returns {Promise<Blob>}
 */
function pngOf(image) {
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = sizeOf(image);
    canvas.getContext('2d')?.drawImage(image, 0, 0, canvas.width, canvas.height);
    return new Promise((done, fail) => canvas.toBlob(blob => blob ? done(blob) : fail(new Error('this browser writes no PNG')), 'image/png'));
}

/** Browsers give no pixels of a clip that was opened as a file: then it is the preview's, else a still's. */
async function saveStill() {
    for (const open of [playerNow, previewNow, stillNow]) {
        const shot = await open();
        if (!shot) continue;
        try {
            return save(await pngOf(shot.image), shot);
        } catch (error) {
            if (!(error instanceof DOMException) || error.name !== 'SecurityError') throw error;
        }
    }
}

/**
 * What is not the clip's own frame says so, in the file's name too: it may be taken for evidence.
 * @param {Blob} blob
 * @param {Shot} shot
 */
function save(blob, {image, frame, from}) {
    const {data, time, now} = state;
    const size = sizeOf(image);
    const whole = from === '' && size.every((side, k) => Math.abs(side - data.size[k]) <= 1);
    const name = stillName(data, time, frame, whole ? '.png' : '.preview.png');
    download(blob, name);
    const fullSize = at('copystill', HTMLButtonElement).disabled ? '' : ' “Copy command for this frame” gives the clip’s own frame.';
    const other = frame === now ? '' : ` It is the frame at ${time.clockOf(time.secondsOf(frame))}.`;
    tell(whole ? `Saved ${name}, ${size.join('×')}, as in the clip`
        : `Saved ${name}: ${size.join('×')} of the clip’s ${data.size.join('×')}, from ${from || 'the player'}.${other}${fullSize}`);
}

const cutOfChosen = () => state.chosen === null ? null : cutCommand(state.data, state.time, state.chosen, state.gone);
const stillNowCommand = () => stillCommand(state.data, state.time, state.now, state.gone);

/**
 * @param {Blob} blob
 * @param {string} name
 */
function download(blob, name) {
    const link = element('a');
    link.download = name;
    link.href = URL.createObjectURL(blob);
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

function saveNotes() {
    const {data, events, marks, time} = state;
    const name = stillName(data, time, time.firstFrame, '.notes.json');
    download(new Blob([savedMarks(data, events, marks, time)], {type: 'application/json'}), name);
    tell(`Saved ${name}`);
}

export function drawCommands() {
    const {data, gone, time, now} = state;
    const file = fileAt(footageOf(data, gone), time.secondsOf(now));
    at('openclip').hidden = !file;
    if (file) at('openclip', HTMLAnchorElement).href = file[0];
    at('copycut', HTMLButtonElement).disabled = cutOfChosen() === null;
    at('copystill', HTMLButtonElement).disabled = stillNowCommand() === null;
}

export function listenToExport() {
    at('copylink').addEventListener('click', () => copy(linkHere(), 'a link'));
    at('copycut').addEventListener('click', () => copy(cutOfChosen(), 'the command'));
    at('copystill').addEventListener('click', () => copy(stillNowCommand(), 'the command for this frame in full size'));
    at('copyroi').addEventListener('click', () => copy(state.asked && roiOption(state.asked, state.data.size), 'the option for the next run'));
    at('savenotes').addEventListener('click', saveNotes);
    at('savestill').addEventListener('click', () => saveStill().catch(error => tell(`The still can’t be saved: ${error.message}`)));
}
