// The index of an archive.

import {at, button, element, press} from '../shared/dom.js';
import {grouped} from '../shared/text.js';
import {counted, summaryOf} from './clips.js';
import {takeDay} from './events.js';
import {askedWords, drawCount, drawFilters, listenToFilters} from './filters.js';
import {drawHits, listenToHits} from './hits.js';
import {focusShown, followAddress, leadToHit, listenToReturn} from './leading.js';
import {drawClips, fillAll} from './list.js';
import {drawDays, listenToDays} from './overview.js';
import {answer, askPlace, drawHeat, drawHours, drawPlace, drawScene, drawTools, drawWays, listenToScene, sceneCamera} from './scene.js';
import {ask, cameraName, camerasByName, chosenClips, clips, data, drawAll, hits, search, searchedClips, set, span, state} from './state.js';

const cameras = at('camera', HTMLSelectElement);

/**
 * The buttons of cameras; null = all.
 * @type {Map<number | null, HTMLButtonElement>}
 */
const buttonOf = new Map();

function drawViews() {
    document.documentElement.toggleAttribute('data-scene', state.view === 'scene');
    for (const [view, id] of [['clips', 'days'], ['days', 'overview'], ['scene', 'scene']]) at(id).hidden = state.view !== view;
    for (const choice of at('views').querySelectorAll('button')) press(choice, choice.value === state.view);
}

function drawCamera() {
    for (const [camera, made] of buttonOf) press(made, camera === state.camera);
    cameras.value = String(state.camera);
}

/** For paper, which has no filters: what is shown. */
function drawAsked() {
    const camera = state.camera === null ? 'All cameras' : cameraName(state.camera);
    const place = state.view === 'scene' && state.place ? state.place.kind === 'line' ? 'across the line' : 'in the area' : '';
    at('asked').textContent = [camera, askedWords(), state.kind === 'all' ? '' : state.kind, state.class, place, state.text].filter(Boolean).join(' · ');
}

/** What the index shows, and what of the state each part depends on. */
const parts = [
    {draw: drawViews, from: () => [state.view]},
    {draw: drawFilters, from: () => [state.text, state.order, state.class, state.kind, span(), state.days, state.times]},
    {draw: drawCount, from: () => [chosenClips(), state.place, state.view, span()]},
    {draw: drawAsked, from: () => [search()]},
    {draw: drawCamera, from: () => [state.camera]},
    {draw: drawClips, from: () => [state.view === 'clips' && chosenClips(), state.order]},
    {draw: drawDays, from: () => [state.view === 'days' && chosenClips()]},
    {draw: drawScene, from: () => [state.view === 'scene', sceneCamera(), sceneCamera() === null && state.tool]},
    {draw: drawTools, from: () => [state.tool, state.view, state.drawn, state.place, sceneCamera()]},
    {draw: drawPlace, from: () => [state.place, state.drawn, sceneCamera()]},
    {draw: answer, from: () => state.view === 'scene' ? [searchedClips(), state.place, state.way, state.kind, state.class, span()] : [null]},
    {draw: drawWays, from: () => [state.answer, state.place, state.way]},
    {draw: drawHits, from: () => [state.answer, hits(), state.all]},
    {draw: drawHeat, from: () => [state.answer, hits()]},
    {draw: drawHours, from: () => [state.answer, hits()]},
    {draw: focusShown, from: () => [state.shown, state.answer]},
    {draw: leadToHit, from: () => [state.leading, state.answer]},
];

/**
 * @param {number | null} camera
 * @param {string} name
 * @param {import('./clips.js').Clip[]} list
 */
function cameraItem(camera, name, list) {
    const made = button('', '', () => ask({camera}));
    const failed = counted(list).filter(clip => clip.failed).length;
    const counts = element('i', '', counted(list).length.toLocaleString('en'));
    if (failed) counts.append(Object.assign(element('span', 'bad', ` ✕${failed}`), {title: `${failed} failed`}));
    made.append(element('bdi', '', name), counts);
    buttonOf.set(camera, made);
    cameras.append(Object.assign(element('option', '', name), {value: String(camera)}));
    const item = element('li');
    item.append(made);
    return item;
}

/** What does not change: the summary, and the cameras, by name. */
function fillPage() {
    const ofCamera = grouped(clips, 'camera');
    at('summary').textContent = summaryOf(clips, data);
    at('cameras').append(cameraItem(null, 'All cameras', clips), ...camerasByName.map(camera => cameraItem(camera, cameraName(camera), ofCamera.get(camera) ?? [])));
}

function listen() {
    for (const choice of at('views').querySelectorAll('button')) choice.addEventListener('click', () => ask({view: choice.value}));
    cameras.addEventListener('change', () => ask({camera: cameras.value === 'null' ? null : Number(cameras.value)}));
    addEventListener('beforeprint', () => {
        fillAll();
        set({all: true});
    });
    addEventListener('afterprint', () => set({all: false}));
}

// The files of days call it.
Object.assign(window, {vvrDay: takeDay});
fillPage();
for (const start of [listen, listenToFilters, listenToDays, listenToScene, listenToHits, listenToReturn]) start();
drawAll(parts);
followAddress();

// The names that tests, and whoever debugs the index, find as `vvr.NAME`.
export {ask, askPlace, data, hits, set, state};
