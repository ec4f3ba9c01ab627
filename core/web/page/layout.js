// How large the film is: the border that is dragged, full screen, zoom into the film; and what a phone shows below it.

import {at, press, sharesWithin} from '../shared/dom.js';
import {clamp} from '../shared/text.js';
import {wheelZooms, zoomedAbout} from './zoom.js';
import {set, state} from './state.js';

const main = /** @type {HTMLElement} */ (document.querySelector('main'));
const screen = at('screen');
const divider = at('divider');
const kept = 'vvr-film';  // the name under which the browser keeps the share
const equal = 0.5;

/** Equal halves, then a larger film, then a larger volume. */
export function changeShares() {
    if (state.fills) return;
    setShare(state.filmShare === equal ? 0.68 : state.filmShare > equal ? 0.32 : equal);
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

/** @param {number} share of the film */
function setShare(share) {
    const near = Math.abs(share - equal) < 0.015 ? equal : share;  // the border stays in the middle when it is near
    set({filmShare: clamp(Math.round(near * 1000) / 1000, 0.2, 0.8)});
    try {
        localStorage.setItem(kept, String(state.filmShare));
    } catch {
        // Nothing is kept then.
    }
}

export function drawShares() {
    const {filmShare} = state;
    main.style.setProperty('--film', filmShare + 'fr');
    main.style.setProperty('--volume', 1 - filmShare + 'fr');
    main.toggleAttribute('data-uneven', Math.abs(filmShare - equal) > 0.1);
    press(at('larger'), filmShare !== equal);
    divider.ariaValueNow = String(Math.round(100 * filmShare));
}

export const drawTab = () => {
    main.dataset.tab = state.tab;
    for (const tab of tabs) press(at('tab' + tab), tab === state.tab);
};

/** @type {(typeof state.tab)[]} */
const tabs = ['events', 'volume', 'map'];

/** On a phone, the bar has no room for the kinds and the source. */
function moveParts() {
    const isPhone = narrow.matches;
    if (isPhone) at('filters').querySelector('div')?.prepend(at('kinds'));
    else at('heading').after(at('kinds'));
    (isPhone ? at('side') : at('bar')).append(at('filmnow'));
}
const narrow = matchMedia('(max-width: 760px)');

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
        const share = Number(localStorage.getItem(kept));
        if (share > 0) setShare(share);
    } catch {
        // Nothing was kept.
    }
    for (const tab of tabs) at('tab' + tab).addEventListener('click', () => set({tab}));
    moveParts();
    narrow.addEventListener('change', moveParts);
    at('larger').addEventListener('click', changeShares);
    at('fullscreen').addEventListener('click', toggleFullScreen);
    document.addEventListener('fullscreenchange', () => { if (!document.fullscreenElement) set({fills: false}); });
    divider.addEventListener('pointerdown', event => {
        divider.setPointerCapture(event.pointerId);
        event.preventDefault();
    });
    divider.addEventListener('pointermove', event => {
        if (divider.hasPointerCapture(event.pointerId)) setShare(sharesWithin(main, event)[0]);
    });
    divider.addEventListener('dblclick', () => setShare(equal));
    divider.addEventListener('keydown', event => {
        const by = {ArrowLeft: -0.03, ArrowRight: 0.03}[event.key];
        if (!by) return;
        setShare(state.filmShare + by);
        event.preventDefault();
        event.stopPropagation();
    });
    listenToReel();
}
