// The picture of a card: which event it shows, and which of the clip's small pictures.

import assert from 'node:assert/strict';
import test from 'node:test';
import {markOf, pictureOfEvent, placeUnder, spanOf, turnOfKey, turnOfSwipe} from '../../core/web/index/turning.js';

/** From 2 s to 6 s, from left to right. */
const event = {way: [20, 0, 500, 40, 500, 500, 60, 1000, 500]};

test('the place of the pointer is that of an event', () => {
    assert.deepEqual([0, 0.32, 0.34, 0.99, 1].map(share => placeUnder(share, 3)), [0, 0, 1, 2, 2]);
    assert.deepEqual([-0.1, 1.2].map(share => placeUnder(share, 3)), [0, 2]);  // rounded beyond the border
    assert.deepEqual([0, 0.5, 1].map(share => placeUnder(share, 0)), [0, 0, 0]);  // while the events have not come
    assert.deepEqual([0, 0.5, 1].map(share => placeUnder(share, 1)), [0, 0, 0]);
});

test('arrow keys turn to the event beside it, and leave the keys of the browser alone', () => {
    assert.deepEqual(['ArrowLeft', 'ArrowRight', 'ArrowUp', 'Enter'].map(key => turnOfKey({key})), [-1, 1, 0, 0]);
    for (const held of ['altKey', 'ctrlKey', 'metaKey']) assert.equal(turnOfKey({key: 'ArrowRight', [held]: true}), 0, held);
});

test('a swipe to the left turns to the next event, and a tap to none', () => {
    assert.deepEqual([-80, -31, -30, 0, 30, 31, 80].map(turnOfSwipe), [1, 1, 0, 0, 0, -1, -1]);
});

test('each event has a mark, and of very many some share one', () => {
    assert.deepEqual([0, 1, 2].map(place => markOf(place, 3, 3)), [0, 1, 2]);
    const marks = Array.from({length: 100}, (_, place) => markOf(place, 100, 40));
    assert.deepEqual([marks[0], marks[99], new Set(marks).size], [0, 39, 40]);
    assert.ok(marks.every((mark, k) => k === 0 || mark >= marks[k - 1]));
});

test('an event is shown in its middle, with a ring only where it is', () => {
    assert.deepEqual(spanOf(event), [2, 6]);
    assert.deepEqual(pictureOfEvent(event, [0, 2.5, 4.5, 9]), {still: 2, at: 4.5});
    assert.deepEqual(pictureOfEvent(event, [0, 2.5, 4.5, 9], 1), {still: 1, at: 2.5});  // while it plays
    assert.deepEqual(pictureOfEvent(event, [0, 1.6, 9]), {still: 1, at: 2});  // just before it: where it begins
    assert.deepEqual(pictureOfEvent(event, [0, 9]), {still: 0, at: null});  // there is none of it
});
