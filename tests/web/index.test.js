// The index's own logic: clips, what is asked of them, orders, and answers of the scene.

import assert from 'node:assert/strict';
import test from 'node:test';
import {answerOf, coloursOf, daysBetween, eventOf, heatOf, sortedFound} from '../../core/web/index/answers.js';
import {busiestHour, clipsOf, counted, eventsIn, failureOf, hoursOf, neighbourOf, pageOf, summaryOf} from '../../core/web/index/clips.js';
import {choicesIn, chosenOf, isOf, nothingAsked, readQuery, sortedBy, writeQuery} from '../../core/web/index/query.js';
import {wallIn} from '../../core/web/shared/wall_clock.js';

const kind = (name, tally, choice) => ({name, words: name, by: 'by', isThing: false, emphasis: 'none', tally, choice});
const day = Date.UTC(2026, 10, 21) / 1000;
const hour = 3600;
const data = {
    cameras: ['', 'gate', 'Übergabe'],
    zone: [[0, 3600, 'CET']],
    kinds: [kind('left', 'lasts', 'left'), kind('taken', 'count', 'left'), kind('stood', 'still', 'stood'), kind('moved', 'none', null)],
    classes: {person: ['person'], vehicle: ['bus', 'car']},
    // camera, URL, begin, seconds, events, files, tallies, classes, and of failures: status, reason, tries, until
    clips: [[1, './gate/a.mp4', day + 7 * hour, 20, 2, 1 | 2 | 16, [26, 0, 0, 0], ['car']],
            [1, './gate/b.mp4', day + 8 * hour, 20, 9, 1 | 512 | 1024, [0, 2, 185, 0], ['person']],
            [1, './gate/c.mp4', day + 9 * hour, 0, null, 0, null, null, 3, 'no\u202evideo', 1],
            [2, './%C3%9C/d%20e.mp4', day + 23.5 * hour, 5, 0, 1 | 256 | 2048, [0, 0, 0, 0], null],
            [1, './gate/f.mp4', day - 30 * hour, 5, 1, 1 | 2, [26, 1, 0, 0], null, 6, 'disk full', 4, day]],
    recordings: [{date: '2026-11-21', clips: 3, row: [1, './gate/2026-11-21', day + 7 * hour, 7220, 11, 1 | 2, [26, 2, 185, 0], null]}],
    days: ['2026-11-19', '2026-11-21', '2026-11-24'],
};
const clips = clipsOf(data, wallIn(data.zone));
const choices = choicesIn(data);
const named = list => list.map(clip => clip.url.split('/').pop());
const unseen = () => false;

test('clips are read from their rows, the newest first', () => {
    assert.deepEqual(named(clips), ['d%20e.mp4', 'c.mp4', 'b.mp4', '2026-11-21', 'a.mp4', 'f.mp4']);
    const [d, c, b, whole, a, f] = clips;
    assert.deepEqual([d.path, d.name, d.day, d.time, d.hour, d.gone], ['Ü/d e.mp4', 'd e.mp4', '2026-11-22', '00:30:00', 0, true]);
    assert.deepEqual([d.placedBy, b.placedBy, a.placedBy], ['when it was last written', 'when its container says it was written', '']);
    assert.deepEqual([c.failed, c.drawn, c.reason, failureOf(c)], [true, false, 'no[U+202E]video', 'Failed once, status 3']);
    assert.deepEqual([f.failed, f.drawn, f.until, failureOf(f)], [true, true, '2026-11-21 01:00:00', 'Failed 4 times, status 6']);
    assert.deepEqual([b.damaged, a.damaged, a.tallyOf, c.tallyOf.left], [true, false, {left: 26, taken: 0, stood: 0, moved: 0}, 0]);
    assert.deepEqual([whole.wholeDay, whole.name, whole.day, whole.hour], [true, '3 clips', '2026-11-21', 8]);
    assert.deepEqual([pageOf(a), pageOf(b)], ['./gate/a.mp4.html', './gate/b.mp4.png']);
});

test('a whole day is not counted again', () => {
    assert.equal(summaryOf(clips, data), '5 clips · 3 cameras · 12 events · 2 failures · 1 gone · times are those of CET');
    assert.deepEqual(named(counted(clips.filter(clip => clip.wholeDay))), ['2026-11-21']);
    assert.equal(eventsIn(counted(clips)), 12);
    assert.match(summaryOf([], {...data, cameras: [], zone: []}), /^0 clips · 0 cameras · 0 events · times are those of UTC$/);
});

test('hours of a day', () => {
    const hours = hoursOf(clips.filter(clip => clip.day === '2026-11-21' && !clip.wholeDay));
    assert.equal(hours.length, 24);
    assert.deepEqual([hours[8], hours[9], hours[10], hours[11]], [2, 9, 0, null]);
    assert.equal(busiestHour(clips), 9);
    assert.equal(busiestHour([]), 1);
});

test('the clip before and the one after, of the same camera and with a picture', () => {
    const of = name => clips.find(clip => clip.url.endsWith(name));
    assert.equal(neighbourOf(clips, of('b.mp4'), 1), of('2026-11-21'));
    assert.equal(neighbourOf(clips, of('a.mp4'), 1), of('f.mp4'));
    assert.equal(neighbourOf(clips, of('f.mp4'), 1), null);
    assert.equal(neighbourOf(clips, of('b.mp4'), -1), null);  // c failed
    assert.equal(neighbourOf(clips, of('f.mp4'), -1), of('a.mp4'));
});

test('what is asked for', () => {
    const chosen = (query, isSeen = unseen) => named(chosenOf(clips, {...nothingAsked, ...query}, choices, isSeen));
    assert.equal(chosen({}).length, 6);
    assert.deepEqual(chosen({camera: 2}), ['d%20e.mp4']);
    assert.deepEqual(chosen({kind: 'events'}), ['b.mp4', '2026-11-21', 'a.mp4', 'f.mp4']);
    assert.deepEqual(chosen({kind: 'left'}), ['b.mp4', '2026-11-21', 'a.mp4', 'f.mp4']);  // left, or taken
    assert.deepEqual(chosen({kind: 'stood'}), ['b.mp4', '2026-11-21']);
    assert.deepEqual(chosen({kind: 'failed'}), ['c.mp4', 'f.mp4']);
    assert.deepEqual(chosen({kind: 'unseen'}, clip => clip.url.endsWith('b.mp4')), ['d%20e.mp4', '2026-11-21', 'a.mp4', 'f.mp4']);
    assert.deepEqual(chosen({class: 'vehicle'}), ['a.mp4']);
    assert.deepEqual(chosen({class: 'person'}), ['b.mp4']);
    assert.deepEqual(chosen({day: '2026-11-22'}), ['d%20e.mp4']);
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
    const queries = [{}, {view: 'scene', text: 'a & b=c #1', camera: 2, day: '2026-11-21'}, {kind: 'left', class: 'vehicle', order: 'stood'}, {camera: 0}];
    for (const change of queries) {
        const query = {...nothingAsked, ...change};
        assert.deepEqual(readQuery(writeQuery(query, choices, data.cameras), choices, data.cameras), query);
    }
    assert.equal(writeQuery(nothingAsked, choices, data.cameras), '#');
    assert.deepEqual(readQuery('#view=constructor&kind=x&class=lorry&order=&camera=none', choices, data.cameras), nothingAsked);
    assert.deepEqual(choices.known, {view: ['clips', 'days', 'scene'], kind: ['all', 'events', 'left', 'stood', 'unseen', 'failed'],
                                     class: ['', 'person', 'person', 'vehicle', 'bus', 'car'].filter((name, k, all) => all.indexOf(name) === k),
                                     order: ['newest', 'left', 'stood', 'events']});
});

// ---- Scene

const kindOf = name => ({...kind(name, 'none', null), rank: ['left', 'moved'].indexOf(name)});
const clip = clips.find(one => one.url.endsWith('a.mp4'));
const sceneEvent = (name, ...row) => eventOf(clip, [name, 1, 0, ...row], kindOf);
const clock = (_, seconds) => `+${seconds}`;

test('events of a day', () => {
    const found = eventOf(clip, ['left', 4, 255, 10, 500, 600, 270, 400, 700, 'car'], kindOf);
    assert.deepEqual([found.kind.name, found.number, found.still, found.what], ['left', 4, 25.5, 'car']);
    assert.deepEqual([found.way, found.bounds], [[10, 500, 600, 270, 400, 700], [400, 600, 500, 700]]);
    assert.equal(sceneEvent('moved', 0, 1, 1).what, '');
});

test('answers for a place', () => {
    const walker = sceneEvent('moved', 100, 0, 500, 300, 1000, 500);  // from 10 s to 30 s, from left to right
    const answer = place => answerOf(walker, place, [640, 480], clock);
    assert.deepEqual([answer(null).at, answer(null).words()], [10, '']);
    const stay = answer({kind: 'box', from: [250, 400], to: [500, 600]});
    assert.deepEqual([stay.at, stay.words()], [15, 'here 5.0 s']);
    assert.equal(answer({kind: 'box', from: [0, 0], to: [1000, 400]}), null);
    const line = answer({kind: 'line', from: [500, 0], to: [500, 1000]});
    assert.deepEqual([line.at, line.words()], [20, 'crossed → +20']);
    assert.equal(answer({kind: 'line', from: [500, 600], to: [500, 1000]}), null);
});

test('what was found: the latest first, or by kind', () => {
    const found = [['moved', 50], ['left', 10], ['moved', 90], ['left', 20]].map(([name, at]) => ({event: sceneEvent(name, 0, 1, 1), how: {at, words: () => ''}}));
    assert.deepEqual(sortedFound(found, false).map(({how}) => how.at), [90, 50, 20, 10]);
    assert.deepEqual(sortedFound(found, true).map(({how}) => how.at), [20, 10, 90, 50]);
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
    assert.deepEqual(daysBetween(data.days, '2026-11-20', '2026-11-21'), ['2026-11-21']);
    assert.deepEqual(daysBetween(data.days, '', '2026-11-19'), ['2026-11-19']);
    assert.deepEqual(daysBetween(data.days, '2026-11-25', ''), []);
});
