// What lies over the picture: times, numbers, portraits, the map, and the paths of what is lit. It is text of the page, so it
// is sharp and of one size however large the picture is.

import {appendShape, at, element} from '../shared/dom.js';
import {clamp} from '../shared/text.js';
import {overlap, pointIn, roomFor, sectionAt, trailOf} from './arc.js';
import {briefDeeds, deedOf, numberOf, pointAt} from './events.js';
import {asksForSome, wantedEvents} from './filters.js';
import {entriesOf} from './legend.js';
import {litEvents} from './picture.js';
import {isPlaying} from './player.js';
import {pictureSize, state} from './state.js';
import {ofEvent} from './looks.js';
import {contentsNow, frameAt, overlayNow, pathOf, pixelAt, showsFrame} from './turned.js';
import {hiddenOf} from './volume_view.js';

const letters = at('letters');
const [width, height] = pictureSize;
/** @type {SVGSVGElement} */
const lines = at('lines', SVGSVGElement);
/** @type {SVGSVGElement} */
const lit = at('lit', SVGSVGElement);

const mostLit = 24;  // more paths at a time tell nothing
const smallest = 56;  // pixels: below, a portrait has no room for text

/** @param {number[][]} points */
const pointsText = points => points.map(point => point.map(value => value.toFixed(1)).join(',')).join(' ');

/**
 * @param {string} className
 * @param {number[]} box left, top, right, bottom in the picture
 */
function boxAt(className, [left, top, right, bottom]) {
    const made = element('div', className);
    made.style.left = left / width * 100 + '%';
    made.style.top = top / height * 100 + '%';
    made.style.width = (right - left) / width * 100 + '%';
    made.style.height = (bottom - top) / height * 100 + '%';
    return made;
}

/**
 * A text at a point: its middle, in shares of the picture.
 * @param {string} className
 * @param {string} text
 * @param {number[]} middle
 */
function textAt(className, text, [x, y]) {
    const made = element('span', className, text);
    made.style.left = x * 100 + '%';
    made.style.top = y * 100 + '%';
    return made;
}

/**
 * Where what is drawn stands in the volume that turns.
 * @type {Map<Element, import('./layouts.js').Point>}
 */
const places = new Map();

/**
 * @template {Element} E
 * @param {E} element
 * @param {import('./layouts.js').Point | undefined} place in C-space
 * @returns {E}
 */
function standsAt(element, place) {
    if (place) places.set(element, place);
    return element;
}

/** What is nearer hides times and the lines of portraits. */
function hideBehind() {
    const hidden = hiddenOf([...places.values()]);
    [...places.keys()].forEach((element, k) => element.classList.toggle('behind', hidden[k]));
}

/** @typedef {{at: number[], place?: import('./layouts.js').Point}} Stand in the picture, and in C-space */

/**
 * Where an event's number may stand: where its portrait's line ends, and along its trail.
 * @param {import('./data.js').PageEvent} event
 * @param {Stand} [end]
 * @returns {Stand[]}
 */
function standsOf(event, end) {
    const trail = state.turns ? pathOf(event).map(place => ({at: pixelAt(place), place})) : trailOf(state.data.overlay.sections, event, state.time).map(at => ({at}));
    const along = trail.length ? [0, 1, 2, 3, 4, 5].map(k => trail[Math.floor(k / 6 * trail.length)]) : [];
    return end ? [end, ...along] : along;
}

/**
 * The stretches of an event's path: whether something hides them, and whether the object moves there, as far as that is known.
 * @param {import('./data.js').PageEvent} event
 */
function stretchesOf(event) {
    if (!state.turns) return [{points: trailOf(state.data.overlay.sections, event, state.time), isHidden: false, flows: false}];
    const path = pathOf(event);
    const hidden = hiddenOf(path);
    /** @type {{points: number[][], isHidden: boolean, flows: boolean}[]} */
    const stretches = [];
    path.map(pixelAt).forEach((point, k) => {
        const frame = frameAt(path[k][2]);
        const [isHidden, flows] = [hidden[k], !event.stays?.some(([from, to]) => frame >= from && frame <= to)];
        const before = stretches[stretches.length - 1];
        before?.points.push(point);
        if (before?.isHidden !== isHidden || before.flows !== flows) stretches.push({points: [point], isHidden, flows});
    });
    return stretches;
}

/** Pixels of the screen per pixel of the picture. */
const scaleNow = () => state.stageWidth / width;

/**
 * Marks the object in its portrait, which may show others too.
 * @param {number[]} object left, top, right, bottom in shares of the portrait
 */
function objectIn([left, top, right, bottom]) {
    const made = element('i', 'object');
    made.style.inset = [top, 1 - right, 1 - bottom, left].map(share => share * 100 + '%').join(' ');
    return made;
}

/**
 * @param {import('./data.js').Overlay['portraits'][number]} portrait
 * @param {Stand} end of its line
 */
function portraitOf({event: place, box, object}, {at: to, place: at}) {
    const {events, time} = state;
    const event = events[place];
    const [left, , right] = box;
    const made = ofEvent(boxAt('portrait', box), place);
    const image = element('img');
    image.alt = '';
    if (event.portrait) image.src = event.portrait;
    const wide = (right - left) * scaleNow();
    const number = element('b', 'number', String(numberOf(events, place)));
    if (wide >= smallest) {
        const caption = element('span', 'caption');
        caption.style.maxWidth = wide + 10 + 'px';
        const widthOf = (/** @type {string} */ text) => 26 + text.length * 6.7 + (/[←-↙]/.test(text) ? 8 : 0);
        const brief = briefDeeds(deedOf(event)).find(text => widthOf(text) <= wide + 6);
        caption.append(number, ' ' + (brief ?? ''));
        if (overlayNow().captions * scaleNow() >= 40) caption.append(element('br'), element('span', 'times', time.fromTo(event.begin, event.end)));
        made.append(caption);
        if (object) made.append(objectIn(object));
    } else {
        made.append(number);
        made.classList.add('small');
    }
    made.append(image);
    standsAt(ofEvent(appendShape('line', {x1: (left + right) / 2, y1: box[3], x2: to[0], y2: to[1]}, lines), place), at);
    return made;
}

/** The empty scene with the path of each object. */
function drawMap() {
    const {map} = overlayNow();
    at('map').replaceChildren();
    if (!map) return;
    const [left, top, right, bottom] = map.box;
    const made = boxAt('', map.box);
    const image = element('img');
    image.alt = '';
    image.src = map.src;
    made.append(image);
    state.events.forEach((event, place) => {
        /** @type {[number, number][]} */
        const points = event.path.map(([, x, y]) => [left + x * (right - left), top + y * (bottom - top)]);
        ofEvent(appendShape('polyline', {points: pointsText(points), class: 'path'}, lines), place);
    });
    at('map').replaceChildren(made);
    drawAskedOnMap(map.box);
}

/**
 * The place that is asked for, on the map too: it is printed.
 * @param {number[]} box of the map
 */
function drawAskedOnMap([left, top, right, bottom]) {
    const {asked} = state;
    if (!asked) return;
    const [[x, y], [toX, toY]] = [asked.from, asked.to].map(([u, v]) => [left + u * (right - left), top + v * (bottom - top)]);
    if (asked.kind === 'line') appendShape('line', {x1: x, y1: y, x2: toX, y2: toY, class: 'asked'}, lines);
    else appendShape('rect', {x: Math.min(x, toX), y: Math.min(y, toY), width: Math.abs(toX - x), height: Math.abs(toY - y), class: 'asked'}, lines);
}

/** Where a note's text has its middle, beside the axis, in pixels of the screen. */
function noteBox(/** @type {{text: string, at: number[], out: number[]}} */ {text, at: point, out}) {
    const scale = scaleNow();
    const [wide, high] = [text.length * 6.8 + 4, 15];
    const half = (Math.abs(out[0]) * wide + Math.abs(out[1]) * high) / 2 + 4;
    // Where the picture is small, the text has no room beside it: it stays within.
    const [left, , right] = contentsNow().map(value => value * scale);
    const x = clamp(point[0] * scale + out[0] * half, left + wide / 2, Math.max(left, right - wide / 2));
    const y = point[1] * scale + out[1] * half;
    return {left: x - wide / 2, right: x + wide / 2, top: y - high / 2, bottom: y + high / 2, x, y};
}

/** The boxes of portraits with their captions, and of the map, in pixels of the screen: no note lies on them. */
function picturesOver() {
    const {portraits, captions, map} = overlayNow();
    const scale = scaleNow();
    const boxes = [...portraits.map(({box}) => [box[0], box[1] - captions, box[2], box[3]]), ...map ? [map.box] : []];
    return boxes.map(box => box.map(value => value * scale)).map(([left, top, right, bottom]) => ({left, top, right, bottom}));
}

/** The times along the axis, beside it; within it where a picture lies there; none where there is no room. */
function notes() {
    const taken = picturesOver();
    const scale = scaleNow();
    const made = [];
    for (const note of overlayNow().notes) {
        const box = [note, {...note, out: note.out.map(value => -value)}].map(noteBox).find(one => !taken.some(other => overlap(one, other)));
        if (!box) continue;
        taken.push(box);
        made.push(standsAt(textAt('note', note.text, [box.x / scale / width, box.y / scale / height]), note.place));
    }
    return made;
}

/** Frames at the ends whose far side is seen look like in a mirror: below them it is said why. */
function behindNotes() {
    const {overlay: {sections}, settings} = state.data;
    if (!settings.show?.split(',').includes('frames')) return [];
    const shown = overlayNow().sections;
    const scale = scaleNow();
    return [shown[0], shown[shown.length - 1]].filter((section, k) => section && section[0] === [sections[0], sections[sections.length - 1]][k][0])
        .flatMap(([, x0, y0, x1, y1, x2, y2, x3, y3]) => {
            const turned = (x1 - x0) * (y3 - y0) - (y1 - y0) * (x3 - x0);
            // From the edge, or small, nobody sees what is in it.
            if (turned > Math.min(-2500 / scale / scale, -0.2 * ((x1 - x0) ** 2 + (y1 - y0) ** 2))) return [];
            return [textAt('note', 'seen from behind', [(x2 + x3) / 2 / width, (Math.max(y0, y1, y2, y3) + 10 / scale) / height])];
        });
}

/**
 * Where the numbers of the events stand, as many as have room and as nothing hides: at the lines of their portraits, or where their
 * trails begin.
 * @param {import('./data.js').Overlay['portraits']} portraits
 * @returns {Map<number, Stand>} by the event's place
 */
function numberStands(portraits) {
    const {events} = state;
    const scale = scaleNow();
    const ends = new Map(portraits.map(({event, to, place}) => [event, {at: to, place}]));
    const lasts = (/** @type {number} */ place) => (ends.has(place) ? 1e9 : 0) + events[place].last - events[place].first;
    const order = [...events.keys()].filter(place => overlayNow().numbers || ends.has(place)).sort((a, b) => lasts(b) - lasts(a));
    const stands = order.map(place => standsOf(events[place], ends.get(place)));
    const places = stands.flat().flatMap(({place}) => place ? [place] : []);
    const hidden = new Set(hiddenOf(places).flatMap((isHidden, k) => isHidden ? [places[k]] : []));
    const seen = stands.map(some => some.filter(({place}) => !place || !hidden.has(place)));
    const taken = roomFor(seen.map(some => some.map(({at: [x, y]}) => ({left: x * scale - 12, right: x * scale + 12, top: y * scale - 12, bottom: y * scale + 12}))));
    return new Map(order.flatMap((place, k) => taken[k] < 0 ? [] : [[place, seen[k][taken[k]]]]));
}

export function drawLetters() {
    lines.setAttribute('viewBox', `0 0 ${width} ${height}`);
    lines.replaceChildren();
    places.clear();
    const {numbers} = overlayNow();
    const portraits = overlayNow().portraits.filter(({event}) => event < state.events.length);
    const stands = numberStands(portraits);
    drawMap();
    letters.replaceChildren(
        ...portraits.map(portrait => portraitOf(portrait, stands.get(portrait.event) ?? {at: portrait.to, place: portrait.place})),
        ...notes(), ...behindNotes(),
        ...numbers ? [...stands].map(([place, {at: [x, y]}]) => ofEvent(textAt('number badge', String(numberOf(state.events, place)), [x / width, y / height]), place)) : []);
    hideBehind();
    drawLit();
}

/** The paths of what is lit lie above all others; the rest is paled. */
export function drawLit() {
    const {events} = state;
    const shown = litEvents();
    const wanted = state.turns && asksForSome() ? wantedEvents() : null;
    for (const root of [letters, lines]) {
        for (const child of root.querySelectorAll('[data-event]')) {
            child.classList.toggle('off', wanted !== null && !wanted.includes(Number(child.getAttribute('data-event'))));
            child.classList.toggle('pale', shown !== null && !shown.includes(Number(child.getAttribute('data-event'))));
        }
        for (const child of root.querySelectorAll('.lit')) child.classList.remove('lit');
    }
    lit.setAttribute('viewBox', `0 0 ${width} ${height}`);
    lit.replaceChildren();
    if (shown === null || shown.length > mostLit) return drawRib();
    for (const place of shown) {
        const stretches = stretchesOf(events[place]);
        for (const name of ['casing', 'trail']) {
            for (const {points, isHidden} of stretches) ofEvent(appendShape('polyline', {points: pointsText(points), class: isHidden ? name + ' behind' : name}, lit), place);
        }
        for (const {points, isHidden, flows} of stretches) if (flows && !isHidden) appendShape('polyline', {points: pointsText(points), class: 'zebra'}, lit);
        for (const same of lines.querySelectorAll(`[data-event="${place}"]`)) same.classList.add('lit');
    }
    drawRib();
}

/** The zebra of the lit path runs while the film does, or while the pointer is on its event: at rest nothing needs to be drawn. */
export const drawZebra = () => lit.toggleAttribute('data-runs', isPlaying() || state.lightened !== null);

/** The cross-section at the moment that the player shows, and where the chosen object is in it. */
export function drawRib() {
    const {time, now, moved, chosen, events} = state;
    for (const old of lit.querySelectorAll('.rib, .here')) old.remove();
    const corners = moved && (!state.turns || showsFrame(now)) ? sectionAt(overlayNow().sections, time.secondsOf(now)) : null;
    if (!corners) return;
    /** @type {[number, number][]} */
    const points = [0, 2, 4, 6].map(k => [corners[k], corners[k + 1]]);
    appendShape('polygon', {points: pointsText(points), class: 'rib'}, lit);
    const place = chosen === null ? null : pointAt(events[chosen], now);
    if (!place || chosen === null) return;
    const [cx, cy] = pointIn(corners, place[0], place[1]);
    ofEvent(appendShape('circle', {cx, cy, r: clamp(6 / scaleNow(), 4, 40), class: 'here'}, lit), chosen);
}

export function drawLegend() {
    const {data, events} = state;
    /** @type {Record<string, number>} */
    const shows = {plain: 0, stripes: events.findIndex(({stays}) => stays?.length)};
    at('legend').replaceChildren(...entriesOf(data, events).map(({sign, words}) => {
        const entry = element('span', '', words);
        const swatch = element('i', sign);
        if (sign !== 'grey') ofEvent(swatch, shows[sign]);
        entry.prepend(swatch);
        return entry;
    }));
}
