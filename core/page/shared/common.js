'use strict';

// What every page begins with.

const data = JSON.parse(document.getElementById('data').textContent);
const at = id => document.getElementById(id);
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);
const digits = number => String(number).padStart(2, '0');

/// A duration as pictures tell it: 45 s, 7 min, 3:20 h.
function durationOf(seconds) {
    const whole = Math.round(Math.round(seconds * 10) / 10);
    const minutes = Math.round(whole / 60);
    return whole < 100 ? whole + ' s' : minutes < 100 ? minutes + ' min' : Math.floor(minutes / 60) + ':' + digits(minutes % 60) + ' h';
}

function element(tag, className, text) {
    const made = document.createElement(tag);
    if (className) made.className = className;
    if (text !== undefined) made.textContent = text;
    return made;
}

/// Marks that turn the direction of writing would let a name show another ending: they are shown as what they are.
const upright = text => text.replace(/[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]/g,
                                     mark => `[U+${mark.charCodeAt(0).toString(16).toUpperCase().padStart(4, '0')}]`);
