// Why a clip can't be played.

/** What Chromium and Firefox say of a file that is not there. They have one code for all that fails. */
const notThere = ['the clip is not where it was', 'the file of that name is another clip'];
const missing = [/^MEDIA_ELEMENT_ERROR: Format error$/, /^\d+: /];

const maybeMissing = 'the clip is missing or can’t be played here';

/**
 * Whether the clip is no longer there.
 * @param {string} why it can't be played
 * @param {boolean} hasPieces they were kept for when it is gone
 */
export const isGone = (why, hasPieces) => notThere.includes(why) || hasPieces && why === maybeMissing;

export const notPlayed = 'this browser doesn’t play this kind of file';

/**
 * Whether a file is of a kind that this browser says it does not play. To find that out by itself, it would read a million bytes.
 * @param {string} address
 * @param {HTMLVideoElement} player
 */
export const isForeign = (address, player) => /\.avi$/i.test(address) && player.canPlayType('video/x-msvideo') === '';

/**
 * @param {string} message of the browser
 * @param {string} name of the clip
 */
export function whyNot(message, name) {
    if (missing.some(words => words.test(message))) return notThere[0];
    if (message !== '' || !/\.(mp4|m4v|webm|mov)$/i.test(name)) return notPlayed;
    return maybeMissing;
}
