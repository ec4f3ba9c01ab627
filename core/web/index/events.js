// The events of an archive's days, which are loaded from files beside the index when somebody asks.

import {element} from '../shared/dom.js';
import {dayText} from '../shared/wall_clock.js';
import {eventOf} from './answers.js';
import {clipOfUrl, data, kindOf, wallOf} from './state.js';

/**
 * @typedef {import('./answers.js').SceneEvent} SceneEvent
 * @typedef {import('./clips.js').Clip} Clip
 */

/** @type {Map<string, SceneEvent[]>} */
const eventsOfDay = new Map();
/** @type {Map<string, SceneEvent[]>} */
const eventsOfClip = new Map();
/** @type {Map<string, number[]>} */
const stillsOfClip = new Map();
/** @type {Map<string, Promise<unknown>>} */
const waiting = new Map();

/**
 * Takes the events of a day. The files of days call it as `vvrDay`.
 * @param {string} day
 * @param {[url: string, events: import('./data.js').EventRow[], stills?: number[]][]} list
 */
export function takeDay(day, list) {
    for (const [url, rows, stills] of list) {
        const clip = clipOfUrl.get(url);
        if (!clip) continue;
        eventsOfClip.set(url, rows.map(row => eventOf(clip, row, kindOf)));
        if (stills) stillsOfClip.set(url, stills.map(tenths => tenths / 10));
    }
    eventsOfDay.set(day, list.flatMap(([url]) => eventsOfClip.get(url) ?? []));
}

/** @param {string} day */
export function loadDay(day) {
    const there = eventsOfDay.has(day) || !data.days.includes(day) ? Promise.resolve() : waiting.get(day) ?? new Promise(done => {
        const script = element('script');
        script.src = `index.${day}.js`;
        script.onload = done;
        script.onerror = () => { eventsOfDay.set(day, []); done(undefined); };
        document.head.append(script);
    });
    waiting.set(day, there);
    return there;
}

/** @param {string} day */
export const eventsOf = day => eventsOfDay.get(day) ?? [];

/**
 * The events of a clip whose day is loaded.
 * @param {Clip} clip
 */
export const eventsIn = clip => eventsOfClip.get(clip.url) ?? [];

/** @param {Clip} clip */
export const loadEventsOf = clip => loadDay(dayText(wallOf(clip.begins)));

/**
 * The seconds of the pictures on a clip's contact sheet; none = it has no sheet, or its day is not loaded.
 * @param {Clip} clip
 */
export const stillsOf = clip => stillsOfClip.get(clip.url) ?? [];
