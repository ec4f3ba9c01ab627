// Kinds of events: the rows of the program's table (core/tracking/event_kind.h), most informative first.

/**
 * @typedef {{name: string, words: string, by: string, isThing: boolean, isOfScene: boolean, emphasis: string,
 *     tally: string, choice: string | null}} KindRow
 * @typedef {KindRow & {rank: number}} Kind
 */

/**
 * Returns a function that looks up a kind by its name. A stream's newer program may name one that the page does not
 * know: it is shown by its name, and ranks last.
 * @param {KindRow[]} rows
 * @returns {(name: string) => Kind}
 */
export function kindsBy(rows) {
    const kinds = new Map(rows.map((row, rank) => [row.name, {...row, rank}]));
    return name => kinds.get(name) ??
        {name, words: name, by: 'by', isThing: false, isOfScene: false, emphasis: 'none', tally: 'none', choice: null,
         rank: kinds.size};
}
