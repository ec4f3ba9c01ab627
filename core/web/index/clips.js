// The clips of an archive.

import {durationOf} from '../shared/durations.js';
import {folded, grouped, many, readable, upright} from '../shared/text.js';
import {dayText, timeText, weekday} from '../shared/wall_clock.js';
import {bits} from './data.js';

/**
 * @typedef {import('./data.js').IndexData} IndexData
 *
 * @typedef {object} Clip
 * @property {number} camera
 * @property {string} url
 * @property {string} path
 * @property {string} name
 * @property {number} begins seconds since 1970
 * @property {number} seconds
 * @property {string} day 2026-11-21
 * @property {string} time 07:15:02
 * @property {string} clock 07:15, with seconds only where the camera has another clip in that minute
 * @property {number} hour
 * @property {number | null} events null = unknown
 * @property {number} files bits
 * @property {Record<string, number>} tallyOf by kind
 * @property {string[]} classes
 * @property {boolean} wholeDay whether it is all that a camera recorded on a day
 * @property {boolean} night whether that is the night after the day
 * @property {number | undefined} status
 * @property {string} reason why it failed, or what its picture lacks; '' = neither
 * @property {number | undefined} tries
 * @property {boolean} failed
 * @property {boolean} drawn whether there is a picture
 * @property {string} until what an older picture shows; '' = none
 * @property {boolean} gone
 * @property {string[]} faults of the recording
 * @property {string} placedBy why it is at this time, if nothing tells when it was recorded
 * @property {string} text that is searched
 */

/**
 * @param {IndexData} data
 * @param {(seconds: number) => Date} wallOf
 * @returns {(row: import('./data.js').Row, recording?: {date: string, night: boolean, clips: number}) => Clip}
 */
function clipBy(data, wallOf) {
    return ([camera, url, begins, seconds, events, files, tallies, classes, faults, status, reason = '', tries, until], recording) => {
        const date = wallOf(begins);
        const path = readable(url).replace(/^\.\//, '');
        const [day, time] = [recording?.date ?? dayText(date), timeText(date)];
        const shown = until === undefined ? '' : dayText(wallOf(until)) + ' ' + timeText(wallOf(until));
        const failed = typeof status === 'number';
        return {
            camera, url, path, begins, seconds, day, time, clock: time.slice(0, 5), events, files, status: status ?? undefined, tries, failed,
            name: recording ? many(recording.clips, 'clip') : path.slice(path.lastIndexOf('/') + 1),
            hour: date.getUTCHours(),
            tallyOf: Object.fromEntries(data.kinds.map(({name}, rank) => [name, tallies?.[rank] ?? 0])),
            classes: classes ?? [],
            wholeDay: recording !== undefined,
            night: recording?.night ?? false,
            reason: upright(reason),
            until: shown,
            drawn: !failed || shown !== '',
            gone: (files & bits.gone) !== 0,
            faults: faults ?? [],
            placedBy: files & bits.byContainer ? 'when its container says it was written' : files & bits.byFile ? 'when it was last written' : '',
            text: folded([data.cameras[camera], path, day, weekday(day), time, recording?.night ? 'night of ' + day : '', reason, ...classes ?? [], ...faults ?? []].join(' ')),
        };
    };
}

/**
 * All clips and recordings, the newest first.
 * @param {IndexData} data
 * @param {(seconds: number) => Date} wallOf
 */
export function clipsOf(data, wallOf) {
    const clipOf = clipBy(data, wallOf);
    const single = data.clips.map(row => clipOf(row));
    /** @type {Map<string, Clip>} */
    const first = new Map();
    for (const clip of single) {
        const minute = [clip.camera, clip.day, clip.time.slice(0, 5)].join();
        const other = first.get(minute);
        if (other) other.clock = other.time;
        if (other) clip.clock = clip.time;
        first.set(minute, clip);
    }
    return [...single, ...data.recordings.map(recording => clipOf(recording.row, recording))]
        .sort((a, b) => b.begins - a.begins || (a.url < b.url ? -1 : 1));
}

/** @type {(clip: Clip) => string} */
export const pageOf = clip => clip.url + (clip.files & bits.page ? '.html' : '.png');

/**
 * The clips that count: a picture of a camera's day or night repeats those that begin in it.
 * @param {Clip[]} list
 */
export function counted(list) {
    const single = grouped(list.filter(clip => !clip.wholeDay), 'camera');
    /** @type {(clip: Clip) => boolean} */
    const repeats = ({camera, begins, seconds}) =>
        (single.get(camera) ?? []).some(clip => clip.begins >= begins && clip.begins <= begins + seconds);
    return list.filter(clip => !clip.wholeDay || !repeats(clip));
}

/**
 * The events of clips; null = no clip's are known, as all failed.
 * @param {Clip[]} list
 * @returns {number | null}
 */
export function eventsIn(list) {
    const known = list.flatMap(({events}) => events ?? []);
    return known.length || !list.length ? known.reduce((sum, count) => sum + count, 0) : null;
}

/**
 * What is told of a clip's events of a kind: "left behind for 26 s", "taken", "2 taken".
 * @param {import('../shared/kinds.js').KindRow} kind
 * @param {number} told seconds, or how many
 */
export const tallyWords = ({words, tally}, told) => tally !== 'count' ? `${words} for ${durationOf(told)}` : told > 1 ? `${told} ${words}` : words;

/** @param {Clip} clip */
export const failureOf = clip => `Failed ${clip.tries === 1 ? 'once' : clip.tries + ' times'}`;

/**
 * Where the times of clips come from, the most frequent source first: "file names (4), when files were written (1)".
 * @param {Clip[]} clips
 */
export function sourcesOf(clips) {
    const sources = {'file names': 0, 'creation times in containers': 0, 'when files were last written': 0};
    for (const {files} of clips) {
        ++sources[files & bits.byContainer ? 'creation times in containers' : files & bits.byFile ? 'when files were last written' : 'file names'];
    }
    const used = Object.entries(sources).filter(([, count]) => count > 0).sort((a, b) => b[1] - a[1]);
    return used.map(([words, count]) => used.length > 1 ? `${words} (${count.toLocaleString('en')})` : words).join(', ');
}

/**
 * The summary of the archive.
 * @param {Clip[]} clips
 * @param {IndexData} data
 */
export function summaryOf(clips, data) {
    const failures = counted(clips).filter(clip => clip.failed).length;
    const gone = clips.filter(clip => clip.gone).length;
    const zones = data.zone.length ? [...new Set(data.zone.map(([, , name]) => name))].join(', then ') : 'UTC';
    const sources = sourcesOf(counted(clips));
    const events = eventsIn(counted(clips));
    return [many(counted(clips).length, 'clip'), many(data.cameras.length, 'camera'), events === null ? '' : many(events, 'event'),
            failures ? many(failures, 'failure') : '', gone ? `${gone} gone` : '', `times in ${zones}${sources && ', from ' + sources}`].filter(Boolean).join(' · ');
}

/**
 * For each hour of a day, how many clips begin in it, and their events.
 * @param {Clip[]} list
 */
export function hoursOf(list) {
    /** @type {Clip[][]} */
    const hours = Array.from({length: 24}, () => []);
    for (const clip of list) hours[clip.hour].push(clip);
    return hours.map(clips => ({clips: clips.length, events: eventsIn(clips)}));
}

/**
 * The most events that a camera has in an hour, at least 1.
 * @param {Clip[]} list
 */
export function busiestHour(list) {
    const days = grouped(list.filter(clip => !clip.wholeDay), 'day');
    const cells = [...days.values()].flatMap(ofDay => [...grouped(ofDay, 'camera').values()]);
    return cells.reduce((most, cell) => Math.max(most, ...hoursOf(cell).map(({events}) => events ?? 0)), 1);
}

/**
 * The clip of the same camera before or after another one, which need not be in the list; null = there is none. A
 * picture of a whole day leads to other days.
 * @param {Clip[]} list the newest first
 * @param {Clip} clip
 * @param {number} by 1 = after, -1 = before
 */
export function neighbourOf(list, clip, by) {
    const alike = list.filter(other => other.camera === clip.camera && other.drawn && other.wholeDay === clip.wholeDay && other !== clip);
    const isLater = (/** @type {Clip} */ other) => other.begins > clip.begins || (other.begins === clip.begins && other.url < clip.url);
    return (by > 0 ? alike.findLast(isLater) : alike.find(other => !isLater(other))) ?? null;
}
