// Draws the volume by WebGL 2: a ray per pixel, and before it lines and arrows, which hide and are hidden.

import {bytesOf} from './base64.js';
import {matrixOf, plus, toLight} from './camera.js';
import {layouts} from './layouts.js';
import {arrowSources, lineSources, marchSources} from './shaders.js';
import {extinctionAt} from './volume_data.js';

/**
 * @typedef {import('./camera.js').Camera} Camera
 * @typedef {import('./layouts.js').Point} Point
 * @typedef {{program: WebGLProgram, at: Record<string, WebGLUniformLocation | null>}} Program
 * @typedef {{corner: Point, across: Point, down: Point, opacity: number}} Standing a frame in the volume
 *
 * What is to be drawn; all but size and spacing is in P-space or C-space.
 * @typedef {object} Shot
 * @property {Camera} camera
 * @property {number[]} size of what is drawn, pixels
 * @property {import('./layouts.js').LayoutName} layout
 * @property {import('./layouts.js').Map} pOf
 * @property {[number, number]} bent t that the layout's ends show
 * @property {[number, number]} piece t of the layout that is shown
 * @property {number} spacing of the samples, in voxels
 * @property {(Standing | null)[]} frames
 */

const units = {brick: 0, owners: 1, far: 2, transfer: 3, palette: 4, frame_0: 5, frame_1: 6, frame_2: 7, lines: 8, lines_depth: 9, points: 10, picks: 11};
/** Most pixels on a side of what is picked. */
export const mostPicked = 64;

export class Volume {
    /**
     * @param {HTMLCanvasElement} canvas
     * @param {import('./data.js').TurningVolume} data
     * @param {import('./volume_data.js').Voxels} voxels
     */
    constructor(canvas, data, voxels) {
        const gl = canvas.getContext('webgl2', {antialias: false, depth: false, premultipliedAlpha: true, preserveDrawingBuffer: true});
        if (!gl) throw new Error('there is no WebGL 2');
        if (Math.max(...voxels.size) > gl.getParameter(gl.MAX_3D_TEXTURE_SIZE)) throw new Error('the volume is too large for this WebGL');
        if (!gl.getExtension('EXT_color_buffer_float')) throw new Error('this WebGL draws no numbers');
        this.gl = gl;
        this.data = data;
        this.voxel = 0;
        /** @type {Map<string, Program>} */
        this.programs = new Map();
        this.setVoxels(data, voxels);
        for (const name of /** @type {const} */ (['transfer', 'palette', 'picks', 'frame_0', 'frame_1', 'frame_2', 'points'])) {
            this.bind(name, gl.createTexture());
            const filter = name.startsWith('frame') ? gl.LINEAR : gl.NEAREST;
            for (const key of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, key, filter);
            for (const key of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, key, gl.CLAMP_TO_EDGE);
        }
        this.picked = this.target(gl.RGBA32UI);
        this.lined = {size: [0, 0], smooth: gl.createFramebuffer(), flat: gl.createFramebuffer()};
        this.makeArrays();
    }

    /**
     * Shows these instead of those that it has.
     * @param {import('./data.js').TurningVolume} data
     * @param {import('./volume_data.js').Voxels} voxels
     */
    setVoxels(data, voxels) {
        const {gl} = this;
        this.close();
        this.data = data;
        const [rMin, rMax, height] = data.shape;
        const [wide, high, deep] = voxels.size;
        /** The shortest side of a voxel. */
        this.voxel = Math.min((rMax - rMin) / wide / data.scale[0], height / high / data.scale[1], Math.PI * rMin / deep / data.scale[2]);
        this.texture3d('brick', voxels.size, gl.R8, gl.RED, voxels.scalars, gl.LINEAR);
        this.texture3d('owners', voxels.size, gl.RG8, gl.RG, new Uint8Array(voxels.owners.buffer), gl.NEAREST);
        this.texture3d('far', voxels.cells, gl.R8, gl.RED, voxels.far, gl.NEAREST);
    }

    /**
     * @param {keyof typeof units} name
     * @param {WebGLTexture | null} texture
     * @param {number} [kind]
     */
    bind(name, texture, kind = this.gl.TEXTURE_2D) {
        this.gl.activeTexture(this.gl.TEXTURE0 + units[name]);
        this.gl.bindTexture(kind, texture);
        return texture;
    }

    /**
     * @param {'brick' | 'owners' | 'far'} name
     * @param {number[]} size
     * @param {number} storage
     * @param {number} format
     * @param {Uint8Array} bytes
     * @param {number} filter
     */
    texture3d(name, [width, height, depth], storage, format, bytes, filter) {
        const {gl} = this;
        this.bind(name, gl.createTexture(), gl.TEXTURE_3D);
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
        gl.texImage3D(gl.TEXTURE_3D, 0, storage, width, height, depth, 0, format, gl.UNSIGNED_BYTE, bytes);
        for (const key of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_3D, key, filter);
        for (const key of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T, gl.TEXTURE_WRAP_R]) gl.texParameteri(gl.TEXTURE_3D, key, gl.CLAMP_TO_EDGE);
    }

    /**
     * A place to draw numbers into.
     * @param {number} storage
     */
    target(storage) {
        const {gl} = this;
        const framebuffer = gl.createFramebuffer();
        const room = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, room);
        gl.renderbufferStorage(gl.RENDERBUFFER, storage, mostPicked, mostPicked);
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, room);
        return framebuffer;
    }

    makeArrays() {
        const {gl, data: {arrow}} = this;
        /**
         * @param {number} place
         * @param {number} count
         * @param {number} stride
         * @param {number} offset
         * @param {number} each
         */
        const attribute = (place, count, stride, offset, each) => {
            gl.enableVertexAttribArray(place);
            gl.vertexAttribPointer(place, count, gl.FLOAT, false, stride * 4, offset * 4);
            gl.vertexAttribDivisor(place, each);
        };
        /**
         * @param {number} kind
         * @param {BufferSource | null} content
         */
        const buffer = (kind, content) => {
            const made = gl.createBuffer();
            gl.bindBuffer(kind, made);
            if (content) gl.bufferData(kind, content, gl.STATIC_DRAW);
            return made;
        };
        const lines = {array: gl.createVertexArray(), instances: /** @type {WebGLBuffer | null} */ (null), count: 0};
        gl.bindVertexArray(lines.array);
        buffer(gl.ARRAY_BUFFER, new Float32Array([0, -1, 1, -1, 0, 1, 1, 1]));
        attribute(0, 2, 2, 0, 0);
        lines.instances = buffer(gl.ARRAY_BUFFER, null);
        [[1, 3, 0], [2, 3, 3], [3, 4, 6]].forEach(([place, count, offset]) => attribute(place, count, 10, offset, 1));
        const arrows = {...lines, array: gl.createVertexArray()};
        gl.bindVertexArray(arrows.array);
        buffer(gl.ARRAY_BUFFER, bytesOf(arrow.vertices));
        attribute(0, 3, 6, 0, 0);
        attribute(1, 3, 6, 3, 0);
        buffer(gl.ELEMENT_ARRAY_BUFFER, new Uint16Array(arrow.indices));
        arrows.instances = buffer(gl.ARRAY_BUFFER, null);
        attribute(2, 3, 6, 0, 1);
        attribute(3, 3, 6, 3, 1);
        gl.bindVertexArray(null);
        this.lines = lines;
        this.arrows = arrows;
    }

    /**
     * @param {string} name
     * @param {() => import('./shaders.js').Sources} sources
     */
    program(name, sources) {
        const {gl} = this;
        let made = this.programs.get(name);
        if (!made) {
            const program = /** @type {WebGLProgram} */ (gl.createProgram());
            sources().forEach((source, k) => {
                const shader = /** @type {WebGLShader} */ (gl.createShader(k ? gl.FRAGMENT_SHADER : gl.VERTEX_SHADER));
                gl.shaderSource(shader, source);
                gl.compileShader(shader);
                gl.attachShader(program, shader);
            });
            gl.linkProgram(program);
            if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) throw new Error(`this WebGL cannot link ${name}: ${gl.getProgramInfoLog(program)}`);
            /** @type {Program['at']} */
            const at = {};
            const count = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) ?? 0;
            for (let k = 0; k < count; ++k) {
                const uniform = gl.getActiveUniform(program, k)?.name ?? '';
                at[uniform.replace('[0]', '')] = gl.getUniformLocation(program, uniform);
            }
            this.programs.set(name, made = {program, at});
        }
        gl.useProgram(made.program);
        return made.at;
    }

    /**
     * Extinction of each value.
     * @param {number} factor on it
     */
    setTransfer(factor) {
        const {gl, data: {extinction}} = this;
        const table = new Float32Array(1021 * 4);
        for (let k = 0; k < 1021; ++k) {
            table[4 * k + 3] = extinctionAt(extinction, k / 4, factor) * Math.LOG2E;
        }
        gl.activeTexture(gl.TEXTURE0 + units.transfer);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 1021, 1, 0, gl.RGBA, gl.FLOAT, table);
    }

    /**
     * @param {Float32Array} colours four numbers for each owner
     * @param {'palette' | 'picks'} name that is seen, or by which is found what a pixel shows
     */
    setPalette(colours, name) {
        const {gl} = this;
        gl.activeTexture(gl.TEXTURE0 + units[name]);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 256, colours.length / 1024, 0, gl.RGBA, gl.FLOAT, colours);
    }

    /**
     * @param {0 | 1 | 2} number
     * @param {TexImageSource} image
     */
    setFrame(number, image) {
        const {gl} = this;
        gl.activeTexture(gl.TEXTURE0 + units[/** @type {'frame_0'} */ (`frame_${number}`)]);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, image);
    }

    /**
     * @param {number[]} lines from, to and colour of each, P-space
     * @param {number[]} arrows tail and vector of each
     */
    setLines(lines, arrows) {
        const {gl} = this;
        for (const [into, numbers, size] of /** @type {const} */ ([[this.lines, lines, 10], [this.arrows, arrows, 6]])) {
            if (!into) continue;
            gl.bindBuffer(gl.ARRAY_BUFFER, into.instances);
            gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.DYNAMIC_DRAW);
            into.count = numbers.length / size;
        }
    }

    /**
     * Room for lines and arrows, with four samples per pixel.
     * @param {number[]} size
     */
    roomForLines([width, height]) {
        const {gl, lined} = this;
        if (lined.size[0] === width && lined.size[1] === height) return;
        lined.size = [width, height];
        gl.bindFramebuffer(gl.FRAMEBUFFER, lined.smooth);
        for (const [attachment, storage] of [[gl.COLOR_ATTACHMENT0, gl.RGBA8], [gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24]]) {
            const room = gl.createRenderbuffer();
            gl.deleteRenderbuffer(gl.getFramebufferAttachmentParameter(gl.FRAMEBUFFER, attachment, gl.FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
            gl.bindRenderbuffer(gl.RENDERBUFFER, room);
            gl.renderbufferStorageMultisample(gl.RENDERBUFFER, 4, storage, width, height);
            gl.framebufferRenderbuffer(gl.FRAMEBUFFER, attachment, gl.RENDERBUFFER, room);
        }
        gl.bindFramebuffer(gl.FRAMEBUFFER, lined.flat);
        for (const [name, attachment, storage] of /** @type {const} */ ([['lines', gl.COLOR_ATTACHMENT0, gl.RGBA8], ['lines_depth', gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24]])) {
            gl.deleteTexture(gl.getFramebufferAttachmentParameter(gl.FRAMEBUFFER, attachment, gl.FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
            const texture = this.bind(name, gl.createTexture());
            gl.texStorage2D(gl.TEXTURE_2D, 1, storage, width, height);
            for (const key of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, key, gl.NEAREST);
            gl.framebufferTexture2D(gl.FRAMEBUFFER, attachment, gl.TEXTURE_2D, texture, 0);
        }
    }

    /**
     * @param {Shot} shot
     * @param {number} lineWidth pixels
     * @param {number[]} arrowColour
     */
    drawLines({camera, size: [width, height]}, lineWidth, arrowColour) {
        const {gl, lined, lines, arrows, data} = this;
        if (!lines || !arrows) return;
        this.roomForLines([width, height]);
        gl.bindFramebuffer(gl.FRAMEBUFFER, lined.smooth);
        gl.viewport(0, 0, width, height);
        gl.enable(gl.DEPTH_TEST);
        gl.clearColor(0, 0, 0, 0);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        const matrix = matrixOf(camera);
        const ofLines = this.program('the lines', () => lineSources);
        gl.uniformMatrix4fv(ofLines.clip_from_p, false, matrix);
        gl.uniform2f(ofLines.half_width, lineWidth / width, lineWidth / height);
        gl.bindVertexArray(lines.array);
        gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, lines.count);
        const ofArrows = this.program('the arrows', () => arrowSources);
        gl.uniformMatrix4fv(ofArrows.clip_from_p, false, matrix);
        gl.uniform1f(ofArrows.thickness, data.thickness);
        gl.uniform2f(ofArrows.speed_range, 0, 1);
        gl.uniform3fv(ofArrows.to_light, toLight(camera));
        for (const name of ['slow_colour', 'fast_colour']) gl.uniform3fv(ofArrows[name], arrowColour);
        gl.bindVertexArray(arrows.array);
        gl.drawElementsInstanced(gl.TRIANGLES, data.arrow.indices.length, gl.UNSIGNED_SHORT, 0, arrows.count);
        gl.bindVertexArray(null);
        gl.disable(gl.DEPTH_TEST);
        gl.bindFramebuffer(gl.READ_FRAMEBUFFER, lined.smooth);
        gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, lined.flat);
        gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT, gl.NEAREST);
    }

    /**
     * @param {'VIEW' | 'PICK' | 'REACH'} what
     * @param {Shot} shot
     */
    march(what, {camera, size: [width, height], layout, pOf, bent, piece, spacing, frames}) {
        const {gl, data} = this;
        const at = this.program(`${what} ${layout}`, () => marchSources(what, layout, data.relief));
        for (const [name, unit] of Object.entries(units)) if (at[name]) gl.uniform1i(at[name], unit);
        if (what === 'PICK') gl.uniform1i(at.palette, units.picks);
        for (const [name, value] of Object.entries(layouts[layout].uniforms(data.shape))) gl.uniform1f(at[name], value);
        gl.uniformMatrix4fv(at.p_from_clip, false, inverseOf(camera));
        gl.uniform3fv(at.eye, camera.eye);
        gl.uniform3fv(at.forward, camera.forward);
        gl.uniform3fv(at.to_light, toLight(camera));
        const scale = data.scale[2] * (bent[1] - bent[0]);
        gl.uniform3f(at.brick_scale, data.scale[0], data.scale[1], scale);
        gl.uniform3f(at.brick_offset, 0, 0, data.scale[2] * bent[0]);
        gl.uniform1f(at.frame_height, data.shape[2]);
        gl.uniform1f(at.spacing, this.voxel * spacing);
        gl.uniform1f(at.voxel, this.voxel * Math.min(1, 1 / (bent[1] - bent[0])));
        const points = [0, 0.5, 1].flatMap(t => [[0, 0, t], [1, 1, t]].map(pOf));
        gl.uniform3fv(at.low, [0, 1, 2].map(k => Math.min(...points.map(point => point[k]))));
        gl.uniform3fv(at.high, [0, 1, 2].map(k => Math.max(...points.map(point => point[k]))));
        gl.uniform2fv(at.piece, piece);
        gl.uniform2f(at.pixels, width, height);
        const of = (/** @type {'corner' | 'across' | 'down'} */ part) => [0, 1, 2].flatMap(k => frames[k]?.[part] ?? [0, 0, 0]);
        gl.uniform3fv(at.frame_corner, of('corner'));
        gl.uniform3fv(at.frame_across, of('across'));
        gl.uniform3fv(at.frame_down, of('down'));
        gl.uniform1fv(at.frame_opacity, [0, 1, 2].map(k => frames[k]?.opacity ?? 0));
        gl.viewport(0, 0, width, height);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    /**
     * @param {Shot} shot
     * @param {number} lineWidth
     * @param {number[]} arrowColour
     */
    draw(shot, lineWidth, arrowColour) {
        this.drawLines(shot, lineWidth, arrowColour);
        this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, null);
        this.march('VIEW', shot);
    }

    /**
     * What each pixel shows: owner's number, t of the layout in 2²⁴ths, what it is (1 = the volume, 2 = the frame that is
     * shown now, 3 = another frame), and how opaque; from the lowest row on.
     * @param {Shot} shot of at most `mostPicked` pixels on a side
     */
    pick(shot) {
        this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.picked);
        this.march('PICK', shot);
        return this.read(shot.size);
    }

    /**
     * How much of what is before each point hides it, 0 to 255.
     * @param {Shot} shot
     * @param {Point[]} points P-space
     */
    hidden(shot, points) {
        const {gl} = this;
        const size = [mostPicked, Math.ceil(points.length / mostPicked)];
        const places = new Float32Array(size[0] * size[1] * 4);
        points.forEach((point, k) => places.set(point, 4 * k));
        gl.activeTexture(gl.TEXTURE0 + units.points);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, size[0], size[1], 0, gl.RGBA, gl.FLOAT, places);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.picked);
        this.march('REACH', {...shot, size});
        const found = this.read(size);
        return points.map((_, k) => found[4 * k + 3]);
    }

    /** @param {number[]} size */
    read([width, height]) {
        const found = new Uint32Array(width * height * 4);
        this.gl.readPixels(0, 0, width, height, this.gl.RGBA_INTEGER, this.gl.UNSIGNED_INT, found);
        return found;
    }

    /** Gives the memory of the voxels back. */
    close() {
        for (const name of /** @type {const} */ (['brick', 'owners', 'far'])) {
            this.gl.activeTexture(this.gl.TEXTURE0 + units[name]);
            this.gl.deleteTexture(this.gl.getParameter(this.gl.TEXTURE_BINDING_3D));
        }
    }

    /** Waits until all is drawn. */
    finish() {
        this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, null);
        this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4));
    }
}

/**
 * From clip space to P-space, by columns: the inverse of `matrixOf`.
 * @param {Camera} camera
 */
function inverseOf({eye, right, up, forward, focus, shift, depth: [near, far]}) {
    // w of P-space is 1 for (x w, y w, z w, w), so that all is linear in these.
    const [a, b] = [(far + near) / (far - near), -2 * far * near / (far - near)];
    const x = right.map(value => value / focus[0]);
    const y = up.map(value => value / focus[1]);
    const ahead = plus(plus(forward, -shift[0], x), -shift[1], y);
    // The point is eye + x X + y Y + ahead W, times 1; and 1 = (Z - a W) / b.
    const column = (/** @type {Point} */ direction, /** @type {number} */ w) => [...plus(direction, w, eye), w];
    return new Float32Array([...column(x, 0), ...column(y, 0), ...column([0, 0, 0], 1 / b), ...column(ahead, -a / b)]);
}

