// Days: a row for each, cameras as columns, in each cell the hours.

import {at, button, element} from '../shared/dom.js';
import {durationOf} from '../shared/durations.js';
import {grouped, many} from '../shared/text.js';
import {monthOf, weekday} from '../shared/wall_clock.js';
import {busiestHour, counted, eventsIn, hoursOf, pageOf} from './clips.js';
import {stretchOf} from './list.js';
import {see} from './seen.js';
import {ask, cameraName, chosenClips, data, state} from './state.js';

/** @typedef {import('./clips.js').Clip} Clip */

/**
 * @param {Clip[]} all
 * @param {number} most events in an hour of any cell
 */
function hoursOfCell(all, most) {
    const hours = element('span', 'hours');
    for (const count of hoursOf(all.filter(clip => !clip.wholeDay))) {
        const hour = element('i', count === null ? 'nothing' : count === 0 ? 'quiet' : 'busy');
        if (count) hour.style.opacity = String(0.25 + 0.75 * Math.sqrt(count / most));
        hours.append(hour);
    }
    return hours;
}

/** @param {Clip[]} list */
function wordsOfCell(list) {
    const words = element('span', 'badges');
    words.append(element('span', '', many(eventsIn(list), 'event')));
    for (const {name, emphasis} of data.kinds.filter(({tally}) => tally === 'lasts' || tally === 'still')) {
        const longest = Math.max(...list.map(clip => clip.tallyOf[name]));
        if (longest > 0) words.append(element('span', 'badge ' + emphasis, name + ' ' + durationOf(longest)));
    }
    const failed = list.filter(clip => clip.failed).length;
    if (failed) words.append(element('span', 'bad', `✕${failed} failed`));
    return words;
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
    const made = button('', '', () => ask({view: 'clips', camera, day}));
    made.append(hoursOfCell(all, most), words);
    made.ariaLabel = `${cameraName(camera)}, ${day}: ${words.textContent}`;
    cell.append(made);
    const recording = all.find(clip => clip.wholeDay && clip.drawn);
    if (recording) {
        const link = element('a', 'wholeday', stretchOf(recording));
        link.href = pageOf(recording);
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
    const cameras = [...new Set(list.map(clip => clip.camera))].sort((a, b) => a - b);
    const head = element('tr');
    head.append(element('td'), ...cameras.map(camera => headOf(cameraName(camera), 'col')));
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
    const hint = element('p', 'hint', 'Each little box is an hour of the day, 0 to 23: the stronger its colour, the more events. Click a cell for its clips.');
    at('overview').replaceChildren(list.length ? hint : element('p', 'empty', 'Nothing here is like that.'), table);
}
