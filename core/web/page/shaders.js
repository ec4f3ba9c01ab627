// The shaders of the volume that turns. Map, transfer function, shading and lines are those of glsl/, in the dialect of WebGL 2.

import arrowFragment from '../../../glsl/arrow.frag';
import arrowVertex from '../../../glsl/arrow.vert';
import box from '../../../glsl/layout_box.glsl';
import horseshoe from '../../../glsl/layout_horseshoe.glsl';
import lineFragment from '../../../glsl/line.frag';
import lineVertex from '../../../glsl/line.vert';
import optical from '../../../glsl/optical_object.glsl';
import none from '../../../glsl/shading_none.glsl';
import relief from '../../../glsl/shading_relief.glsl';
import sample from '../../../glsl/volume_sample.glsl';
import march from './march.frag';
import voxel from './page_voxel.glsl';

/** @typedef {[vertex: string, fragment: string]} Sources */

const dialect = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler3D;
`;

/** Those of glsl/volume_in.glsl, as variables of the ray. */
const ofRay = 'vec3 local;\nfloat t_near;\nvec3 ray;\nvec3 light;\nvec3 view;\n';

/** One triangle over everything. */
const everywhere = 'void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }\n';

/** @type {(...chunks: string[]) => string} */
const text = (...chunks) => dialect + chunks.join('\n');

/** @type {Sources} */
export const lineSources = [text(lineVertex), text(lineFragment)];
/** @type {Sources} */
export const arrowSources = [text(arrowVertex), text(arrowFragment)];

/**
 * @param {'VIEW' | 'PICK' | 'REACH'} what
 * @param {import('./layouts.js').LayoutName} layout
 * @param {boolean} shades by relief
 * @returns {Sources}
 */
export const marchSources = (what, layout, shades) => [text(everywhere),
    text(`#define ${what}`, ofRay, {horseshoe, box}[layout], sample, voxel, optical, shades ? relief : none, march)];
