// Calls bound functions of embind without `new Function`. Emscripten 3.1.6 stores the arguments of a call in lists that belong to the bound
// function: if a callback calls the same function again, a string is freed twice. Here each call has its own lists. The option `fail` of the
// factory converts errors before they are thrown.
mergeInto(LibraryManager.library, {
  $craftInvokerFunction__deps: ['$runDestructors', '$throwBindingError'],
  $craftInvokerFunction: function (humanName, argTypes, classType, invoker, target) {
    var result = argTypes[0].name === 'void' ? null : argTypes[0]
    var self = classType === null ? null : argTypes[1]
    var parameters = argTypes.slice(2)
    return function () {
      try {
        if (arguments.length !== parameters.length)
          throwBindingError(
            humanName + ': expected ' + parameters.length + ' arguments, got ' + arguments.length,
          )
        var destructors = []
        var wired = [target]
        if (self) wired.push(self['toWireType'](destructors, this))
        for (var i = 0; i < parameters.length; ++i)
          wired.push(parameters[i]['toWireType'](destructors, arguments[i]))
        var value = invoker.apply(null, wired)
        runDestructors(destructors)
        return result ? result['fromWireType'](value) : undefined
      } catch (error) {
        throw Module['fail'](error)
      }
    }
  },
})
