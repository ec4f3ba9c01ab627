// The index's own logic: clips, what is asked of them, orders, and answers of the scene.

import assert from 'node:assert/strict';
import test from 'node:test';
import {answerOf, coloursOf, daysBetween, eventOf, heatOf, hitBeside, ofWay, sortedFound, waysOf} from '../../core/web/index/answers.js';
import {busiestHour, clipsOf, counted, eventsIn, failureOf, hoursOf, neighbourOf, pageOf, summaryOf} from '../../core/web/index/clips.js';
import {choicesIn, chosenOf, isOf, isOfChoice, nothingAsked, readQuery, sortedBy, spanOf, writeQuery} from '../../core/web/index/query.js';
import {nearestStill, sheetPlace, stillsBetween} from '../../core/web/index/sheet.js';
import {isWithin, overlaps, timeWords, timesIn} from '../../core/web/shared/day_time.js';
import {wallIn} from '../../core/web/shared/wall_clock.js';

const kind = (name, tally, choice) =>
    ({name, words: name, by: 'by', isThing: false, isOfScene: name === 'taken', emphasis: 'none', tally, choice});
const day = Date.UTC(2026, 10, 21) / 1000;
const hour = 3600;
const data = {
    cameras: ['', 'gate', 'Übergabe'],
    zone: [[0, 3600, 'CET']],
    kinds: [kind('left', 'lasts', 'left'), kind('taken', 'count', 'left'), kind('stood', 'still', 'stood'), kind('moved', 'none', null)],
    classes: {person: ['person'], vehicle: ['bus', 'car']},
    // camera, URL, begin, seconds, events, files, tallies, classes, faults, and of failures: status, reason, tries, until
    clips: [[1, './gate/a.mp4', day + 7 * hour, 20, 2, 1 | 2 | 16, [26, 0, 0, 0], ['car'], null],
            [1, './gate/b.mp4', day + 8 * hour, 20, 9, 1 | 1024, [0, 2, 185, 0], ['person'], ['no new pictures for 20.0 s']],
            [1, './gate/c.mp4', day + 9 * hour, 0, null, 0, null, null, null, 3, 'no\u202evideo', 1],
            [2, './%C3%9C/d%20e.mp4', day + 23.5 * hour, 5, 0, 1 | 256 | 2048, [0, 0, 0, 0], null, null],
            [1, './gate/f.mp4', day - 30 * hour, 5, 1, 1 | 2, [26, 1, 0, 0], null, null, 6, 'disk full', 4, day]],
    recordings: [{date: '2026-11-21', clips: 3, row: [1, './gate/2026-11-21', day + 7 * hour, 7220, 11, 1 | 2, [26, 2, 185, 0], null, null]}],
    days: ['2026-11-19', '2026-11-21', '2026-11-24'],
};
const clips = clipsOf(data, wallIn(data.zone));
const choices = choicesIn(data);
const named = list => list.map(clip => clip.url.split('/').pop());
const unseen = () => false;

test('a time has seconds only where a camera has two clips in a minute', () => {
    const row = (camera, seconds) => [camera, `${camera}/${seconds}`, seconds, 5, 0, 0, null, null, null];
    const few = clipsOf({...data, zone: [[0, 0, 'UTC']], clips: [row(0, 60), row(0, 90), row(1, 61), row(0, 120)], recordings: []}, wallIn([[0, 0, 'UTC']]));
    assert.deepEqual(few.map(clip => [clip.camera, clip.clock]), [[0, '00:02'], [0, '00:01:30'], [1, '00:01'], [0, '00:01:00']]);
});

test('clips are read from their rows, the newest first', () => {
    assert.deepEqual(named(clips), ['d%20e.mp4', 'c.mp4', 'b.mp4', '2026-11-21', 'a.mp4', 'f.mp4']);
    const [d, c, b, whole, a, f] = clips;
    assert.deepEqual([d.path, d.name, d.day, d.time, d.hour, d.gone], ['Ü/d e.mp4', 'd e.mp4', '2026-11-22', '00:30:00', 0, true]);
    assert.deepEqual([d.placedBy, b.placedBy, a.placedBy], ['when it was last written', 'when its container says it was written', '']);
    assert.deepEqual([c.failed, c.drawn, c.reason, failureOf(c)], [true, false, 'no[U+202E]video', 'Failed once']);
    assert.deepEqual([f.failed, f.drawn, f.until, failureOf(f)], [true, true, '2026-11-21 01:00:00', 'Failed 4 times']);
    assert.deepEqual([b.faults, a.faults, a.tallyOf, c.tallyOf.left], [['no new pictures for 20.0 s'], [], {left: 26, taken: 0, stood: 0, moved: 0}, 0]);
    assert.deepEqual([whole.wholeDay, whole.name, whole.day, whole.hour], [true, '3 clips', '2026-11-21', 8]);
    assert.deepEqual([pageOf(a), pageOf(b)], ['./gate/a.mp4.html', './gate/b.mp4.png']);
});

test('a whole day is not counted again', () => {
    assert.equal(summaryOf(clips, data), '5 clips · 3 cameras · 12 events · 2 failures · 1 gone · times in CET, from file names (3), creation times in containers (1), when files were last written (1)');
    assert.deepEqual(named(counted(clips.filter(clip => clip.wholeDay))), ['2026-11-21']);
    assert.equal(eventsIn(counted(clips)), 12);
    assert.equal(eventsIn(clips.filter(clip => clip.url.endsWith('c.mp4'))), null);  // failed
    assert.match(summaryOf([], {...data, cameras: [], zone: []}), /^0 clips · 0 cameras · 0 events · times in UTC$/);
});

test('hours of a day', () => {
    const hours = hoursOf(clips.filter(clip => clip.day === '2026-11-21' && !clip.wholeDay));
    assert.equal(hours.length, 24);
    assert.deepEqual(hours.slice(8, 12).map(({events}) => events), [2, 9, null, 0]);  // a clip that failed, and no clip
    assert.deepEqual(hours.slice(8, 12).map(({clips: count}) => count), [1, 1, 1, 0]);
    assert.equal(busiestHour(clips), 9);
    assert.equal(busiestHour([]), 1);
});

test('the clip before and the one after, of the same camera and with a picture', () => {
    const of = name => clips.find(clip => clip.url.endsWith(name));
    assert.equal(neighbourOf(clips, of('b.mp4'), -1), of('a.mp4'));  // not the picture of the whole day between them
    assert.equal(neighbourOf(clips, of('a.mp4'), -1), of('f.mp4'));
    assert.equal(neighbourOf(clips, of('f.mp4'), -1), null);
    assert.equal(neighbourOf(clips, of('b.mp4'), 1), null);  // c failed
    assert.equal(neighbourOf(clips, of('f.mp4'), 1), of('a.mp4'));
    assert.equal(neighbourOf(clips, of('2026-11-21'), 1), null);
    // Of a list from which the clip itself is gone, as it has been seen.
    assert.equal(neighbourOf(clips.filter(clip => clip !== of('a.mp4')), of('a.mp4'), 1), of('b.mp4'));
    assert.equal(neighbourOf([of('f.mp4')], of('b.mp4'), -1), of('f.mp4'));
});

test('what is asked for', () => {
    const chosen = (query, isSeen = unseen) => named(chosenOf(clips, {...nothingAsked, ...query}, choices, isSeen, wallIn(data.zone)));
    assert.equal(chosen({}).length, 6);
    assert.deepEqual(chosen({camera: 2}), ['d%20e.mp4']);
    assert.deepEqual(chosen({kind: 'events'}), ['b.mp4', '2026-11-21', 'a.mp4', 'f.mp4']);
    assert.deepEqual(chosen({kind: 'left'}), ['b.mp4', '2026-11-21', 'a.mp4', 'f.mp4']);  // left, or taken
    assert.deepEqual(chosen({kind: 'stood'}), ['b.mp4', '2026-11-21']);
    assert.deepEqual(chosen({kind: 'failed'}), ['c.mp4', 'f.mp4']);
    assert.deepEqual(chosen({kind: 'unseen'}, clip => clip.url.endsWith('b.mp4')), ['d%20e.mp4', '2026-11-21', 'a.mp4', 'f.mp4']);
    assert.deepEqual(chosen({class: 'vehicle'}), ['a.mp4']);
    assert.deepEqual(chosen({class: 'person'}), ['b.mp4']);
    assert.deepEqual(chosen({from: '2026-11-22', to: '2026-11-22'}), ['d%20e.mp4']);
    assert.deepEqual(chosen({to: '2026-11-20'}), ['f.mp4']);
    assert.deepEqual(chosen({from: '2026-11-21', to: '2026-11-21'}), ['c.mp4', 'b.mp4', '2026-11-21', 'a.mp4']);
    assert.deepEqual(chosen({camera: 1, since: '09:00', until: '10:00'}), ['b.mp4', '2026-11-21']);  // a whole day has all hours
    assert.deepEqual(chosen({since: '22:00', until: '06:00'}), ['d%20e.mp4', '2026-11-21']);
    assert.deepEqual(chosen({text: 'saturday after 9'}), ['c.mp4', 'b.mp4', '2026-11-21']);
    assert.deepEqual(chosen({text: 'uebergabe'}), ['d%20e.mp4']);
    assert.deepEqual(chosen({text: 'GATE sat 08:0'}), ['2026-11-21', 'a.mp4']);
    assert.deepEqual(chosen({text: 'gate xyz'}), []);
    assert.deepEqual([isOf(choices, '', []), isOf(choices, 'bus', ['car']), isOf(choices, 'vehicle', ['car']), isOf(choices, 'none', ['car'])],
                     [true, false, true, false]);
});

test('orders: what failed is last, and days are first', () => {
    const sorted = order => named(sortedBy(clips, order, choices));
    assert.deepEqual(sorted('events'), ['2026-11-21', 'b.mp4', 'a.mp4', 'f.mp4', 'd%20e.mp4', 'c.mp4']);
    assert.deepEqual(sorted('left'), ['2026-11-21', 'f.mp4', 'a.mp4', 'b.mp4', 'd%20e.mp4', 'c.mp4']);  // 26 s and one taken before 26 s
    assert.deepEqual(sorted('stood'), ['2026-11-21', 'b.mp4', 'd%20e.mp4', 'a.mp4', 'f.mp4', 'c.mp4']);  // others keep their order
});

test('the address keeps what is asked', () => {
    const queries = [{}, {view: 'scene', text: 'a & b=c #1', camera: 2, from: '2026-11-21', to: '2026-11-22'},
                     {since: '20:00', until: '06:00', place: {kind: 'line', from: [500, 0], to: [500, 1000]}, way: -1},
                     {until: '24:00', place: {kind: 'box', from: [10, 20], to: [400, 1000]}}, {kind: 'left', class: 'vehicle', order: 'stood'}, {camera: 0}];
    for (const change of queries) {
        const query = {...nothingAsked, ...change};
        assert.deepEqual(readQuery(writeQuery(query, choices, data.cameras), choices, data.cameras), query);
    }
    assert.equal(writeQuery(nothingAsked, choices, data.cameras), '#');
    assert.deepEqual(readQuery('#from=yesterday&since=25:00&until=7&place=line.1.2.3&way=1', choices, data.cameras), nothingAsked);
    assert.deepEqual(readQuery('#view=constructor&kind=x&class=lorry&order=&camera=none', choices, data.cameras), nothingAsked);
    assert.deepEqual(choices.known, {view: ['clips', 'days', 'scene'], kind: ['all', 'events', 'left', 'stood', 'unseen', 'failed'],
                                     class: ['', 'person', 'person', 'vehicle', 'bus', 'car'].filter((name, k, all) => all.indexOf(name) === k),
                                     order: ['newest', 'oldest', 'left', 'stood', 'events']});
});

// ---- Scene

const kindOf = name => ({...kind(name, 'none', null), rank: ['left', 'moved'].indexOf(name)});
const clip = clips.find(one => one.url.endsWith('a.mp4'));
const sceneEvent = (name, ...row) => eventOf(clip, [name, 1, 0, ...row], kindOf);
const clock = {has: () => true, text: (_, seconds) => `+${seconds}`};

test('events of a day', () => {
    const found = eventOf(clip, ['left', 4, 255, 10, 500, 600, 270, 400, 700, 'car'], kindOf);
    assert.deepEqual([found.kind.name, found.number, found.still, found.what], ['left', 4, 25.5, 'car']);
    assert.deepEqual([found.way, found.bounds], [[10, 500, 600, 270, 400, 700], [400, 600, 500, 700]]);
    assert.equal(sceneEvent('moved', 0, 1, 1).what, '');
});

test('answers for a place', () => {
    const walker = sceneEvent('moved', 100, 0, 500, 300, 1000, 500);  // from 10 s to 30 s, from left to right
    const answer = (place, way = 0, time = clock) => answerOf(walker, place, way, [640, 480], time);
    assert.deepEqual([answer(null).at, answer(null).words()], [10, '']);
    const stay = answer({kind: 'box', from: [250, 400], to: [500, 600]});
    assert.deepEqual([stay.at, stay.words()], [15, 'here 5.0 s']);
    assert.equal(answer({kind: 'box', from: [0, 0], to: [1000, 400]}), null);
    const line = answer({kind: 'line', from: [500, 0], to: [500, 1000]});
    assert.deepEqual([line.at, line.words()], [20, 'crossed → +20']);
    assert.equal(answer({kind: 'line', from: [500, 600], to: [500, 1000]}), null);
    assert.deepEqual(line.ways, [-1]);
    // Only what happens within the time.
    const before = end => ({...clock, has: (_, seconds) => seconds < end});
    assert.equal(answer({kind: 'line', from: [500, 0], to: [500, 1000]}, 0, before(20)), null);
    assert.equal(answer({kind: 'box', from: [250, 400], to: [500, 600]}, 0, before(15)), null);
    assert.equal(answer(null, 0, {...clock, has: (_, seconds) => seconds >= 25}).at, 30);
});

test('an object that comes to a place again is found at the later time too', () => {
    const pacer = sceneEvent('moved', 0, 0, 500, 100, 1000, 500, 3000, 1000, 500, 3100, 0, 500);  // to the right, and 5 minutes later back
    const place = {kind: 'box', from: [250, 400], to: [500, 600]};
    const from = begin => answerOf(pacer, place, 0, [640, 480], {...clock, has: (_, seconds) => seconds >= begin});
    assert.deepEqual([from(0).at, from(100).at, from(306).at, from(308)], [2.5, 305, 307.5, null]);
    assert.equal(from(100).words(), 'here 5.0 s');
});

test('a thing that was taken is missing while its event lasts', () => {
    const bag = sceneEvent('taken', 400, 498, 500, 600, 502, 500);  // went at 40 s; the clip ends at 60 s
    const answer = (place, time = clock) => answerOf(bag, place, 0, [640, 480], time);
    const box = {kind: 'box', from: [400, 400], to: [600, 600]};
    assert.equal(answer(box).words(), 'missing from +40');
    assert.equal(answer(null).words(), 'missing from +40');
    assert.equal(answer({...box, to: [450, 600]}), null);
    // Also of a search for a later time.
    const later = answer(box, {...clock, has: (_, seconds) => seconds >= 50});
    assert.deepEqual([later.at, later.words()], [60, 'missing from +40']);
    // It didn't go across a line, though the middle of its outline does.
    assert.equal(answer({kind: 'line', from: [500, 0], to: [500, 1000]}), null);
    const left = sceneEvent('left', ...bag.way);
    assert.deepEqual(waysOf([bag, left]), [[400, 498, 500], bag.way]);
});

test('a hit is at the crossing in the direction that is asked for', () => {
    const pacer = sceneEvent('moved', 0, 400, 300, 100, 600, 300, 200, 400, 300);
    const place = {kind: 'line', from: [500, 0], to: [500, 1000]};
    const at = way => answerOf(pacer, place, way, [640, 480], clock);
    assert.deepEqual([at(0).at, at(-1).at, at(1).at], [5, 5, 15]);
    assert.deepEqual(at(0).ways, [1, -1]);
    assert.equal(at(0).words(), 'crossed → +5, ← +15');
    const found = [{event: pacer, how: at(0)}, {event: pacer, how: {...at(0), ways: [1]}}];
    assert.deepEqual([0, 1, -1].map(way => ofWay(found, way).length), [2, 2, 1]);
});

test('events of a kind', () => {
    const kindNamed = name => kindOf(name);
    assert.deepEqual(['left', 'taken', 'moved'].map(name => isOfChoice(choices, 'left', kindNamed(name))), [true, true, false]);
    assert.ok(isOfChoice(choices, 'unseen', kindNamed('moved')));  // this is about clips
});

test('from hit to hit', () => {
    const hits = [3, 1, 7].map(number => ({event: {...sceneEvent('moved', 0, 1, 1), number}, how: {at: 0, ways: [], words: () => ''}}));
    const beside = (number, by, url = clip.url) => hitBeside(hits, {clip: url, number}, by)?.event.number ?? null;
    assert.deepEqual([beside(3, 1), beside(1, 1), beside(7, 1), beside(1, -1), beside(3, -1), beside(1, 0)], [1, 7, null, 3, null, 1]);
    assert.deepEqual([beside(4, 1), beside(3, 1, 'another')], [null, null]);
});

test('what was found: the latest first, or by kind', () => {
    const found = [['moved', 50], ['left', 10], ['moved', 90], ['left', 20]].map(([name, at]) => ({event: sceneEvent(name, 0, 1, 1), how: {at, ways: [], words: () => ''}}));
    const sorted = (order, kinds = []) => sortedFound(found, order, kinds).map(({how}) => how.at);
    assert.deepEqual(sorted('newest'), [90, 50, 20, 10]);
    assert.deepEqual(sorted('oldest'), [10, 20, 50, 90]);
    assert.deepEqual(sorted('left', ['left']), [20, 10, 90, 50]);
});

test('heat is the time in each cell', () => {
    // One stands for 10 s in the upper left cell; one crosses the lower row in 8 s.
    const cells = heatOf([[0, 100, 100, 100, 100, 100], [0, 0, 900, 80, 1000, 900]], 4, 2);
    assert.equal(cells[0], 101);  // and its last point
    assert.equal(cells[1], 0);
    assert.equal(Math.round(cells.reduce((sum, heat) => sum + heat)), 101 + 81);
    assert.ok([4, 5, 6, 7].every(k => cells[k] >= 16), `${cells}`);
    // One that goes down in 10 s through two cells, and one that goes up.
    assert.deepEqual([...heatOf([[0, 500, 0, 100, 500, 999]], 1, 2)].map(Math.round), [50, 51]);
    assert.deepEqual([...heatOf([[0, 500, 999, 60, 500, 0]], 1, 2)].map(Math.round), [31, 30]);
    const bytes = coloursOf(cells);
    assert.deepEqual([...bytes.slice(0, 4)], [255, 0, 0, 200]);  // the hottest
    assert.deepEqual([...bytes.slice(4, 8)], [255, 210, 0, 0]);  // nothing
    assert.ok(bytes[4 * 5 + 3] > 100 && bytes[4 * 5 + 3] < 200);
});

test('days between two', () => {
    assert.deepEqual(daysBetween(data.days, '', ''), data.days);
    // A clip may begin the day before, and a night ends a day later.
    assert.deepEqual(daysBetween(data.days, '2026-11-22', '2026-11-22'), ['2026-11-21']);
    assert.deepEqual(daysBetween(data.days, '', '2026-11-19'), ['2026-11-19']);
    assert.deepEqual(daysBetween(data.days, '2026-11-26', ''), []);
});

// ---- Days and times

test('days and times of day', () => {
    const span = (from, to, since, until) => ({from, to, since, until});
    const within = (asked, text) => isWithin(asked, new Date(text + ':00Z'));
    const evening = span('2026-11-17', '2026-11-17', '20:00', '');
    assert.deepEqual(['2026-11-17T19:59', '2026-11-17T20:00', '2026-11-17T23:59', '2026-11-18T00:00'].map(text => within(evening, text)),
                     [false, true, true, false]);
    // A night belongs to the evening with which it begins.
    const night = span('2026-11-17', '2026-11-17', '20:00', '06:00');
    assert.deepEqual(['2026-11-17T05:00', '2026-11-17T20:00', '2026-11-18T05:59', '2026-11-18T06:00'].map(text => within(night, text)),
                     [false, true, true, false]);
    assert.ok(within(span('', '', '', ''), '2026-11-17T05:00'));
    assert.deepEqual([within(span('', '', '', '06:00'), '2026-11-17T05:00'), within(span('', '', '', '06:00'), '2026-11-17T06:00')], [true, false]);
    const begins = Date.UTC(2026, 10, 17, 19, 55) / 1000;
    const wallOf = seconds => new Date(seconds * 1000);
    assert.deepEqual([[290, false], [300, true], [3600, true]].map(([lasts]) => overlaps(evening, begins, lasts, wallOf)), [false, true, true]);
});

test('times in a text', () => {
    assert.deepEqual(timesIn('tuesday after 20:00'), {words: 'tuesday  ', since: '20:00', until: ''});
    assert.deepEqual(timesIn('gate 20:00-6:30'), {words: 'gate  ', since: '20:00', until: '06:30'});
    assert.deepEqual(timesIn('8:00 to 9'), {words: ' ', since: '08:00', until: '09:00'});
    assert.deepEqual(timesIn('before 6'), {words: ' ', since: '', until: '06:00'});
    for (const text of ['08:1', '2026-11-20', '11-20', 'cam 3 2026-11-0', 'after 25:00', 'after 20:61', '20:15.mp4', 'after']) {
        assert.deepEqual(timesIn(text), {words: text, since: '', until: ''}, text);
    }
    assert.deepEqual(spanOf({...nothingAsked, text: 'after 20:00', since: '08:00'}), {from: '', to: '', since: '08:00', until: ''});
    assert.deepEqual(['20:00 to 06:00', 'after 20:00', '00:00 to 06:00', ''],
                     [['20:00', '06:00'], ['20:00', ''], ['', '06:00'], ['', '']].map(([since, until]) => timeWords({since, until})));
});

// ---- Contact sheets

test('pictures on a sheet', () => {
    const stills = [1, 2, 5, 9];
    assert.deepEqual([nearestStill(stills, 3), nearestStill(stills, 8), nearestStill(stills, 8, 0, 6), nearestStill(stills, 7, 6, 8)], [1, 3, 2, 2]);
    assert.deepEqual(stillsBetween(stills, 2, 6), [1, 2]);
    assert.deepEqual(stillsBetween(stills, 6, 7), [2]);
    assert.deepEqual(sheetPlace(13, 25, 10), {left: -300, top: -100, width: 1000, height: 300});
    assert.deepEqual(sheetPlace(2, 3, 10), {left: -200, top: -0, width: 300, height: 100});
});
