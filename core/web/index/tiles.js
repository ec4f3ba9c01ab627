// Small pictures of moments: a window on a clip's contact sheet, which can play.

import {element} from '../shared/dom.js';
import {drawShape} from '../shared/drawing.js';
import {bits} from './data.js';
import {sheetPlace} from './sheet.js';
import {data} from './state.js';

/**
 * @typedef {import('./clips.js').Clip} Clip
 * @typedef {import('../shared/shapes.js').Shape} Shape
 */

/**
 * @param {Clip} clip
 * @param {string} extension
 */
export function imageOf(clip, extension) {
    const image = element('img');
    image.loading = 'lazy';
    image.decoding = 'async';
    image.alt = '';
    image.src = clip.url + extension;
    return image;
}

/**
 * The picture that tells most of a clip: a frame, else the picture of the whole.
 * @param {Clip} clip
 */
export const stillOf = clip => imageOf(clip, clip.files & bits.still ? '.still.jpg' : clip.files & bits.thumbnail ? '.jpg' : '.png');

/**
 * Cameras whose shape is known: all that a camera records mostly has the same, so cards have it before their pictures come.
 * @type {Set<number>}
 */
const knownShapes = new Set();

/**
 * An element that has the shape of a camera's pictures.
 * @template {HTMLElement} E
 * @param {E} made
 * @param {number} camera
 */
export function shaped(made, camera) {
    made.classList.add('shaped');
    made.style.setProperty('--shape', `var(--shape-${camera}, 1.333)`);
    return made;
}

/** A window that shows one picture of a sheet. */
export class Tile {
    /**
     * @param {Clip} clip
     * @param {number} count of the sheet's pictures; 0 = there is no sheet
     */
    constructor(clip, count) {
        this.count = count;
        this.camera = clip.camera;
        this.window = element('span', count ? 'tile' : 'tile single');
        this.image = count ? imageOf(clip, '.stills.jpg') : stillOf(clip);
        this.window.append(this.image);
        this.image.addEventListener('load', () => this.takeShape());
    }

    takeShape() {
        const columns = Math.max(1, Math.min(this.count, data.sheet_columns));
        const rows = Math.max(1, Math.ceil(this.count / columns));
        const shape = this.image.naturalWidth / columns / (this.image.naturalHeight / rows);
        this.window.style.aspectRatio = String(shape);
        /** @type {HTMLElement | null} */ (this.window.closest('.shaped'))?.style.setProperty('--shape', String(shape));
        if (!knownShapes.has(this.camera)) document.documentElement.style.setProperty('--shape-' + this.camera, String(shape));
        knownShapes.add(this.camera);
    }

    /** @param {number} place of the picture on the sheet */
    show(place) {
        if (!this.count) return;
        for (const [side, value] of Object.entries(sheetPlace(place, this.count, data.sheet_columns))) this.image.style.setProperty(side, value + '%');
    }

    /**
     * Draws what was searched for, and a ring about where the object is.
     * @param {Shape | null} place in thousandths of the picture
     * @param {number[] | null} spot
     */
    mark(place, spot) {
        for (const old of this.window.querySelectorAll('svg, .spot')) old.remove();
        if (place) {
            const marks = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
            marks.setAttribute('preserveAspectRatio', 'none');
            marks.setAttribute('aria-hidden', 'true');
            drawShape(marks, place, [1000, 1000], 1000, true);
            this.window.append(marks);
        }
        if (spot) {
            const ring = element('i', 'spot');
            [ring.style.left, ring.style.top] = spot.map(thousandths => thousandths / 10 + '%');
            this.window.append(ring);
        }
        return this;
    }
}

const picturesPerSecond = 4;

/**
 * Plays while the pointer is on an element, or it has the focus.
 * @param {HTMLElement} on
 * @param {() => {show: () => void}[]} scenes what is shown one after the other
 * @param {() => void} rest shows what is shown otherwise
 */
export function playOn(on, scenes, rest) {
    let timer = 0;
    const pause = () => {
        clearInterval(timer);
        timer = 0;
    };
    const stop = () => {
        pause();
        rest();
    };
    const play = () => {
        if (timer) return;
        let next = 0;
        timer = window.setInterval(() => {
            const all = scenes();
            if (!on.isConnected) return clearInterval(timer);
            if (all.length) all[next++ % all.length].show();
        }, 1000 / picturesPerSecond);
    };
    on.addEventListener('pointerenter', play);
    // A finger that has gone leaves what it turned to.
    on.addEventListener('pointerleave', event => event.pointerType === 'touch' ? pause() : stop());
    on.addEventListener('focus', () => { if (on.matches(':focus-visible')) play(); });
    on.addEventListener('blur', stop);
}
