/**
 * Tests whether a division of `given` triangles may be uniform, by its number of triangles. The CPU chooses a uniform division where it has fewer
 * triangles; compute passes never do.
 */
export const isUniform = (triangles, given) => Number.isInteger(Math.sqrt(triangles / given))
