// Days: a row for each, cameras as columns, in each cell the hours.

import {at, button, element} from '../shared/dom.js';
import {digits, grouped, many} from '../shared/text.js';
import {monthOf, weekday} from '../shared/wall_clock.js';
import {busiestHour, counted, eventsIn, hoursOf, pageOf, tallyWords} from './clips.js';
import {addressOfClip} from '../page/address.js';
import {bits} from './data.js';
import {noteOfNone, stretchOf} from './list.js';
import {ask, byCameraName, cameraName, chosenClips, data, search, see, state} from './state.js';

/** @typedef {import('./clips.js').Clip} Clip */

/**
 * The hours that have clips; the others are empty space.
 * @param {Clip[]} all
 * @param {number} most events in an hour of any cell
 */
function hoursOfCell(all, most) {
    const hours = element('span', 'hours');
    hoursOf(all.filter(clip => !clip.wholeDay)).forEach(({clips, events}, k) => {
        if (!clips) return;
        const hour = element('i', events === null ? 'unknown' : events === 0 ? 'quiet' : 'busy');
        hour.style.gridColumn = String(k + 1);
        hour.dataset.hour = String(k);
        hour.dataset.events = String(events ?? '');
        if (events) hour.style.opacity = String(0.25 + 0.75 * Math.sqrt(events / most));
        hours.append(hour);
    });
    return hours;
}

/**
 * Tells what an hour has, once somebody points at it: words for all would be most of the work.
 * @param {MouseEvent} event
 */
function tellHour({target}) {
    if (!(target instanceof HTMLElement) || target.dataset.hour === undefined) return;
    const {hour, events} = target.dataset;
    const told = events ? many(Number(events), 'event') + ' in' : 'no events are known of';
    target.title = `${digits(Number(hour))}:00 to ${digits(Number(hour))}:59: ${told} clips that begin then`;
}

/**
 * What is told of a cell, the most important first.
 * @param {Clip[]} list
 */
function tellingsOf(list) {
    const tellings = data.kinds.filter(({tally}) => tally === 'lasts' || tally === 'still')
        .map(kind => ({kind, longest: Math.max(...list.map(clip => clip.tallyOf[kind.name]))})).filter(({longest}) => longest > 0)
        .map(({kind, longest}) => ({words: tallyWords(kind, longest), className: 'badge ' + kind.emphasis}));
    const failed = list.filter(clip => clip.failed).length;
    return [...failed ? [{words: `✕${failed} failed`, className: 'bad'}] : [], ...tellings];
}

// An hour is too small for a finger.
const fingers = matchMedia('(pointer: coarse)');

/**
 * The hour that was clicked, if it has clips.
 * @param {MouseEvent} event
 */
function hourUnder({target}) {
    if (fingers.matches) return {};
    const hour = target instanceof HTMLElement && target.dataset.hour !== undefined ? Number(target.dataset.hour) : null;
    return hour === null ? {} : {since: digits(hour) + ':00', until: digits(hour + 1) + ':00'};
}

/**
 * @param {Clip[]} all of a day and a camera
 * @param {number} most events in an hour of any cell
 */
function cellOf(all, most) {
    const cell = element('td');
    if (!all.length) return cell;
    const list = counted(all);
    const {camera, day} = list[0];
    const events = eventsIn(list);
    const count = events === null ? [] : [{words: many(events, 'event'), className: ''}];
    const [first, ...more] = tellingsOf(list);
    // One line: bars stand at one height.
    const words = element('span', 'badges');
    words.append(...[...count, ...first ? [first] : []].map(({words: text, className}) => element('span', className, text)));
    if (more.length) words.append(Object.assign(element('span', '', '+' + more.length), {title: more.map(({words: text}) => text).join(', ')}));
    const made = button('', '');
    made.addEventListener('click', event => ask({view: 'clips', camera, from: day, to: day, ...hourUnder(event)}));
    made.append(hoursOfCell(all, most), words);
    made.ariaLabel = `${cameraName(camera)}, ${day}: ${[...count, ...first ? [first] : [], ...more].map(({words: text}) => text).join(', ')}`;
    cell.append(made);
    const recording = all.find(clip => clip.wholeDay && clip.drawn);
    if (recording) {
        const link = element('a', 'wholeday', stretchOf(recording));
        link.href = pageOf(recording) + (recording.files & bits.page ? addressOfClip(search()) : '');
        link.addEventListener('click', () => see(recording));
        cell.append(link);
    }
    return cell;
}

/**
 * @param {string} text
 * @param {'row' | 'col'} scope
 */
const headOf = (text, scope) => Object.assign(element('th', '', text), {scope});

const rowHeight = 58;  // about

/**
 * The days of a month.
 * @param {Map<string, Clip[]>} days
 * @param {number[]} cameras
 * @param {number} most events in an hour of any cell
 */
function tableOf(days, cameras, most) {
    const table = element('table');
    table.style.setProperty('contain-intrinsic-height', `auto ${rowHeight * (days.size + 1)}px`);
    const [first] = days.keys();
    const head = element('tr');
    head.append(element('td'), ...cameras.map(camera => {
        const cell = headOf('', 'col');
        const scale = element('span', 'scale');
        scale.setAttribute('aria-hidden', 'true');
        for (let hour = 0; hour <= 24; hour += 6) scale.append(element('i', '', String(hour)));
        cell.append(element('bdi', '', cameraName(camera)), scale);
        return cell;
    }));
    table.append(element('caption', '', monthOf(first)), head, ...[...days].map(([day, ofDay]) => {
        const row = element('tr');
        const byCamera = grouped(ofDay, 'camera');
        row.append(headOf(`${weekday(day).slice(0, 3)} ${day.slice(8)}`, 'row'), ...cameras.map(camera => cellOf(byCamera.get(camera) ?? [], most)));
        return row;
    }));
    return table;
}

let drawings = 0;

export function drawDays() {
    if (state.view !== 'days') return;
    const list = chosenClips();
    const cameras = [...new Set(list.map(clip => clip.camera))].sort(byCameraName);
    at('overview').style.setProperty('--cameras', String(cameras.length));
    const most = busiestHour(list);
    /** @type {Map<string, Map<string, Clip[]>>} */
    const months = new Map();
    for (const [day, ofDay] of grouped(list, 'day')) {
        const month = day.slice(0, 7);
        months.set(month, (months.get(month) ?? new Map()).set(day, ofDay));
    }
    const hint = element('p', 'hint', `Each box is an hour. The stronger its colour, the more events (at most ${most}). `);
    hint.append(element('span', 'how', fingers.matches ? 'Tap a day to see its clips.' : 'Click an hour, or a day, to see its clips.'));
    const waiting = [...months.values()];
    const tables = (/** @type {number} */ count) => waiting.splice(0, count).map(days => tableOf(days, cameras, most));
    at('overview').replaceChildren(...list.length ? [hint, ...tables(3)] : [noteOfNone()]);
    // Nobody sees more at once.
    const drawn = ++drawings;
    const goOn = () => {
        if (!waiting.length || drawn !== drawings) return;
        at('overview').append(...tables(1));
        setTimeout(goOn);
    };
    setTimeout(goOn);
}

export const listenToDays = () => at('overview').addEventListener('pointerover', tellHour);
