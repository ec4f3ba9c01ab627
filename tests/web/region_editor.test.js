// Regions of the region editor, and the state of all pages.

import assert from 'node:assert/strict';
import test from 'node:test';
import {boxOf, copyOf, isBox, moved, nameOf, optionText, parse, withCorner, withMoreCorners} from '../../core/web/region_editor/regions.js';
import {derived, store} from '../../core/web/shared/state.js';

const box = {box: true, corners: [[10, 10], [30, 10], [30, 20], [10, 20]]};
const triangle = {box: false, corners: [[0, 0], [10, 0], [0, 4]]};

test('regions are read and written as the options have them', () => {
    const text = '10,10 30,10 30,20 10,20; 0,0 10,0 0,4';
    assert.deepEqual(parse(text), [box, triangle]);
    assert.equal(optionText('roi', parse(text)), `--roi "${text}"`);
    assert.equal(optionText('mask', []), '');
    assert.deepEqual(parse('1,2 3,4; a,b c,d e,f; 1,2,3 1,2,3 1,2,3'), []);
    assert.deepEqual(parse(''), []);
});

test('what is a box', () => {
    assert.ok(isBox(boxOf([30, 20], [10, 10])));
    assert.deepEqual(boxOf([30, 20], [10, 10]), box.corners);
    assert.ok(isBox([[10, 10], [10, 20], [30, 20], [30, 10]]));  // the other way around
    // One corner of a box elsewhere, in one direction, is no box.
    for (let k = 0; k < 4; ++k) {
        for (const axis of [0, 1]) {
            const bent = box.corners.map((corner, n) => corner.map((value, m) => n === k && m === axis ? value + 1 : value));
            assert.ok(!isBox(bent) && !isBox([...bent].reverse()), `${bent}`);
        }
    }
    assert.ok(!isBox([[10, 10], [31, 10], [30, 20], [10, 20]]) && !isBox(triangle.corners));
});

test('a region moves as far as the picture goes', () => {
    assert.deepEqual(moved(box.corners, [5, -3], [100, 50]), [[15, 7], [35, 7], [35, 17], [15, 17]]);
    assert.deepEqual(moved(box.corners, [-99, 99], [100, 50]), [[0, 40], [20, 40], [20, 50], [0, 50]]);
});

test('a box keeps its right angles when a corner moves', () => {
    for (const [k, to] of [[0, [5, 6]], [1, [40, 6]], [2, [40, 30]], [3, [5, 30]]]) {
        const corners = withCorner(box, k, to);
        assert.ok(isBox(corners), `corner ${k}`);
        assert.deepEqual(corners[k], to);
        assert.deepEqual(corners[(k + 2) % 4], box.corners[(k + 2) % 4]);
    }
    assert.deepEqual(withCorner(triangle, 1, [9, 9]), [[0, 0], [9, 9], [0, 4]]);
});

test('another corner is in the middle of the longest side', () => {
    assert.deepEqual(withMoreCorners(triangle.corners), [[0, 0], [10, 0], [5, 2], [0, 4]]);
    assert.deepEqual(withMoreCorners([[0, 0], [4, 0], [4, 9]]), [[0, 0], [4, 0], [4, 9], [2, 5]]);  // the side that closes it
    assert.deepEqual(withMoreCorners([[100, 50], [110, 50], [110, 54]]), [[100, 50], [110, 50], [110, 54], [105, 52]]);
    assert.deepEqual(withMoreCorners([[50, 100], [50, 110], [53, 100]]), [[50, 100], [50, 110], [52, 105], [53, 100]]);
});

test('names, and copies that do not change', () => {
    assert.equal(nameOf(box), '20×10 at 10,10');
    assert.equal(nameOf(triangle), '3 corners, 10×4 at 0,0');
    const copy = copyOf([box]);
    copy[0].corners[0][0] = 99;
    assert.equal(box.corners[0][0], 10);
});

test('a page draws what depends on a change, and nothing else', () => {
    const {state, set, drawAll} = store({a: 1, b: 2});
    const drawn = [];
    drawAll([{draw: () => drawn.push(`a${state.a}`), from: () => [state.a]},
             {draw: () => drawn.push(`ab${state.a}${state.b}`), from: () => [state.a, state.b]}]);
    set({b: 2});
    set({b: 3});
    set({a: NaN});
    set({a: NaN});
    assert.deepEqual(drawn, ['a1', 'ab12', 'ab13', 'aNaN', 'abNaN3']);
});

test('a part may change the state: another round follows', () => {
    const {state, set, drawAll} = store({wanted: 5, shown: 0});
    const drawn = [];
    drawAll([{draw: () => drawn.push(state.shown), from: () => [state.shown]},
             {draw: () => { if (state.wanted > 3) set({wanted: 3}); set({shown: state.wanted}); }, from: () => [state.wanted]}]);
    assert.deepEqual([drawn, state.wanted], [[0, 3], 3]);
});

test('a failure in a part does not stop later changes', () => {
    const {state, set, drawAll} = store({a: 0});
    const drawn = [];
    drawAll([{draw: () => { if (state.a === 1) throw new Error('once'); drawn.push(state.a); }, from: () => [state.a]}]);
    assert.throws(() => set({a: 1}), /once/);
    set({a: 2});
    assert.deepEqual(drawn, [0, 2]);
});

test('a derived value is computed again only when its inputs change', () => {
    let [input, count] = [1, 0];
    const value = derived(() => [input], () => { ++count; return {twice: 2 * input}; });
    const first = value();
    assert.equal(value(), first);
    input = 4;
    assert.deepEqual([value().twice, count], [8, 2]);
});
