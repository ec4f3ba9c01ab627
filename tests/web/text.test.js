// Words, durations, times of a clip and of the day, axes.

import assert from 'node:assert/strict';
import test from 'node:test';
import {clipTime, durationOf, shortSpanOf, spanOf} from '../../core/web/shared/durations.js';
import {kindsBy} from '../../core/web/shared/kinds.js';
import {clamp, digits, folded, grouped, many, readable, upright} from '../../core/web/shared/text.js';
import {tickStep, ticksOf, within, zoomed} from '../../core/web/shared/time_axis.js';
import {dateOf, dayText, daysBefore, monthOf, timeText, wallIn, weekday} from '../../core/web/shared/wall_clock.js';

const table = (what, write, rows) => test(what, () => {
    for (const [value, wanted] of rows) assert.equal(write(value), wanted, `of ${value}`);
});

table('durations as pictures write them', durationOf, [
    [0, '0 s'], [0.44, '0 s'], [0.46, '1 s'], [45, '45 s'], [99.4, '99 s'], [99.5, '2 min'], [420, '7 min'], [5969, '99 min'],
    [5970, '1:40 h'], [12_000, '3:20 h'], [86_400, '24:00 h'],
]);
table('durations with tenths', spanOf, [[0, '0.0 s'], [8.44, '8.4 s'], [59.9, '59.9 s'], [60, '1:00 min'], [185, '3:05 min'], [3599.4, '59:59 min'],
                                        [3600, '1:00 h'], [3720, '1:02 h'], [50_400, '14:00 h']]);
table('short durations', shortSpanOf, [[8.44, '8.4 s'], [10, '10 s'], [41.6, '42 s'], [59.6, '1:00 min'], [185, '3:05 min'], [3720, '1:02 h']]);
table('times of a clip', clipTime, [[0, '0:00.0'], [75.25, '1:15.2'], [0.3, '0:00.3'], [59.99, '0:59.9'], [3599.9, '59:59.9'], [3600, '1:00:00.0'], [36_610.5, '10:10:10.5']]);
table('times of a clip without tenths', seconds => clipTime(seconds, false), [[75.4, '1:15'], [75.9, '1:16'], [59.6, '1:00'], [3661, '1:01:01']]);
table('two digits', digits, [[0, '00'], [7, '07'], [12, '12'], [123, '123']]);
table('counts', count => many(count, 'clip'), [[0, '0 clips'], [1, '1 clip'], [2024, '2,024 clips']]);

test('text that would turn is shown as what it is', () => {
    assert.equal(upright('a\u202egpj.exe'), 'a[U+202E]gpj.exe');
    assert.equal(upright('\u061c\u200e\u2069'), '[U+061C][U+200E][U+2069]');
    assert.equal(upright('日本 ü'), '日本 ü');
    assert.equal(readable('./a%20b%E2%80%AE.mp4'), './a b[U+202E].mp4');
    assert.equal(readable('./bad%FF.mp4'), './bad%FF.mp4');
});

test('text is found as people write it', () => {
    const has = (name, word) => folded(word).split('\n').some(way => folded(name).includes(way));
    for (const word of ['uebergabe', 'ubergabe', 'Übergabe', 'U\u0308BERGABE', 'strasse', 'STRAßE']) assert.ok(has('Übergabe/Straße 7.avi', word), word);
    assert.ok(has('Café', 'cafe') && has('Café', 'CAFÉ'));
    assert.ok(!has('Uebergabe', 'ubergabe'));
    assert.equal(folded('plain'), 'plain');
});

test('grouping keeps the order', () => {
    const groups = grouped([{k: 'b', n: 1}, {k: 'a', n: 2}, {k: 'b', n: 3}], 'k');
    assert.deepEqual([...groups], [['b', [{k: 'b', n: 1}, {k: 'b', n: 3}]], ['a', [{k: 'a', n: 2}]]]);
    assert.deepEqual([clamp(5, 0, 3), clamp(-1, 0, 3), clamp(2, 0, 3)], [3, 0, 2]);
});

test('kinds have the rank of their row, and unknown ones rank last', () => {
    const row = name => ({name, words: name + '!', by: 'b', isThing: true, isOfScene: true, emphasis: 'strong', tally: 'count', choice: null});
    const kindOf = kindsBy([row('first'), row('second')]);
    assert.equal(kindOf('second').rank, 1);
    assert.equal(kindOf('second').words, 'second!');
    assert.deepEqual(kindOf('new'), {name: 'new', words: 'new', by: 'by', isThing: false, isOfScene: false, emphasis: 'none', tally: 'none', choice: null,
                                     rank: 2});
});

test('dates on the wall', () => {
    const seconds = Date.UTC(2026, 2, 29, 0, 59, 59) / 1000;
    assert.deepEqual([dayText(dateOf(seconds + 0.9)), timeText(dateOf(seconds + 0.9))], ['2026-03-29', '00:59:59']);
    // Summer time begins in Berlin at 01:00 UTC.
    const wallOf = wallIn([[0, 3600, 'CET'], [seconds + 1, 7200, 'CEST']]);
    assert.equal(timeText(wallOf(seconds)), '01:59:59');
    assert.equal(timeText(wallOf(seconds + 1)), '03:00:00');
    assert.equal(dayText(wallOf(-86_400)), '1969-12-31');  // before the first change
    assert.equal(weekday('2026-11-24'), 'Tuesday');
    assert.equal(monthOf('2024-02-29'), 'February 2024');
    assert.equal(daysBefore('2026-03-03', 6), '2026-02-25');
    assert.equal(daysBefore('2024-03-01', 1), '2024-02-29');
});

test('ticks are at whole steps of the clock, and no more than there is space for', () => {
    assert.deepEqual(ticksOf(0, 60, 6, 0), [0, 10, 20, 30, 40, 50]);
    // Second 0 is 07:12:03: ticks at :10, :20, ...
    assert.deepEqual(ticksOf(0, 30, 4, 7 * 3600 + 12 * 60 + 3), [7, 17, 27]);
    for (const lasts of [0.5, 3, 59, 61, 1800, 86_400, 700_000, 3e7]) {
        for (const most of [2, 5.5, 12]) {
            const step = tickStep(lasts, most);
            const ticks = ticksOf(12.5, lasts, most, 1000);
            if (lasts <= 86_400 * 10) assert.ok(lasts / step <= Math.max(most, 10), `${lasts} s in steps of ${step}`);
            for (const tick of ticks) {
                assert.ok(tick >= 12.5 && tick <= 12.5 + lasts, `a tick at ${tick}`);
                const off = (tick + 1000) % step;
                assert.ok(Math.min(off, step - off) < 1e-3, `a tick at ${tick} is not on a step of ${step}`);
            }
            assert.ok(ticks.every((tick, k) => k === 0 || Math.abs(tick - ticks[k - 1] - step) < 1e-6));
            assert.ok(ticks.length >= Math.floor(lasts * 0.98 / step) && ticks.length <= lasts / step + 1, `${ticks.length} ticks`);
        }
    }
});

test('an axis zooms about a point and stays in its whole', () => {
    const whole = {from: 10, lasts: 100};
    const part = zoomed({from: 20, lasts: 50}, whole, 0.5, 0.4);
    assert.deepEqual(part, {from: 30, lasts: 25});  // second 40 is at 40 % before and after
    assert.deepEqual(zoomed(part, whole, 1e-6, 0), {from: 30, lasts: 2});
    assert.deepEqual(zoomed(part, whole, 1e6, 0.7), whole);
    assert.deepEqual(zoomed({from: 0, lasts: 1}, {from: 0, lasts: 1}, 0.1, 0.5), {from: 0, lasts: 1});
    assert.deepEqual(within({from: -5, lasts: 20}, whole), {from: 10, lasts: 20});
    assert.deepEqual(within({from: 105, lasts: 20}, whole), {from: 90, lasts: 20});
});
