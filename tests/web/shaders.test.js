// glslang checks the shaders of the page in the dialect of WebGL 2. Those that it shares with the program are checked there too.

import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import test from 'node:test';

const folder = mkdtempSync(join(tmpdir(), 'vvr-shaders-'));
globalThis.process.on('exit', () => rmSync(folder, {recursive: true}));

/** Runs a program; null = there is none. */
function run(...words) {
    const {status, stdout, stderr, error} = spawnSync(words[0], words.slice(1), {encoding: 'utf8'});
    return error ? null : {status, text: stdout + stderr};
}

test('the shaders of the volume that turns', async t => {
    if (!run('glslangValidator', '--version')) return t.skip('there is no glslangValidator; install with: apt-get install glslang-tools');
    const joined = join(folder, 'shaders.mjs');
    const made = run('esbuild', new URL('../../core/web/page/shaders.js', import.meta.url).pathname, '--bundle', '--format=esm', '--loader:.glsl=text',
                     '--loader:.vert=text', '--loader:.frag=text', `--outfile=${joined}`, '--log-level=warning');
    assert.equal(made?.status, 0, made?.text);
    const {arrowSources, lineSources, marchSources} = await import(joined);
    const all = [lineSources, arrowSources];
    for (const what of ['VIEW', 'PICK', 'REACH']) for (const layout of ['horseshoe', 'box']) for (const shades of [true, false]) all.push(marchSources(what, layout, shades));
    for (const sources of all) {
        const files = sources.map((source, k) => join(folder, k ? 'x.frag' : 'x.vert'));
        files.forEach((file, k) => writeFileSync(file, sources[k]));
        const {status, text} = run('glslangValidator', '-l', ...files);
        assert.equal(status, 0, text);
        assert.ok(sources.every(source => source.startsWith('#version 300 es\n')));
    }
});
