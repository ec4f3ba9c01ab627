// Asking by place: a rectangle or a line that is drawn on the player.

import {at, press} from '../shared/dom.js';
import {beginByKeys, drawChip, drawShape, isByKeyboard, letDraw} from '../shared/drawing.js';
import {say} from './messages.js';
import {set, state} from './state.js';

/** @typedef {import('../shared/shapes.js').Shape} Shape */

/** @type {SVGSVGElement} */
const drawing = at('drawing', SVGSVGElement);

/** @type {[id: string, kind: Shape['kind']][]} */
const tools = [['askbox', 'box'], ['askline', 'line']];
const hints = {box: 'Draw a rectangle on the player: what was in it is listed.', line: 'Draw a line on the player: what crossed it is listed.'};

const keyHint = 'Arrows move an end, Tab goes to the other, Enter searches.';

/**
 * Lets the next drag on the player draw; the same button again ends that.
 * @param {Shape['kind']} kind
 */
export const askBy = kind => set({asking: state.asking === kind ? null : kind});

/**
 * Searches a place without a pointer: a shape is there at once, whose ends arrows move.
 * @param {Shape['kind']} kind
 */
export function askByKeys(kind) {
    askBy(kind);
    if (state.asking) beginByKeys(drawing, 1, kind, shape => set({drawn: shape}));
}

/**
 * Lists what has to do with a place; null = everything.
 * @param {Shape | null} shape in shares of the clip's picture
 */
export function askPlace(shape) {
    set({asked: shape, drawn: null});
    say(shape ? at('heading').textContent ?? '' : 'All events again');
}

export function drawTools() {
    const {asking, drawn} = state;
    drawing.classList.toggle('active', asking !== null);
    for (const [id, kind] of tools) press(at(id), asking === kind);
    at('hint').textContent = drawn ? keyHint : asking ? hints[asking] : '';
    at('asks').hidden = at('hint').textContent === '' && state.asked === null;
    at('filmnow').hidden = !at('asks').hidden;  // in its place, so that the list does not move
    at('asks').toggleAttribute('data-asked', state.asked !== null);
}

export function drawAsked() {
    const {asked, drawn, data} = state;
    drawShape(drawing, drawn ?? asked, data.size, 1);
    drawChip(at('askall'), asked, state.parts.stills[0]?.src ?? '', 1);
    at('copyroi').hidden = asked?.kind !== 'box';
}

export function listenToTools() {
    for (const [id, kind] of tools) {
        at(id).addEventListener('click', event => isByKeyboard(event) ? askByKeys(kind) : askBy(kind));
    }
    at('askall').addEventListener('click', () => askPlace(null));
    drawing.removeAttribute('aria-hidden');  // its ends can be moved by keys
    letDraw(drawing, 1, {
        kind: () => state.asking,
        shape: () => state.drawn ?? state.asked,
        shows: shape => set({drawn: shape}),
        asks: shape => {
            set({asking: null});
            askPlace(shape);
        },
    });
}
