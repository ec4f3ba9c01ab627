// The camera of the volume, as core/space/camera.cpp has it. P-space is left-handed.

/**
 * @typedef {import('./layouts.js').Point} Point
 *
 * @typedef {object} Camera
 * @property {Point} eye
 * @property {Point} right
 * @property {Point} up
 * @property {Point} forward
 * @property {number[]} focus x and y: what the tangent of an angle is in clip space
 * @property {number[]} shift x and y in clip space
 * @property {number[]} depth of the nearest and the farthest that is shown
 *
 * @typedef {[azimuth: number, elevation: number, fov: number, margin: number]} View degrees, and a share of the picture
 */

/** @type {(a: Point, b: Point) => number} */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @type {(a: Point, b: Point) => Point} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @type {(a: Point, factor: number, b: Point) => Point} */
export const plus = (a, factor, b) => a.map((value, k) => value + factor * b[k]);
/** @param {Point} a */
const unit = a => a.map(value => value / Math.hypot(...a));

const radians = (/** @type {number} */ degrees) => degrees * Math.PI / 180;

/**
 * The camera in a direction that shows all points as large as possible.
 * @param {View} view
 * @param {Point[]} points
 * @param {number[]} size of the picture
 * @returns {Camera}
 */
export function fitCamera([azimuth, elevation, fov, margin], points, [width, height]) {
    const [a, e] = [radians(azimuth), radians(elevation)];
    const forward = [-Math.sin(a) * Math.cos(e), -Math.sin(e), Math.cos(a) * Math.cos(e)];
    const right = [Math.cos(a), 0, Math.sin(a)];
    const up = cross(forward, right);
    const free = 1 - 2 * margin;
    const tangents = [Math.tan(radians(fov) / 2) * free * width / height, Math.tan(radians(fov) / 2) * free];
    // A point is visible from a distance if two half-planes per axis have it; the tightest ones give middle and distance.
    const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
    for (const point of points) {
        const z = dot(point, forward);
        [right, up].forEach((axis, k) => {
            const at = dot(point, axis);
            low[k] = Math.min(low[k], at + z * tangents[k]);
            high[k] = Math.max(high[k], at - z * tangents[k]);
        });
        low[2] = Math.min(low[2], z);
        high[2] = Math.max(high[2], z);
    }
    const half = low.map((value, k) => (high[k] - value) / 2);
    const distance = Math.max(half[0] / tangents[0], half[1] / tangents[1], 1e-9 - low[2]);
    const middle = plus(right.map(value => value * (low[0] + high[0]) / 2), (low[1] + high[1]) / 2, up);
    const eye = plus(middle, -distance, forward);
    const reach = Math.max(...half, 1e-9);
    const far = high[2] - dot(eye, forward) + 0.3 * reach;
    const focus = 1 / Math.tan(radians(fov) / 2);
    return {eye, right, up, forward, focus: [focus * height / width, focus], shift: [0, 0],
            depth: [Math.max(low[2] - dot(eye, forward) - 0.3 * reach, far * 1e-3), far]};
}

/**
 * The camera that shows only a part of a picture: left, top, right, bottom in its pixels.
 * @param {Camera} camera
 * @param {number[]} part
 * @param {number[]} size of the picture
 * @returns {Camera}
 */
export function cropped(camera, [left, top, right, bottom], [width, height]) {
    const scale = [width / (right - left), height / (bottom - top)];
    const middle = [(left + right) / width - 1, 1 - (top + bottom) / height];
    return {...camera, focus: camera.focus.map((value, k) => value * scale[k]), shift: camera.shift.map((value, k) => (value - middle[k]) * scale[k])};
}

/**
 * The camera that shows this one's view in a part of a picture: the inverse of `cropped`.
 * @param {Camera} camera
 * @param {number[]} part
 * @param {number[]} size
 * @returns {Camera}
 */
export function within(camera, [left, top, right, bottom], [width, height]) {
    const scale = [(right - left) / width, (bottom - top) / height];
    const middle = [(left + right) / width - 1, 1 - (top + bottom) / height];
    return {...camera, focus: camera.focus.map((value, k) => value * scale[k]), shift: camera.shift.map((value, k) => value * scale[k] + middle[k])};
}

/**
 * Where a point is in a picture: column, and row from the top.
 * @param {Camera} camera
 * @param {Point} point
 * @param {number[]} size
 */
export function pixelOf({eye, right, up, forward, focus, shift}, point, [width, height]) {
    const from = plus(point, -1, eye);
    const z = dot(from, forward);
    return [(focus[0] * dot(from, right) / z + shift[0] + 1) / 2 * width, (1 - focus[1] * dot(from, up) / z - shift[1]) / 2 * height];
}

/**
 * From P-space to clip space, by columns.
 * @param {Camera} camera
 */
export function matrixOf({eye, right, up, forward, focus, shift, depth: [near, far]}) {
    const rows = [plus(right.map(value => value * focus[0]), shift[0], forward), plus(up.map(value => value * focus[1]), shift[1], forward),
                  forward.map(value => value * (far + near) / (far - near)), forward];
    const ends = rows.map((row, k) => -dot(row, eye) - (k === 2 ? 2 * far * near / (far - near) : 0));
    return new Float32Array([0, 1, 2].flatMap(column => rows.map(row => row[column])).concat(ends));
}

/**
 * The direction to the light: above and behind the viewer's left shoulder.
 * @param {Camera} camera
 */
export const toLight = ({forward}) => unit(plus(plus([0, 1.4, 0], -1, forward), -0.4, cross([0, 1, 0], forward)));
