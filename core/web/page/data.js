// What the program writes into a page: PageContent of core/page/page.h as JSON.

/**
 * An event. Its path is in shares of the picture, its way as in shared/ways.js; `from`, `into` and `by` are places in
 * the list of events.
 * @typedef {object} PageEvent
 * @property {string} kind
 * @property {string | null} [class] what the object is; null = unknown
 * @property {string | null} [group] of classes
 * @property {number | null} [score] of the class
 * @property {number} first frame
 * @property {number} last frame
 * @property {number} begin seconds of the clip: when its first frame was, though a stream's page may no longer have that
 * @property {number} end seconds, of its last frame
 * @property {number} still seconds
 * @property {number | null} from
 * @property {number | null} into
 * @property {number | null} by
 * @property {number[][]} path frame, x, y each
 * @property {number[][]} stays first and last frame of each
 * @property {number[]} box all its places: left, top, right, bottom in shares of the picture
 * @property {number[]} way
 * @property {string} [deed] what it did: "went down and right"
 * @property {string} [colour]
 * @property {number} [number] that the picture shows
 * @property {string | null} [portrait] URL
 * @property {number} [twin] how many events before it in the list have the same frames
 *
 * @typedef {[first: number, count: number, begin: number, step: number]} Stretch frames at a constant rate
 * @typedef {{begin: number, leaps: [number, number][], zone: string | null, by: string}} WallClock
 * @typedef {[url: string, begin: number, length: number]} Segment a file of a recording
 * @typedef {{frame: number, src: string}} Still
 * @typedef {{src: string, sum: number}} PixelData a number per pixel, in three bytes
 *
 * What lies over the picture, in its pixels; an event is meant by its place.
 * @typedef {object} Overlay
 * @property {number[][]} sections see arc.js
 * @property {{text: string, t: number, at: number[], out: number[], place?: number[]}[]} notes along the time axis, the most important first; t, and in the volume that turns place, are in C-space
 * @property {{event: number, box: number[], object?: number[], to: number[], place?: number[]}[]} portraits; the object is in shares of the box
 * @property {number} captions height of the space above the portraits
 * @property {boolean} numbers whether trails have numbers
 * @property {{box: number[], src: string} | null} map
 *
 * @typedef {object} PageData
 * @property {string} name
 * @property {string | null} camera
 * @property {string | null} clip URL
 * @property {Segment[]} segments
 * @property {Segment[]} [pieces] of the events, which were kept
 * @property {Segment[]} [films] of a stream's last bricks
 * @property {number} [stretch] seconds of the picture per second of these files; 1 if missing
 * @property {{ending: string, names: string[]}} cut
 * @property {[number, number]} size
 * @property {Stretch[]} times
 * @property {string[]} [gaps] why there are no frames: of each gap in the times
 * @property {string[]} [unseen] what nobody looked at, in words
 * @property {[begin: number, end: number][]} [damage] seconds
 * @property {WallClock | null} clock
 * @property {string} told the source of the time of day
 * @property {import('../shared/kinds.js').KindRow[]} kinds
 * @property {{url: string, clip: string} | null} index
 * @property {{state: string, written: number, ended: boolean, brick: number} | null} live
 * @property {PageEvent[] | null} events null = not detected
 * @property {number} unchosen events that were found, and that --events doesn't choose
 * @property {Overlay} overlay
 * @property {Record<string, string>} settings
 *
 * What comes after the script.
 * @typedef {object} Parts
 * @property {PixelData & {first: number} | null} pixels
 * @property {PixelData | null} objects
 * @property {Still[]} stills
 * @property {(string | null)[]} portraits
 * @property {TurningVolume | null} volume
 * @property {{type: string, begin: number, step: number, base64: string} | null} preview
 *
 * The volume that turns: cli/compose/page_content.cpp makes it.
 * @typedef {object} TurningVolume
 * @property {number[]} size in voxels: x, y and time
 * @property {number[]} scale from C-space to shares of the voxels
 * @property {number[]} values the scalar of each level
 * @property {string} levels deflated, in base64
 * @property {string} owners the same: low bytes, then high bytes
 * @property {number[]} extinction of each scalar
 * @property {boolean} relief
 * @property {import('./layouts.js').LayoutName} layout
 * @property {import('./layouts.js').Shape} shape
 * @property {import('./camera.js').View} view
 * @property {number[]} part of the picture, in which the camera fits the volume: left, top, right, bottom
 * @property {{outline: boolean, ribs: boolean, ruler: boolean}} shows
 * @property {number[]} ticks t of each
 * @property {number} end t at the end of the last layer
 * @property {number[]} frames the first of each layer of voxels, and the last one
 * @property {number[]} colours of the events: the place in a palette of 8
 * @property {{palette: number[][], lines: number[], arrows: number[]}[]} schemes light, dark
 * @property {{vertices: string, indices: number[]}} arrow
 * @property {number} thickness
 * @property {number[][]} arrows tail and tip of each, in C-space
 * @property {string[]} ends URLs of the frames at the beginning and at the end
 * @property {number} opacity of these
 */

export {};
