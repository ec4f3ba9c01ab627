
// ---- Kinds of events: the rows of vvr's table, those that tell most first

const eventKinds = new Map(data.kinds.map((row, rank) => [row.name, {...row, rank}]));
/// A stream's newer vvr may name one that this page does not know: it stands by its name, behind the others.
const kindOf = name => eventKinds.get(name) ?? {name, words: name, by: 'by', isThing: false, emphasis: 'none', tally: 'none', choice: null, rank: eventKinds.size};
