// The performance aims of warpjet, as ratios of measurements of one run. Missing an aim is not a failure.

const find = (records, name) => records.find(({ method }) => method === name)

/** Returns warpjet's frame time divided by another method's. */
function frameRatio(records, name) {
  const toWarpjet = find(records, name)?.toWarpjet
  return toWarpjet && 1 / toWarpjet
}

const MANY_NODES = 3000

/** `ratio(records)` takes the records of one row, and returns `undefined` if the aim does not apply. `of` and `to` label it in the table. */
export const aims = [
  {
    of: 'frame ×',
    to: 'by hand ≤ 1.03',
    ratio: (records) => frameRatio(records, 'by hand'),
    isMet: (ratio) => ratio <= 1.03,
  },
  {
    of: 'frame ×',
    to: 'forward < 1',
    ratio: (records) => frameRatio(records, 'forward differences'),
    isMet: (ratio) => ratio < 1,
  },
  {
    of: 'frame ×',
    to: 'positions ≤ 1.5',
    ratio: (records) =>
      records[0].nodes === MANY_NODES ? find(records, 'warpjet')?.toPositions : undefined,
    isMet: (ratio) => ratio <= 1.5,
  },
  {
    of: 'first ×',
    to: 'positions ≤ 2',
    ratio: (records) => find(records, 'warpjet')?.firstToPositions,
    isMet: (ratio) => ratio <= 2,
  },
  {
    of: 'first ×',
    to: 'by hand ≤ 1.15',
    ratio: (records) => find(records, 'warpjet')?.firstToByHand,
    isMet: (ratio) => ratio <= 1.15,
  },
  {
    of: 'characters ×',
    to: 'by hand ≤ 1.3',
    ratio: (records) => find(records, 'warpjet')?.charactersToByHand,
    isMet: (ratio) => ratio <= 1.3,
  },
]
