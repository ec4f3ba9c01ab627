// The index of an archive.

import {at, button, element, press} from '../shared/dom.js';
import {grouped, many} from '../shared/text.js';
import {counted, neighbourOf, pageOf, summaryOf} from './clips.js';
import {drawClips, fillAll} from './list.js';
import {drawDays} from './overview.js';
import {readQuery} from './query.js';
import {askPlace, drawFound, drawHeat, drawHours, drawPlace, drawScene, drawTools, listenToScene, takeDay} from './scene.js';
import {ask, cameraName, choices, chosenClips, clipOfUrl, clips, data, drawAll, set, state} from './state.js';

const text = at('text', HTMLInputElement);
const classes = at('class', HTMLSelectElement);
const order = at('order', HTMLSelectElement);
const kinds = () => /** @type {HTMLInputElement[]} */ ([...document.getElementsByName('kind')]);

/**
 * The buttons of cameras; null = all.
 * @type {Map<number | null, HTMLButtonElement>}
 */
const buttonOf = new Map();

function drawViews() {
    for (const [view, id] of [['clips', 'days'], ['days', 'overview'], ['scene', 'scene']]) at(id).hidden = state.view !== view;
    for (const choice of at('views').querySelectorAll('button')) press(choice, choice.value === state.view);
}

/** A text that is being typed stays as it is. */
function drawFilters() {
    if (text.value.trim() !== state.text) text.value = state.text;
    order.value = state.order;
    classes.value = state.class;
    for (const radio of kinds()) radio.checked = radio.value === state.kind;
}

function drawCount() {
    const list = chosenClips();
    const day = state.day ? ` on ${state.day}` : '';
    at('count').textContent = list.length === clips.length ? '' : `${list.length.toLocaleString('en')} of ${many(clips.length, 'clip')}${day}`;
}

function drawCamera() {
    for (const [camera, made] of buttonOf) press(made, camera === state.camera);
}

/** What the index shows, and what of the state each part depends on. */
const parts = [
    {draw: drawViews, from: () => [state.view]},
    {draw: drawFilters, from: () => [state.text, state.order, state.class, state.kind]},
    {draw: drawCount, from: () => [chosenClips(), state.day]},
    {draw: drawCamera, from: () => [state.camera]},
    {draw: drawClips, from: () => [state.view === 'clips' && chosenClips(), state.order]},
    {draw: drawDays, from: () => [state.view === 'days' && chosenClips()]},
    {draw: drawTools, from: () => [state.tool, state.from, state.to]},
    {draw: drawPlace, from: () => [state.place, state.drawn]},
    {draw: drawScene, from: () => state.view === 'scene' ? [chosenClips(), state.place, state.from, state.to] : [null]},
    {draw: drawFound, from: () => [state.answer]},
    {draw: drawHeat, from: () => [state.answer]},
    {draw: drawHours, from: () => [state.answer]},
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
    const item = element('li');
    item.append(made);
    return item;
}

/** What does not change: the summary, and what can be chosen. */
function fillPage() {
    const ofCamera = grouped(clips, 'camera');
    at('summary').textContent = summaryOf(clips, data);
    at('cameras').append(cameraItem(null, 'All cameras', clips),
                         ...data.cameras.map((_, camera) => cameraItem(camera, cameraName(camera), ofCamera.get(camera) ?? [])));
    classes.append(...choices.known.class.map(name => {
        const words = name === '' ? 'everything' : (Object.hasOwn(data.classes, name) ? '' : '\u2013 ') + name;
        return Object.assign(element('option', '', words), {value: name});
    }));
    classes.hidden = choices.classes.size === 0;
}

function listen() {
    let typing = 0;
    text.addEventListener('input', () => {
        clearTimeout(typing);
        typing = window.setTimeout(() => ask({text: text.value.trim()}), 120);
    });
    for (const radio of kinds()) radio.addEventListener('change', () => ask({kind: radio.value}));
    classes.addEventListener('change', () => ask({class: classes.value}));
    order.addEventListener('change', () => ask({order: order.value}));
    for (const choice of at('views').querySelectorAll('button')) choice.addEventListener('click', () => ask({view: choice.value, day: null}));
    at('tools').addEventListener('submit', event => event.preventDefault());
    addEventListener('beforeprint', fillAll);
    addEventListener('hashchange', followAddress);
}

/** Shows what the address asks for. A clip's page leads here to find the clip before or after it, which it can't know. */
function followAddress() {
    const parts = new URLSearchParams(location.hash.slice(1));
    const clip = clipOfUrl.get(parts.get('after') ?? parts.get('before') ?? '');
    const next = clip ? neighbourOf(clips, clip, parts.has('after') ? -1 : 1) : null;
    if (next) return location.replace(pageOf(next));
    if (clip) history.replaceState(null, '', '#' + new URLSearchParams({camera: data.cameras[clip.camera]}));
    set(readQuery(location.hash, choices, data.cameras));
}

// The files of days call it.
Object.assign(window, {vvrDay: takeDay});
fillPage();
listen();
listenToScene();
followAddress();
drawAll(parts);

// The names that tests, and whoever debugs the index, find as `vvr.NAME`.
export {ask, askPlace, data, set, state};
