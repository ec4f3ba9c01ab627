// The filters: which clips and events are shown.

import {at, element} from '../shared/dom.js';
import {isNight, timeWords} from '../shared/day_time.js';
import {many} from '../shared/text.js';
import {daysBefore} from '../shared/wall_clock.js';
import {nothingAsked} from './query.js';
import {ask, choices, chosenClips, clips, data, set, span, state} from './state.js';

const text = at('text', HTMLInputElement);
const classes = at('class', HTMLSelectElement);
const order = at('order', HTMLSelectElement);
const day = at('day', HTMLSelectElement);
const time = at('time', HTMLSelectElement);
const fields = {from: at('from', HTMLInputElement), to: at('to', HTMLInputElement), since: at('since', HTMLInputElement), until: at('until', HTMLInputElement)};
const kinds = () => /** @type {HTMLInputElement[]} */ ([...document.getElementsByName('kind')]);

const mostDays = 31;
const allDays = [...new Set(clips.map(clip => clip.day))].sort().reverse();
const lastDay = allDays[0] ?? '';

/**
 * "Tue 17 Nov"
 * @param {string} date as 2026-11-17
 */
export const dayWords = date => new Date(date + 'T00:00:00Z').toLocaleDateString('en-GB', {weekday: 'short', day: 'numeric', month: 'short', timeZone: 'UTC'}).replace(',', '');

/**
 * What can be chosen from the lists of days and times: words, and what is asked then.
 * @type {[string, string, string][]}
 */
const days = [['Any day', '', ''], ...lastDay ? [/** @type {[string, string, string]} */ (['Last 7 days', daysBefore(lastDay, 6), lastDay])] : [],
              ...allDays.slice(0, mostDays).map(date => /** @type {[string, string, string]} */ ([dayWords(date), date, date]))];
/** @type {[string, string, string][]} */
const times = [['Any time', '', ''], ['Day, 06:00 to 20:00', '06:00', '20:00'], ['Night, 20:00 to 06:00', '20:00', '06:00'], ['After 20:00', '20:00', ''],
               ['Before 06:00', '', '06:00']];

/** @type {(rows: [string, string, string][], from: string, to: string) => number} */
const rowOf = (rows, from, to) => rows.findIndex(([, first, last]) => first === from && last === to);

/**
 * A choice of rows, and one to enter others.
 * @param {HTMLSelectElement} list
 * @param {[string, string, string][]} rows
 */
const fill = (list, rows) => list.append(...[...rows.map(([words]) => words), 'Other…'].map((words, k) => Object.assign(element('option', '', words), {value: String(k)})));

/** A text that is being typed stays as it is. */
export function drawFilters() {
    const {from, to, since, until} = state;
    if (text.value.trim() !== state.text) text.value = state.text;
    order.value = state.order;
    classes.value = state.class;
    for (const radio of kinds()) radio.checked = radio.value === state.kind;
    for (const name of /** @type {const} */ (['from', 'to', 'since', 'until'])) fields[name].value = state[name];
    const [dayRow, timeRow] = [rowOf(days, from, to), rowOf(times, since, until)];
    const [otherDays, otherTimes] = [state.days || dayRow < 0, state.times || timeRow < 0];
    day.value = String(otherDays ? days.length : dayRow);
    time.value = String(otherTimes ? times.length : timeRow);
    at('dates').hidden = !otherDays;
    at('hoursasked').hidden = !otherTimes;
}

/** What is asked for, in words. */
export function askedWords() {
    const {from, to, since, until} = span();
    const dates = !from && !to ? '' : from === to ? dayWords(from) : `${from ? dayWords(from) : 'the first day'} to ${to ? dayWords(to) : 'the last'}`;
    const night = isNight(span()) ? ' of the next day' : '';
    return [dates, timeWords({since, until}) + night].filter(Boolean).join(', ');
}

export function drawCount() {
    const list = chosenClips();
    const isAll = Object.entries(nothingAsked).every(([name, value]) => ['view', 'order'].includes(name) || state[/** @type {keyof typeof nothingAsked} */ (name)] === value);
    const words = askedWords();
    const of = state.view === 'scene' || list.length === clips.length ? '' : `${list.length.toLocaleString('en')} of ${many(clips.length, 'clip')}`;
    at('count').textContent = [of, words].filter(Boolean).join(' · ');
    at('clear').hidden = isAll;
    at('filtering').textContent = isAll ? 'Filters' : 'Filters ●';
}

/** @param {number} row */
function takeDay(row) {
    state.days = row === days.length;
    if (!state.days) ask({from: days[row][1], to: days[row][2]});
    else set({});
}

/** @param {number} row */
function takeTime(row) {
    state.times = row === times.length;
    if (!state.times) ask({since: times[row][1], until: times[row][2]});
    else set({});
}

/** Asks for everything again, in the same view and order. */
export const clear = () => {
    Object.assign(state, {days: false, times: false, drawn: null});
    ask({...nothingAsked, view: state.view, order: state.order});
};

export function listenToFilters() {
    fill(day, days);
    fill(time, times);
    classes.append(...choices.known.class.map(name => {
        const words = name === '' ? 'Everything' : (Object.hasOwn(data.classes, name) ? '' : '\u2013 ') + name;
        return Object.assign(element('option', '', words), {value: name});
    }));
    classes.hidden = choices.classes.size === 0;
    let typing = 0;
    text.addEventListener('input', () => {
        clearTimeout(typing);
        typing = window.setTimeout(() => ask({text: text.value.trim()}), 120);
    });
    for (const radio of kinds()) radio.addEventListener('change', () => ask({kind: radio.value}));
    classes.addEventListener('change', () => ask({class: classes.value}));
    order.addEventListener('change', () => ask({order: order.value}));
    day.addEventListener('change', () => takeDay(Number(day.value)));
    time.addEventListener('change', () => takeTime(Number(time.value)));
    for (const [name, field] of Object.entries(fields)) field.addEventListener('change', () => ask({[name]: field.value}));
    at('clear').addEventListener('click', clear);
    at('filtering').addEventListener('click', () => { at('filtering').ariaExpanded = String(at('tools').classList.toggle('open')); });
    at('tools').addEventListener('submit', event => event.preventDefault());
}
