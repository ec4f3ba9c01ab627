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
 * @param {Clip[]} all
 * @param {number} most events in an hour of any cell
 */
function hoursOfCell(all, most) {
    const hours = element('span', 'hours');
    hoursOf(all.filter(clip => !clip.wholeDay)).forEach(({clips, events}, k) => {
        const hour = element('i', !clips ? 'nothing' : events === null ? 'unknown' : events === 0 ? 'quiet' : 'busy');
        const told = events === null ? 'no events are known of' : many(events, 'event') + ' in';
        hour.title = `${digits(k)}:00 to ${digits(k)}:59: ${clips ? told + ' clips that begin then' : 'no clip begins'}`;
        hour.dataset.hour = String(k);
        if (events) hour.style.opacity = String(0.25 + 0.75 * Math.sqrt(events / most));
        hours.append(hour);
    });
    return hours;
}

/** @param {Clip[]} list */
function wordsOfCell(list) {
    const words = element('span', 'badges');
    const events = eventsIn(list);
    if (events !== null) words.append(element('span', '', many(events, 'event')));
    for (const kind of data.kinds.filter(({tally}) => tally === 'lasts' || tally === 'still')) {
        const longest = Math.max(...list.map(clip => clip.tallyOf[kind.name]));
        if (longest > 0) words.append(element('span', 'badge ' + kind.emphasis, tallyWords(kind, longest)));
    }
    const failed = list.filter(clip => clip.failed).length;
    if (failed) words.append(element('span', 'bad', `✕${failed} failed`));
    return words;
}

// An hour is too small for a finger.
const fingers = matchMedia('(pointer: coarse)');

/**
 * The hour that was clicked, if it has clips.
 * @param {MouseEvent} event
 */
function hourUnder({target}) {
    if (fingers.matches) return {};
    const hour = target instanceof HTMLElement && target.matches('.unknown, .quiet, .busy') ? Number(target.dataset.hour) : null;
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
    const words = wordsOfCell(list);
    const made = button('', '');
    made.addEventListener('click', event => ask({view: 'clips', camera, from: day, to: day, ...hourUnder(event)}));
    made.append(hoursOfCell(all, most), words);
    made.ariaLabel = `${cameraName(camera)}, ${day}: ${[...words.children].map(word => word.textContent).join(', ')}`;
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

export function drawDays() {
    if (state.view !== 'days') return;
    const list = chosenClips();
    const table = element('table');
    const cameras = [...new Set(list.map(clip => clip.camera))].sort(byCameraName);
    const head = element('tr');
    head.append(element('td'), ...cameras.map(camera => {
        const cell = headOf('', 'col');
        const scale = element('span', 'scale');
        scale.setAttribute('aria-hidden', 'true');
        for (let hour = 0; hour <= 24; hour += 6) scale.append(element('i', '', String(hour)));
        cell.append(element('bdi', '', cameraName(camera)), scale);
        return cell;
    }));
    table.append(head);
    const most = busiestHour(list);
    let month = '';
    for (const [day, ofDay] of grouped(list, 'day')) {
        if (day.slice(0, 7) !== month) {
            month = day.slice(0, 7);
            const row = element('tr', 'month');
            row.append(Object.assign(element('th', '', monthOf(day)), {colSpan: cameras.length + 1}));
            table.append(row);
        }
        const row = element('tr');
        const byCamera = grouped(ofDay, 'camera');
        row.append(headOf(`${weekday(day).slice(0, 3)} ${day.slice(8)}`, 'row'), ...cameras.map(camera => cellOf(byCamera.get(camera) ?? [], most)));
        table.append(row);
    }
    const hint = element('p', 'hint', `Each box is an hour. The stronger its colour, the more events (at most ${most}). `);
    hint.append(element('span', 'how', fingers.matches ? 'Tap a day to see its clips.' : 'Click an hour, or a day, to see its clips.'));
    at('overview').replaceChildren(...list.length ? [hint, table] : [noteOfNone()]);
}
