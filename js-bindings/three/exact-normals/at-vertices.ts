// Remembers whether a warp is about to be added to a shader that has exact normals.
let isWarping = false

/** Runs `work` such that exact normals stay at vertices, where the warp can transform them. */
export function withNormalsAtVertices<Result>(work: () => Result): Result {
  const wasWarping = isWarping
  isWarping = true
  try {
    return work()
  } finally {
    isWarping = wasWarping
  }
}

export const areNormalsAtVertices = () => isWarping
