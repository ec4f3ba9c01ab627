// The page of a clip.

import {at} from '../shared/dom.js';
import {spanOf} from '../shared/durations.js';
import {upright} from '../shared/text.js';
import {linkIndex, listenToNeighbours, playOn, takeArrival} from './around.js';
import {askPlace, drawAsked, drawTools, listenToTools} from './asking.js';
import {besideNow, choose, drawBeside, followAddress, leaveUnfound} from './choice.js';
import {drawCommands, listenToExport} from './export.js';
import {wantedEvents} from './filters.js';
import {listenToKeys} from './keys.js';
import {drawFilling, drawReel, drawShares, drawTab, listenToLayout} from './layout.js';
import {drawLegend, drawLetters, drawLit, drawRib, drawZebra} from './letters.js';
import {drawChips, drawChosen, drawClasses, drawFilters, drawList, drawLitRow, listenToList} from './list.js';
import {drawAge, drawFollowing, followStream, takeKeptState} from './live.js';
import {drawSheet, listenToSheet} from './map.js';
import {takeArrived} from './parts.js';
import {drawGround, drawVeil, readPicture} from './picture.js';
import {drawClocks, drawJump, drawPlayButton, drawPlayer, drawSpeed, drawStill, drawTour, followPlayer, isPlaying, listenToPlayer, openFilm, openWaiting, showsStill} from './player.js';
import {drawPeek, drawTip, listenToPeeker, openPeeker} from './pointing.js';
import {drawRing} from './ring.js';
import {drawAll, set, state} from './state.js';
import {drawBars, drawBrush, drawCursor, drawGaps, drawPart, drawRange, drawTicks, followNow, listenToStrip, markChosen, strip} from './strip.js';
import {inSentence} from './timeline.js';
import {drawFirst, drawGlance, drawMeaning, drawStage, listenToView, playCandidate, roomOf} from './view.js';
import {contentsNow, overlayNow} from './turned.js';
import {becomeTurnable, drawTurning, listenToTurning} from './turning.js';
import {drawColours, drawDensity, drawLook, drawVolume, listenToVolume, prepareVolume} from './volume_view.js';
import {drawWhich, listenToWhich} from './which.js';

/** Characters that change the direction of writing are shown as code points. */
function drawNames() {
    document.title = upright(document.title);
    for (const name of [document.querySelector('h1'), at('file')]) if (name) name.textContent = upright(name.textContent ?? '');
}

function drawSummary() {
    const {data, time} = state;
    const seen = time.secondsSeen();
    const lost = time.secondsWithout().map(([reason, seconds]) => `, ${inSentence(reason)} for ${spanOf(seconds)}`);
    const count = state.events.length;
    const found = data.events ? `, ${count.toLocaleString('en')} event${count === 1 ? '' : 's'}` : '';
    const isAll = data.clock === null && time.begins === 0 && !lost.length;  // then its length says as much
    const span = `${isAll ? '' : time.span() + ', '}${spanOf(seen)}${lost.length ? ' of video' : ''}${lost.join('')}${found}`;
    const zone = data.clock?.zone ? ' in ' + data.clock.zone : '';
    at('summary').textContent = data.clock === null ? `${span}; ${data.told}`
        : `${time.dayOf(time.begins)}, ${span}; times${zone}, ${data.told}`;
}

/** What nobody looked at, and when the clip is damaged. */
function drawUnseen() {
    const {data: {unseen = [], damage = []}, time} = state;
    const when = damage.slice(0, 5).map(([from, to]) => `${time.clockOf(from)} to ${time.clockOf(to)}`);
    if (damage.length > 5) when.push(`${damage.length - 5} more`);
    at('unseen').hidden = !unseen.length;
    at('unseen').textContent = `Not seen: ${unseen.join('; ')}${when.length ? `; damage from ${when.join(', ')}` : ''}`;
}

/** The players have the shape of the clip. */
function drawShapes() {
    const {size} = state.data;
    at('screen').style.aspectRatio = size[0] + ' / ' + size[1];
    at('screen').style.setProperty('--shape', String(size[0] / size[1]));
}

/** What the page shows, and what of the state each part depends on. */
const parts = [
    {draw: drawNames, from: () => [state.data]},
    {draw: drawSummary, from: () => [state.data]},
    {draw: drawUnseen, from: () => [state.data]},
    {draw: drawShapes, from: () => [...state.data.size]},
    {draw: drawAge, from: () => [state.data]},
    {draw: drawFollowing, from: () => [state.data, state.follows]},
    {draw: drawFilling, from: () => [state.fills]},
    {draw: drawLegend, from: () => [state.data, state.events]},
    {draw: drawShares, from: () => [state.filmShare]},
    {draw: drawTab, from: () => [state.tab]},
    {draw: drawSheet, from: () => [state.tab, state.data, state.events, state.chosen, state.lightened, wantedEvents()]},
    {draw: drawFirst, from: () => [state.isFirst, state.turnable]},
    {draw: leaveUnfound, from: () => [wantedEvents()]},
    {draw: drawChips, from: () => [state.events, state.kind]},
    {draw: drawClasses, from: () => [state.events, state.what]},
    {draw: drawFilters, from: () => [state.leastSeconds, state.onlyStarred, state.showsHidden]},
    {draw: drawList, from: () => [state.data, state.events, wantedEvents(), state.order, state.marks]},
    {draw: drawChosen, from: () => [state.chosen]},
    {draw: drawBeside, from: () => [state.events, state.chosen, besideNow(-1), besideNow(1)]},
    {draw: drawLitRow, from: () => [state.lightened]},
    {draw: drawTools, from: () => [state.asking, state.asked, state.drawn]},
    {draw: drawAsked, from: () => [state.asked, state.drawn, state.parts.stills]},
    {draw: drawRange, from: () => [state.time]},
    {draw: followNow, from: () => [state.now, state.chosen, state.moved]},
    {draw: drawPart, from: () => [state.time, state.stripFrom, state.stripLasts]},
    {draw: drawBrush, from: () => [state.brush, state.piece, state.turnable, state.stripFrom, state.stripLasts]},
    {draw: drawTicks, from: () => [state.time, state.stripFrom, state.stripLasts, state.stripWidth]},
    {draw: drawGaps, from: () => [state.time, state.stripFrom, state.stripLasts, state.stripWidth]},
    {draw: drawBars, from: () => [state.time, state.stripFrom, state.stripLasts, state.stripWidth, wantedEvents()]},
    {draw: markChosen, from: () => [state.chosen]},
    {draw: drawCursor, from: () => [state.time, state.stripFrom, state.stripLasts, state.now]},
    {draw: drawGround, from: () => [state.ground]},
    {draw: drawStage, from: () => [state.scale, ...state.middle, contentsNow(), ...state.room]},
    {draw: drawMeaning, from: () => [state.data, state.stageWidth, state.piece, overlayNow()]},
    {draw: drawGlance, from: () => [state.contents]},
    {draw: drawPlayer, from: () => [state.source, state.film?.segment, showsStill()]},
    {draw: drawSpeed, from: () => [state.speed, state.film]},
    {draw: drawReel, from: () => [state.filmScale, ...state.filmMiddle]},
    {draw: drawTour, from: () => [state.touring]},
    {draw: drawJump, from: () => [state.jumping]},
    {draw: drawClocks, from: () => [state.data, state.now, isPlaying()]},
    {draw: drawStill, from: () => [state.parts, state.now, showsStill()]},
    {draw: drawPlayButton, from: () => [isPlaying()]},
    {draw: drawVeil, from: () => [state.pixels, state.chosen, state.lightened, wantedEvents(), state.dark, state.ground]},
    {draw: drawColours, from: () => [state.turns, state.dark, state.ground, state.parts.volume]},
    {draw: drawLook, from: () => [state.turnable, state.parts.volume, state.dark, state.ground, state.events, state.chosen, state.lightened, wantedEvents()]},
    {draw: drawDensity, from: () => [state.density]},
    {draw: drawVolume, from: () => [state.turns, state.parts.volume, ...state.angle, state.unbent, state.density, state.piece, state.bends, state.now, state.moved, state.scale,
                                    ...state.middle, ...state.room, contentsNow(), state.dark, state.ground, state.chosen, state.lightened, wantedEvents()]},
    {draw: drawTurning, from: () => [state.turnable, state.turns, state.brush, state.piece, state.bends, state.stripLasts]},
    {draw: drawLetters, from: () => [state.data, state.events, state.stageWidth, contentsNow(), state.asked, overlayNow()]},
    {draw: drawLit, from: () => [state.turns, state.chosen, state.lightened, wantedEvents(), state.stageWidth]},
    {draw: drawRib, from: () => [state.now, state.moved, state.chosen]},
    {draw: drawZebra, from: () => [isPlaying(), state.lightened]},
    {draw: drawRing, from: () => [state.data, state.chosen, state.now, showsStill()]},
    {draw: drawCommands, from: () => [state.data, state.chosen, state.gone, state.now]},
    {draw: openPeeker, from: () => [state.film]},
    {draw: drawPeek, from: () => [state.pointed?.frame]},
    {draw: drawTip, from: () => [state.pointed, state.lightened, isPlaying()]},
    {draw: drawWhich(playCandidate), from: () => [state.which]},
    {draw: playOn, from: () => [isPlaying()]},
];

/** The picture can tell times once its pixels have come. */
function readPixels() {
    readPicture().then(() => {
        if (state.pixels) document.documentElement.dataset.ready = '';
    }).catch(error => {
        at('notice').textContent = `The picture can’t tell times here: ${error.message}. The strip of time and the events can.`;
        at('notice').hidden = false;
    });
}

/** The page calls it when a part of its data has come. */
export function takeParts() {
    const had = state.parts;
    takeArrived();
    if (state.parts.pixels !== had.pixels) readPixels();
    if (state.parts.volume !== had.volume) becomeTurnable();
    openWaiting();
}

document.documentElement.dataset.script = '';
state.room = roomOf();
state.stripWidth = strip.clientWidth;
drawAll(parts);
for (const listen of [listenToLayout, listenToPlayer, listenToPeeker, listenToView, listenToSheet, listenToWhich, listenToStrip, listenToList, listenToTools, listenToExport, listenToKeys, listenToTurning, listenToVolume, listenToNeighbours]) listen();
linkIndex();
takeArrival();
addEventListener('hashchange', followAddress);
const dark = matchMedia('(prefers-color-scheme: dark)');
dark.addEventListener('change', ({matches}) => set({dark: matches}));
// Paper is light: what is not chosen is veiled in its colour.
// Its width, in pixels of the screen, decides which texts have room.
const paperWidth = 700;
addEventListener('beforeprint', () => set({dark: false, stageWidth: paperWidth, stripWidth: paperWidth}));
addEventListener('afterprint', () => {
    set({dark: dark.matches, stripWidth: strip.clientWidth});
    drawStage();
});
takeKeptState();
followStream();
performance.mark('usable');
openFilm(0);
followPlayer();
followAddress();
readPixels();

// The names that tests, and whoever debugs a page, find as `vvr.NAME`.
export {framingNow, pathOf, pixelAt, placeOf, tOf} from './turned.js';
export {pickedAround} from './volume_view.js';
export {arrowAcross} from '../shared/ways.js';
export {sortedPlaces, stillNear} from './events.js';
export {tell} from './messages.js';
export {paleOf, veilWords} from './picture.js';
export {setPlaying, show} from './player.js';
export {kindOf, pictureSize} from './state.js';
export {zoomStrip} from './strip.js';
export {askPlace, choose, drawChips, drawClasses, drawList, isPlaying, overlayNow, prepareVolume, set, state};
