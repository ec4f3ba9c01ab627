// The voxels of the volume that turns: as the page has them, and as the graphics unit gets them.

import {bytesOf} from './base64.js';

/**
 * @typedef {object} Voxels
 * @property {number[]} size x, y and time, in voxels
 * @property {Uint8Array} scalars
 * @property {Uint16Array} owners 4 times the event's place plus 1, plus its state (core/scene/theme.h); 0 = of no event
 * @property {number[]} cells how many blocks there are, in x, y and time
 * @property {Uint8Array} far of each block, how many blocks it is to the nearest that has something; 0 = it has
 */

/** Voxels along each side of a block. */
export const blockSide = 4;

/** The owner of what is empty, and beside nothing. */
const nobody = 0xFFFF;

/** @param {string} base64 */
async function inflated(base64) {
    const stream = new Blob([bytesOf(base64)]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * @param {Pick<import('./data.js').TurningVolume, 'size' | 'values' | 'levels' | 'owners'>} packed
 * @param {() => Promise<unknown>} pause between two steps, so that the page stays alive
 * @returns {Promise<Voxels>}
 */
export async function unpacked({size, values, levels, owners}, pause) {
    const [scalars, ownerBytes] = await Promise.all([levels, owners].map(inflated));
    const places = [];
    const ownerOf = new Uint16Array(scalars.length).fill(nobody);
    const count = ownerBytes.length / 2;
    for (let k = 0; k < scalars.length; ++k) {
        if (k % 1e6 === 0) await pause();
        if (!scalars[k]) continue;
        ownerOf[k] = ownerBytes[places.length] | ownerBytes[count + places.length] << 8;
        scalars[k] = values[scalars[k]];
        places.push(k);
    }
    await pause();
    await spread(places, scalars, ownerOf, size, pause);
    const {cells, far} = distances(ownerOf, size);
    return {size, scalars, owners: ownerOf.map(owner => owner === nobody ? 0 : owner), cells, far};
}

/**
 * Interpolation extends a voxel into its empty neighbours: they get its owner. The nearest come last, and so prevail.
 * @param {number[]} places of the voxels that have something
 * @param {Uint8Array} scalars
 * @param {Uint16Array} owners
 * @param {number[]} size
 * @param {() => Promise<unknown>} pause
 */
async function spread(places, scalars, owners, [width, height], pause) {
    const steps = [-1, 0, 1];
    const offsets = steps.flatMap(z => steps.flatMap(y => steps.map(x => ({far: x * x + y * y + 2 * z * z, by: (z * height + y) * width + x}))));
    for (const {by} of offsets.filter(({far}) => far > 0).sort((a, b) => b.far - a.far)) {
        for (const place of places) {
            const other = place + by;
            if (scalars[other] === 0) owners[other] = owners[place];
        }
        await pause();
    }
}

/**
 * How far the blocks are from the nearest that has something; diagonals count as one.
 * @param {Uint16Array} owners
 * @param {number[]} size
 */
export function distances(owners, [width, height, layers]) {
    const cells = [width, height, layers].map(side => Math.ceil(side / blockSide));
    const far = new Uint8Array(cells[0] * cells[1] * cells[2]).fill(255);
    for (let z = 0, k = 0; z < layers; ++z) {
        for (let y = 0; y < height; ++y) {
            const row = ((z >> 2) * cells[1] + (y >> 2)) * cells[0];
            for (let x = 0; x < width; ++x, ++k) if (owners[k] !== nobody) far[row + (x >> 2)] = 0;
        }
    }
    // There and back: of the neighbours that were seen before, the nearest, and one block more.
    const before = [-1, 0, 1].flatMap(z => [-1, 0, 1].flatMap(y => [-1, 0, 1].map(x => [x, y, z]))).slice(0, 13);
    for (const sign of [1, -1]) {
        for (let n = 0; n < far.length; ++n) {
            const k = sign > 0 ? n : far.length - 1 - n;
            const at = [k % cells[0], Math.floor(k / cells[0]) % cells[1], Math.floor(k / cells[0] / cells[1])];
            for (const offset of before) {
                const [x, y, z] = at.map((value, axis) => value + sign * offset[axis]);
                if (x < 0 || y < 0 || z < 0 || x >= cells[0] || y >= cells[1] || z >= cells[2]) continue;
                far[k] = Math.min(far[k], far[(z * cells[1] + y) * cells[0] + x] + 1);
            }
        }
    }
    return {cells, far};
}

const reach = 10;  // scalars by which the threshold moves while the opacity doubles

/**
 * The extinction of a scalar. Fainter is a smaller opacity and a higher threshold, more solid the opposite.
 * @param {number[]} extinction of each scalar
 * @param {number} scalar
 * @param {number} factor 1 = as the program draws it
 */
export function extinctionAt(extinction, scalar, factor) {
    const from = Math.min(extinction.length - 1, Math.max(0, scalar + reach * Math.log2(factor)));
    const low = Math.floor(from);
    return scalar === 0 ? extinction[0] : (extinction[low] + (from - low) * ((extinction[low + 1] ?? extinction[low]) - extinction[low])) * factor;
}
