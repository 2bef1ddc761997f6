// Types that never cross the border to JavaScript need no conversion: 1 KB less.
mergeInto(LibraryManager.library, {
  _embind_register_std_wstring: function () {},
  _embind_register_memory_view: function () {},
  _embind_register_emval: function () {},
})
