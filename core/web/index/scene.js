// Scene: what was where over all days of a camera.

import {at, button, element, press} from '../shared/dom.js';
import {beginByKeys, drawChip, drawShape, isByKeyboard, letDraw} from '../shared/drawing.js';
import {isWithin} from '../shared/day_time.js';
import {digits, many} from '../shared/text.js';
import {timeText} from '../shared/wall_clock.js';
import {arrowAcross} from '../shared/ways.js';
import {answerOf, coloursOf, daysBetween, heatOf, ofWay, waysOf} from './answers.js';
import {bits} from './data.js';
import {eventsOf, loadDay} from './events.js';
import {isOf, isOfChoice} from './query.js';
import {ask, cameraName, camerasByName, choices, clips, data, hits, searchedClips, set, span, state, wallOf} from './state.js';
import {stillOf} from './tiles.js';

/**
 * @typedef {import('../shared/shapes.js').Shape} Shape
 * @typedef {import('./answers.js').SceneEvent} SceneEvent
 * @typedef {import('./answers.js').Found} Found
 */

const stage = at('stage');
const ground = at('ground', HTMLImageElement);
const surface = at('drawing', SVGSVGElement);

/** @type {[id: string, kind: Shape['kind']][]} */
const tools = [['askbox', 'box'], ['askline', 'line']];

/** The cameras that have a picture of their scene. */
const filmed = camerasByName.filter(camera => clips.some(clip => clip.camera === camera && clip.drawn));

/** The camera whose scene is shown; null = one is to be chosen. */
export const sceneCamera = () => state.camera ?? (filmed.length === 1 ? filmed[0] : null);

/**
 * A clip that shows a camera's scene, if possible with nobody in it.
 * @param {number} camera
 */
function clipOfScene(camera) {
    const ofCamera = clips.filter(clip => clip.camera === camera && clip.drawn);
    const withStill = ofCamera.filter(clip => clip.files & bits.still);
    return withStill.find(clip => clip.events === 0) ?? withStill[0] ?? ofCamera[0];
}

/**
 * @param {SceneEvent} event
 * @param {number} seconds
 */
export const wallIn = (event, seconds) => wallOf(event.clip.begins + seconds);

let questions = 0;  // an answer to an older one is not shown

/** Answers what is asked of the scene once the days are loaded. */
export async function answer() {
    if (state.view !== 'scene') return;
    const mine = ++questions;
    const {place, way, kind} = state;
    const asked = span();
    const wanted = new Set(searchedClips());
    set({answer: null});
    const days = daysBetween(data.days, asked.from, asked.to).reverse();
    await Promise.all(days.map(loadDay));
    if (mine !== questions) return;
    const began = performance.now();
    const hasLimits = Object.values(asked).some(Boolean);
    const clock = {
        has: (/** @type {SceneEvent} */ event, /** @type {number} */ seconds) => !hasLimits || isWithin(asked, wallIn(event, seconds)),
        text: (/** @type {SceneEvent} */ event, /** @type {number} */ seconds) => timeText(wallIn(event, seconds)),
    };
    const size = [ground.naturalWidth || 4, ground.naturalHeight || 3];
    const events = days.flatMap(eventsOf).filter(event =>
        wanted.has(event.clip) && isOfChoice(choices, kind, event.kind) && isOf(choices, state.class, [event.what]));
    /** @type {Found[]} */
    const found = [];
    for (const event of events) {
        const how = answerOf(event, place, way, size, clock);
        if (how) found.push({event, how});
    }
    set({answer: {found, events, took: performance.now() - began}});
}

export function drawScene() {
    if (state.view !== 'scene') return;
    const camera = sceneCamera();
    at('choosers').hidden = camera !== null;
    at('pictured').hidden = camera === null;
    if (camera === null) return drawChoosers();
    const shows = clipOfScene(camera);
    ground.src = shows ? stillOf(shows).src : '';
    ground.alt = 'The scene of ' + cameraName(camera);
}

/** A scene of each camera: who draws on one has chosen it. */
function drawChoosers() {
    at('choosers').replaceChildren(...filmed.map(camera => {
        const figure = element('figure', 'chooser');
        const picture = element('div', 'stage');
        const image = stillOf(/** @type {import('./clips.js').Clip} */ (clipOfScene(camera)));
        const drawing = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
        drawing.setAttribute('class', state.tool ? 'drawing active' : 'drawing');
        drawing.setAttribute('preserveAspectRatio', 'none');
        drawing.setAttribute('aria-hidden', 'true');
        /** @type {Shape | null} */
        let drawn = null;
        letDraw(drawing, 1000, {
            kind: () => state.tool, shape: () => drawn,
            shows: shape => drawShape(drawing, drawn = shape, [1000, 1000], 1000, true),
            asks: place => ask({camera, place}),
        });
        drawing.addEventListener('click', () => { if (!state.tool) ask({camera}); });
        image.addEventListener('load', () => { figure.style.setProperty('--shape', String(image.naturalWidth / image.naturalHeight)); });
        picture.append(image, drawing);
        const name = button('', cameraName(camera), () => ask({camera}));
        name.addEventListener('click', event => { if (isByKeyboard(event) && state.tool) beginDrawing(state.tool); });
        figure.append(picture, name);
        return figure;
    }));
}

const grid = [48, 36];

export function drawHeat() {
    if (!state.answer || sceneCamera() === null) return;
    const [columns, rows] = grid;
    const canvas = at('heat', HTMLCanvasElement);
    [canvas.width, canvas.height] = grid;
    // Where nothing was found one sees where something would have been.
    const shown = hits().length ? hits().map(({event}) => event) : state.answer.events;
    const cells = heatOf(waysOf(shown), columns, rows);
    canvas.getContext('2d')?.putImageData(new ImageData(coloursOf(cells), columns, rows), 0, 0);
}

export function drawHours() {
    if (!state.answer) return;
    const counts = new Array(24).fill(0);
    for (const {event, how} of hits()) ++counts[wallIn(event, how.at).getUTCHours()];
    const most = Math.max(1, ...counts);
    const scale = element('b', '', 'most: ' + many(most, 'event'));
    at('hours').replaceChildren(scale, ...counts.map((count, hour) => {
        const column = element('span');
        const bar = element('i');
        bar.style.height = count / most * 100 + '%';
        column.title = `${digits(hour)}:00 to ${digits(hour)}:59: ${many(count, 'event')}`;
        column.append(bar, element('small', '', hour % 3 ? '' : digits(hour)));
        return column;
    }));
    const busiest = counts.indexOf(most);
    at('hours').ariaLabel = hits().length ? `Events by hour of the day; most, ${most}, from ${busiest} to ${busiest + 1}` : 'No events';
}

export function drawPlace() {
    drawShape(surface, state.drawn ?? state.place, [1000, 1000], 1000);
    drawChip(at('askall'), state.place, ground.src, 1000);
}

const hints = {box: 'Draw a rectangle: what was in it is listed.', line: 'Draw a line: what crossed it is listed, with the direction.'};

export function drawTools() {
    const {tool, view, drawn, place} = state;
    for (const [id, kind] of tools) press(at(id), view === 'scene' && tool === kind);
    surface.classList.toggle('active', tool !== null);
    const whichCamera = sceneCamera() === null ? 'Choose a camera. ' : '';
    at('scenehint').textContent = drawn ? 'Arrow keys move an end, Tab goes to the other one, Enter searches.'
        : tool && !place ? whichCamera + hints[tool]
        : whichCamera || (place ? '' : 'Warm colours show where most went on. Search by area, or draw a line, to ask who was where.');
}

/** → 12, ← 4, both: with how many events. */
export function drawWays() {
    const {place, answer: known, way} = state;
    at('ways').hidden = place?.kind !== 'line' || !known;
    if (place?.kind !== 'line' || !known) return;
    const size = [ground.naturalWidth || 4, ground.naturalHeight || 3];
    at('ways').replaceChildren(...[0, 1, -1].map(side => {
        const count = ofWay(known.found, side).length;
        const arrow = side ? arrowAcross(place, side, size) : 'Both ways';
        const made = button('', `${arrow} ${count}`, () => ask({way: side}));
        if (side) made.ariaLabel = `Only those that crossed ${arrow}: ${count}`;
        press(made, way === side);
        return made;
    }));
}

/** @param {Shape | null} place in thousandths of the scene; null = everywhere */
export function askPlace(place) {
    state.drawn = null;
    ask({place});
}

/** @param {Shape['kind']} kind */
function beginDrawing(kind) {
    beginByKeys(surface, 1000, kind, drawn => set({drawn}));
}

/**
 * Lets the next drags draw.
 * @param {Shape['kind']} kind
 * @param {MouseEvent} event
 */
function take(kind, event) {
    state.tool = kind;
    ask({view: 'scene'});
    if (!isByKeyboard(event)) return;
    if (sceneCamera() !== null) beginDrawing(kind);
    else /** @type {HTMLElement | null} */ (at('choosers').querySelector('button'))?.focus();
}

export function listenToScene() {
    letDraw(surface, 1000, {kind: () => state.tool, shape: () => state.drawn ?? state.place, shows: drawn => set({drawn}), asks: askPlace});
    for (const [id, kind] of tools) at(id).addEventListener('click', event => take(kind, event));
    at('askall').addEventListener('click', () => askPlace(null));
    ground.addEventListener('load', () => { stage.style.aspectRatio = String(ground.naturalWidth / ground.naturalHeight); });
}
