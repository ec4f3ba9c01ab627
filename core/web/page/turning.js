// Turning the volume: by dragging, by keys, to a known angle; and the piece of time that it shows.

import {at, press} from '../shared/dom.js';
import {addressWithView, readAddress} from './address.js';
import {renderCommand} from './commands.js';
import {copy} from './export.js';
import {angleBetween, angleWithin} from './framing.js';
import {goTo, isPlaying, show} from './player.js';
import {set, state} from './state.js';
import {frameAt, pixelAt, shownNow, tOf} from './turned.js';
import {prepareVolume} from './volume_view.js';

/** @typedef {{angle: number[], unbent?: boolean}} Place an angle, and whether the volume is straight there */

const defaultAngle = () => state.parts.volume?.view.slice(0, 2) ?? [0, 46];

/**
 * The angles that have a name.
 * @type {Record<string, () => Place>}
 */
const known = {
    default: () => ({angle: defaultAngle()}),
    above: () => ({angle: [0, 90]}),
    side: () => ({angle: [-55, 16]}),
    camera: () => ({angle: [state.unbent ? -90 : -180 * tOf(state.now), 12], unbent: state.unbent}),
    unbent: () => ({angle: [0, 28], unbent: true}),
};

/**
 * Shows the volume instead of the picture.
 * @returns {boolean} whether that can be
 */
export function startTurning() {
    if (!state.turnable) return false;
    if (!state.turns) set({turns: true});
    return true;
}

/** @param {number[]} angle */
function turnTo(angle) {
    set({angle: angleWithin(angle)});
    clearTimeout(kept);
    kept = setTimeout(keepInAddress, 300);
}
/** @type {ReturnType<typeof setTimeout> | undefined} */
let kept;

const isDefault = () => !state.unbent && state.angle.every((value, k) => value === defaultAngle()[k]);

function keepInAddress() {
    const hash = addressWithView(location.hash, isDefault() ? null : {angle: state.angle, unbent: state.unbent});
    if (location.hash !== hash) history.replaceState(null, '', hash || location.pathname + location.search);
}

/** Degrees per pixel. */
const perPixel = [0.35, 0.3];

/**
 * @param {number} x pixels of the window
 * @param {number} y
 */
export function turnBy(x, y) {
    turnTo([state.angle[0] - x * perPixel[0], state.angle[1] + y * perPixel[1]]);
}

/**
 * By keys, degrees.
 * @param {number} azimuth
 * @param {number} elevation
 */
export function turn(azimuth, elevation) {
    if (startTurning()) turnTo([state.angle[0] + azimuth, state.angle[1] + elevation]);
}

/**
 * Goes to a known angle, by a short way that is seen.
 * @param {string} name
 */
export function turnToKnown(name) {
    if (!startTurning()) return;
    const {angle, unbent = false} = known[name]();
    const from = state.angle;
    set({unbent});
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) return turnTo(angle);
    const begin = performance.now();
    const step = () => {
        const share = Math.min(1, (performance.now() - begin) / 400);
        turnTo(share === 1 ? angle : angleBetween(from, angle, share * share * (3 - 2 * share)));
        if (share < 1 && state.turns) requestAnimationFrame(step);
    };
    step();
}

/** The view of the picture again. */
export const turnBack = () => { if (state.turns && !isDefault()) turnToKnown('default'); };

/**
 * The frame at which a point of the frame of now would be nearest to a point of the picture.
 * @param {number[]} place x and y of C-space
 * @param {number[]} pixel
 */
function frameNearest([x, y], pixel) {
    const [from, to] = shownNow();
    let best = from;
    let nearest = Infinity;
    for (let k = 0; k <= 400; ++k) {
        const t = from + (to - from) * k / 400;
        const [column, row] = pixelAt([x, y, t]);
        const far = Math.hypot(column - pixel[0], row - pixel[1]);
        if (far < nearest) [nearest, best] = [far, t];
    }
    return frameAt(best);
}

/**
 * Drags the frame of now along the volume.
 * @param {number[]} held x and y of C-space
 * @param {number[]} pixel
 */
export const dragNow = (held, pixel) => show(frameNearest(held, pixel), false, {until: null, touring: false});

/**
 * Where the frame of now is held: x and y of C-space.
 * @param {number[]} pixel of the picture
 */
export function heldAt(pixel) {
    let best = [0.5, 0.5];
    let nearest = Infinity;
    for (let i = 0; i <= 20; ++i) {
        for (let j = 0; j <= 20; ++j) {
            const [column, row] = pixelAt([i / 20, j / 20, tOf(state.now)]);
            const far = Math.hypot(column - pixel[0], row - pixel[1]);
            if (far < nearest) [nearest, best] = [far, [i / 20, j / 20]];
        }
    }
    return best;
}

/**
 * A piece of time: what is chosen in the strip, or what is zoomed there; again, all.
 * @param {boolean} bends
 */
function choosePiece(bends) {
    if (!startTurning()) return;
    const {stripFrom, stripLasts, brush} = state;
    const [from, to] = brush ?? [stripFrom, stripFrom + stripLasts];
    const isOn = state.piece !== null && state.bends === bends;
    set(isOn ? {piece: null, bends: false} : {piece: [from, to], bends});
    if (!isOn && !isPlaying() && state.moved && tOf(state.now) !== Math.min(1, Math.max(0, tOf(state.now)))) goTo(state.time.frameAt(from));
}

export function drawTurning() {
    const {turnable, turns, brush, piece, bends, stripLasts, time} = state;
    at('turning').hidden = !turnable;
    at('copyview').hidden = !turnable;
    const isWhole = stripLasts >= time.lasts * 0.999;
    at('piece').hidden = !turnable || isWhole && !brush && !piece;
    press(at('cut'), turns && piece !== null && !bends);
    press(at('bend'), turns && piece !== null && bends);
}

/** The volume can be turned once its voxels have come; nobody waits for it. */
export function becomeTurnable() {
    const {volume} = state.parts;
    if (!volume) return;
    set({angle: volume.view.slice(0, 2)});
    setTimeout(() => prepareVolume().then(followView), 200);  // first what is seen at once
}

/** The angle that the address has. */
function followView() {
    const view = readAddress(location.hash).view;
    if (view && startTurning()) {
        set({unbent: view.unbent});
        turnTo(view.angle);
    }
}

export function listenToTurning() {
    const angles = at('angle', HTMLSelectElement);
    angles.addEventListener('change', () => {
        turnToKnown(angles.value);
        angles.value = '';
    });
    const density = at('density', HTMLInputElement);
    density.addEventListener('input', () => { if (startTurning()) set({density: 2 ** Number(density.value)}); });
    at('cut').addEventListener('click', () => choosePiece(false));
    at('bend').addEventListener('click', () => choosePiece(true));
    at('copyview').addEventListener('click', () => copy(renderCommand(state.data, state.time, state, state.gone), 'the command for a picture from this angle'));
}
