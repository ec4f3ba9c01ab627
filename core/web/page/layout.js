// How large the film is: the border that is dragged, picture and film that change places, full screen, zoom into the film.

import {at, press, sharesWithin} from '../shared/dom.js';
import {clamp} from '../shared/text.js';
import {wheelZooms, zoomedAbout} from './zoom.js';
import {set, state} from './state.js';

const main = /** @type {HTMLElement} */ (document.querySelector('main'));
const screen = at('screen');
const divider = at('divider');
const kept = 'vvr-side';  // the name under which the browser keeps the width

export function swapPlaces() {
    if (!state.fills) set({large: state.large === 'film' ? 'picture' : 'film'});
}

/**
 * Film and strip fill the window, and that the screen; a phone that has no full screen for pages shows at least the first.
 * @param {boolean} fills
 */
function fill(fills) {
    set({fills});
    if (fills) document.documentElement.requestFullscreen?.().catch(() => {});
    else if (document.fullscreenElement) document.exitFullscreen();
}

export const toggleFullScreen = () => fill(!state.fills);

/** @returns {boolean} whether there was anything to end */
export function endFilling() {
    if (!state.fills) return false;
    fill(false);
    return true;
}

export const drawFilling = () => document.documentElement.toggleAttribute('data-filling', state.fills);

/** @param {number} wide pixels */
function setSide(wide) {
    const side = clamp(Math.round(wide), 260, Math.max(260, innerWidth - 320));
    set({side});
    try {
        localStorage.setItem(kept, String(side));
    } catch {
        // Nothing is kept then.
    }
}

export function drawPlaces() {
    main.dataset.large = state.large;
    press(at('larger'), state.large === 'film');
}

export function drawSide() {
    if (state.side === null) main.style.removeProperty('--side');
    else main.style.setProperty('--side', state.side + 'px');
    main.toggleAttribute('data-sized', state.side !== null);
    divider.ariaValueNow = String(Math.round(100 * at('side').clientWidth / Math.max(1, main.clientWidth)));
}

export function drawReel() {
    const {filmScale, filmMiddle} = state;
    const half = 0.5 / filmScale;
    const middle = filmMiddle.map(share => clamp(share, half, 1 - half));
    state.filmMiddle = middle;
    at('reel').style.transform = filmScale === 1 ? '' : `translate(${middle.map(share => (0.5 - share * filmScale) * 100 + '%').join(', ')}) scale(${filmScale})`;
    screen.style.touchAction = filmScale > 1 ? 'none' : 'manipulation';
}

/**
 * @param {number} factor
 * @param {{clientX: number, clientY: number}} point that stays in its place
 */
function zoomFilm(factor, point) {
    const {scale, middle} = zoomedAbout({scale: state.filmScale, middle: state.filmMiddle}, factor, sharesWithin(at('reel'), point));
    set({filmScale: scale, filmMiddle: middle});
}

/** @type {{x: number, y: number, far: boolean} | null} */
let drag = null;
/** Whether the click that ends now was the end of a drag. */
export const wasDrag = () => drag?.far ?? false;

function listenToReel() {
    /** @type {Map<number, {clientX: number, clientY: number}>} */
    const fingers = new Map();
    screen.addEventListener('wheel', event => {
        if (!wheelZooms(event)) return;
        event.preventDefault();
        zoomFilm(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.04 : 0.0016)), event);
    }, {passive: false});
    screen.addEventListener('pointerdown', event => {
        if (state.asking || event.button !== 0) return;
        fingers.set(event.pointerId, event);
        drag = {x: event.clientX, y: event.clientY, far: fingers.size > 1};
    });
    screen.addEventListener('pointermove', event => {
        const before = fingers.get(event.pointerId);
        if (!before || !drag) return;
        drag.far ||= Math.hypot(event.clientX - drag.x, event.clientY - drag.y) > 5;
        const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
        fingers.set(event.pointerId, event);
        if (other) {
            const apart = (/** @type {{clientX: number, clientY: number}} */ a) => Math.max(1, Math.hypot(a.clientX - other.clientX, a.clientY - other.clientY));
            zoomFilm(apart(event) / apart(before), {clientX: (event.clientX + other.clientX) / 2, clientY: (event.clientY + other.clientY) / 2});
        } else if (drag.far && state.filmScale > 1) {
            const box = at('reel').getBoundingClientRect();
            set({filmMiddle: [state.filmMiddle[0] - (event.clientX - before.clientX) / box.width, state.filmMiddle[1] - (event.clientY - before.clientY) / box.height]});
        }
    });
    for (const name of ['pointerup', 'pointercancel', 'pointerleave']) {
        screen.addEventListener(name, event => fingers.delete(/** @type {PointerEvent} */ (event).pointerId));
    }
    screen.addEventListener('dblclick', event => {
        event.preventDefault();
        toggleFullScreen();
    });
}

export function listenToLayout() {
    try {
        const wide = Number(localStorage.getItem(kept));
        if (wide > 0 && wide < innerWidth) setSide(wide);
    } catch {
        // Nothing was kept.
    }
    at('larger').addEventListener('click', swapPlaces);
    at('fullscreen').addEventListener('click', toggleFullScreen);
    document.addEventListener('fullscreenchange', () => { if (!document.fullscreenElement) set({fills: false}); });
    divider.addEventListener('pointerdown', event => {
        divider.setPointerCapture(event.pointerId);
        event.preventDefault();
    });
    divider.addEventListener('pointermove', event => {
        if (divider.hasPointerCapture(event.pointerId)) setSide(main.getBoundingClientRect().right - event.clientX - 7);
    });
    divider.addEventListener('dblclick', () => {
        localStorage.removeItem(kept);
        set({side: null});
    });
    divider.addEventListener('keydown', event => {
        const by = {ArrowLeft: 40, ArrowRight: -40}[event.key];
        if (!by) return;
        setSide(at('side').clientWidth + by);
        event.preventDefault();
        event.stopPropagation();
    });
    addEventListener('resize', () => { if (state.side !== null) setSide(state.side); });
    listenToReel();
}
