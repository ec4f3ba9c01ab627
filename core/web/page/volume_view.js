// The volume in the page: made of what has come, and drawn again when anything changes. Without WebGL 2, where it is slow, and
// on paper, the picture stays.

import {at} from '../shared/dom.js';
import {cropped, plus} from './camera.js';
import {stillNear} from './events.js';
import {asksForSome, wantedEvents} from './filters.js';
import {edgeLines, markAt} from './layouts.js';
import {litEvents} from './picture.js';
import {previewUrl, showsStill, video} from './player.js';
import {pictureSize, set, state} from './state.js';
import {bentNow, contentsNow, frameAt, framingNow, layoutNow, shownNow, showsFrame, ticksNow, tOf} from './turned.js';
import {mostPicked, Volume} from './volume.js';
import {unpacked} from './volume_data.js';
import {placed} from './zoom.js';

const view = at('view');
const canvas = at('volume', HTMLCanvasElement);

/** @type {Volume | null} */
let volume = null;
/** @type {Promise<import('./volume_data.js').Voxels> | null} */
let voxels = null;
/** Milliseconds that a frame may take while it moves; else the picture stays. */
let most = 100;
const mostPixels = 3e6;

const pause = () => new Promise(done => setTimeout(done));

/** Shows the picture again. */
function giveUp() {
    volume?.close();
    volume = null;
    set({turnable: false, turns: false});
}

/** Of the view's pixels that are drawn while it moves: as many as are quick. */
let coarse = 0.5;
let prepared = Promise.resolve();

/**
 * Makes the volume ready to be turned. Call it when it has come, and after a context was lost; one after the other.
 * @param {number} [milliseconds] that a frame may take, from now on
 */
export function prepareVolume(milliseconds = most) {
    most = milliseconds;
    return prepared = prepared.then(prepare);
}

/** @param {import('./data.js').TurningVolume} data */
async function framesAtEnds(data) {
    const images = data.ends.map(src => Object.assign(new Image(), {src}));
    await Promise.all(images.map(image => image.decode()));
    return () => images.forEach((image, k) => volume?.setFrame(/** @type {0 | 1} */ (k), image));
}

/**
 * Makes the newer volume of a stream ready. What it returns puts it in the place of the one that is shown, at once: call it
 * together with all else that changes.
 * @param {import('./data.js').TurningVolume | null} data
 */
export async function nextVolume(data) {
    await prepared;
    const next = data && volume ? unpacked(data, pause) : null;
    const ready = await next;
    const setEnds = data && ready ? await framesAtEnds(data) : () => {};
    return () => {
        voxels = next;
        if (!data || !ready) return;
        volume?.setVoxels(data, ready);
        setEnds();
    };
}

async function prepare() {
    const data = state.parts.volume;
    if (!data) return;
    try {
        voxels ??= unpacked(data, pause);
        volume = new Volume(canvas, data, await voxels);
        (await framesAtEnds(data))();
        drawLook();
        drawDensity();
        // The first one is slow: the shaders are made.
        const trial = () => {
            const begin = performance.now();
            drawNow({size: sizeOfView().map(side => Math.ceil(side / 8)), spacing: 2});
            volume?.finish();
            return performance.now() - begin;
        };
        trial();
        const took = trial();
        if (took * 16 > most) return giveUp();
        coarse = took * 64 < 12 ? 1 : 0.5;
        performance.mark('turnable');
        // A dark page has the colours of the dark volume, which the picture has not.
        set({turnable: true, turns: state.turns || isDark()});
    } catch (error) {
        giveUp();
        if (!(error instanceof Error) || !/WebGL/.test(error.message)) throw error;
    }
}

/** Pixels of the screen in the view. */
function sizeOfView() {
    const dense = Math.min(devicePixelRatio || 1, 2);
    // On a phone it may not be shown yet.
    const size = [(view.clientWidth || innerWidth) * dense, (view.clientHeight || innerWidth * 0.7) * dense];
    const factor = Math.min(1, Math.sqrt(mostPixels / Math.max(1, size[0] * size[1])));
    return size.map(side => Math.max(1, Math.round(side * factor)));
}

/** The part of the picture that is in the view: left, top, right, bottom in its pixels. */
function partOfPicture() {
    const {size, corner} = placed({size: pictureSize, room: state.room, contents: contentsNow(), scale: state.scale, middle: state.middle});
    const scale = size[0] / pictureSize[0];
    return [-corner[0], -corner[1], view.clientWidth - corner[0], view.clientHeight - corner[1]].map(value => value / scale);
}

/**
 * @param {number} t of the layout
 * @param {number} opacity
 * @returns {import('./volume.js').Standing}
 */
function standingAt(t, opacity) {
    const {pOf} = framingNow();
    const corner = pOf([1, 1, t]);
    return {corner, across: plus(pOf([0, 1, t]), -1, corner), down: plus(pOf([1, 0, t]), -1, corner), opacity};
}

/** Whether the frame of now stands in the volume. */
const showsNow = () => state.moved && nowIsThere && showsFrame(state.now);
let nowIsThere = false;

/**
 * @param {{size: number[], spacing: number, part?: number[]}} how
 * @returns {import('./volume.js').Shot}
 */
function shotOf({size, spacing, part = partOfPicture()}) {
    const {camera, pOf} = framingNow();
    const {opacity, ends, end} = /** @type {import('./data.js').TurningVolume} */ (state.parts.volume);
    const [first, last] = shownNow();
    const isWhole = bentNow()[0] === 0 && bentNow()[1] === 1;
    const frames = [ends.length && isWhole && first === 0 ? standingAt(0, opacity) : null, ends.length && isWhole && last === 1 ? standingAt(end, opacity) : null,
                    showsNow() ? standingAt(tOf(state.now), 0.9) : null];
    return {camera: cropped(camera, part, pictureSize), size, layout: layoutNow(), pOf, bent: bentNow(), piece: shownNow(), spacing, frames};
}

/** Whether the volume is that of a dark page. */
const isDark = () => state.dark && state.ground === null;

const schemeNow = () => /** @type {import('./data.js').TurningVolume} */ (state.parts.volume).schemes[isDark() ? 1 : 0];

/** Numbers, strip and list have the colours of the volume. */
export function drawColours() {
    const {data, parts: {volume: turning}, turns, events} = state;
    const takesDark = turns && isDark();
    document.documentElement.toggleAttribute('data-dark-volume', takesDark);
    const colourOf = (/** @type {number} */ place) => {
        if (!takesDark || !turning) return data.events?.[place]?.colour;
        const bytes = turning.schemes[1].palette[1 + 3 * (turning.colours[place] ?? 0)].slice(0, 3).map(share => Math.round(share * 255));
        return '#' + bytes.map(byte => byte.toString(16).padStart(2, '0')).join('');
    };
    if (events.every(({colour}, place) => colour === colourOf(place))) return;
    set({events: events.map((event, place) => ({...event, colour: colourOf(place)}))});
}

/** Lines and arrows, as they are in the picture. */
function setLines() {
    const {shows, arrows} = /** @type {import('./data.js').TurningVolume} */ (state.parts.volume);
    const {pOf, edge} = framingNow();
    const [from, to] = bentNow();
    const inLayout = (/** @type {number} */ t) => (t - from) / (to - from);
    const cuts = ticksNow().filter(t => t >= shownNow()[0] && t <= shownNow()[1]);
    const {lines: colour} = schemeNow();
    const ground = state.ground ? state.ground.map(byte => byte / 255) : state.dark ? [0.12, 0.13, 0.15] : [1, 1, 1];
    const pale = colour.map((value, k) => value + 0.55 * (ground[k] - value));
    const lineOf = (/** @type {number[]} */ ink) => (/** @type {import('./layouts.js').Point[]} */ [begin, end]) => [...pOf(begin), ...pOf(end), ...ink, 1];
    const marks = [edge, [1 - edge[0], edge[1]]].flatMap(side => cuts.map(t => markAt(side, t)));
    const all = [...shows.outline ? edgeLines([0, 1]).map(lineOf(colour)) : [], ...shows.ribs ? edgeLines(cuts).slice(4 * 96).map(lineOf(pale)) : [],
                 ...shows.ruler ? marks.map(lineOf(colour)) : []];
    const lit = litEvents();
    const shown = lit === null ? arrows : [];
    const ofArrows = shown.map(([x, y, t, toX, toY, toT]) => [[x, y, inLayout(t)], [toX, toY, inLayout(toT)]])
        .filter(ends => ends.every(([, , t]) => t >= shownNow()[0] && t <= shownNow()[1]))
        .flatMap(([tail, tip]) => [...pOf(tail), ...plus(pOf(tip), -1, pOf(tail))]);
    volume?.setLines(all.flat(), ofArrows);
}

/** Which owners are seen, and in which colours. */
export function drawLook() {
    if (!volume) return;
    const {colours} = /** @type {import('./data.js').TurningVolume} */ (state.parts.volume);
    const {palette} = schemeNow();
    const count = 4 * (state.events.length + 1);
    const faint = 0.06;  // of what is not lit
    const wanted = asksForSome() ? wantedEvents() : null;  // what the list does not have is off
    // What the pointer lights must not decide what it is on.
    for (const [name, lit] of /** @type {const} */ ([['palette', litEvents()], ['picks', litEvents(null)]])) {
        const table = new Float32Array(Math.ceil(count / 256) * 1024);
        for (let owner = 0; owner < count; ++owner) {
            const place = (owner >> 2) - 1;
            const look = place < 0 ? 0 : 1 + 3 * (colours[place] ?? 0) + Math.min(owner & 3, 2);
            const [red, green, blue, factor] = palette[look];
            const isLit = lit === null || lit.includes(place);
            const isOff = wanted !== null && !wanted.includes(place);
            table.set([red, green, blue, factor * (isOff ? 0 : isLit ? 1 : faint)], 4 * owner);
        }
        volume.setPalette(table, name);
    }
}

export const drawDensity = () => volume?.setTransfer(state.density);

/** A preview for the plane of now, where the film itself may not be read: one that was opened from a folder. */
const inner = Object.assign(document.createElement('video'), {muted: true, preload: 'auto'});
let isForbidden = false;  // to read the film
let nowSource = '';

/** Puts the frame of now into its plane: of the film, of the preview, or the nearest still. */
function setNow() {
    if (!volume || !state.moved) return;
    const {film, now, parts: {stills, preview}, time} = state;
    if (film && !showsStill() && !isForbidden && video.readyState > 1) {
        try {
            volume.setFrame(2, video);
            nowIsThere = true;
            return;
        } catch {
            isForbidden = true;
        }
    }
    if (preview && isForbidden) {
        if (!inner.src) {
            inner.src = previewUrl();
            inner.addEventListener('seeked', () => {
                volume?.setFrame(2, inner);
                nowIsThere = true;
                nowSource = '';
                drawVolume();
            });
        }
        if (inner.readyState > 0 && !inner.seeking && nowSource !== String(now)) {
            nowSource = String(now);
            inner.currentTime = Math.max(0, time.timeWithin(now) - preview.begin);
        }
        if (nowIsThere) return;
    }
    const still = stillNear(stills, now);
    if (!still || nowSource === still.src) return;
    nowSource = still.src;
    const image = Object.assign(new Image(), {src: still.src});
    image.decode().then(() => {
        volume?.setFrame(2, image);
        nowIsThere = true;
        drawVolume();
    });
}

/** @param {{size: number[], spacing: number}} how */
function drawNow(how) {
    if (!volume) return;
    if (canvas.width !== how.size[0] || canvas.height !== how.size[1]) [canvas.width, canvas.height] = how.size;
    setLines();
    const shot = shotOf(how);
    const perPixel = how.size[0] / Math.max(1, view.clientWidth) * state.stageWidth / pictureSize[0];
    volume.draw(shot, Math.max(1, (1 + pictureSize[1] / 800) * perPixel), schemeNow().arrows);
}

let isAsked = false;
let lastDrawn = 0;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let rest;

/** Coarse while things move, fine when they rest. */
export function drawVolume() {
    view.toggleAttribute('data-turns', state.turns);
    if (!state.turns || isAsked) return;
    isAsked = true;
    requestAnimationFrame(() => {
        isAsked = false;
        if (!state.turns || !volume) return;
        const passed = performance.now() - lastDrawn;
        lastDrawn = performance.now();
        if (passed < 24) coarse = Math.min(1, coarse * 1.1);
        else if (passed > 45 && passed < 250) coarse = Math.max(0.25, coarse * 0.8);
        setNow();
        drawNow({size: sizeOfView().map(side => Math.max(1, Math.round(side * coarse))), spacing: 2});
        clearTimeout(rest);
        rest = setTimeout(() => {
            if (!state.turns) return;
            drawNow({size: sizeOfView(), spacing: 1});
            volume?.finish();
            canvas.dataset.drawn = String(Number(canvas.dataset.drawn ?? 0) + 1);
        }, 150);
    });
}

/**
 * What is around a point of the view, as pixels of the screen; the point is in their middle.
 * @param {number} x pixels of the view
 * @param {number} y
 * @param {number} reach
 * @returns {import('./pixels.js').Pixels & {isNow: boolean}}
 */
export function pickedAround(x, y, reach) {
    const side = Math.min(2 * reach + 1, mostPicked);
    const frames = new Int32Array(side * side).fill(-1);
    const objects = new Int32Array(side * side).fill(-1);
    let isNow = false;
    if (volume) {
        const [left, top, right] = partOfPicture();
        const scale = (right - left) / Math.max(1, view.clientWidth);
        const part = [x - side / 2, y - side / 2, x + side / 2, y + side / 2].map((value, k) => value * scale + [left, top][k % 2]);
        const found = volume.pick(shotOf({size: [side, side], spacing: 1, part}));
        for (let k = 0; k < frames.length; ++k) {
            const at = 4 * ((side - 1 - Math.floor(k / side)) * side + k % side);
            if (found[at + 3] === 0) continue;
            frames[k] = frameAt(found[at + 1] / 0xFFFFFF);
            objects[k] = found[at] - 1;
            if (found[at + 2] === 2 && k === (frames.length - 1) / 2) isNow = true;
        }
    }
    return {width: side, height: side, frames, objects, isNow};
}

/**
 * Which of these places are hidden by something nearer.
 * @param {import('./layouts.js').Point[]} places in C-space
 * @returns {boolean[]}
 */
export function hiddenOf(places) {
    if (!volume || !places.length) return places.map(() => false);
    const {pOf} = framingNow();
    const asked = places.slice(0, mostPicked * mostPicked).map(pOf);
    return volume.hidden(shotOf({size: [1, 1], spacing: 1}), asked).map(opacity => opacity > 150);
}

export function listenToVolume() {
    canvas.addEventListener('webglcontextlost', event => {
        event.preventDefault();
        giveUp();
    });
    canvas.addEventListener('webglcontextrestored', () => prepareVolume());
    let turned = false;
    addEventListener('beforeprint', () => {
        turned = state.turns;
        set({turns: false});
    });
    addEventListener('afterprint', () => set({turns: turned && state.turnable}));
}
