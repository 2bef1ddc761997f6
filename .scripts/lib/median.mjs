/** The one in the middle, or the upper of two. */
export const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1]
