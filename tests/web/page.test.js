// The page's own logic: times of frames, lists of events, pixels, zoom, keys, addresses, commands.

import assert from 'node:assert/strict';
import test from 'node:test';
import {addressOfClip, addressOfEvent, addressOfHit, addressOfMoment, addressWith, readAddress} from '../../core/web/page/address.js';
import {cutCommand, filesOf, maskOption, quoted, roiOption, stillCommand, stillName} from '../../core/web/page/commands.js';
import {briefDeeds, countsOfClasses, countsOfKinds, densityOf, factsOf, isOf, isSet, nameOf, numberOf, placeBeside, placeOfNumber, pointAt, relationsOf, rowsOf,
        sortedPlaces, spoken, stillNear, wantedPlaces} from '../../core/web/page/events.js';
import {pageAction, stripAction} from '../../core/web/page/key_table.js';
import {entriesOf} from '../../core/web/page/legend.js';
import {contentsOf, meantByFinger, numbersIn, othersThan, shownNear} from '../../core/web/page/pixels.js';
import {inSentence, Timeline} from '../../core/web/page/timeline.js';
import {placed, zoomedAbout} from '../../core/web/page/zoom.js';

const near = (value, wanted) => assert.ok(Math.abs(value - wanted) < 1e-9, `${value}, not ${wanted}`);

// ---- Times

const steady = () => new Timeline([[0, 250, 0, 0.04]], null);  // 10 s of 25 frames per second

/** Ten frames, two gaps, a frame alone, two slow frames. */
const gappy = clock => new Timeline([[0, 10, 0, 0.1], [50, 1, 30, 0.1], [90, 2, 60, 0.2]], clock ?? null);

test('frames and seconds are each other’s inverse', () => {
    const time = steady();
    for (let frame = 0; frame < 250; ++frame) {
        near(time.secondsOf(frame), frame / 25);
        assert.equal(time.frameAt(frame / 25), frame);
        assert.equal(time.frameAt(frame / 25 + 0.039), frame);
        assert.equal(time.frameAt(time.timeWithin(frame)), frame);
    }
    assert.deepEqual([time.frameAt(-1), time.frameAt(1e9)], [0, 249]);
    assert.deepEqual([time.clamped(-3), time.clamped(17), time.clamped(999)], [0, 17, 249]);
    near(time.ends, 10);
    assert.equal(time.span(), '0:00 to 0:10');
    // A clock of the day shows the second that has begun, as the picture's title does.
    const begin = Date.UTC(2026, 10, 21, 8) / 1000;
    assert.equal(new Timeline([[0, 250, 0, 0.04]], {begin, leaps: [], zone: null, by: ''}).span(), '08:00:00 to 08:00:09');
    near(time.lasts, 9.96);
});

test('stretches of other rates, and gaps', () => {
    const time = gappy();
    assert.deepEqual([time.firstFrame, time.lastFrame, time.frames], [0, 91, 13]);
    assert.deepEqual([5, 9, 50, 90, 91].map(frame => Number(time.secondsOf(frame).toFixed(6))), [0.5, 0.9, 30, 60, 60.2]);
    assert.deepEqual([0.5, 15, 30, 45, 60.1, 60.2].map(seconds => time.frameAt(seconds)), [5, 9, 50, 50, 90, 91]);
    assert.deepEqual(time.gaps, [[9, 50], [50, 90]]);
    assert.deepEqual([[8, 1], [9, 1], [50, 1], [50, -1], [90, -1], [91, -1]].map(([frame, by]) => time.frameBeside(frame, by)), [9, 50, 90, 9, 50, 90]);
});

test('how long a frame is shown: by the next one, by the one before it, or as nothing tells', () => {
    const time = gappy();
    assert.deepEqual([0, 9, 50, 90, 91].map(frame => Number(time.lengthOf(frame).toFixed(6))), [0.1, 0.1, 0.04, 0.2, 0.2]);
    near(time.secondsSeen(), 1 + 0.04 + 0.4);
    assert.deepEqual([0.95, 1.05, 29.9, 30.01, 30.05, 59.9, 60].map(seconds => time.reasonAt(seconds) !== undefined), [false, true, true, false, true, true, false]);
    near(time.endOf({last: 9}), 1);
    near(time.endOf({last: 91}), 60.4);
    // Several frames at one time: the last of them is shown until the next time.
    const crowded = new Timeline([[0, 3, 0, 0], [3, 2, 0.5, 0.1]], null);
    near(crowded.lengthOf(0), 0.5);
    near(crowded.endOf({last: 2}), 0.5);
});

test('gaps are told by their reasons', () => {
    const gaps = reasons => new Timeline([[0, 10, 0, 0.1], [50, 10, 30, 0.1], [90, 2, 60, 0.2], [200, 2, 100, 0.2]], null, reasons);
    const time = gaps(['left out', 'no signal', 'left out']);
    assert.deepEqual([15, 30.5, 45, 80].map(seconds => time.reasonAt(seconds)), ['left out', undefined, 'no signal', 'left out']);
    assert.deepEqual(time.secondsWithout().map(([reason, seconds]) => [reason, Math.round(seconds)]), [['left out', 69], ['no signal', 29]]);
    assert.deepEqual(gaps().secondsWithout().map(([reason]) => reason), ['no signal']);
    assert.deepEqual(steady().secondsWithout(), []);
    assert.deepEqual(['no signal', 'left out, no signal'].map(inSentence), ['no signal', 'left out and no signal']);
});

test('the clock is that of the day where it is known, and leaps with summer time', () => {
    const begin = Date.UTC(2026, 9, 25, 2, 59, 50) / 1000;  // on the wall
    const time = gappy({begin, leaps: [[10, -3600]], zone: 'CET', by: 'file name'});
    assert.equal(time.clockOf(0.25), '02:59:50.2');
    assert.equal(time.clockOf(9.99), '02:59:59.9');
    assert.equal(time.clockOf(10), '02:00:00.0');
    assert.equal(time.clockOf(70, false), '02:01:00');
    assert.equal(time.dayOf(0), '2026-10-25');
    assert.equal(time.bothClocks(10), '02:00:00.0 (0:10.0 of the clip)');
    assert.equal(gappy().clockOf(75.25), '1:15.2');
    assert.equal(gappy().bothClocks(75.25), '1:15.2');
    assert.equal(gappy().dayOf(5), '');
    assert.equal(new Timeline([[0, 1, 0, 1]], {begin: -0.5, leaps: [], zone: null, by: ''}).clockOf(0), '23:59:59.5');
});

// ---- Events

const event = (kind, first, last, more = {}) => ({kind, first, last, begin: first / 25, end: last / 25, still: 0, from: null, into: null, by: null, path: [], way: [], ...more});
const rank = {left: 0, stood: 1, moved: 2};
const kindOf = name => ({name, words: name + ' behind', by: 'put down by', isThing: name === 'left', isOfScene: name === 'taken', emphasis: 'none',
                         tally: name === 'stood' ? 'still' : 'none', choice: null, rank: rank[name]});
const events = [event('moved', 0, 100), event('stood', 25, 50, {still: 3, class: 'person', group: 'person', score: 0.874}),
                event('left', 75, 225, {still: 1, from: 0, by: 1}), event('moved', 75, 80, {class: 'car', group: 'vehicle', score: 1}),
                event('left', 200, 249, {still: 5, class: 'bus', group: 'vehicle', score: 0.5})];
const all = [0, 1, 2, 3, 4];
const anything = {kind: 'all', what: '', leastSeconds: 0};
const yes = () => '';

test('filters', () => {
    const wanted = (filter, answer = yes) => wantedPlaces(events, {...anything, ...filter}, answer);
    assert.deepEqual(wanted({}), all);
    assert.deepEqual(wanted({kind: 'left'}), [2, 4]);
    assert.deepEqual(wanted({what: 'vehicle'}), [3, 4]);
    assert.deepEqual(wanted({what: 'bus'}), [4]);
    assert.deepEqual(wanted({what: '?'}), [0, 2]);
    assert.deepEqual(wanted({leastSeconds: 2}), [0, 2]);  // 4 s and 6 s; the last lasts 1.96 s
    assert.deepEqual(wanted({kind: 'left', leastSeconds: 2}), [2]);
    assert.deepEqual(wanted({}, one => one.first === 75 ? 'here' : null), [2, 3]);
    assert.deepEqual([isSet(anything), isSet({...anything, kind: 'left'}), isSet({...anything, what: '?'}), isSet({...anything, leastSeconds: 2})],
                     [false, true, true, true]);
    assert.deepEqual([isOf(events[3], 'car'), isOf(events[3], 'vehicle'), isOf(events[3], 'bus'), isOf(events[3], '')], [true, true, false, true]);
});

test('orders', () => {
    const sorted = order => sortedPlaces(events, all, order, kindOf);
    assert.deepEqual(sorted('time'), all);
    assert.deepEqual(sorted('newest'), [4, 2, 3, 1, 0]);
    assert.deepEqual(sorted('longest'), [2, 0, 4, 1, 3]);
    assert.deepEqual(sorted('kind'), [4, 2, 1, 0, 3]);  // what was still longest first
    assert.deepEqual(all, [0, 1, 2, 3, 4]);
});

test('the next event, and the one before', () => {
    const beside = (chosen, frame, by, places = all) => placeBeside(events, places, chosen, frame, by);
    assert.deepEqual([beside(1, 0, 1), beside(1, 0, -1), beside(4, 0, 1), beside(0, 0, -1)], [2, 0, 4, 0]);
    assert.deepEqual([beside(null, 60, 1), beside(null, 60, -1), beside(null, 0, -1), beside(null, 0, 1)], [2, 1, 0, 0]);
    assert.deepEqual([beside(3, 80, 1, [0, 4]), beside(3, 80, -1, [0, 4])], [4, 0]);  // the chosen one is not wanted
    assert.equal(beside(null, 0, 1, []), null);
    assert.deepEqual([beside(null, 25, 1), beside(null, 25, -1)], [1, 0]);  // at the first frame of one
    assert.deepEqual([beside(null, 999, 1), beside(null, 999, -1)], [0, 4]);
});

test('counts of kinds and of classes', () => {
    assert.deepEqual(countsOfKinds(events, kindOf), [{name: 'left', count: 2}, {name: 'stood', count: 1}, {name: 'moved', count: 2}]);
    assert.deepEqual(countsOfClasses(events), [
        {name: 'vehicle', isGroup: true, count: 2}, {name: 'bus', isGroup: false, count: 1}, {name: 'car', isGroup: false, count: 1},
        {name: 'person', isGroup: true, count: 1}, {name: '?', isGroup: true, count: 2}]);
    assert.deepEqual(countsOfClasses([event('moved', 0, 1)]), [{name: '?', isGroup: true, count: 1}]);
    assert.deepEqual(countsOfClasses([]), []);
});

test('an event in words', () => {
    assert.deepEqual(factsOf(events[1], kindOf('stood'), 'here 1.0 s'), ['1 s', 'person (87 %)', 'stood behind 3 s', 'here 1.0 s']);
    assert.deepEqual(factsOf(events[0], kindOf('moved'), ''), ['4 s']);
    assert.deepEqual(factsOf(event('taken', 0, 500), kindOf('taken'), 'missing from 0:00'), ['missing 20 s', 'missing from 0:00']);
    assert.deepEqual(relationsOf(events[2], kindOf('left')), [{place: 0, words: 'began in one outline with'}, {place: 1, words: 'put down by'}]);
    assert.deepEqual(relationsOf(event('left', 0, 1, {into: 3}), kindOf('left')), [{place: 3, words: 'ended in one outline with'}]);
});

test('an event that began before a stream’s page does has its whole length', () => {
    // Its frames came slower before: the times of the page's own frames do not tell.
    const early = event('stood', 50, 300, {deed: 'stood 8 s', begin: 0.5, end: 12});
    assert.deepEqual(factsOf(early, kindOf('stood'), null), ['12 s']);
});

test('numbers are not places', () => {
    const numbered = [event('moved', 0, 1, {number: 7}), event('moved', 0, 1)];
    assert.deepEqual([numberOf(numbered, 0), numberOf(numbered, 1)], [7, 2]);
    assert.equal(nameOf(numbered, 0, [1, 0]), 'Event 7, 2 of 2 in the list');
    assert.deepEqual([placeOfNumber(numbered, 7), placeOfNumber(numbered, 2), placeOfNumber(numbered, 1)], [0, 1, null]);
});

test('where an object is between two points of its path', () => {
    const walker = event('moved', 10, 40, {path: [[10, 0.1, 0.5], [20, 0.3, 0.5], [40, 0.3, 0.9]]});
    for (const [frame, x, y] of [[10, 0.1, 0.5], [15, 0.2, 0.5], [20, 0.3, 0.5], [25, 0.3, 0.6], [40, 0.3, 0.9]]) {
        const point = pointAt(walker, frame);
        near(point[0], x);
        near(point[1], y);
    }
    assert.deepEqual([pointAt(walker, 9), pointAt(walker, 41), pointAt(event('moved', 0, 9), 5)], [null, null, null]);
    // A path may begin after its event.
    assert.deepEqual(pointAt(event('moved', 0, 20, {path: [[5, 0.1, 0.2], [20, 1, 1]]}), 2), [0.1, 0.2]);
});

test('the nearest still', () => {
    const stills = [{frame: 0, src: 'a'}, {frame: 100, src: 'b'}, {frame: 200, src: 'c'}];
    assert.deepEqual([-9, 49, 51, 149, 999].map(frame => stillNear(stills, frame).src).join(''), 'aabbc');
});

test('rows of the strip have no two events at one time', () => {
    const spans = [[0, 10], [5, 8], [9, 20], [10, 12], [21, 30]].map(([first, last]) => ({first, last}));
    assert.deepEqual(rowsOf(spans, 10), {rows: [0, 1, 1, 2, 0], count: 3});
    assert.equal(rowsOf(spans, 2), null);
    assert.deepEqual(rowsOf([], 2), {rows: [], count: 0});
    assert.deepEqual(densityOf([[0, 0.3], [0.25, 1], [0.99, 1]], 4), [1, 2, 1, 2]);
});

// ---- Pixels

const pixels = (rows, objects = null) => ({width: rows[0].length, height: rows.length, frames: Int32Array.from(rows.flat()),
                                          objects: objects && Int32Array.from(objects.flat())});

test('numbers are read from three bytes of a pixel, and noise is found', () => {
    assert.deepEqual([...numbersIn([0, 0, 0, 255, 0, 1, 2, 255, 1, 0, 0, 255], 258 + 65_536)], [-1, 257, 65_535]);
    assert.throws(() => numbersIn([0, 0, 1, 255], 2), /changes what pages read/);
});

test('a picture’s contents', () => {
    const words = new Array(200 * 100).fill(7);
    assert.deepEqual(contentsOf(words, 200, 100), [0, 0, 200, 100]);
    words[50 * 200 + 30] = words[60 * 200 + 199] = 1;
    assert.deepEqual(contentsOf(words, 200, 100), [28, 48, 200, 63]);  // a border of 2
});

test('what a point of the picture shows', () => {
    const rows = Array.from({length: 12}, () => new Array(12).fill(-1));
    rows[5][5] = 40;
    rows[5][7] = 60;
    const objects = rows.map(row => row.map(frame => frame === 60 ? 1 : -1));
    const picture = pixels(rows, objects);
    const [none, one] = [{frame: 40, event: null}, {frame: 60, event: 1}];
    const near = (x, y, reach, of = picture) => shownNear(of, x, y, reach);
    assert.deepEqual(near(5.9, 5.1, 4), [{...none, distance: 0}, {...one, distance: 2}]);
    assert.deepEqual(near(7.2, 8.5, 4), [{...one, distance: 3}, {...none, distance: Math.hypot(2, 3)}]);
    assert.deepEqual(near(7.2, 5.5, 0.3), [{...one, distance: 0}]);  // where a pixel of the picture is many of the screen
    assert.deepEqual(near(0, 0, 4), []);
    assert.deepEqual(near(5, 9, 4), [{...none, distance: 4}]);
    assert.deepEqual(near(5, 10, 4), []);
    assert.equal(near(5, 10, 5.2).length, 1);
    assert.deepEqual(near(7, 5, 4, null), []);
    // A finger means events before what is none, and those that are wanted before others.
    const two = {event: 2};
    assert.deepEqual(meantByFinger([none, one, two], [1, 2]), [one, two]);
    assert.deepEqual(meantByFinger([none, one, two], [2]), [two]);
    assert.deepEqual(meantByFinger([none, one], []), [one]);
    assert.deepEqual(meantByFinger([none], [1]), [none]);
    assert.deepEqual(meantByFinger([], [1]), []);
    // In each corner of the picture.
    for (const [column, row] of [[0, 0], [11, 0], [0, 11], [11, 11]]) {
        const corner = pixels(rows.map((_, y) => rows.map((__, x) => x === column && y === row ? 3 : -1)));
        for (const [x, y] of [[column, row], [column ? 9 : 2, row ? 9 : 2]]) assert.equal(near(x, y, 4, corner)[0].frame, 3);
    }
});

test('what is veiled', () => {
    const spans = [{first: 10, last: 20}, {first: 30, last: 40}];
    const veiled = (lit, objects) => [0, 1, 2, 3].filter(othersThan(pixels([[-1, 15, 25, 35]], objects), lit, spans));
    assert.deepEqual(veiled(null), []);
    assert.deepEqual(veiled([0]), [0, 2, 3]);
    assert.deepEqual(veiled([0, 1]), [0, 2]);
    assert.deepEqual(veiled([1], [[-1, 0, -1, 1]]), [0, 1, 2]);
    assert.deepEqual(veiled([], [[-1, 0, -1, 1]]), [0, 1, 2, 3]);
    // An event's first and last frame belong to it.
    assert.deepEqual([0, 1, 2, 3].filter(othersThan(pixels([[9, 10, 20, 21]]), [0], spans)), [0, 3]);
});

test('zoom keeps a point where it is, and no border comes into the view', () => {
    const view = {size: [800, 400], room: [400, 400], contents: [0, 0, 800, 400], scale: 1, middle: [0.5, 0.5]};
    assert.deepEqual(placed(view), {size: [400, 200], middle: [0.5, 0.5], corner: [0, 100]});
    const at = (v, point) => placed(v).corner.map((corner, k) => corner + point[k] * placed(v).size[k]);
    const point = [0.3, 0.6];
    const closer = {...view, ...zoomedAbout(view, 4, point)};
    assert.equal(closer.scale, 4);
    assert.deepEqual(at(closer, point).map(Math.round), at(view, point).map(Math.round));
    assert.equal(zoomedAbout(view, 0.1, point).scale, 1);
    assert.equal(zoomedAbout(view, 1000, point).scale, 16);
    // Dragged far to the right: the left side of the picture is at the left of the view.
    assert.deepEqual(placed({...view, scale: 4, middle: [-5, 0.5]}).corner, [0, -200]);
    assert.deepEqual(placed({...view, scale: 4, middle: [5, 0.5]}).corner, [400 - 1600, -200]);
    // Only contents fill the view.
    assert.deepEqual(placed({...view, contents: [200, 100, 600, 300]}).size, [800, 400]);
});

// ---- Keys, addresses, commands

test('keys', () => {
    const keys = [['ArrowRight', 'step', 1], ['ArrowDown', 'step', 1], ['ArrowLeft', 'step', -1], ['ArrowUp', 'step', -1], [' ', 'togglePlaying'],
                  ['k', 'togglePlaying'], ['K', 'togglePlaying'], ['j', 'goBy', -5], ['L', 'goBy', 5], [',', 'stepFrame', -1], ['.', 'stepFrame', 1],
                  ['0', 'showWhole'], ['<', 'changeSpeed', -1], ['>', 'changeSpeed', 1], ['e', 'toggleTour'], ['g', 'askTime'], ['f', 'toggleFullScreen'],
                  ['x', 'changeShares'], ['a', 'searchByArea'], ['d', 'searchByLine'], ['?', 'showHelp'], ['Escape', 'leave'], ['+', 'zoom', 1.5], ['-', 'zoom', 1 / 1.5]];
    for (const [key, ...action] of keys) assert.deepEqual(pageAction({key}), action, key);
    assert.deepEqual(pageAction({key: 'ArrowRight', shiftKey: true}), ['pan', -80, 0]);
    assert.deepEqual(pageAction({key: 'ArrowUp', shiftKey: true}), ['pan', 0, 80]);
    assert.deepEqual(pageAction({key: '+', shiftKey: true}), ['zoom', 1.5]);
    for (const key of ['y', 'Tab', 'Enter', 'constructor', 'toString']) assert.equal(pageAction({key}), null, key);
    for (const modifier of ['ctrlKey', 'altKey', 'metaKey']) assert.equal(pageAction({key: 'k', [modifier]: true}), null, modifier);
});

test('keys of the strip of time', () => {
    assert.deepEqual(['ArrowLeft', 'ArrowRight', 'PageUp', 'Home', 'End', '-'].map(key => stripAction({key})),
                     [['goBy', -1], ['goBy', 1], ['goBy', 10], ['goToFirst'], ['goToLast'], ['zoomStrip', 1.5]]);
    assert.deepEqual(stripAction({key: 'ArrowRight', shiftKey: true}), ['goBy', 10]);
    assert.deepEqual(stripAction({key: '+', shiftKey: true}), ['zoomStrip', 1 / 1.5]);
    assert.deepEqual([stripAction({key: 'Home', ctrlKey: true}), stripAction({key: 'k'})], [null, null]);
});

test('addresses', () => {
    const nothing = {number: null, seconds: null, plays: false, place: null, search: '', nth: null, of: null, ended: null, all: false, view: null};
    assert.deepEqual(readAddress('#event=4'), {...nothing, number: 4});
    assert.deepEqual(readAddress('#t=12.9'), {...nothing, seconds: 12.9});
    assert.deepEqual(readAddress('#t=nonsense&event=x&place=line.1.2'), nothing);
    assert.deepEqual(readAddress(''), nothing);
    assert.equal(readAddress(addressOfEvent(17)).number, 17);
    assert.equal(readAddress(addressOfMoment(4.92)).seconds, 4.92);
});

test('the address of a hit', () => {
    const place = {kind: 'line', from: [500, 0], to: [500, 1000]};
    const search = 'view=scene&camera=a+%26+b&place=line.500.0.500.1000';
    const hit = {number: 4, seconds: 12.5, place, search, nth: 2, of: 7, view: null};
    assert.deepEqual(readAddress(addressOfHit(hit)), {...hit, plays: true, ended: null, all: false});
    assert.deepEqual(readAddress(addressOfHit(hit, {all: true})), {...hit, plays: true, ended: null, all: true});
    assert.deepEqual(readAddress(addressOfHit(hit, {ended: -1})), {...hit, plays: false, ended: -1, all: false});
    // The hit stays with its event, what was searched for with each; a reload does not play.
    const {plays, ...kept} = readAddress(addressWith(addressOfHit(hit), 4));
    assert.deepEqual([kept, plays], [{...hit, ended: null, all: false}, false]);
    assert.equal(addressWith(addressOfHit(hit), 5), '#' + new URLSearchParams({event: '5', search}));
    assert.equal(addressWith(addressOfHit(hit), null), '#' + new URLSearchParams({search}));
    assert.deepEqual([addressWith('#event=4', 5), addressWith('#event=4', null)], ['#event=5', '']);
    assert.deepEqual([addressOfClip(''), addressOfClip('view=days'), readAddress(addressOfClip('', 1)).ended], ['', '#search=view%3Ddays', 1]);
    assert.equal(addressOfMoment(1 / 3), '#t=0.333');
});

const pageData = more => ({name: 'clip.mp4', camera: null, clip: './clip.mp4', segments: [], cut: {ending: '.mp4', names: []}, size: [640, 360],
                           events, ...more});

test('words of a shell', () => {
    assert.equal(quoted('./a/b-1_c.mp4'), './a/b-1_c.mp4');
    assert.equal(quoted("it's $(touch gone)"), "'it'\\''s $(touch gone)'");
    assert.equal(quoted(''), "''");
});

test('the command that cuts an event', () => {
    assert.equal(cutCommand(pageData(), steady(), 1), 'vvr cut ./clip.mp4 --start 1.000s --end 2.040s -o clip-event-2.mp4');
    assert.equal(cutCommand(pageData({clip: './-a%20b.avi', cut: {ending: '.avi', names: ['%Y x']}}), steady(), 1),
                 "vvr cut './-a b.avi' --names '%Y x' --start 1.000s --end 2.040s -o '_a b-event-2.avi'");
    for (const clip of [null, './a%0Ab.mp4', './bad%FF.mp4']) assert.equal(cutCommand(pageData({clip}), steady(), 1), null, clip);
});

test('the command that cuts an event out of files of a recording', () => {
    const segments = [['a.mp4', 0, 2], ['b.mp4', 2, 4], ['c.mp4', 6, 4]];
    assert.deepEqual(filesOf(pageData({segments}), steady(), {first: 0, last: 49}), [['a.mp4', 0, 2]]);
    assert.deepEqual(filesOf(pageData({segments}), steady(), {first: 0, last: 50}), [['a.mp4', 0, 2], ['b.mp4', 2, 6]]);
    // From 3 s to 9.04 s: the second file begins at 2 s, and the third ends at 10 s.
    assert.equal(cutCommand(pageData({segments}), steady(), 2), 'vvr cut b.mp4 c.mp4 --start 1.000s --end 7.040s -o b-event-3.mp4');
    const overlapping = [['a.mkv', 0, 5], ['b.mkv', 4, 6]];
    assert.equal(cutCommand(pageData({segments: overlapping, cut: {ending: '.mkv', names: []}}), steady(), 2),
                 'vvr cut a.mkv --start 3.000s --end 5.000s -o a-event-3.mkv && vvr cut b.mkv --start 0.000s --end 5.040s -o b-event-3.mkv');
});

test('commands of a page whose clip is gone name the kept pieces', () => {
    const data = pageData({pieces: [['./clip.mp4.events/event-1.mp4', 0.5, 2]], cut: {ending: '.avi', names: ['%Y x']}});
    assert.equal(cutCommand(data, steady(), 1, true), 'vvr cut ./clip.mp4.events/event-1.mp4 --start 0.500s --end 1.540s -o event-1-event-2.mp4');
    assert.equal(stillCommand(data, steady(), 50, true), "ffmpeg -ss 1.490 -i ./clip.mp4.events/event-1.mp4 -frames:v 1 'clip.mp4 0-02.0.png'");
    // Where there is no piece there is no command.
    assert.deepEqual([stillCommand(data, steady(), 100, true), cutCommand(pageData(), steady(), 1, true)], [null, null]);
});

test('stills', () => {
    assert.equal(stillName(pageData(), steady(), 100, '.png'), 'clip.mp4 0-04.0.png');
    const clock = {begin: Date.UTC(2026, 10, 21, 7, 12) / 1000, leaps: [], zone: null, by: ''};
    assert.equal(stillName(pageData({camera: 'back: door\u202e'}), new Timeline([[0, 250, 0, 0.04]], clock), 100, '.preview.png'),
                 'back_door_U_202E_ 2026-11-21 07-12-04.0.preview.png');
    // Half a frame before the frame, at most 0.01 s.
    assert.equal(stillCommand(pageData(), steady(), 100), "ffmpeg -ss 3.990 -i ./clip.mp4 -frames:v 1 'clip.mp4 0-04.0.png'");
    assert.equal(stillCommand(pageData({segments: [['-a.mp4', 0, 2], ['-b.mp4', 2, 8]]}), steady(), 100),
                 "ffmpeg -ss 1.990 -i ./-b.mp4 -frames:v 1 'clip.mp4 0-04.0.png'");
    assert.equal(stillCommand(pageData(), steady(), 0).slice(0, 16), 'ffmpeg -ss 0.000');
    assert.equal(stillCommand(pageData({clip: null}), steady(), 0), null);
});

test('a rectangle as --roi', () => {
    assert.equal(roiOption({from: [0.75, 0.5], to: [0.25, 0.25]}, [192, 144]), "--roi '48,36 144,36 144,72 48,72'");
});

test('a box as --mask, with a border', () => {
    assert.equal(maskOption([0.25, 0.25, 0.75, 0.5], [200, 100]), "--mask '48,24 152,24 152,51 48,51'");
    assert.equal(maskOption([0, 0, 1, 1], [200, 100]), "--mask '0,0 200,0 200,100 0,100'");
});

test('a still that has not come', () => {
    assert.equal(stillNear([], 5), undefined);
});

test('the legend says what the picture has, and no more', () => {
    const words = (settings, events, live = null) => entriesOf({settings, live}, events).map(entry => entry.words);
    const all = {color: 'object', show: 'volume,directions,legend'};
    assert.deepEqual(words(all, [{stays: []}, {stays: [[3, 9]]}]), ['moved', 'stayed or left behind', 'other change']);
    assert.deepEqual(words(all, [{stays: []}]), ['moved', 'other change']);
    assert.deepEqual(words(all, []), ['other change']);
    assert.deepEqual(words({...all, show: 'volume'}, [{stays: [[3, 9]]}]), ['moved', 'stayed or left behind', 'other change']);
    assert.deepEqual(words(all, [{stays: [[3, 9]]}], {state: 'watching'}), ['moved', 'other change']);
    assert.deepEqual(words({...all, color: 'time'}, [{stays: [[3, 9]]}]), []);
    assert.deepEqual(words({color: 'object', show: 'map'}, [{stays: [[3, 9]]}]), []);
    assert.deepEqual(words({}, []), []);
});

test('words for who hears the page', () => {
    assert.equal(spoken('went down and right · 6 s'), 'went down and right, 6 seconds');
    assert.equal(spoken('stayed 1 s in all'), 'stayed 1 second in all');
    assert.equal(spoken('crossed ← 0:06, → 0:10'), 'crossed to the left 0:06, to the right 0:10');
    assert.equal(spoken('left behind 3:20 h'), 'left behind 3:20 hours');
});

test('words for where there is little room', () => {
    assert.deepEqual(briefDeeds('stayed 9 s in all'), ['stayed 9 s in all', 'stayed 9 s', '9 s']);
    assert.deepEqual(briefDeeds('went up and left'), ['went up and left', 'up and left', '↖']);
    assert.equal(briefDeeds('to and fro')[2], '⇄');
    assert.equal(briefDeeds('left behind')[2], 'left behind');
});
