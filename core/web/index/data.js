// What the program writes into the index: make_index of core/archive/index.cpp as JSON.

/**
 * A clip: camera, URL, when it begins (seconds since 1970), duration, number of events, bits of `files`, tallies by kind
 * (seconds, or how many; 0 = nothing), classes of its objects, faults of the recording; if it failed, the exit status, the reason, the number of
 * tries, and the time until which its older picture shows it.
 * @typedef {[camera: number, url: string, begins: number, seconds: number, events: number | null, files: number,
 *     tallies: number[] | null, classes: string[] | null, faults: string[] | null, status?: number | null, reason?: string, tries?: number, until?: number]} Row
 *
 * @typedef {object} IndexData
 * @property {string[]} cameras names; '' = the top folder
 * @property {import('../shared/wall_clock.js').ZoneChange[]} zone
 * @property {import('../shared/kinds.js').KindRow[]} kinds
 * @property {Record<string, string[]>} classes of objects, by group
 * @property {number} sheet_columns at most, of contact sheets
 * @property {Row[]} clips
 * @property {{date: string, night: boolean, clips: number, row: Row}[]} recordings all that a camera recorded on a day or in the night after it, in one picture
 * @property {string[]} days that have files of events
 *
 * @typedef {(number | string)[]} EventRow kind, number, tenths of a second for which it was still, its way, its class if known
 */

/** Bits of a row's files. */
export const bits = {page: 2, thumbnail: 4, still: 16, stills: 32, gone: 256, byContainer: 1024, byFile: 2048};
