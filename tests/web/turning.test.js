// The volume that turns: layouts, camera, framing, voxels.

import assert from 'node:assert/strict';
import test from 'node:test';
import {deflateSync} from 'node:zlib';
import {addressWith, addressWithView, readAddress} from '../../core/web/page/address.js';
import {cropped, dot, fitCamera, matrixOf, pixelOf, toLight, within} from '../../core/web/page/camera.js';
import {renderCommand} from '../../core/web/page/commands.js';
import {angleBetween, angleWithin, framingOf, timesOf} from '../../core/web/page/framing.js';
import {pageAction} from '../../core/web/page/key_table.js';
import {edgeLines, layouts, markAt, outerEdge, outlinePoints} from '../../core/web/page/layouts.js';
import {Timeline} from '../../core/web/page/timeline.js';
import {distances, extinctionAt, unpacked} from '../../core/web/page/volume_data.js';

const near = (value, wanted, reach = 1e-9) => assert.ok(Math.abs(value - wanted) < reach, `${value}, not ${wanted}`);
const allNear = (values, wanted, reach) => values.forEach((value, k) => near(value, wanted[k], reach));

const shape = [0.45, 1, 0.4];
const bent = c => layouts.horseshoe.pOf(shape, c);
const straight = c => layouts.box.pOf(shape, c);
const size = [1280, 800];

test('layouts put time from left to right', () => {
    allNear(bent([1, 0, 0]), [-1, 0, 0]);
    allNear(bent([0, 1, 0]), [-0.45, 0.4, 0]);
    allNear(bent([1, 0.5, 0.5]), [0, 0.2, 1]);
    allNear(bent([0, 0, 1]), [0.45, 0, 0]);
    allNear(straight([0, 0, 0.5]), [0, 0, 0]);
    allNear(straight([1, 1, 1]), [Math.PI * 1.45 / 4, 0.4, 0.55]);
    near(layouts.box.uniforms(shape).layout_length, Math.PI * 1.45 / 2);
});

test('a camera shows all points as large as possible', () => {
    for (const pOf of [bent, straight]) {
        for (const angle of [[0, 46], [-55, 16], [120, 90], [10, 3]]) {
            const pixels = outlinePoints(pOf).map(point => pixelOf(fitCamera([...angle, 30, 0.1], outlinePoints(pOf), size), point, size));
            const [xs, ys] = [0, 1].map(k => pixels.map(pixel => pixel[k]));
            assert.ok(Math.min(...xs) > 127.9 && Math.max(...xs) < 1152.1 && Math.min(...ys) > 79.9 && Math.max(...ys) < 720.1, angle);
            const tight = Math.abs(Math.min(...xs) - 128) < 0.1 || Math.abs(Math.min(...ys) - 80) < 0.1;
            assert.ok(tight, `there is room on all sides at ${angle}`);
        }
    }
});

test('the viewer of the default view sees the first frame on the left, unmirrored', () => {
    const camera = fitCamera([0, 46, 30, 0.04], outlinePoints(bent), size);
    const [left, right] = [[1, 0, 0], [0, 0, 0]].map(c => pixelOf(camera, bent(c), size)[0]);
    assert.ok(left < right && right < 640);  // x of C-space runs against the columns
    assert.ok(dot(toLight(camera), camera.forward) < 0);
});

test('a part of a picture, and a picture as a part, undo each other', () => {
    const camera = fitCamera([30, 20, 40, 0.04], outlinePoints(bent), size);
    const part = [100, 50, 500, 750];
    const back = cropped(within(camera, part, size), part, size);
    const [p, q] = [camera, back].map(one => pixelOf(one, bent([0.3, 0.4, 0.2]), size));
    allNear(p, q, 1e-6);
    const [x, y] = pixelOf(cropped(camera, part, size), bent([0.3, 0.4, 0.2]), [400, 700]);
    allNear([x + 100, y + 50], p, 1e-6);
});

test('the matrix says the same as the camera, and depth is between its ends', () => {
    const camera = within(fitCamera([-70, 25, 30, 0], outlinePoints(bent), [600, 400]), [0, 100, 600, 500], [600, 600]);
    const matrix = matrixOf(camera);
    for (const c of [[0, 0, 0], [1, 1, 0.3], [0.5, 0.2, 1]]) {
        const point = bent(c);
        const [x, y, z, w] = [0, 1, 2, 3].map(row => matrix[row] * point[0] + matrix[4 + row] * point[1] + matrix[8 + row] * point[2] + matrix[12 + row]);
        allNear([(x / w + 1) * 300, (1 - y / w) * 300], pixelOf(camera, point, [600, 600]), 1e-3);
        assert.ok(Math.abs(z / w) < 1);
    }
});

test('the ruler runs along the outer edge, and has room', () => {
    const volume = {shape, view: [0, 46, 30, 0.01], part: [0, 100, 1280, 700], shows: {ruler: true}};
    for (const angle of [[0, 46], [40, 10], [180, 30]]) {
        const {camera, edge, pOf} = framingOf(volume, 'horseshoe', angle, size);
        for (let t = 0; t <= 1; t += 0.125) {
            const [x, y] = pixelOf(camera, pOf(markAt(edge, t)[1]), size);
            assert.ok(x > 0 && x < 1280 && y > 100 && y < 700);
        }
    }
    assert.deepEqual(outerEdge(bent, point => pixelOf(fitCamera([0, 90, 30, 0], outlinePoints(bent), size), point, size), size), [1, 1]);
    assert.equal(edgeLines([0, 1]).length, 4 * 96 + 8);
});

test('frames and places along the volume are each other’s inverse', () => {
    // Ten layers of the volume in four of three voxels; the last has one.
    const times = timesOf({frames: [0, 30, 40, 100, 109], size: [1, 1, 4], scale: [1, 1, 10 / 12], end: 1});
    near(times.tOf(0), 0);
    near(times.tOf(30), 0.3);
    near(times.tOf(70), 0.75);
    near(times.tOf(109), 1);
    for (const frame of [0, 12, 30, 35, 99, 100, 104, 109]) assert.equal(times.frameAt(times.tOf(frame)), frame);
    assert.deepEqual([times.frameAt(-1), times.frameAt(2)], [0, 109]);
});

test('angles stay above the ground and turn the shorter way', () => {
    assert.deepEqual(angleWithin([190, -5]), [-170, 3]);
    assert.deepEqual(angleWithin([-725.04, 95]), [-5, 90]);
    allNear(angleBetween([170, 10], [-170, 30], 0.5), [180, 20]);
    assert.deepEqual(angleBetween([0, 46], [-55, 16], 1), [-55, 16]);
});

test('voxels are unpacked, and empty neighbours get their owner', async () => {
    const size = [6, 5, 4];
    const levels = new Uint8Array(120);
    const at = (x, y, z) => (z * 5 + y) * 6 + x;
    levels[at(2, 2, 1)] = 3;
    levels[at(3, 2, 1)] = 1;
    const owners = [4 * 300 + 2, 0];
    const pack = bytes => deflateSync(Uint8Array.from(bytes)).toString('base64');
    const voxels = await unpacked({size, values: [0, 20, 90, 255], levels: pack(levels), owners: pack([...owners.map(o => o & 255), ...owners.map(o => o >> 8)])},
                                  async () => {});
    assert.equal(voxels.scalars[at(2, 2, 1)], 255);
    assert.equal(voxels.scalars[at(3, 2, 1)], 20);
    assert.deepEqual([...voxels.scalars].filter(Boolean).length, 2);
    assert.equal(voxels.owners[at(2, 2, 1)], 1202);
    assert.equal(voxels.owners[at(3, 2, 1)], 0);
    for (const [x, y, z] of [[1, 2, 1], [2, 1, 1], [2, 2, 0], [1, 1, 2]]) assert.equal(voxels.owners[at(x, y, z)], 1202);
    assert.equal(voxels.owners[at(5, 4, 3)], 0);
    assert.deepEqual(voxels.cells, [2, 2, 1]);
    assert.deepEqual([...voxels.far], [0, 0, 1, 1]);
});

test('the way to the nearest block that has something', () => {
    const size = [40, 24, 32];
    const owners = new Uint16Array(40 * 24 * 32).fill(0xFFFF);
    const filled = [[3, 3, 3], [39, 10, 30], [20, 23, 0]];
    for (const [x, y, z] of filled) owners[(z * 24 + y) * 40 + x] = 4;
    const {cells, far} = distances(owners, size);
    assert.deepEqual(cells, [10, 6, 8]);
    for (let k = 0; k < far.length; ++k) {
        const at = [k % 10, Math.floor(k / 10) % 6, Math.floor(k / 60)];
        const truth = Math.min(...filled.map(place => Math.max(...place.map((value, axis) => Math.abs((value >> 2) - at[axis])))));
        assert.equal(far[k], truth);
    }
});

test('the angle is in the address', () => {
    const hash = addressWithView('#event=4', {angle: [-30, 12.5], unbent: false});
    assert.equal(hash, '#event=4&view=-30,12.5');
    assert.deepEqual(readAddress(hash).view, {angle: [-30, 12.5], unbent: false});
    assert.deepEqual(readAddress('#view=0,28,unbent').view, {angle: [0, 28], unbent: true});
    for (const wrong of ['#view=', '#view=1', '#view=a,b', '#view=,3', '#t=3']) assert.equal(readAddress(wrong).view, null);
    assert.equal(addressWithView(hash, null), '#event=4');
    assert.equal(addressWith('#event=2&view=-30,12', 3), '#event=3&view=-30%2C12');
});

test('Alt and arrows turn', () => {
    assert.deepEqual(pageAction({key: 'ArrowLeft', altKey: true}), ['turn', 6, 0]);
    assert.equal(pageAction({key: 'ArrowLeft', altKey: true, ctrlKey: true}), null);
    assert.equal(pageAction({key: 'd', altKey: true}), null);
});

test('the command that draws what is seen', () => {
    const time = new Timeline([[0, 250, 0, 0.04]], null);
    const data = {clip: './a%20b.mp4', segments: [], pieces: [], cut: {names: []}};
    const turned = {angle: [-30, 12.5], unbent: false, density: 1, piece: null, bends: false};
    assert.equal(renderCommand(data, time, turned), "vvr render './a b.mp4' --camera -30,12.5 -o turned.png");
    assert.equal(renderCommand(data, time, {...turned, unbent: true, density: 2, piece: [1, 2.5], bends: true}),
                 "vvr render './a b.mp4' --camera -30,12.5 --layout box --opacity 2.00 --start 1.000s --end 2.500s -o turned.png");
    assert.equal(renderCommand({...data, clip: null}, time, turned), null);
});

test('fainter is a smaller opacity and a higher threshold', () => {
    const extinction = Array.from({length: 256}, (_, k) => k < 50 ? 0 : k);
    for (const scalar of [0, 10, 50, 99.5, 255]) near(extinctionAt(extinction, scalar, 1), scalar < 50 ? 0 : scalar);
    assert.equal(extinctionAt(extinction, 55, 0.5), 0);
    near(extinctionAt(extinction, 100, 0.5), 45);
    near(extinctionAt(extinction, 45, 2), 110);
    assert.equal(extinctionAt(extinction, 0, 16), 0);
});
