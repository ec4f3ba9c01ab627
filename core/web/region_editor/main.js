// The page on which regions of a clip are drawn.

import {copyText} from '../shared/clipboard.js';
import {appendShape, at, button, dataOfPage, element, press, sharesWithin} from '../shared/dom.js';
import {store} from '../shared/state.js';
import {clamp} from '../shared/text.js';
import {boundsOf, boxOf, copyOf, moved, nameOf, optionText, parse, textOf, withCorner, withMoreCorners} from './regions.js';

/**
 * @typedef {import('./regions.js').Corner} Corner
 * @typedef {import('./regions.js').Region} Region
 * @typedef {{from: Corner, box?: Corner[], corners?: Corner[], corner?: number, before?: Region[]}} Drag
 *     box: of a new rectangle; corners: of the region that is moved; corner: the one that is moved
 */

/** @type {{option: 'roi' | 'mask', regions: string}} */
const data = dataOfPage();
const drawing = at('drawing', SVGSVGElement);
const option = at('option', HTMLTextAreaElement);
const [width, height] = ['width', 'height'].map(name => Number(at('frame').getAttribute(name)));

const {state, set, drawAll} = store({
    regions: /** @type {Region[]} */ ([]),
    chosen: -1,  // place in `regions`; -1 = none
    option: /** @type {string} */ (data.option),
    tool: 'box',
    draft: /** @type {Corner[] | null} */ (null),   // corners of a polygon that is being drawn
    pointer: /** @type {Corner | null} */ (null),   // where its next one would be
    drag: /** @type {Drag | null} */ (null),        // what the pointer holds
    past: /** @type {Region[][]} */ ([]),           // what `regions` was, for undo
    wide: 0,                                        // the drawing's width on the screen
});

/** The past with the regions as they are now, before they change. */
const remembered = (before = copyOf(state.regions)) => [...state.past, before].slice(-200);

/** @param {string} text */
const say = text => { at('said').textContent = text; };

/**
 * @param {Corner[]} corners
 * @param {boolean} box
 */
function add(corners, box) {
    const regions = [...state.regions, {box, corners}];
    set({past: remembered(), regions, chosen: regions.length - 1});
    say(`Region ${regions.length} added.`);
}

/** @param {number} place */
function remove(place) {
    if (!state.regions[place]) return;
    const regions = state.regions.filter((_, k) => k !== place);
    set({past: remembered(), regions, chosen: regions.length ? Math.min(place, regions.length - 1) : -1});
    say(`Region ${place + 1} deleted.`);
}

/**
 * @param {number} place
 * @param {Partial<Region>} change
 */
const regionsWith = (place, change) => state.regions.map((region, k) => k === place ? {...region, ...change} : region);

function undo() {
    const {draft, past} = state;
    if (draft) {
        set({draft: draft.length > 1 ? draft.slice(0, -1) : null});
    } else if (past.length) {
        const regions = past[past.length - 1];
        set({regions, past: past.slice(0, -1), chosen: Math.min(state.chosen, regions.length - 1)});
        say('Undone.');
    }
}

function closeDraft() {
    const {draft} = state;
    if (!draft || draft.length < 3) return;
    set({draft: null, pointer: null});
    add(draft, false);
}

// ---- What is shown

/** Pixels of the clip for one of the screen. */
const unit = () => width / Math.max(1, state.wide);
const reach = () => (matchMedia('(pointer: coarse)').matches ? 13 : 7) * unit();

/** Darkens what vvr will not look at. */
function drawVeil() {
    const {regions} = state;
    if (!regions.length) return;
    if (state.option === 'mask') {
        for (const region of regions) appendShape('polygon', {class: 'veil', points: textOf(region.corners)}, drawing);
        return;
    }
    const mask = appendShape('mask', {id: 'outside', maskUnits: 'userSpaceOnUse', x: 0, y: 0, width, height}, drawing);
    appendShape('rect', {width, height, fill: '#fff'}, mask);
    for (const region of regions) appendShape('polygon', {points: textOf(region.corners), fill: '#000'}, mask);
    appendShape('rect', {class: 'veil', width, height, mask: 'url(#outside)'}, drawing);
}

function drawRegions() {
    const {regions, chosen, draft} = state;
    regions.forEach((region, k) => {
        appendShape('polygon', {class: k === chosen ? 'region chosen' : 'region', points: textOf(region.corners), tabindex: 0, role: 'button',
                                'aria-pressed': k === chosen, 'aria-label': `Region ${k + 1}: ${nameOf(region)}`, 'data-key': `region ${k}`}, drawing);
        const [left, top] = boundsOf(region.corners);
        const size = 15 * unit();
        appendShape('text', {class: 'number', x: left + size / 2, y: top + 1.2 * size, 'font-size': size, 'stroke-width': size / 5, 'aria-hidden': true},
                    drawing).textContent = String(k + 1);
    });
    if (!regions[chosen] || draft) return;
    regions[chosen].corners.forEach(([x, y], k) => {
        appendShape('circle', {class: 'corner', cx: x, cy: y, r: reach(), tabindex: 0, role: 'button',
                               'aria-label': `Corner ${k + 1} of region ${chosen + 1}: ${x}, ${y}`, 'data-key': `corner ${k}`}, drawing);
    });
}

function drawDraft() {
    const {drag, draft, pointer} = state;
    if (drag?.box) appendShape('polygon', {class: 'draft', points: textOf(drag.box)}, drawing);
    if (!draft) return;
    appendShape('polyline', {class: 'draft', points: textOf([...draft, ...pointer ? [pointer] : []])}, drawing);
    draft.forEach(([x, y]) => appendShape('circle', {class: 'corner', cx: x, cy: y, r: reach() * 0.7}, drawing));
}

function drawList() {
    const keyed = (/** @type {HTMLButtonElement} */ made, /** @type {string} */ key) => {
        made.dataset.key = key;
        return made;
    };
    at('list').replaceChildren(...state.regions.map((region, k) => {
        const row = element('li');
        const name = keyed(button('', `${k + 1}. ${nameOf(region)}`, () => set({chosen: k})), `row ${k}`);
        press(name, k === state.chosen);
        const cross = keyed(button('', '✕', () => remove(k)), `delete ${k}`);
        cross.setAttribute('aria-label', `Delete region ${k + 1}`);
        row.append(name, cross);
        return row;
    }));
    at('none').hidden = state.regions.length > 0;
}

/**
 * The part that has the focus: "corner 2", "region 0", "row 0", "delete 0"; empty = none.
 * @param {EventTarget | null} target
 */
const keyOf = target => target instanceof HTMLElement || target instanceof SVGElement ? target.dataset.key ?? '' : '';

/** Draws all anew, and gives the focus back to what had it. */
function draw() {
    const {regions, chosen, draft, past} = state;
    const focused = keyOf(document.activeElement);
    drawing.replaceChildren();
    drawVeil();
    drawRegions();
    drawDraft();
    drawList();
    option.value = optionText(state.option, regions);
    at('copy', HTMLButtonElement).disabled = at('clear', HTMLButtonElement).disabled = !regions.length;
    at('undo', HTMLButtonElement).disabled = !past.length && !draft;
    at('corner', HTMLButtonElement).disabled = !regions[chosen];
    at('hint').textContent = draft ? 'Click for each corner; the first one again, or Enter, closes it.' : '';
    if (!focused) return;
    const again = document.querySelector(`[data-key="${focused}"]`);
    if (again instanceof HTMLElement || again instanceof SVGElement) again.focus({preventScroll: true});
}

// ---- Mouse, pen and finger

/**
 * A point of the screen in whole pixels of the clip, within the picture.
 * @param {PointerEvent} event
 */
function placeOf(event) {
    const [x, y] = sharesWithin(drawing, event);
    return [clamp(Math.round(x * width), 0, width), clamp(Math.round(y * height), 0, height)];
}

/** @type {(a: Corner, b: Corner) => boolean} */
const isNear = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]) <= 1.6 * reach();

/** @param {PointerEvent} event */
function beginDrag(event) {
    const {draft, regions} = state;
    const from = placeOf(event);
    if (draft) {
        if (draft.length > 2 && isNear(from, draft[0])) closeDraft();
        else if (!isNear(from, draft[draft.length - 1])) set({draft: [...draft, from]});
        return;
    }
    const [part, number] = keyOf(event.target).split(' ');
    const before = copyOf(regions);
    if (part === 'corner') set({drag: {from, corner: Number(number), before}});
    else if (part === 'region') set({chosen: Number(number), drag: {from, corners: regions[Number(number)].corners, before}});
    else if (state.tool === 'polygon') set({chosen: -1, draft: [from], pointer: null});
    else set({chosen: -1, drag: {from, box: boxOf(from, from)}});
}

/** @param {PointerEvent} event */
function moveDrag(event) {
    const {draft, drag, regions, chosen} = state;
    const place = placeOf(event);
    at('place').textContent = `x ${place[0]}, y ${place[1]}`;
    if (draft) {
        set({pointer: place});
    } else if (drag?.box) {
        const box = boxOf(drag.from, place);
        set({drag: {...drag, box}});
        at('place').textContent += `, ${box[1][0] - box[0][0]}×${box[2][1] - box[0][1]}`;
    } else if (drag?.corners) {
        set({regions: regionsWith(chosen, {corners: moved(drag.corners, [place[0] - drag.from[0], place[1] - drag.from[1]], [width, height])})});
    } else if (drag?.corner !== undefined) {
        set({regions: regionsWith(chosen, {corners: withCorner(regions[chosen], drag.corner, place)})});
    }
}

function endDrag() {
    const {drag, regions} = state;
    if (!drag) return;
    const {box, before} = drag;
    const hasMoved = before && JSON.stringify(before) !== JSON.stringify(regions);
    set(hasMoved ? {drag: null, past: remembered(before)} : {drag: null});
    // A click is no rectangle.
    if (box && box[2][0] - box[0][0] > 2 && box[2][1] - box[0][1] > 2) add(box, true);
}

const withoutDrag = () => ({drag: null, regions: state.drag?.before ?? state.regions});

drawing.addEventListener('pointerdown', event => {
    if (!event.isPrimary || event.button !== 0) return;
    event.preventDefault();
    drawing.setPointerCapture(event.pointerId);
    if (document.activeElement instanceof HTMLElement || document.activeElement instanceof SVGElement) document.activeElement.blur();
    beginDrag(event);
});
drawing.addEventListener('pointermove', event => { if (event.isPrimary) moveDrag(event); });
drawing.addEventListener('pointerup', endDrag);
drawing.addEventListener('pointercancel', () => set(withoutDrag()));
drawing.addEventListener('pointerleave', () => { at('place').textContent = '\u00a0'; });
drawing.addEventListener('dblclick', closeDraft);

// ---- Keys

/** @type {Record<string, Corner>} */
const steps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};

/**
 * Moves the corner or the region that has the focus.
 * @param {Corner} by
 * @returns {boolean} whether there is one
 */
function moveByKey(by) {
    const [part, number] = keyOf(document.activeElement).split(' ');
    if (!['corner', 'region', 'row'].includes(part)) return false;
    const chosen = part === 'corner' ? state.chosen : Number(number);
    const region = state.regions[chosen];
    const past = remembered();
    if (part === 'corner') {
        const [x, y] = region.corners[Number(number)];
        const to = [clamp(x + by[0], 0, width), clamp(y + by[1], 0, height)];
        set({past, chosen, regions: regionsWith(chosen, {corners: withCorner(region, Number(number), to)})});
    } else {
        set({past, chosen, regions: regionsWith(chosen, {corners: moved(region.corners, by, [width, height])})});
    }
    return true;
}

/**
 * @param {KeyboardEvent} event
 * @returns {boolean} whether the key means something here
 */
function onKey(event) {
    const {chosen, draft} = state;
    const control = event.ctrlKey || event.metaKey;
    const [part, number] = keyOf(event.target).split(' ');
    if (event.key === 'z' && control) undo();
    else if (control || event.altKey) return false;
    else if (steps[event.key]) return moveByKey(steps[event.key].map(step => step * (event.shiftKey ? 10 : 1)));
    else if ((event.key === 'Delete' || event.key === 'Backspace') && chosen >= 0 && event.target !== option) remove(chosen);
    else if (event.key === 'Enter' && draft) closeDraft();
    else if (event.key === 'Escape') set({...withoutDrag(), draft: null, pointer: null, chosen: -1});
    else if ((event.key === 'Enter' || event.key === ' ') && part === 'region') set({chosen: Number(number)});
    else return false;
    return true;
}

document.addEventListener('keydown', event => { if (onKey(event)) event.preventDefault(); });

// ---- Buttons

at('add').addEventListener('click', () => {
    // Not on top of one that was added so before.
    const offset = (state.regions.length % 6) * 0.04;
    const corner = (/** @type {number} */ share) => [Math.round(width * (share + offset)), Math.round(height * (share + offset))];
    add(boxOf(corner(0.3), corner(0.6)), true);
});
at('corner').addEventListener('click', () => {
    const {chosen, regions} = state;
    const corners = withMoreCorners(regions[chosen].corners);
    set({past: remembered(), regions: regionsWith(chosen, {corners, box: false})});
    say(`Region ${chosen + 1} has ${corners.length} corners.`);
});
at('undo').addEventListener('click', undo);
at('clear').addEventListener('click', () => {
    set({past: remembered(), regions: [], chosen: -1});
    say('All regions deleted.');
});
at('copy').addEventListener('click', async () => say(await copyText(option.value, option) ? 'Copied.' : 'Press Ctrl+C to copy.'));

/** @param {'option' | 'tool'} name */
function listenToChoices(name) {
    for (const choice of document.querySelectorAll(`[name=${name}]`)) {
        if (!(choice instanceof HTMLInputElement)) continue;
        choice.checked = choice.value === state[name];
        choice.addEventListener('change', () => set({[name]: choice.value, draft: null, pointer: null}));
    }
}
listenToChoices('option');
listenToChoices('tool');

/** As large as the window allows: a small clip is hard to draw on. */
function fit() {
    const stage = at('stage');
    const room = innerWidth > 900 ? innerHeight - 130 : 0.52 * innerHeight;
    const wide = stage.parentElement?.clientWidth ?? 0;
    stage.style.width = `${Math.floor(Math.max(160, Math.min(wide, room * width / height)))}px`;
}
addEventListener('resize', fit);

at('panel').hidden = false;
fit();
set({regions: parse(data.regions), wide: drawing.clientWidth});
drawAll([{draw, from: () => Object.values(state)}]);
new ResizeObserver(() => set({wide: drawing.clientWidth})).observe(drawing);
document.documentElement.dataset.ready = '';
