// Scene: what was where over all days of a camera. Events are loaded by day, from files beside the index.

import {at, element, press} from '../shared/dom.js';
import {drawByPointer, drawShape} from '../shared/drawing.js';
import {durationOf, shortSpanOf} from '../shared/durations.js';
import {digits, many} from '../shared/text.js';
import {dayText, daysBefore, timeText} from '../shared/wall_clock.js';
import {answerOf, coloursOf, daysBetween, eventOf, heatOf, sortedFound} from './answers.js';
import {bits} from './data.js';
import {isOf} from './query.js';
import {see} from './seen.js';
import {cameraName, choices, chosenClips, clipOfUrl, clips, data, kindOf, set, state, wallOf} from './state.js';

/**
 * @typedef {import('../shared/shapes.js').Shape} Shape
 * @typedef {import('./answers.js').SceneEvent} SceneEvent
 * @typedef {import('./answers.js').Found} Found
 */

const ground = at('ground', HTMLImageElement);
const surface = at('drawing', SVGSVGElement);
const from = at('from', HTMLInputElement);
const to = at('to', HTMLInputElement);

/** @type {Map<string, SceneEvent[]>} */
const eventsOfDay = new Map();
/** @type {Map<string, Promise<unknown>>} */
const waiting = new Map();

/**
 * Takes the events of a day. The files of days call it as `vvrDay`.
 * @param {string} day
 * @param {[url: string, events: import('./data.js').EventRow[]][]} list
 */
export function takeDay(day, list) {
    eventsOfDay.set(day, list.flatMap(([url, rows]) => {
        const clip = clipOfUrl.get(url);
        return clip ? rows.map(row => eventOf(clip, row, kindOf)) : [];
    }));
}

/** @param {string} day */
function loadDay(day) {
    const there = eventsOfDay.has(day) ? Promise.resolve() : waiting.get(day) ?? new Promise(done => {
        const script = element('script');
        script.src = `index.${day}.js`;
        script.onload = done;
        script.onerror = () => { eventsOfDay.set(day, []); done(undefined); };
        document.head.append(script);
    });
    waiting.set(day, there);
    return there;
}

/**
 * @param {SceneEvent} event
 * @param {number} seconds
 */
const clockIn = (event, seconds) => timeText(wallOf(event.clip.begins + seconds));

let questions = 0;  // an answer to an older one is not shown

/** Shows the camera's scene, and answers what is asked of it once the days are loaded. */
export async function drawScene() {
    if (state.view !== 'scene') return;
    const mine = ++questions;
    const {place} = state;
    const list = chosenClips();
    const camera = state.camera ?? list[0]?.camera ?? 0;
    const wanted = new Set(list.filter(clip => clip.camera === camera));
    const shows = clips.find(clip => clip.camera === camera && clip.files & bits.still) ?? clips.find(clip => clip.camera === camera);
    ground.src = shows ? shows.url + (shows.files & bits.still ? '.still.jpg' : '.png') : '';
    at('scenehint').textContent = `${shows ? cameraName(camera) : 'No clips'}: draw on the scene to ask what was there. Warm colours show where most went on.`;
    set({answer: null});
    const days = daysBetween(data.days, state.from, state.to).reverse();
    await Promise.all(days.map(loadDay));
    if (mine !== questions) return;
    const events = days.flatMap(day => eventsOfDay.get(day) ?? []).filter(event => wanted.has(event.clip) && isOf(choices, state.class, [event.what]));
    const began = performance.now();
    const size = [ground.naturalWidth || 4, ground.naturalHeight || 3];
    /** @type {Found[]} */
    const found = [];
    for (const event of events) {
        const how = answerOf(event, place, size, clockIn);
        if (how) found.push({event, how});
    }
    set({answer: {found, of: events.length, took: performance.now() - began}});
}

const grid = [48, 36];

export function drawHeat() {
    if (!state.answer) return;
    const [columns, rows] = grid;
    const canvas = at('heat', HTMLCanvasElement);
    [canvas.width, canvas.height] = grid;
    const cells = heatOf(state.answer.found.map(({event}) => event.way), columns, rows);
    canvas.getContext('2d')?.putImageData(new ImageData(coloursOf(cells), columns, rows), 0, 0);
}

export function drawHours() {
    if (!state.answer) return;
    const {found} = state.answer;
    const counts = new Array(24).fill(0);
    for (const {event, how} of found) ++counts[wallOf(event.clip.begins + how.at).getUTCHours()];
    const most = Math.max(1, ...counts);
    at('hours').replaceChildren(...counts.map((count, hour) => {
        const column = element('span');
        const bar = element('i');
        bar.style.height = count / most * 100 + '%';
        column.title = `${digits(hour)}:00 to ${digits(hour)}:59: ${many(count, 'event')}`;
        column.append(bar, element('small', '', hour % 3 ? '' : String(hour)));
        return column;
    }));
    const busiest = counts.indexOf(most);
    at('hours').ariaLabel = found.length ? `Events by hour of the day; most, ${most}, from ${busiest} to ${busiest + 1}` : 'No events';
}

const mostFound = 300;

/** @param {Found} found */
function itemOf({event, how}) {
    const link = element('a');
    link.href = event.clip.url + (event.clip.files & bits.page ? `.html#event=${event.number}` : '.png');
    link.addEventListener('click', () => see(event.clip));
    const when = wallOf(event.clip.begins + how.at);
    const lasts = (event.way[event.way.length - 3] - event.way[0]) / 10;
    const more = how.words() || (event.kind.tally === 'still' ? durationOf(event.still) : shortSpanOf(lasts));
    link.append(element('b', '', `${dayText(when)} ${timeText(when)}`), ' ', element('span', 'badge ' + event.kind.emphasis, event.kind.words), ' ',
                event.what ? event.what + ' ' : '', element('small', '', more));
    const item = element('li');
    item.append(link);
    return item;
}

export function drawFound() {
    const heading = at('foundheading');
    if (!state.answer) {
        heading.textContent = 'Loading…';
        return;
    }
    const {found, of} = state.answer;
    heading.textContent = state.place ? `${found.length.toLocaleString('en')} of ${many(of, 'event')}` : many(of, 'event');
    const items = sortedFound(found, !state.place).slice(0, mostFound).map(itemOf);
    const more = found.length - mostFound;
    if (more > 0) items.push(element('li', 'none', `${more.toLocaleString('en')} more: choose days, or draw a smaller area.`));
    if (!found.length) items.push(element('li', 'none', 'Nothing was here.'));
    at('found').replaceChildren(...items);
}

export function drawPlace() {
    drawShape(surface, state.drawn ?? state.place, [1000, 1000], 1000);
    at('askall').hidden = state.place === null;
}

export function drawTools() {
    press(at('askbox'), state.tool === 'box');
    press(at('askline'), state.tool === 'line');
    from.value = state.from;
    to.value = state.to;
}

/** @param {Shape | null} place in thousandths of the scene; null = everywhere */
export const askPlace = place => set({place, drawn: null});

export function listenToScene() {
    const lastDay = data.days[data.days.length - 1] ?? '';
    drawByPointer(surface, 1000, {kind: () => state.tool, shows: shape => set({drawn: shape}), asks: askPlace});
    at('askbox').addEventListener('click', () => set({tool: 'box'}));
    at('askline').addEventListener('click', () => set({tool: 'line'}));
    at('askall').addEventListener('click', () => askPlace(null));
    from.addEventListener('change', () => set({from: from.value}));
    to.addEventListener('change', () => set({to: to.value}));
    at('day').addEventListener('click', () => set({from: lastDay, to: lastDay}));
    at('week').addEventListener('click', () => set({from: lastDay && daysBefore(lastDay, 6), to: lastDay}));
    at('everything').addEventListener('click', () => set({from: '', to: ''}));
    ground.addEventListener('load', () => { at('stage').style.aspectRatio = String(ground.naturalWidth / ground.naturalHeight); });
}
