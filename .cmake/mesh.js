// What the mesh module calls in JavaScript: js-bindings/wasm/mesh.ts sets it for the time of one call.
mergeInto(LibraryManager.library, {
  evaluateWarp: function (job) {
    return Module['evaluateWarp'](job)
  },
})
