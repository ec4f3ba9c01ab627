// The logic of the page's player and of what lies over its picture: typed times, busy stretches, marks, cross-sections.

import assert from 'node:assert/strict';
import test from 'node:test';
import {isForeign, isGone, whyNot} from '../../core/web/page/unplayable.js';
import {pointIn, roomFor, sectionAt, trailOf} from '../../core/web/page/arc.js';
import {busyStretches, newestAt, stretchFrom} from '../../core/web/page/busy.js';
import {changed, clipKey, keyOf, readMarks, savedMarks, withTwins} from '../../core/web/page/marks.js';
import {momentOf} from '../../core/web/page/moments.js';
import {fileAt, footageOf, hasMoment, nameOf} from '../../core/web/page/pieces.js';
import {Timeline} from '../../core/web/page/timeline.js';

const steady = clock => new Timeline([[0, 2500, 0, 0.04]], clock ?? null);  // 100 s

test('typed times of a clip without a clock', () => {
    const of = text => momentOf(text, steady());
    assert.deepEqual(['75', '1:15', '1:15.5', '0:05', '75s', ' 12,5 '].map(of), [75, 75, 75.5, 5, 75, 12.5]);
    for (const text of ['', 'noon', '1:75', '101', '2:00', '-4', '1:2:3:4']) assert.equal(of(text), null, text);
});

test('typed times of the day', () => {
    const begin = Date.UTC(2026, 10, 21, 23, 59, 30) / 1000;
    const of = text => momentOf(text, steady({begin, leaps: [], zone: null, by: ''}));
    assert.deepEqual(['23:59:40', '00:00:05', '0:00', '23:59', '00:01'].map(of), [10, 35, 30, 0, 90]);
    assert.equal(of('75'), 75);
    assert.equal(of('1:15'), 75);  // no time of its day, but of the clip
    assert.equal(of('14:20'), null);
});

test('typed times of a night in which summer time begins or ends', () => {
    const hours = 3600;
    const night = (month, day, at, by) => new Timeline(
        [[0, 8 * hours, 0, 1]], {begin: Date.UTC(2026, month, day, 22) / 1000, leaps: [[at * hours, by]], zone: null, by: ''});
    const spring = text => momentOf(text, night(2, 28, 4, hours));  // 02:00 becomes 03:00
    assert.deepEqual(['23:00', '03:30', '02:30', '06:15'].map(spring), [1, 4.5, 4, 7.25].map(hour => hour * hours));
    const autumn = text => momentOf(text, night(9, 24, 5, -hours));  // 03:00 becomes 02:00
    assert.deepEqual(['02:30', '03:30', '22:00'].map(autumn), [4.5, 6.5, 0].map(hour => hour * hours));
});

test('busy stretches, and what plays after a frame', () => {
    const events = [{first: 50, last: 90}, {first: 10, last: 30}, {first: 25, last: 40}, {first: 92, last: 95}];
    const stretches = busyStretches(events, 3);
    assert.deepEqual(stretches, [{first: 10, last: 40}, {first: 50, last: 95}]);
    assert.deepEqual([-1, 10, 35, 40, 45, 94].map(frame => stretchFrom(stretches, frame)),
                     [{from: 10, last: 40}, {from: 10, last: 40}, {from: 35, last: 40}, {from: 50, last: 95}, {from: 50, last: 95}, {from: 94, last: 95}]);
    assert.equal(stretchFrom(stretches, 95), null);
    assert.deepEqual(busyStretches([], 3), []);
    assert.deepEqual([20, 27, 35, 45].map(frame => newestAt(events, [0, 1, 2, 3], frame)), [1, 2, 2, -1]);
    assert.equal(newestAt(events, [1], 27), 1);
});

test('marks are kept by the event, and what is damaged is as nothing', () => {
    const event = {first: 3, last: 9};
    assert.equal(keyOf(event), '3-9');
    let marks = changed({}, '3-9', {star: true});
    marks = changed(marks, '3-9', {note: 'who?'});
    assert.deepEqual(marks, {'3-9': {star: true, note: 'who?'}});
    assert.deepEqual(changed(marks, '3-9', {star: false, note: ''}), {});
    assert.deepEqual(readMarks(JSON.stringify(marks)), {'3-9': {star: true, note: 'who?', nothing: false}});
    for (const text of [null, '', '{', '5', 'null', '{"x": 1}', '{"3-9": 7}']) assert.deepEqual(readMarks(text), {}, String(text));
});

test('events with the same frames have marks of their own', () => {
    const events = withTwins([{first: 0, last: 90}, {first: 3, last: 9}, {first: 0, last: 90}, {first: 0, last: 9}]);
    assert.deepEqual(events.map(keyOf), ['0-90', '3-9', '0-90-1', '0-9']);
    const marks = changed({}, keyOf(events[2]), {star: true});
    assert.deepEqual(events.map(event => readMarks(JSON.stringify(marks))[keyOf(event)]?.star), [undefined, undefined, true, undefined]);
});

test('files of a recording, and pieces of its events', () => {
    // As in tests/unit/footage/parts_test.cpp, which asks the program's own function. The last two overlap.
    const files = [['a', 0, 10], ['b', 10, 10], ['c', 30, 5], ['d', 34, 6]];
    assert.deepEqual([-1, 0, 9.9, 9.999, 10, 25, 30, 34.5, 35, 99].map(seconds => fileAt(files, seconds)[0]),
                     ['a', 'a', 'a', 'b', 'b', 'c', 'c', 'c', 'd', 'd']);
    const pieces = [['a', 5, 10], ['b', 20, 4]];
    assert.deepEqual([0, 5, 14.9, 15, 20, 23.9, 24].map(seconds => hasMoment(pieces, seconds)), [false, true, true, false, true, true, false]);
    assert.equal(hasMoment([], 5), false);
    assert.deepEqual(footageOf({clip: './a.mp4', segments: []}), [['./a.mp4', 0, Infinity]]);
    assert.deepEqual(footageOf({clip: null, segments: files, pieces}, true), pieces);
    assert.deepEqual([nameOf(['./day/a%20b.mp4', 0, 1]), nameOf(['bad%FF.mp4', 0, 1])], ['a b.mp4', 'bad%FF.mp4']);
});

const pageData = more => ({name: 'clip.mp4', camera: null, clip: './clip.mp4', size: [640, 360], times: [[0, 2500, 0, 0.04]], clock: null, ...more});

test('a clip has its own marks, and the same ones when its page is made again', () => {
    assert.match(clipKey(pageData()), /^vvr-marks-[0-9a-f]{8}$/);
    assert.equal(clipKey(pageData()), clipKey(pageData({kinds: []})));
    for (const other of [{name: 'other.mp4'}, {camera: 'gate'}, {times: [[0, 2501, 0, 0.04]]}]) assert.notEqual(clipKey(pageData()), clipKey(pageData(other)));
});

test('marks as a file', () => {
    const events = [{first: 0, last: 25, begin: 0, end: 1, kind: 'moved'}, {first: 50, last: 100, begin: 2, end: 4, kind: 'stood', deed: 'stayed 2 s', class: 'person', number: 7}];
    const saved = JSON.parse(savedMarks(pageData(), events, {'50-100': {star: true, note: 'blue coat'}}, steady()));
    assert.deepEqual(saved, {clip: 'clip.mp4', camera: null, file: './clip.mp4', events: [
        {event: 7, from: '0:02.0', to: '0:04.0', frames: [50, 100], deed: 'stayed 2 s', class: 'person', star: true, nothing: false, note: 'blue coat'}]});
    // An event of a stream that began before the page's first frame keeps its time.
    const stream = new Timeline([[250, 100, 10, 0]], {begin: Date.UTC(2026, 10, 21, 14) / 1000, leaps: [], zone: null, by: ''});
    const early = {first: 50, last: 300, begin: 0.5, end: 10, kind: 'moved'};
    const [{from, to}] = JSON.parse(savedMarks(pageData(), [early], {'50-300': {star: true}}, stream)).events;
    assert.deepEqual([from, to], ['2026-11-21 14:00:00.5', '2026-11-21 14:00:10.0']);
});

const square = [0, 0, 10, 0, 10, 10, 0, 10];

test('cross-sections, and places in them', () => {
    const sections = [[0, ...square], [10, ...square.map(value => value + 100)]];
    assert.deepEqual(sectionAt(sections, 5), square.map(value => value + 50));
    assert.deepEqual(sectionAt(sections, -3), square);
    assert.deepEqual(sectionAt(sections, 99), square.map(value => value + 100));
    assert.equal(sectionAt([], 5), null);
    assert.deepEqual([pointIn(square, 0, 0), pointIn(square, 1, 0), pointIn(square, 1, 1), pointIn(square, 0.5, 0.25)], [[0, 0], [10, 0], [10, 10], [5, 2.5]]);
    // A trapezium: corners stay corners, and the diagonals cross where they cross in the frame.
    const slanted = [2, 0, 8, 0, 10, 10, 0, 10];
    const near = (point, x, y) => assert.ok(Math.hypot(point[0] - x, point[1] - y) < 1e-9, String(point));
    near(pointIn(slanted, 0, 0), 2, 0);
    near(pointIn(slanted, 1, 1), 10, 10);
    near(pointIn(slanted, 0.5, 0.5), 5, 3.75);
    const trail = trailOf(sections, {path: [[0, 0.5, 0.5], [125, 0, 0]]}, steady());
    assert.deepEqual(trail.map(point => point.map(Math.round)), [[5, 5], [50, 50]]);
    // A thing that lies there has two places only, but its path follows the arc.
    const bent = [[0, ...square], [10, ...square.map(value => value + 100)], [20, ...square]];
    const still = trailOf(bent, {path: [[0, 0.5, 0.5], [500, 0.5, 0.5]]}, steady());
    assert.deepEqual(still.map(point => point.map(Math.round)), [[5, 5], [105, 105], [5, 5]]);
});

test('texts have room, the first ones first', () => {
    const box = (left, top) => ({left, top, right: left + 10, bottom: top + 10});
    assert.deepEqual(roomFor([[box(0, 0)], [box(5, 5)], [box(5, 5), box(10, 0)], [], [box(0, 10)]]), [0, -1, 1, -1, 0]);
});

test('why a clip can’t be played', () => {
    const [gone, unknown] = ['the clip is not where it was', 'this browser doesn’t play this kind of file'];
    assert.deepEqual(['MEDIA_ELEMENT_ERROR: Format error', '404: Not Found', '2152857618: Request failed'].map(text => whyNot(text, './a.mp4')), [gone, gone, gone]);
    assert.deepEqual(['PipelineStatus::DEMUXER_ERROR_NO_SUPPORTED_STREAMS: FFmpegDemuxer: no supported streams', 'Failed to init decoder'].map(text => whyNot(text, './a.mp4')),
                     [unknown, unknown]);
    assert.deepEqual([gone, unknown, 'the file of that name is another clip'].map(why => isGone(why, false)), [true, false, true]);
    // Of a page that was opened as a file some browsers say nothing.
    assert.deepEqual(['./a.avi', './a.MP4', ''].map(name => whyNot('', name)), [unknown, 'the clip is missing or can’t be played here', unknown]);
});

test('which files are not even tried', () => {
    const player = plays => ({canPlayType: () => plays});
    assert.deepEqual(['./a.avi', './a.AVI', './a.mp4'].map(name => isForeign(name, player(''))), [true, true, false]);
    assert.equal(isForeign('./a.avi', player('maybe')), false);
});
