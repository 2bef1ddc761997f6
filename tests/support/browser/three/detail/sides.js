/** Counts the sides of triangles that no other triangle has in the opposite direction. Vertices at the same place count as one vertex. */
export function countOpenSides(indices, positions) {
  const places = new Map()
  const placeOf = (vertex) => {
    const key = positions.subarray(3 * vertex, 3 * vertex + 3).join()
    if (!places.has(key)) places.set(key, places.size)
    return places.get(key)
  }
  const open = new Map()
  for (let t = 0; t < indices.length; t += 3)
    for (let i = 0; i < 3; i++) {
      const [a, b] = [placeOf(indices[t + i]), placeOf(indices[t + ((i + 1) % 3)])]
      const back = `${b} ${a}`
      if (open.get(back)) open.set(back, open.get(back) - 1)
      else open.set(`${a} ${b}`, (open.get(`${a} ${b}`) ?? 0) + 1)
    }
  return [...open.values()].reduce((sum, count) => sum + count, 0)
}
